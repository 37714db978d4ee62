// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

#include "framewise/io/dataset_parts.h"

namespace framewise {

// Lists of the TUM RGB-D benchmark, which several data sets have. Inside the room alone.

// associations.txt, association.txt or associate.txt; empty where there is none.
std::filesystem::path association_file(const std::filesystem::path& folder);

// Whether the folder's files say what its frames are: an association list, rgb.txt, or folders rgb and depth
// whose files are called by their stamps.
bool has_tum_layout(const std::filesystem::path& folder);

// Fills frames, unmatched_depth, times_source and fingerprint from those.
void read_tum_frames(Dataset& dataset, double max_time_difference);

// Fills truth from the file, where it exists.
void read_tum_truth(Dataset& dataset, const std::filesystem::path& file);

}  // namespace framewise
