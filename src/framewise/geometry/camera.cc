// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/geometry/camera.h"

#include <cmath>
#include <sstream>
#include <stdexcept>

#include "framewise/geometry/lens_distortion.h"

namespace framewise {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Jacobian = Eigen::Matrix<double, 2, 3>;

double azimuth_per_column(const Camera& camera) { return 2 * M_PI / camera.width; }
double theta_per_row(const Camera& camera) {
  return (camera.theta_range[1] - camera.theta_range[0]) / camera.height;
}

std::optional<Vector2d> project_pinhole(const Camera& camera, const Vector3d& X) {
  if (!(X.z() > 0)) return std::nullopt;
  Vector2d x = X.head<2>() / X.z();
  if (camera.is_distorted()) {
    if (!brown_polynomial(camera.distortion).grows_until(x.squaredNorm())) return std::nullopt;
    x = distort_brown(camera.distortion, x).x;
  }
  return Vector2d(camera.fx * x.x() + camera.cx, camera.fy * x.y() + camera.cy);
}

Jacobian pinhole_jacobian(const Camera& camera, const Vector3d& X) {
  const Vector2d x = X.head<2>() / X.z();
  Jacobian J;
  J << 1, 0, -x.x(), 0, 1, -x.y();
  return Vector2d(camera.fx, camera.fy).asDiagonal() * distort_brown(camera.distortion, x).J * J / X.z();
}

std::optional<Vector2d> project_fisheye(const Camera& camera, const Vector3d& X) {
  const double rho = X.head<2>().norm(), theta = std::atan2(rho, X.z());
  const RadialPolynomial f = fisheye_polynomial(camera.distortion);
  // Straight behind, every direction about the axis is as good.
  if (!(X.squaredNorm() > 0) || (rho == 0 && X.z() < 0) || !f.grows_until(theta * theta)) return std::nullopt;
  const Vector2d x = rho == 0 ? Vector2d(0, 0) : Vector2d(theta * f.value(theta * theta) / rho * X.head<2>());
  return Vector2d(camera.fx * x.x() + camera.cx, camera.fy * x.y() + camera.cy);
}

Jacobian fisheye_jacobian(const Camera& camera, const Vector3d& X) {
  const double rho2 = X.head<2>().squaredNorm(), rho = std::sqrt(rho2), theta = std::atan2(rho, X.z());
  const RadialPolynomial f = fisheye_polynomial(camera.distortion);
  Jacobian J;
  if (rho < 1e-9 * X.z()) {  // on the axis the model is a pinhole
    J << 1 / X.z(), 0, 0, 0, 1 / X.z(), 0;
  } else {
    const double r = theta * f.value(theta * theta), growth = f.growth(theta * theta);
    const Vector2d e = X.head<2>() / rho;
    const double range2 = X.squaredNorm();
    J.leftCols<2>() =
        growth * X.z() / range2 * e * e.transpose() + r / rho * (Matrix2d::Identity() - e * e.transpose());
    J.col(2) = -growth * rho / range2 * e;
  }
  return Vector2d(camera.fx, camera.fy).asDiagonal() * J;
}

std::optional<Vector2d> project_equirectangular(const Camera& camera, const Vector3d& X) {
  const double rho = std::hypot(X.x(), X.z());
  if (!(X.squaredNorm() > 0)) return std::nullopt;
  const double azimuth = std::atan2(X.x(), X.z()), theta = std::atan2(rho, -X.y());
  double u = azimuth / azimuth_per_column(camera) + 0.5 * camera.width - 0.5;
  if (u >= camera.width - 0.5) u -= camera.width;
  return Vector2d(u, (theta - camera.theta_range[0]) / theta_per_row(camera) - 0.5);
}

std::optional<Jacobian> equirectangular_jacobian(const Camera& camera, const Vector3d& X) {
  const double rho2 = X.x() * X.x() + X.z() * X.z(), rho = std::sqrt(rho2), range2 = X.squaredNorm();
  if (!(rho > 0)) return std::nullopt;  // straight up and down every azimuth is as good
  Jacobian J;
  J.row(0) << X.z() / rho2, 0, -X.x() / rho2;
  J.row(1) << -X.y() * X.x() / (rho * range2), rho / range2, -X.y() * X.z() / (rho * range2);
  return Vector2d(1 / azimuth_per_column(camera), 1 / theta_per_row(camera)).asDiagonal() * J;
}

std::optional<Bearing> bearing_pinhole(const Camera& camera, const Vector2d& distorted) {
  const auto x = camera.is_distorted() ? undistort_brown(camera.distortion, distorted) : distorted;
  if (!x || !x->allFinite()) return std::nullopt;
  return x->homogeneous().normalized();
}

std::optional<Bearing> bearing_fisheye(const Camera& camera, const Vector2d& distorted) {
  const double r = distorted.norm();
  const auto theta = undistort_fisheye(camera.distortion, r);
  if (!theta) return std::nullopt;
  const Vector2d e = r > 0 ? Vector2d(distorted / r) : Vector2d(0, 0);
  return Bearing(std::sin(*theta) * e.x(), std::sin(*theta) * e.y(), std::cos(*theta));
}

std::optional<Bearing> bearing_equirectangular(const Camera& camera, const Vector2d& pixel) {
  const double azimuth = (pixel.x() + 0.5 - 0.5 * camera.width) * azimuth_per_column(camera);
  const double theta = camera.theta_range[0] + (pixel.y() + 0.5) * theta_per_row(camera);
  if (!(theta >= 0 && theta <= M_PI) || !std::isfinite(azimuth)) return std::nullopt;
  return Bearing(std::sin(theta) * std::sin(azimuth), -std::cos(theta), std::sin(theta) * std::cos(azimuth));
}

[[noreturn]] void refuse(const char* field, double found, const char* expected) {
  std::ostringstream message;
  message << "camera: " << field << " is " << found << ", expected " << expected;
  throw std::invalid_argument(message.str());
}

void check_lens(const Camera& camera) {
  if (!(camera.fx > 0) || !std::isfinite(camera.fx)) refuse("fx", camera.fx, "a positive number of pixels");
  if (camera.fy == 0 || !std::isfinite(camera.fy)) refuse("fy", camera.fy, "a number of pixels other than 0");
  if (!std::isfinite(camera.cx)) refuse("cx", camera.cx, "a finite number of pixels");
  if (!std::isfinite(camera.cy)) refuse("cy", camera.cy, "a finite number of pixels");
  for (const double k : camera.distortion)
    if (!std::isfinite(k)) refuse("distortion", k, "finite coefficients");
  if (camera.model == CameraModel::kFisheye && camera.distortion[4] != 0)
    refuse("distortion[4]", camera.distortion[4], "4 coefficients for a fisheye");
}

void check_theta_range(const std::array<double, 2>& range) {
  if (!(range[0] >= 0 && range[0] < M_PI)) refuse("theta_range[0]", range[0], "an angle from 0 to pi");
  // A range written as 180 degrees may round to just above pi.
  if (!(range[1] > range[0] && range[1] <= M_PI + 1e-9))
    refuse("theta_range[1]", range[1], "an angle above theta_range[0], at most pi");
}

}  // namespace

