// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>

#include "framewise/geometry/pose.h"

namespace framewise {

// pinhole: OpenCV's pinhole with radial and tangential distortion. With (x, y) = (X / Z, Y / Z), r2 = x^2 +
// y^2:
//   x' = x (1 + k1 r2 + k2 r2^2 + k3 r2^3) + 2 p1 x y + p2 (r2 + 2 x^2)
//   y' = y (1 + k1 r2 + k2 r2^2 + k3 r2^3) + p1 (r2 + 2 y^2) + 2 p2 x y
//   Brown, Close-range camera calibration, 1971.
// fisheye: OpenCV's fisheye (Kalibr's equidistant), theta the angle to the axis, phi the angle about it:
//   (x', y') = (cos phi, sin phi) theta (1 + k1 theta^2 + k2 theta^4 + k3 theta^6 + k4 theta^8)
//   Kannala, Brandt, A generic camera model and calibration method, PAMI 2006, Eq. (6).
// Both: u = fx x' + cx, v = fy y' + cy.
// equirectangular: columns are even in azimuth over 360 degrees, the middle of the image looks along +z and
// azimuth grows to the right; rows are even in the polar angle from straight up (-y), theta_range[0] at the
// upper edge of the image and theta_range[1] at the lower.
enum class CameraModel { kPinhole, kFisheye, kEquirectangular };

const char* name_of(CameraModel model);
std::optional<CameraModel> camera_model_from_name(std::string_view name);

// Pixel (0, 0) is the centre of the first pixel: the image covers [-0.5, width - 0.5) x [-0.5, height - 0.5).
struct Camera {
  CameraModel model = CameraModel::kPinhole;
  int width = 0;
  int height = 0;
  // Pixels. fy is negative in images that are upside down to the camera's axes (ICL-NUIM).
  double fx = 0, fy = 0, cx = 0, cy = 0;
  // pinhole: k1 k2 p1 p2 k3. fisheye: k1 k2 k3 k4, the fifth stays 0.
  std::array<double, 5> distortion{};
  // equirectangular only (rad).
  std::array<double, 2> theta_range{0, M_PI};

  // The pixel of a point, inside the image or not. Empty where the model sees nothing: behind a pinhole, at
  // the centre, and beyond the angle where the distortion polynomial folds the image back.
  std::optional<Eigen::Vector2d> project(const Eigen::Vector3d& x_in_cam) const;

  // d project / d x_in_cam (pixels per metre); empty where project is.
  std::optional<Eigen::Matrix<double, 2, 3>> project_jacobian(const Eigen::Vector3d& x_in_cam) const;

  // The unit vector that projects to the pixel, to machine precision. Empty where there is none.
  std::optional<Bearing> bearing(const Eigen::Vector2d& pixel) const;

  bool contains(const Eigen::Vector2d& pixel) const {
    return pixel.x() >= -0.5 && pixel.y() >= -0.5 && pixel.x() < width - 0.5 && pixel.y() < height - 0.5;
  }

  bool is_distorted() const { return distortion != std::array<double, 5>{}; }

  // Throws std::invalid_argument naming the field that makes no camera, what it is and what was expected.
  void check() const;
};

}  // namespace framewise
