// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/geometry/camera.h"

#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>

namespace framewise {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Jacobian = Eigen::Matrix<double, 2, 3>;

// f(s) = 1 + c1 s + c2 s^2 + c3 s^3 + c4 s^4, s a squared radius or angle: what the distortion multiplies by.
struct RadialPolynomial {
  double c1 = 0, c2 = 0, c3 = 0, c4 = 0;

  double value(double s) const { return 1 + s * (c1 + s * (c2 + s * (c3 + s * c4))); }
  double derivative(double s) const { return c1 + s * (2 * c2 + s * (3 * c3 + s * 4 * c4)); }
  // d (r f(r^2)) / dr
  double growth(double s) const { return 1 + s * (3 * c1 + s * (5 * c2 + s * (7 * c3 + s * 9 * c4))); }

  // Whether r f(r^2) grows all the way from the centre to r^2 = s; beyond a fold two rays share a pixel.
  bool grows_until(double s) const {
    constexpr int kSteps = 16;
    for (int i = 1; i <= kSteps; ++i)
      if (!(growth(s * i / kSteps) > 0)) return false;
    return true;
  }
};

RadialPolynomial brown_polynomial(const Camera& camera) {
  const auto& d = camera.distortion;
  return {d[0], d[1], d[4], 0};
}

RadialPolynomial fisheye_polynomial(const Camera& camera) {
  const auto& d = camera.distortion;
  return {d[0], d[1], d[2], d[3]};
}

struct Distorted {
  Vector2d x;
  Matrix2d J;  // d distorted / d undistorted
};

Distorted brown(const Camera& camera, const Vector2d& x) {
  const RadialPolynomial f = brown_polynomial(camera);
  const double p1 = camera.distortion[2], p2 = camera.distortion[3];
  const double r2 = x.squaredNorm(), xy = x.x() * x.y();
  const Vector2d tangential(2 * p1 * xy + p2 * (r2 + 2 * x.x() * x.x()),
                            p1 * (r2 + 2 * x.y() * x.y()) + 2 * p2 * xy);
  Matrix2d J_tangential;
  J_tangential << 2 * p1 * x.y() + 6 * p2 * x.x(), 2 * p1 * x.x() + 2 * p2 * x.y(),  //
      2 * p1 * x.x() + 2 * p2 * x.y(), 6 * p1 * x.y() + 2 * p2 * x.x();
  return {f.value(r2) * x + tangential,
          f.value(r2) * Matrix2d::Identity() + 2 * f.derivative(r2) * x * x.transpose() + J_tangential};
}

// Newton from the distorted point itself. The residual is squared every step; it has converged when it no
// longer falls and is at rounding level.
std::optional<Vector2d> undistort_brown(const Camera& camera, const Vector2d& distorted) {
  const double rounding = 8 * std::numeric_limits<double>::epsilon() * (1 + distorted.norm());
  Vector2d x = distorted, best = x;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 30; ++i) {
    const Distorted at = brown(camera, x);
    const Vector2d residual = at.x - distorted;
    const double size = residual.norm();
    if (size < least) {
      least = size;
      best = x;
    } else if (least <= rounding) {
      break;
    }
    if (size == 0) break;
    x -= at.J.inverse() * residual;
  }
  if (!(least <= rounding) || !brown_polynomial(camera).grows_until(best.squaredNorm()) ||
      !(brown(camera, best).J.determinant() > 0))
    return std::nullopt;
  return best;
}

// theta f(theta^2) = r for theta in [0, pi].
std::optional<double> undistort_fisheye(const RadialPolynomial& f, double r) {
  const double rounding = 8 * std::numeric_limits<double>::epsilon() * (1 + r);
  double theta = r, best = r;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 30; ++i) {
    const double residual = theta * f.value(theta * theta) - r;
    if (std::abs(residual) < least) {
      least = std::abs(residual);
      best = theta;
    } else if (least <= rounding) {
      break;
    }
    if (residual == 0) break;
    theta -= residual / f.growth(theta * theta);
  }
  if (!(least <= rounding) || best < 0 || best > M_PI || !f.grows_until(best * best)) return std::nullopt;
  return best;
}

double azimuth_per_column(const Camera& camera) { return 2 * M_PI / camera.width; }
double theta_per_row(const Camera& camera) {
  return (camera.theta_range[1] - camera.theta_range[0]) / camera.height;
}

