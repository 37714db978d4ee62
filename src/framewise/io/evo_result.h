// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "framewise/geometry/trajectory.h"

namespace framewise {

// Errors of one kind as evo keeps them in the zip file of its --save_results, for evo_res and
// evo.tools.file_interface.load_res_file to open.
struct EvoResult {
  std::string title, label;                   // over the figures; beside their axis
  std::string reference_name, estimate_name;  // file names; evo calls the column by the estimate's
  std::vector<std::pair<std::string, double>> statistics;  // rmse, mean, median, std, min, max, sse
  std::vector<double> errors;

  // The poses the errors stand at, aligned; both with the estimate's stamps (s). Of relative errors one more,
  // in front: the first pose of the trajectory.
  Trajectory reference, estimate;
  bool has_times = true;                     // false: poses are written as KITTI has them
  std::optional<Eigen::Matrix4d> alignment;  // reference_from_estimate, scale included; unset: not aligned
};

// info.json, stats.json, the arrays error_array, timestamps, seconds_from_start (s), distances_from_start and
// distances (m; travelled by the reference and by the estimate), alignment_transformation_sim3 (.npy), and
// both trajectories. A pure function of its arguments, to the byte.
// Throws InputError where the file cannot be written (`option`: what the user chose it by), and
// std::invalid_argument unless the trajectories are as long as each other and hold one pose for each error or
// one more.
void write_evo_result(const std::filesystem::path& path, const EvoResult& result, const char* option);

}  // namespace framewise
