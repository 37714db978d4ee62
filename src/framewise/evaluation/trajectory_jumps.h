// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "framewise/geometry/trajectory.h"

namespace framewise {

// Where a trajectory leaps, as two runs in one file make it: the indices i for which the way from pose i - 1
// to pose i is longer than 0.5 m (or turns by more than 30 degrees) and ten times as fast as the steps before
// and after it.
std::vector<std::size_t> find_jumps(const Trajectory& trajectory);

}  // namespace framewise
