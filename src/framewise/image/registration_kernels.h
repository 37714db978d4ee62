// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace framewise {

// The loop under DepthRegistration, a row at a time. The instructions used are chosen when the program runs;
// the answer is the same to the bit with all of them. No OpenCV and no Eigen here: code compiled for newer
// processors must not leak into shared inline functions.

// A row of rays through corners of pixels, turned into the axes of the camera; width + 1 of them. NaN where
// there is none.
struct CornerRow {
  const double *x, *y, *z;
};

// A pinhole camera without distortion, and where the depth camera stands in it (m).
struct PatchView {
  double fx, fy, cx, cy;  // px
  int width, height;      // px
  double t[3];
};

// For each pixel of a row the pixels that its patch covers: columns [left, right) and rows [top, bottom),
// none where left == right.
struct PatchRow {
  std::int32_t *left, *right, *top, *bottom;
  float* z;  // in the camera (m)
};

// Patches of at most this many pixels along a side; wider ones cover none.
constexpr double kWidestPatch_px = 32;

// upper and lower: the corners above and below the row's pixels. depth: z, unknown where NaN, infinite or not
// above 0.
void patches_of_row(const CornerRow& upper, const CornerRow& lower, const float* depth, int width,
                    const PatchView& view, const PatchRow& patches);

}  // namespace framewise
