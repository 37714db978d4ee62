// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "framewise/geometry/trajectory.h"
#include "framewise/image/frame.h"
#include "framewise/simulation/rgbd_sensor.h"

namespace framewise {

struct SimulateOptions {
  std::string scene = "room";
  int frames = 300;
  double rate_hz = 30;
  std::uint64_t seed = 0;  // of the scene's textures and of the path
  int width = 640;         // pixels; the field of view stays that of 640 with f = 525
  int height = 480;
  int threads = 0;           // 0: all cores; the bytes are the same with any number
  float light_cell = 0.05f;  // finest shadow (m); coarser starts sooner

  // Throws std::invalid_argument naming the option, what was found and what was expected.
  void check() const;
};

const std::vector<std::string>& scene_names();

struct SimulatedFrame {
  int index;
  Frame frame;
  Pose world_from_cam;
};

// Renders frames 0, 1, 2, ... and hands each to the sink, in order and one at a time, while later ones are
// being rendered. The sink may run on any thread; returning false ends the recording after that frame.
using FrameSink = std::function<bool(const SimulatedFrame&)>;
void simulate(const SimulateOptions& options, const FrameSink& sink);

// The camera of a recording.
RgbdOptions sensor_of(const SimulateOptions& options);

// When frame i is taken: i / rate_hz, rounded to microseconds so that six decimals in a file are exact.
double frame_time(const SimulateOptions& options, int index);

// Poses at each frame's time from the first to the last of so many frames, and evenly between them, at 100 Hz
// or more.
Trajectory true_trajectory(const SimulateOptions& options, int frames);

}  // namespace framewise
