// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include "framewise/report/comparison_report.h"

namespace framewise::apps {

// Whether a folder is what `compare` leaves.
bool is_comparison_folder(const std::filesystem::path& folder);

// Reads what `compare` left. Throws InputError where results.json cannot be used; of the rest what is missing
// is said in `missing`.
ComparisonReport read_comparison(const std::filesystem::path& folder);

}  // namespace framewise::apps
