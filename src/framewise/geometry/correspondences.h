// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "framewise/geometry/pose.h"

namespace framewise {

// What two frames both saw: entry i of every vector is the same thing, and all have the same length.
struct Correspondences {
  std::vector<Eigen::Vector2d> pixels1, pixels2;  // to fractions of a pixel; (0, 0) is a pixel's centre
  std::vector<Bearing> x1, x2;                    // unit length, lens distortion taken out
  std::vector<double> z1, z2;                     // depth along the optical axis (m); NaN where unknown
  std::vector<double> sigma1, sigma2;             // noise of each coordinate of a position (pixels / fx: rad)
  std::vector<float> distance;                    // of the descriptors: bits or Euclidean
  bool has_depth = false;                         // both frames came with a depth image, known here or not

  std::size_t size() const { return x1.size(); }
};

}  // namespace framewise
