// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/geometry/depth_noise.h"

#include <stdexcept>
#include <string>

namespace framewise {
namespace {

void check_field(const char* name, double value, bool valid, const char* expected) {
  if (!valid)
    throw std::invalid_argument(std::string("DepthNoise::") + name + " is " + std::to_string(value) +
                                ", expected " + expected);
}

}  // namespace

void DepthNoise::check() const {
  check_field("floor", floor, floor > 0 && floor < 1e3, "a positive length (m)");
  check_field("growth", growth, growth >= 0 && growth < 1e3, "0 or more (1/m)");
  check_field("nearest", nearest, nearest >= 0 && nearest < 1e3, "0 or more (m)");
}

Eigen::Matrix3d point_covariance(const Eigen::Vector3d& x, double z, double image_sigma, double depth_sigma) {
  const Eigen::Vector3d ray = x / x.z();
  const double across = z * image_sigma;
  Eigen::Matrix3d S = (depth_sigma * depth_sigma) * ray * ray.transpose();
  S(0, 0) += across * across;
  S(1, 1) += across * across;
  return S;
}

}  // namespace framewise
