// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <vector>

#include "framewise/odometry/map_tracker.h"
#include "framewise/odometry/odometer.h"

namespace framewise {

// What is known when all frames have come.
struct MapRun {
  std::vector<Pose> final_poses;  // world_from_cam of all frames
  LearnedCamera learned;
};

// The default odometer (options.reference "map"): every frame against a local map of the frames before. As
// run_odometry, hands every frame to the sink in order, each with its pose as it was known when the frame
// came. The result does not depend on the number of threads. Of the options those of the features, of depth
// and of `map` are used, ransac, threads and seed. taps.pair gets what each frame sees of the map, beside
// where the frame before would see it.
MapRun run_map_odometry(const FrameSource& frames, const Camera& camera, const OdometryOptions& options,
                        const Clock& clock, const std::function<void(const FrameResult&)>& sink,
                        const OdometryTaps& taps = {});

}  // namespace framewise
