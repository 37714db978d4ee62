// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>

namespace framewise {

// The two distortion models of Camera, on the image plane at distance 1 (camera.h has their equations).
// Coefficients in Camera's order.
using DistortionCoefficients = std::array<double, 5>;

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

RadialPolynomial brown_polynomial(const DistortionCoefficients& coefficients);
RadialPolynomial fisheye_polynomial(const DistortionCoefficients& coefficients);

struct Distorted {
  Eigen::Vector2d x;
  Eigen::Matrix2d J;  // d distorted / d undistorted
};

Distorted distort_brown(const DistortionCoefficients& coefficients, const Eigen::Vector2d& x);

// The inverses, to machine precision. Empty where no point is distorted to this one, or only one beyond a
// fold.
std::optional<Eigen::Vector2d> undistort_brown(const DistortionCoefficients& coefficients,
                                               const Eigen::Vector2d& distorted);
// theta f(theta^2) = r for theta in [0, pi].
std::optional<double> undistort_fisheye(const DistortionCoefficients& coefficients, double r);

}  // namespace framewise
