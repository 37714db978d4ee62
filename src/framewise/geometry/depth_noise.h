// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace framewise {

// Standard deviation of a depth camera's z (m): sigma_z = floor + growth (z - nearest)^2. The defaults are a
// structured-light camera's. Nguyen, Izadi, Lovell, Modeling Kinect Sensor Noise, 3DIMPVT 2012.
struct DepthNoise {
  double floor = 0.0012;   // m
  double growth = 0.0019;  // 1/m
  double nearest = 0.4;    // m

  double sigma(double z) const { return floor + growth * (z - nearest) * (z - nearest); }

  // Throws std::invalid_argument naming the field that makes no sense.
  void check() const;
};

// The point seen along x (x.z > 0) at depth z along the optical axis.
inline Eigen::Vector3d point_at_depth(const Eigen::Vector3d& x, double z) { return (z / x.z()) * x; }

// Its covariance (m^2), first order, where both coordinates x / x.z carry noise image_sigma (pixels over
// focal length) and z carries depth_sigma (m), all independent.
Eigen::Matrix3d point_covariance(const Eigen::Vector3d& x, double z, double image_sigma, double depth_sigma);

}  // namespace framewise
