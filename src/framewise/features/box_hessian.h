// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>

namespace framewise {

// sums[y * stride + x]: sum of the pixels above row y and left of column x, modulo 2^32.
struct Sums {
  const std::uint32_t* data;
  std::ptrdiff_t stride;
};

// Second derivatives by box filters, per pixel of the filter (Bay et al. 2008, Figure 2).
struct BoxDerivatives {
  float xx, yy, xy;
};

// filter: side of the filters, 9, 15, 21, ... pixels; (x, y): the pixel at their centre, at least filter / 2
// from the border.
BoxDerivatives box_derivatives(Sums sums, int filter, int x, int y);

// Determinant of the Hessian, Dxx Dyy - (0.9 Dxy)^2 (Bay et al. 2008, Eq. (3)), at the pixels x, x + step,
// ... x + (n - 1) step of row y. step: 1, 2, 4 or 8. The instructions used are chosen when the program runs;
// the answer is the same with all of them.
void box_hessian_row(Sums sums, int filter, int x, int y, int step, int n, float* determinants);

}  // namespace framewise
