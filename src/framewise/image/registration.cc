// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/image/registration.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "framewise/image/depth.h"
#include "framewise/image/image_check.h"

namespace framewise {
namespace {

void check_depth_camera(const Camera& camera) {
  camera.check();
  if (camera.model == CameraModel::kEquirectangular)
    throw std::invalid_argument("depth camera: model: found equirectangular, expected pinhole or fisheye");
}

std::array<std::vector<double>, 3> turned_corners(const DepthCamera& depth_camera) {
  const Camera& camera = depth_camera.camera;
  std::array<std::vector<double>, 3> corners;
  for (int v = 0; v <= camera.height; ++v)
    for (int u = 0; u <= camera.width; ++u) {
      const auto bearing = camera.bearing({u - 0.5, v - 0.5});
      const bool forward = bearing && bearing->z() > 0;
      const Eigen::Vector3d ray =
          forward ? Eigen::Vector3d(depth_camera.cam_from_depth_cam.R * (*bearing / bearing->z()))
                  : Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
      for (int axis = 0; axis < 3; ++axis) corners[axis].push_back(ray[axis]);
    }
  return corners;
}

// The whole numbers in [a, b), or [b, a), that are at least 0 and below size; none where the box is too wide.
std::pair<int, int> covered(double a, double b, int size) {
  if (a > b) std::swap(a, b);
  if (!(b - a <= kWidestPatch_px) || !(b > 0) || !(a < size)) return {0, 0};
  return {std::max(0, static_cast<int>(std::ceil(a))), std::min(size, static_cast<int>(std::ceil(b)))};
}

// Where patches overlap, the nearest to the camera wins.
void cover(cv::Mat& registered, int left, int right, int top, int bottom, float z) {
  for (int v = top; v < bottom; ++v) {
    float* row = registered.ptr<float>(v);
    for (int u = left; u < right; ++u)
      if (!(row[u] <= z)) row[u] = z;  // NaN is not nearer
  }
}

}  // namespace

DepthRegistration::DepthRegistration(const Camera& camera, const DepthCamera& depth_camera)
    : camera_(camera), width_(depth_camera.camera.width), height_(depth_camera.camera.height) {
  camera.check();
  check_depth_camera(depth_camera.camera);
  const Eigen::Vector3d& t = depth_camera.cam_from_depth_cam.t;
  view_ = {camera.fx, camera.fy, camera.cx, camera.cy, camera.width, camera.height, {t.x(), t.y(), t.z()}};
  corners_ = turned_corners(depth_camera);
}

CornerRow DepthRegistration::corners(int row) const {
  const std::size_t begin = static_cast<std::size_t>(row) * (width_ + 1);
  return {&corners_[0][begin], &corners_[1][begin], &corners_[2][begin]};
}

void DepthRegistration::patches_of_distorted(int row, const float* depth, const PatchRow& patches) const {
  const auto pixel_of = [&](const CornerRow& corner, int u, double z) {
    return camera_.project(
        {z * corner.x[u] + view_.t[0], z * corner.y[u] + view_.t[1], z * corner.z[u] + view_.t[2]});
  };
  const CornerRow upper = corners(row), lower = corners(row + 1);
  for (int u = 0; u < width_; ++u) {
    patches.left[u] = patches.right[u] = 0;
    if (!is_known_depth(depth[u])) continue;
    const double z = depth[u];
    patches.z[u] = static_cast<float>(0.5 * z * (upper.z[u] + lower.z[u + 1]) + view_.t[2]);
    const auto a = pixel_of(upper, u, z), b = pixel_of(lower, u + 1, z);
    if (!a || !b || !(patches.z[u] > 0)) continue;
    std::tie(patches.left[u], patches.right[u]) = covered(a->x(), b->x(), view_.width);
    std::tie(patches.top[u], patches.bottom[u]) = covered(a->y(), b->y(), view_.height);
  }
}

cv::Mat DepthRegistration::operator()(const cv::Mat& depth) const {
  check_image("depth", depth, CV_32F);
  check_image_size("depth", depth, width_, height_);
  cv::Mat registered(camera_.height, camera_.width, CV_32F, cv::Scalar(kUnknownDepth));
  std::vector<std::int32_t> bounds(4 * static_cast<std::size_t>(width_));
  std::vector<float> z(width_);
  const PatchRow patches{bounds.data(), bounds.data() + width_, bounds.data() + 2 * width_,
                         bounds.data() + 3 * width_, z.data()};
  const bool is_plain = camera_.model == CameraModel::kPinhole && !camera_.is_distorted();
  for (int v = 0; v < height_; ++v) {
    if (is_plain)
      patches_of_row(corners(v), corners(v + 1), depth.ptr<float>(v), width_, view_, patches);
    else
      patches_of_distorted(v, depth.ptr<float>(v), patches);
    for (int u = 0; u < width_; ++u)
      cover(registered, patches.left[u], patches.right[u], patches.top[u], patches.bottom[u], patches.z[u]);
  }
  return registered;
}

}  // namespace framewise
