// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace framewise {

// What others reported of a method on a recording, in the names of our options.
struct PublishedFigures {
  std::string sequence;
  std::string solver, scale, error;                         // as --solver, --scale and --error have them
  std::string features;                                     // detector and descriptor, in capitals
  std::optional<double> ate;                                // RMSE (m)
  std::optional<double> rpe_translation, rpe_rotation_deg;  // RMSE (m, degrees)
  std::string outcome;                                      // ok, or why there are no figures
};

// Reads a table with the columns sequence, solver, translation, ransac_error, feature, ate_rmse_m,
// rpe_trans_rmse_m, rpe_rot_rmse_deg, outcome. Of the column translation `first-pair-scale` is our scale
// first-pair and `full-3d` our depth; other names are taken as they are. Throws InputError.
std::vector<PublishedFigures> read_published_figures(const std::filesystem::path& path);

// Whether a data set's name says that it is of this sequence: it contains the sequence's name, capitals or
// not, where the TUM benchmark's freiburg1, 2, 3 may be fr1, 2, 3.
bool is_of_sequence(const std::string& dataset, const std::string& sequence);

}  // namespace framewise
