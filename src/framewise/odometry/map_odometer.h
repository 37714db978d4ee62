// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <vector>

#include "framewise/odometry/odometer.h"

namespace framewise {

// The default odometer (options.reference "map"): every frame against a local map of the frames before. As
// run_odometry, hands every frame to the sink in order, each with its pose as it was known when the frame
// came; returns world_from_cam of all frames as they are known in the end. The result does not depend on the
// number of threads. Of the options those of the features, of depth and of `map` are used, ransac, threads
// and seed. taps.pair gets what each frame sees of the map, beside where the frame before would see it.
std::vector<Pose> run_map_odometry(const FrameSource& frames, const Camera& camera,
                                   const OdometryOptions& options, const Clock& clock,
                                   const std::function<void(const FrameResult&)>& sink,
                                   const OdometryTaps& taps = {});

}  // namespace framewise
