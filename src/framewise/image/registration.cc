// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/image/registration.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "framewise/image/depth.h"
#include "framewise/image/image_check.h"

namespace framewise {
namespace {

constexpr double kWidestPatch_px = 32;
constexpr double kNowhere = std::numeric_limits<double>::quiet_NaN();

void check_depth_camera(const Camera& camera) {
  camera.check();
  if (camera.model == CameraModel::kEquirectangular)
    throw std::invalid_argument("depth camera: model: found equirectangular, expected pinhole or fisheye");
}

cv::Mat rotated_corners(const DepthCamera& depth_camera) {
  const Camera& camera = depth_camera.camera;
  cv::Mat corners(camera.height + 1, camera.width + 1, CV_64FC3);
  for (int v = 0; v < corners.rows; ++v)
    for (int u = 0; u < corners.cols; ++u) {
      const auto bearing = camera.bearing({u - 0.5, v - 0.5});
      const bool forward = bearing && bearing->z() > 0;
      const Eigen::Vector3d ray =
          forward ? Eigen::Vector3d(depth_camera.cam_from_depth_cam.R * (*bearing / bearing->z()))
                  : Eigen::Vector3d::Constant(kNowhere);
      corners.at<cv::Vec3d>(v, u) = {ray.x(), ray.y(), ray.z()};
    }
  return corners;
}

struct Span {
  int begin, end;
};

// The whole numbers in [a, b), or [b, a), that are at least 0 and below size; none where the box is too wide.
Span covered(double a, double b, int size) {
  if (a > b) std::swap(a, b);
  if (!(b - a <= kWidestPatch_px) || !(b > 0) || !(a < size)) return {0, 0};
  return {std::max(0, static_cast<int>(std::ceil(a))), std::min(size, static_cast<int>(std::ceil(b)))};
}

}  // namespace

DepthRegistration::DepthRegistration(const Camera& camera, const DepthCamera& depth_camera)
    : camera_(camera),
      width_(depth_camera.camera.width),
      height_(depth_camera.camera.height),
      t_(depth_camera.cam_from_depth_cam.t) {
  camera.check();
  check_depth_camera(depth_camera.camera);
  corners_ = rotated_corners(depth_camera);
}

cv::Point2d DepthRegistration::project(const cv::Vec3d& corner, double z) const {
  const double X = z * corner[0] + t_.x(), Y = z * corner[1] + t_.y(), Z = z * corner[2] + t_.z();
  if (camera_.model == CameraModel::kPinhole && !camera_.is_distorted())
    return Z > 0 ? cv::Point2d(camera_.fx * X / Z + camera_.cx, camera_.fy * Y / Z + camera_.cy)
                 : cv::Point2d(kNowhere, kNowhere);
  const auto pixel = camera_.project({X, Y, Z});
  return pixel ? cv::Point2d(pixel->x(), pixel->y()) : cv::Point2d(kNowhere, kNowhere);
}

void DepthRegistration::cover(cv::Mat& registered, const cv::Vec3d& corner1, const cv::Vec3d& corner2,
                              double z) const {
  const float z_in_cam = static_cast<float>(0.5 * z * (corner1[2] + corner2[2]) + t_.z());
  if (!(z_in_cam > 0)) return;
  const cv::Point2d a = project(corner1, z), b = project(corner2, z);
  const Span columns = covered(a.x, b.x, registered.cols), rows = covered(a.y, b.y, registered.rows);
  for (int v = rows.begin; v < rows.end; ++v)
    for (int u = columns.begin; u < columns.end; ++u) {
      float& nearest = registered.at<float>(v, u);
      if (!(nearest <= z_in_cam)) nearest = z_in_cam;  // NaN is not nearer
    }
}

cv::Mat DepthRegistration::operator()(const cv::Mat& depth) const {
  check_image("depth", depth, CV_32F);
  check_image_size("depth", depth, width_, height_);
  cv::Mat registered(camera_.height, camera_.width, CV_32F, cv::Scalar(kUnknownDepth));
  for (int v = 0; v < height_; ++v)
    for (int u = 0; u < width_; ++u)
      if (const float z = depth.at<float>(v, u); is_known_depth(z))
        cover(registered, corners_.at<cv::Vec3d>(v, u), corners_.at<cv::Vec3d>(v + 1, u + 1), z);
  return registered;
}

}  // namespace framewise
