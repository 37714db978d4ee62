// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>
#include <string_view>

#include "framewise/geometry/pose.h"

namespace framewise {

// A frame as `run` writes it down.
struct FrameLine {
  std::size_t index = 0;
  double time = 0;  // s
  std::string_view status;
  int matches = 0, inliers = 0;
  Pose cam1_from_cam2;  // the step: the newer camera seen from the older
  bool has_step = false;
  // Of the step's tangent (rotation, translation), rad and m; NaN where it is not known.
  Matrix6d covariance = Matrix6d::Constant(std::numeric_limits<double>::quiet_NaN());
  Pose world_from_cam;
  double load_ms = 0, features_ms = 0, match_ms = 0, step_ms = 0, refine_ms = 0;
  double parallax_deg = 0;  // median over the inliers of the angle between R x1 and x2; NaN without a motion
  double overlap = std::numeric_limits<double>::quiet_NaN();  // of surfaces; NaN: none were aligned
  std::string input;                                          // image that features were looked for in
  std::string free_directions;                                // that surfaces leave, and that were foretold
};

// Writes trajectory.tum and frames.csv line by line, so that what was computed survives a failure.
class RunFiles {
 public:
  // Creates the folder. Throws InputError when it cannot be written.
  explicit RunFiles(const std::filesystem::path& folder);

  void add(const FrameLine& line);

  // Writes run.json, whole or not at all; what was added before is then on the disk as well.
  void write_record(const std::string& json);

 private:
  std::filesystem::path folder_;
  std::ofstream trajectory_, frames_;
};

}  // namespace framewise
