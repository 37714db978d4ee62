// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>

#include "framewise/odometry/step.h"

namespace framewise {

// Where frames come from. load(i) may be called from any thread, once for each i; truth(i) likewise.
struct FrameSource {
  std::size_t size = 0;
  std::function<Frame(std::size_t)> load;
  std::function<std::optional<Pose>(std::size_t)> truth;  // world_from_cam; only asked for scale "truth"
};

struct StageSeconds {
  double load = 0, features = 0, step = 0;
};

// A frame's line in the answer.
struct FrameResult {
  std::size_t index = 0;
  double time = 0;
  Step step;            // from the frame before it, or from the last good one after a loss
  Pose world_from_cam;  // world = the first frame's camera
  StageSeconds seconds;
};

// Seconds of a steady clock; the library never reads one by itself.
using Clock = std::function<double()>;

// Runs over all frames in order and hands every one of them to `sink`, in order. Frames are loaded, described
// and related on options.threads threads; neither that number nor their timing changes the result. What load
// or sink throws comes out after all earlier frames have been handed over.
void run_odometry(const FrameSource& frames, const Camera& camera, const OdometryOptions& options,
                  const Clock& clock, const std::function<void(const FrameResult&)>& sink);

}  // namespace framewise
