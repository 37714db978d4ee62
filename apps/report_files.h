// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace framewise::apps {

// Where a run or a comparison keeps what only its report needs, in its folder. Of a run: truth.tum,
// frames.json and a small JPEG for each frame that is kept; of a comparison: invocation.json.
inline constexpr const char* kReportData = "report_data";

// Writes a file, whole or not at all. Throws InputError where it cannot be opened and std::runtime_error
// where the disk is full.
void write_whole(const std::filesystem::path& path, const std::string& text, const char* option);

// Takes away report.html and what was kept for it: of an earlier run in the same folder.
void remove_report(const std::filesystem::path& folder);

// report.html in the folder of a run or a comparison; with `figures` its plots as SVG and PNG there. Throws
// InputError where the folder is neither.
void write_report(const std::filesystem::path& folder, const std::filesystem::path& figures = {});

}  // namespace framewise::apps
