// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <map>
#include <vector>

#include "compare_work.h"
#include "framewise/io/published_tables.h"
#include "framewise/report/comparison.h"

namespace framewise::apps {

// Reads back what the processes wrote, judges every trajectory by truth.tum of its data set, and compares the
// rows of a data set. The images are not needed.
void fill_comparison(Comparison& comparison, const ComparePlan& plan,
                     const std::map<std::filesystem::path, JobOutcome>& outcomes,
                     const std::vector<PublishedFigures>& published);

}  // namespace framewise::apps
