// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include "framewise/report/run_report.h"

namespace framewise::apps {

// Whether a folder is what `run` leaves, or began to leave.
bool is_run_folder(const std::filesystem::path& folder);

// Reads what `run` left. What is not there or cannot be used is said in `missing`, and the rest is read.
RunReport read_run(const std::filesystem::path& folder);

}  // namespace framewise::apps