std::optional<CameraModel> camera_model_from_name(std::string_view name) {
  for (const CameraModel model :
       {CameraModel::kPinhole, CameraModel::kFisheye, CameraModel::kEquirectangular})
    if (name == name_of(model)) return model;
  return std::nullopt;
}

const char* name_of(CameraModel model) {
  switch (model) {
    case CameraModel::kPinhole:
      return "pinhole";
    case CameraModel::kFisheye:
      return "fisheye";
    case CameraModel::kEquirectangular:
      return "equirectangular";
  }
  throw std::invalid_argument("camera: model is no member of CameraModel");
}

std::optional<Vector2d> Camera::project(const Vector3d& x_in_cam) const {
  if (!x_in_cam.allFinite()) return std::nullopt;
  if (model == CameraModel::kPinhole) return project_pinhole(*this, x_in_cam);
  if (model == CameraModel::kFisheye) return project_fisheye(*this, x_in_cam);
  return project_equirectangular(*this, x_in_cam);
}

std::optional<Jacobian> Camera::project_jacobian(const Vector3d& x_in_cam) const {
  if (!project(x_in_cam)) return std::nullopt;
  if (model == CameraModel::kPinhole) return pinhole_jacobian(*this, x_in_cam);
  if (model == CameraModel::kFisheye) return fisheye_jacobian(*this, x_in_cam);
  return equirectangular_jacobian(*this, x_in_cam);
}

std::optional<Bearing> Camera::bearing(const Vector2d& pixel) const {
  if (model == CameraModel::kEquirectangular) return bearing_equirectangular(*this, pixel);
  const Vector2d distorted((pixel.x() - cx) / fx, (pixel.y() - cy) / fy);
  if (!distorted.allFinite()) return std::nullopt;
  if (model == CameraModel::kPinhole) return bearing_pinhole(*this, distorted);
  return bearing_fisheye(*this, distorted);
}

void Camera::check() const {
  if (width <= 0) refuse("width", width, "a positive number of pixels");
  if (height <= 0) refuse("height", height, "a positive number of pixels");
  if (model == CameraModel::kEquirectangular)
    check_theta_range(theta_range);
  else
    check_lens(*this);
}

}  // namespace framewise
