// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "framewise/geometry/trajectory.h"
#include "framewise/image/frame.h"
#include "framewise/image/mesh.h"
#include "framewise/simulation/depth_sensors.h"
#include "framewise/simulation/imaging.h"
#include "framewise/simulation/imu.h"
#include "framewise/simulation/rgbd_sensor.h"
#include "framewise/simulation/scene_catalog.h"

namespace framewise {

struct SimulateOptions {
  std::string scene = "room";
  std::shared_ptr<const Mesh> mesh;  // to be seen in place of a named scene, if there is one
  std::string path;                  // by name; empty: the one that the scene is made for
  Trajectory poses;           // world_from_cam to move through in place of a named path, if there are any
  std::optional<int> frames;  // none: 300, or as many as the poses last
  double rate_hz = 30;
  std::uint64_t seed = 0;  // of the scene's textures and of the path
  int width = 640;         // pixels; the field of view stays that of 640 with f = 525
  int height = 480;
  int threads = 0;                     // 0: all cores; the bytes are the same with any number
  float light_cell = 0.05f;            // finest shadow (m); coarser starts sooner
  std::array<double, 5> distortion{};  // k1 k2 p1 p2 k3 of the lens
  double exposure = 1;                 // times the usual amount of light
  double headlamp = 0;                 // light it throws at 1 m; the mine has no other
  ImagingOptions imaging;
  DepthSensorOptions depth;
  std::optional<double> depth_max;  // farther is unknown (m); none: the depth sensor's usual reach, and for
                                    // exact depth of a mesh at least across it
  std::optional<ImuOptions> imu;

  // Throws std::invalid_argument naming the option, what was found and what was expected.
  void check() const;
};

struct SimulatedFrame {
  int index;
  Frame frame;
  cv::Mat true_depth;  // where a depth sensor with faults is simulated: as far as it reaches, without them
  Pose world_from_cam;
};

// Renders frames 0, 1, 2, ... and hands each to the sink, in order and one at a time, while later ones are
// being rendered. The sink may run on any thread; returning false ends the recording after that frame.
using FrameSink = std::function<bool(const SimulatedFrame&)>;
void simulate(const SimulateOptions& options, const FrameSink& sink);

// The scene by its name, or that of the mesh; of the mesh it keeps no more than the pointer.
SceneKind scene_of(const SimulateOptions& options);

// Whether some frame of a recording sees a face: a mesh may lie elsewhere than its path. Looks at up to a
// hundred frames.
bool is_anything_in_view(const SimulateOptions& options);

// The camera of a recording.
RgbdOptions sensor_of(const SimulateOptions& options);

// How many frames a recording has that is not ended before.
int frame_count(const SimulateOptions& options);

// The path by its name or through the poses, and what it is called: "poses" where it is those.
Path path_of(const SimulateOptions& options);
std::string path_name(const SimulateOptions& options);

// When frame i is taken: i / rate_hz after 0 or the first of the poses, rounded to microseconds so that six
// decimals in a file are exact.
double frame_time(const SimulateOptions& options, int index);

// Poses at each frame's time from the first to the last of so many frames, and evenly between them, at 100 Hz
// or more; with an inertial unit also at the times of its true readings (to a microsecond).
Trajectory true_trajectory(const SimulateOptions& options, int frames);

// What the inertial unit of the options reads without and with its faults, from the first to the last of so
// many frames. Empty without one.
struct ImuRecording {
  std::vector<ImuReading> truth, readings;
};
ImuRecording imu_recording(const SimulateOptions& options, int frames);

}  // namespace framewise
