// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "framewise/features/matching_neighbours.h"

namespace framewise {

// Exact nearest neighbours by looking at every pair; those of set2 where both_ways.
Neighbours exact_neighbours(const DescriptorPair& pair, bool both_ways, Instructions instructions);

}  // namespace framewise
