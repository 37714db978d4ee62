// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What passes between the five-point solvers' doors and their kernels. No Eigen here: kernels are compiled
// for several instruction sets, and an Eigen compiled for two would be two different types of one name.
namespace framewise::five_point {

struct Points {
  double x1[5][3], x2[5][3];
};

// x2 = R x1 + t up to scale; R row-major, |t| = 1.
struct Motion {
  double R[3][3], t[3];
};

// The motions found, one of the four that share an essential matrix each; returns how many.
using Kernel = int(const Points& points, Motion (&motions)[10]);

// One program for every processor of a kind: the same source for the plain instruction set and for AVX2 with
// FMA.
namespace plain {
Kernel nister, stewenius;
}
#if defined(__x86_64__) && defined(__GNUC__)
#define FRAMEWISE_FIVE_POINT_AVX2
namespace avx2 {
Kernel nister, stewenius;
}
#endif

}  // namespace framewise::five_point
