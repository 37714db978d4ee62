// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>

#include "framewise/odometry/observation.h"
#include "framewise/odometry/step.h"

namespace framewise {

// What is known of a recording besides its images. All may be called from any thread.
struct PriorKnowledge {
  std::function<std::optional<Pose>(std::size_t)> truth;  // world_from_cam; only asked for scale "truth"
  // cam2_from_cam1 of two frames; only asked for solver "two-point".
  std::function<std::optional<Eigen::Matrix3d>(std::size_t index1, std::size_t index2)> rotation;
};

// Where frames come from. load(i) may be called from any thread, once for each i.
struct FrameSource {
  std::size_t size = 0;
  std::function<Frame(std::size_t)> load;
  PriorKnowledge known;
};

// Where correspondences come from that were found before. pair(i, j), i < j, may be called from any thread;
// it is asked for all neighbours and, after a loss, for the frames back to the last good one. Where it knows
// nothing of a pair, the later frame is lost. time: s.
struct PairSource {
  std::size_t size = 0;  // frames
  std::function<double(std::size_t)> time;
  std::function<std::optional<Correspondences>(std::size_t index1, std::size_t index2)> pair;
  PriorKnowledge known;
};

struct StageSeconds {
  double load = 0, features = 0, match = 0, step = 0, refine = 0;
};

// A frame's line in the answer.
struct FrameResult {
  std::size_t index = 0;
  double time = 0;
  Step step;            // from the frame before it, or from the last good one after a loss
  Pose world_from_cam;  // world = the first frame's camera
  StageSeconds seconds;
  std::string input;  // the image that features were looked for in (InputImage::chosen); empty: no images
};

// Seconds of a steady clock; the library never reads one by itself.
using Clock = std::function<double()>;

// What else can be had of a run from images: called in the order of the frames, before the frame's result is
// handed over, never two at a time. What they throw comes out like what the sink throws.
struct OdometryTaps {
  std::function<void(std::size_t index, const Features&)> features;
  // Every pair that was matched: (index - 1, index), and after a loss (last good frame, index).
  std::function<void(std::size_t index1, std::size_t index2, const Correspondences&)> pair;
};

// Runs over all frames in order and hands every one of them to `sink`, in order. Frames are loaded, described
// and related on options.threads threads; neither that number nor their timing changes the result. What load
// or sink throws comes out after all earlier frames have been handed over. Throws std::invalid_argument where
// the options ask for knowledge that is not there.
void run_odometry(const FrameSource& frames, const Camera& camera, const OdometryOptions& options,
                  const Clock& clock, const std::function<void(const FrameResult&)>& sink,
                  const OdometryTaps& taps = {});

// The same from correspondences: gives what the images gave, where the pairs are those that correspond() made
// of them with the same options.
void run_odometry(const PairSource& pairs, const Camera& camera, const OdometryOptions& options,
                  const Clock& clock, const std::function<void(const FrameResult&)>& sink);

}  // namespace framewise
