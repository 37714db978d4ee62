// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/image/depth_rays.h"

#include <limits>
#include <stdexcept>

#include "framewise/image/image_check.h"

namespace framewise {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

DepthRays::Kind kind_of(const Camera& camera) {
  if (camera.model == CameraModel::kEquirectangular) return DepthRays::Kind::kSphere;
  const bool plane = camera.model == CameraModel::kPinhole && !camera.is_distorted();
  return plane ? DepthRays::Kind::kPlane : DepthRays::Kind::kTable;
}

// A function of every pixel's unit ray; NaN where there is none.
template <typename T, typename Function>
cv::Mat of_bearings(const Camera& camera, const Function& function) {
  cv::Mat image(camera.height, camera.width, cv::traits::Type<T>::value);
  for (int v = 0; v < camera.height; ++v)
    for (int u = 0; u < camera.width; ++u) {
      const auto bearing = camera.bearing(Eigen::Vector2d(u, v));
      image.at<T>(v, u) = static_cast<T>(bearing ? function(*bearing) : kNone);
    }
  return image;
}

cv::Mat forward_parts(const Camera& camera) {
  return of_bearings<float>(camera, [](const Bearing& b) { return b.z() > 0 ? b.z() : kNone; });
}

}  // namespace

const char* name_of(DepthType type) { return type == DepthType::kZ ? "z" : "range"; }

DepthRays::DepthRays(const Camera& camera, DepthType type)
    : camera(camera), type(type), kind(kind_of(camera)) {
  camera.check();
  if (kind == Kind::kSphere && type == DepthType::kZ)
    throw std::invalid_argument("depth_type: found z, expected range for an equirectangular camera");
  if (kind == Kind::kPlane && type == DepthType::kRange) z_per_range = forward_parts(camera);
  if (kind != Kind::kTable) return;
  const auto component = [&](int i) {
    return of_bearings<double>(camera, [&](const Bearing& b) {
      if (type == DepthType::kRange) return b[i];
      return b.z() > 0 ? b[i] / b.z() : kNone;
    });
  };
  x = component(0);
  y = component(1);
  z = component(2);
}

cv::Mat z_from_range(const cv::Mat& range, const Camera& camera) {
  check_image("range", range, CV_32F);
  check_image_size("range", range, camera.width, camera.height);
  return range.mul(forward_parts(camera));
}

}  // namespace framewise
