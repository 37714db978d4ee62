// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "framewise/features/matching_blocks.h"

namespace framewise {

// Squared L2 distances of float descriptors, summed component by component in their order, in single
// precision, nothing fused: the same bits whatever the instructions.
BlockKernel l2_kernel(Instructions instructions);

// The same of descriptors whose components are whole numbers from 0 to 255, as SIFT's are:
//   |a - b|^2 = |a|^2 + |b|^2 - 2 a.b
// in integers. A cell holds two components, a row's last cell its |.|^2. Up to kMaxByteComponents the sums of
// l2_kernel are exact too, so both agree. Null where there are no instructions that make it quicker.
constexpr int kMaxByteComponents = (1 << 24) / (255 * 255);
BlockKernel l2_byte_kernel(Instructions instructions);

// As l2_kernel, of one descriptor to those rows that are listed. Rows begin `stride` floats apart.
void l2_to_listed(const float* descriptor, const float* rows, std::int64_t stride, int components,
                  const int* listed, int count, Key* keys);

}  // namespace framewise
