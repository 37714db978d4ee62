// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#define FRAMEWISE_ISA plain
#include "framewise/solvers/relpose_5pt_stewenius_kernel.h"

namespace framewise::five_point::plain {

int stewenius(const Points& points, Motion (&motions)[10]) { return solve_stewenius(points, motions); }

}  // namespace framewise::five_point::plain
