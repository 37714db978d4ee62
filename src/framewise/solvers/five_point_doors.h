// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>

#include "framewise/geometry/pose.h"
#include "framewise/solvers/five_point_types.h"
#include "framewise/solvers/hypotheses.h"

// From a five-point kernel's motions to what its doors return.
namespace framewise::five_point {

using Bearings5 = std::array<Bearing, 5>;

// The kernel for the processor this runs on.
inline Kernel* for_this_processor(Kernel* plain, [[maybe_unused]] Kernel* avx2) {
#ifdef FRAMEWISE_FIVE_POINT_AVX2
  static const bool has_avx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
  if (has_avx2) return avx2;
#endif
  return plain;
}

// [t]x R, |t| = 1, of each motion.
Hypotheses<Eigen::Matrix3d, 10> essential_matrices(Kernel* kernel, const Bearings5& x1, const Bearings5& x2);

// Of each motion's four versions the one with all five points in front of both cameras, if there is one.
// Where bearings have no parallax beyond rounding they lie in front for want of the contrary.
Hypotheses<Pose, 10> poses(Kernel* kernel, const Bearings5& x1, const Bearings5& x2);

}  // namespace framewise::five_point