std::optional<Vector2d> project_pinhole(const Camera& camera, const Vector3d& X) {
  if (!(X.z() > 0)) return std::nullopt;
  Vector2d x = X.head<2>() / X.z();
  if (camera.is_distorted()) {
    if (!brown_polynomial(camera).grows_until(x.squaredNorm())) return std::nullopt;
    x = brown(camera, x).x;
  }
  return Vector2d(camera.fx * x.x() + camera.cx, camera.fy * x.y() + camera.cy);
}

Jacobian pinhole_jacobian(const Camera& camera, const Vector3d& X) {
  const Vector2d x = X.head<2>() / X.z();
  Jacobian J;
  J << 1, 0, -x.x(), 0, 1, -x.y();
  return Vector2d(camera.fx, camera.fy).asDiagonal() * brown(camera, x).J * J / X.z();
}

std::optional<Vector2d> project_fisheye(const Camera& camera, const Vector3d& X) {
  const double rho = X.head<2>().norm(), theta = std::atan2(rho, X.z());
  const RadialPolynomial f = fisheye_polynomial(camera);
  // Straight behind, every direction about the axis is as good.
  if (!(X.squaredNorm() > 0) || (rho == 0 && X.z() < 0) || !f.grows_until(theta * theta)) return std::nullopt;
  const Vector2d x = rho == 0 ? Vector2d(0, 0) : Vector2d(theta * f.value(theta * theta) / rho * X.head<2>());
  return Vector2d(camera.fx * x.x() + camera.cx, camera.fy * x.y() + camera.cy);
}

Jacobian fisheye_jacobian(const Camera& camera, const Vector3d& X) {
  const double rho2 = X.head<2>().squaredNorm(), rho = std::sqrt(rho2), theta = std::atan2(rho, X.z());
  const RadialPolynomial f = fisheye_polynomial(camera);
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
  const auto x = camera.is_distorted() ? undistort_brown(camera, distorted) : distorted;
  if (!x || !x->allFinite()) return std::nullopt;
  return x->homogeneous().normalized();
}

std::optional<Bearing> bearing_fisheye(const Camera& camera, const Vector2d& distorted) {
  const double r = distorted.norm();
  const auto theta = undistort_fisheye(fisheye_polynomial(camera), r);
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
  if (camera.model == CameraModel::fisheye && camera.distortion[4] != 0)
    refuse("distortion[4]", camera.distortion[4], "4 coefficients for a fisheye");
}

void check_theta_range(const std::array<double, 2>& range) {
  if (!(range[0] >= 0 && range[0] < M_PI)) refuse("theta_range[0]", range[0], "an angle from 0 to pi");
  // A range written as 180 degrees may round to just above pi.
  if (!(range[1] > range[0] && range[1] <= M_PI + 1e-9))
    refuse("theta_range[1]", range[1], "an angle above theta_range[0], at most pi");
}

}  // namespace

const char* name_of(CameraModel model) {
  switch (model) {
    case CameraModel::pinhole:
      return "pinhole";
    case CameraModel::fisheye:
      return "fisheye";
    case CameraModel::equirectangular:
      return "equirectangular";
  }
  throw std::invalid_argument("camera: model is no member of CameraModel");
}

std::optional<Vector2d> Camera::project(const Vector3d& x_in_cam) const {
  if (!x_in_cam.allFinite()) return std::nullopt;
  if (model == CameraModel::pinhole) return project_pinhole(*this, x_in_cam);
  if (model == CameraModel::fisheye) return project_fisheye(*this, x_in_cam);
  return project_equirectangular(*this, x_in_cam);
}

std::optional<Jacobian> Camera::project_jacobian(const Vector3d& x_in_cam) const {
  if (!project(x_in_cam)) return std::nullopt;
  if (model == CameraModel::pinhole) return pinhole_jacobian(*this, x_in_cam);
  if (model == CameraModel::fisheye) return fisheye_jacobian(*this, x_in_cam);
  return equirectangular_jacobian(*this, x_in_cam);
}

std::optional<Bearing> Camera::bearing(const Vector2d& pixel) const {
  if (model == CameraModel::equirectangular) return bearing_equirectangular(*this, pixel);
  const Vector2d distorted((pixel.x() - cx) / fx, (pixel.y() - cy) / fy);
  if (!distorted.allFinite()) return std::nullopt;
  if (model == CameraModel::pinhole) return bearing_pinhole(*this, distorted);
  return bearing_fisheye(*this, distorted);
}

void Camera::check() const {
  if (width <= 0) refuse("width", width, "a positive number of pixels");
  if (height <= 0) refuse("height", height, "a positive number of pixels");
  if (model == CameraModel::equirectangular)
    check_theta_range(theta_range);
  else
    check_lens(*this);
}

}  // namespace framewise
