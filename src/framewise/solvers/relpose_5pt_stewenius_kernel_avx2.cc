// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause

// Everything shared with other sources comes first, compiled for the plain instruction set.
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "framewise/solvers/five_point_types.h"

#ifdef FRAMEWISE_FIVE_POINT_AVX2
#pragma GCC target("avx2,fma")
#define FRAMEWISE_ISA avx2
#include "framewise/solvers/relpose_5pt_stewenius_kernel.h"

namespace framewise::five_point::avx2 {

int stewenius(const Points& points, Motion (&motions)[10]) { return solve_stewenius(points, motions); }

}  // namespace framewise::five_point::avx2
#endif
