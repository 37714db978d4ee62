// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>

#include "framewise/evaluation/evaluation.h"
#include "framewise/odometry/odometer.h"
#include "recording.h"

namespace framewise::apps {

// What is counted while frames come in.
struct Tally {
  std::size_t frames = 0;
  std::array<std::size_t, kAllStatuses.size()> by_status{};
  StageSeconds seconds;
  double iterations = 0, iterations_theory = 0;  // of RANSAC, over all steps
  std::size_t steps = 0;                         // with a motion
  std::size_t missing_pairs = 0;                 // asked of an archive that does not hold them
  bool has_moved = false;                        // some step had a translation
  Trajectory trajectory;

  void add(const FrameResult& result) {
    ++frames;
    ++by_status[static_cast<std::size_t>(result.step.status)];
    seconds.load += result.seconds.load;
    seconds.features += result.seconds.features;
    seconds.match += result.seconds.match;
    seconds.step += result.seconds.step;
    iterations += result.step.iterations;
    iterations_theory += result.step.iterations_theory;
    steps += result.step.iterations > 0;
    has_moved |= is_measured(result.step.status) && result.step.cam2_from_cam1.t.norm() > 0;
    trajectory.add(result.time, result.world_from_cam);
  }

  // Frames whose motion was measured; the first has none to measure.
  std::size_t measured() const {
    std::size_t count = 0;
    for (const Status status : kAllStatuses)
      if (is_measured(status)) count += by_status[static_cast<std::size_t>(status)];
    return count;
  }
};

// Against the truth at the frames' own times. Steps of no known length are judged up to one scale.
std::optional<Evaluation> evaluate_run(const Recording& recording, const OdometryOptions& odometry,
                                       const Trajectory& estimate);

// Whether later frames moved any pose: more than 1e-9 m, or than 1e-9 in an entry of its rotation.
bool has_moved(const Trajectory& causal, const Trajectory& final);

// run.json.
nlohmann::ordered_json run_record(const Recording& recording, const nlohmann::ordered_json& options,
                                  const Tally& tally, double seconds,
                                  const std::optional<Evaluation>& evaluation);

// final_evaluation: of the trajectory as it is known in the end, where later frames moved poses.
void print_summary(const nlohmann::ordered_json& run, const std::optional<Evaluation>& evaluation,
                   const std::optional<Evaluation>& final_evaluation, const std::filesystem::path& out,
                   bool has_report);

}  // namespace framewise::apps
