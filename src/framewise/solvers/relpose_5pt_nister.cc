// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/solvers/relpose_5pt_nister.h"

#include "framewise/solvers/five_point_doors.h"

namespace framewise {
namespace {

five_point::Kernel* kernel() {
#ifdef FRAMEWISE_FIVE_POINT_AVX2
  return five_point::for_this_processor(five_point::plain::nister, five_point::avx2::nister);
#else
  return five_point::plain::nister;
#endif
}

}  // namespace

Hypotheses<Eigen::Matrix3d, 10> essential_5pt_nister(const std::array<Bearing, 5>& x1,
                                                     const std::array<Bearing, 5>& x2) {
  return five_point::essential_matrices(kernel(), x1, x2);
}

Hypotheses<Pose, 10> relpose_5pt_nister(const std::array<Bearing, 5>& x1, const std::array<Bearing, 5>& x2) {
  return five_point::poses(kernel(), x1, x2);
}

}  // namespace framewise
