// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "framewise/solvers/problems_for_tests.h"

namespace framewise::testing {

constexpr double kPixel = 1.0 / 525;

// Noise of `noise` (pixels over focal length) on the plane z = 1 of both views; the first `wrong` bearings of
// the second view point anywhere in the image. Points X2 follow their bearings at the depth they had.
inline TwoViewProblem make_noisy_problem(Scene scene, std::size_t size, std::size_t wrong, double noise,
                                         Random& random) {
  TwoViewProblem p = make_problem(scene, size, random);
  const auto shaken = [&](const Eigen::Vector3d& X) {
    return Bearing(X.x() / X.z() + noise * random.normal(), X.y() / X.z() + noise * random.normal(), 1);
  };
  for (std::size_t i = 0; i < size; ++i) {
    const Bearing a = shaken(p.X1[i]);
    const Bearing anywhere(random.uniform(-0.61, 0.61), random.uniform(-0.457, 0.457), 1);
    const Bearing b = i < wrong ? anywhere : shaken(p.X2[i]);
    p.X1[i] = p.X1[i].z() * a;
    p.X2[i] = p.X2[i].z() * b;
    p.x1[i] = a.normalized();
    p.x2[i] = b.normalized();
  }
  return p;
}

// The larger of rotation and translation-direction error (deg).
inline double motion_error_deg(const Pose& pose, const Pose& truth) {
  return 180 / M_PI * std::max(rotation_error(pose.R, truth.R), direction_error(pose.t, truth.t));
}

}  // namespace framewise::testing
