// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "framewise/features/matching_neighbours.h"

namespace framewise {

// Approximate nearest neighbours: OpenCV's FLANN, randomised KD-trees for float descriptors and
// locality-sensitive hashing for binary ones. What is random comes from options.seed alone.
Neighbours flann_neighbours(const DescriptorPair& pair, const MatchOptions& options);

}  // namespace framewise
