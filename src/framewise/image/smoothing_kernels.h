// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace framewise {

// The loops under InverseDepthSmoothing, a row at a time. The instructions used are chosen when the program
// runs; every sum has a fixed order, so the answer is the same to the bit with all of them.
// No OpenCV and no Eigen here: code compiled for newer processors must not leak into shared inline functions.

// value = centre = 1 / depth and weight = 1 where the depth is a positive number, else all 0.
void invert_depths(const float* depth, int width, float* value, float* centre, std::uint16_t* weight);

// sum[u] = rows[0][u] + ... + rows[count - 1][u]. Rows may overlap each other, none overlaps the sum.
void sum_rows(const float* const* rows, int count, int width, float* sum);
void sum_rows(const std::uint16_t* const* rows, int count, int width, std::uint16_t* sum);

// prefix += added (= added where `first`), sum = prefix + suffix.
void grow_window(const float* added, const float* suffix, bool first, int width, float* prefix, float* sum);
void grow_window(const std::int32_t* added, const std::int32_t* suffix, bool first, int width,
                 std::int32_t* prefix, std::int32_t* sum);

// row += other
void add_row(const float* other, int width, float* row);
void add_row(const std::int32_t* other, int width, std::int32_t* row);

void widen(const std::uint16_t* narrow, int width, std::int32_t* wide);

// value / weight where the pixel itself is known (centre > 0) or the weight is at least `enough`, else NaN.
void normalise(const float* value, const std::int32_t* weight, const float* centre, std::int32_t enough,
               int width, float* out);

}  // namespace framewise
