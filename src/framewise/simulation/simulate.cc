// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/simulation/simulate.h"

#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <memory>
#include <opencv2/imgproc.hpp>
#include <set>
#include <stdexcept>

#include "framewise/image/depth.h"
#include "framewise/simulation/mesh_scene.h"
#include "framewise/simulation/random.h"
#include "framewise/simulation/se3_spline.h"

namespace framewise {
namespace {

constexpr double kTruthRateHz = 100;

[[noreturn]] void refuse(const std::string& option, const std::string& found, const std::string& expected) {
  throw std::invalid_argument(option + " is " + found + ", expected " + expected);
}

constexpr int kUsualFrames = 300;

double begin_of(const SimulateOptions& options) {
  return options.poses.empty() ? 0 : options.poses.times.front();
}

// As many as the poses last, or without limit.
int frames_of_poses(const SimulateOptions& options) {
  if (options.poses.empty()) return std::numeric_limits<int>::max();
  const double span = options.poses.times.back() - options.poses.times.front();
  return static_cast<int>(std::min(1e9, std::floor(span * options.rate_hz + 1e-6))) + 1;
}

double to_microseconds(double time) { return std::round(time * 1e6) / 1e6; }

std::uint64_t seed_of_frame(std::uint64_t seed, int index) {
  return Random(Random(seed ^ 0x4672616d65u).bits() + static_cast<std::uint64_t>(index)).bits();
}

cv::Mat within(const cv::Mat& depth, double reach) {
  cv::Mat near = depth.clone();
  near.setTo(kUnknownDepth, depth > reach);
  return near;
}

// One frame with its time and true pose.
SimulatedFrame shoot(const SimulateOptions& options, const RgbdSensor& sensor, const RayTracer& tracer,
                     const Path& path, int index) {
  const double time = frame_time(options, index);
  const std::uint64_t seed = seed_of_frame(options.seed, index);
  const bool exact = options.depth.sensor == DepthSensor::kExact, plain = options.imaging.is_plain();
  SimulatedFrame simulated{index, {}, {}, path(time).world_from_cam};
  Frame& frame = simulated.frame;
  if (plain) {
    frame = sensor.render(tracer, simulated.world_from_cam);
  } else {
    frame.color = develop(expose(sensor, tracer, path, time, options.imaging), sensor.options().camera,
                          options.imaging, seed ^ 0x4c69676874u);
    cv::cvtColor(frame.color, frame.gray, cv::COLOR_BGR2GRAY);
  }
  if (!plain || !exact) {
    const SurfaceImage surface = sensor.surface(tracer, simulated.world_from_cam);
    const double reach = sensor.options().max_depth;
    frame.depth = within(measure_depth(surface, sensor.options().camera, options.depth, seed), reach);
    if (!exact) simulated.true_depth = within(surface.depth, reach);
  }
  frame.time = time;
  return simulated;
}

void render_all(const SimulateOptions& options, int threads, const FrameSink& sink) {
  const Scene scene =
      scene_of(options).build({.seed = options.seed, .light_cell = options.light_cell, .lit = true});
  const RayTracer tracer(scene);
  const RgbdSensor sensor(sensor_of(options));
  const Path path = path_of(options);
  const int frames = frame_count(options);
  std::atomic<bool> stopped = false;
  int next = 0;
  using Item = std::shared_ptr<SimulatedFrame>;
  const auto begin =
      tbb::make_filter<void, Item>(tbb::filter_mode::serial_in_order, [&](tbb::flow_control& control) {
        if (next == frames || stopped) {
          control.stop();
          return Item();
        }
        return std::make_shared<SimulatedFrame>(SimulatedFrame{next++, {}, {}, {}});
      });
  const auto render = tbb::make_filter<Item, Item>(tbb::filter_mode::parallel, [&](Item item) {
    *item = shoot(options, sensor, tracer, path, item->index);
    return item;
  });
  const auto deliver = tbb::make_filter<Item, void>(tbb::filter_mode::serial_in_order, [&](const Item& item) {
    if (!stopped && !sink(*item)) stopped = true;
  });
  tbb::parallel_pipeline(threads + 1, begin & render & deliver);
}

}  // namespace

void SimulateOptions::check() const {
  const SceneKind kind = scene_of(*this);
  if (!poses.empty() && !path.empty()) refuse("path", "'" + path + "' beside poses", "one of the two");
  if (!poses.empty() && poses.size() < 2) refuse("poses", "a single one", "at least 2");
  if (poses.empty() && !path.empty()) named_path(path, kind.space, seed);
  if (frames.value_or(1) < 1) refuse("frames", std::to_string(*frames), "at least 1");
  if (!(rate_hz > 0 && rate_hz <= 1000))
    refuse("rate_hz", std::to_string(rate_hz), "a rate above 0, at most 1000");
  if (width < 16 || width > 8192) refuse("width", std::to_string(width), "16 to 8192 pixels");
  if (height < 16 || height > 8192) refuse("height", std::to_string(height), "16 to 8192 pixels");
  if (threads < 0) refuse("threads", std::to_string(threads), "0 for all cores, or a number of threads");
  if (!(light_cell >= 0.01f && light_cell <= 10))
    refuse("light_cell", std::to_string(light_cell), "0.01 to 10 m");
  if (imu) imu->check();
  imaging.check(1 / rate_hz);
  depth.check();
  sensor_of(*this).check();
  if (const int most = frames_of_poses(*this); frames.value_or(1) > most)
    refuse("frames", std::to_string(*frames),
           "at most " + std::to_string(most) + ", as long as the poses last");
}

SceneKind scene_of(const SimulateOptions& options) {
  if (!options.mesh) return scene_kind(options.scene);
  return {"mesh", [mesh = options.mesh](const SceneOptions& scene) { return mesh_scene(*mesh, scene); },
          mesh_space(*options.mesh), "orbit"};
}

bool is_anything_in_view(const SimulateOptions& options) {
  constexpr int kMostFrames = 100, kWidth = 64;
  options.check();
  SimulateOptions small = options;
  small.width = kWidth;
  small.height = std::max(16, kWidth * options.height / options.width);
  const Scene scene = scene_of(options).build({.light_cell = 10, .lit = false});
  const RayTracer tracer(scene);
  const RgbdSensor sensor(sensor_of(small));
  const Path path = path_of(options);
  const int frames = frame_count(options), step = (frames + kMostFrames - 1) / kMostFrames;
  for (int i = 0; i < frames; i += step) {
    const cv::Mat depth = sensor.surface(tracer, path(frame_time(options, i)).world_from_cam).depth;
    if (cv::countNonZero(depth == depth) > 0) return true;
  }
  return false;
}

RgbdOptions sensor_of(const SimulateOptions& options) {
  RgbdOptions sensor;
  sensor.camera.width = options.width;
  sensor.camera.height = options.height;
  sensor.camera.fx = sensor.camera.fy = 525.0 * options.width / 640;
  sensor.camera.cx = 0.5 * (options.width - 1);
  sensor.camera.cy = 0.5 * (options.height - 1);
  sensor.camera.distortion = options.distortion;
  sensor.max_depth = options.depth_max.value_or(usual_reach(options.depth.sensor));
  if (options.mesh && !options.depth_max && options.depth.sensor == DepthSensor::kExact)
    sensor.max_depth = std::max(sensor.max_depth, mesh_space(*options.mesh).free_space.sizes().x());
  sensor.exposure = options.exposure;
  sensor.headlamp = options.headlamp;
  return sensor;
}

int frame_count(const SimulateOptions& options) {
  return options.frames.value_or(options.poses.empty() ? kUsualFrames : frames_of_poses(options));
}

std::string path_name(const SimulateOptions& options) {
  if (!options.poses.empty()) return "poses";
  return options.path.empty() ? scene_of(options).default_path : options.path;
}

Path path_of(const SimulateOptions& options) {
  if (options.poses.empty()) return named_path(path_name(options), scene_of(options).space, options.seed);
  // Stamps of frames are rounded, perhaps to just outside.
  return [spline = std::make_shared<const Se3Spline>(options.poses)](double time) {
    return (*spline)(std::clamp(time, spline->begin(), spline->end()));
  };
}

double frame_time(const SimulateOptions& options, int index) {
  return to_microseconds(begin_of(options) + index / options.rate_hz);
}

Trajectory true_trajectory(const SimulateOptions& options, int frames) {
  options.check();
  const Path path = path_of(options);
  const int steps = std::max(1, static_cast<int>(std::ceil(kTruthRateHz / options.rate_hz)));
  std::set<double> times;
  for (int i = 0; i < frames; ++i)
    for (int k = 0; k < (i + 1 < frames ? steps : 1); ++k)
      times.insert(
          to_microseconds(begin_of(options) + (i + static_cast<double>(k) / steps) / options.rate_hz));
  for (const ImuReading& reading : imu_recording(options, frames).truth)
    times.insert(to_microseconds(reading.time));
  Trajectory truth;
  for (const double time : times) truth.add(time, path(time).world_from_cam);
  return truth;
}

ImuRecording imu_recording(const SimulateOptions& options, int frames) {
  options.check();
  ImuRecording recording;
  if (!options.imu || frames < 1) return recording;
  recording.truth = true_imu_readings(path_of(options), frame_time(options, 0),
                                      frame_time(options, frames - 1), options.imu->rate_hz);
  recording.readings = imu_readings(recording.truth, *options.imu, options.seed);
  return recording;
}

void simulate(const SimulateOptions& options, const FrameSink& sink) {
  options.check();
  const int threads = options.threads > 0 ? options.threads : tbb::this_task_arena::max_concurrency();
  tbb::task_arena arena(threads);
  arena.execute([&] { render_all(options, threads, sink); });
}

}  // namespace framewise
