// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace framewise {

// How far off a place in an image may be: its covariance is sigma^2 shape. A patch of an edge or of a striped
// floor is certain across the stripes and says nothing along them.
struct PlaceNoise {
  double sigma = 1;                                     // root mean square of both directions
  Eigen::Matrix2d shape = Eigen::Matrix2d::Identity();  // of trace 2

  // None at all where the covariance is zero, or less by rounding.
  static PlaceNoise of(const Eigen::Matrix2d& covariance);
  // The same place in other units.
  PlaceNoise operator*(double factor) const { return {sigma * factor, shape}; }
  PlaceNoise operator/(double divisor) const { return {sigma / divisor, shape}; }
  Eigen::Matrix2d covariance() const { return sigma * sigma * shape; }
  // Where no direction is surer than `least`.
  PlaceNoise at_least(double least) const;
  // Of the surest direction.
  double least() const;
  // W with W' W = covariance^-1.
  Eigen::Matrix2d whitening() const;
};

}  // namespace framewise
