// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "framewise/report/comparison.h"
#include "framewise/report/table.h"

namespace framewise {

// All rows with all figures, a column for each, for programs: medians and quartiles, numbers in full. Where
// there is no number a word or two say why, and the last column says it at length.
Table comparison_csv_table(const Comparison& comparison);

}  // namespace framewise
