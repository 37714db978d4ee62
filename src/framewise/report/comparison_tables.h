// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "framewise/report/comparison.h"
#include "framewise/report/table.h"

namespace framewise {

// For each data set three tables: the errors, the differences to the best row, and the times. A cell without
// a number says why, at length in a note.
std::vector<Table> comparison_tables(const Comparison& comparison);

// The tables as documents.
std::string comparison_markdown(const Comparison& comparison);
std::string comparison_latex(const Comparison& comparison);

}  // namespace framewise
