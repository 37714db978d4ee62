// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/simulation/simulate.h"

#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <memory>
#include <stdexcept>

#include "framewise/simulation/path.h"
#include "framewise/simulation/room_scene.h"

namespace framewise {
namespace {

constexpr double kTruthRateHz = 100;

[[noreturn]] void refuse(const std::string& option, const std::string& found, const std::string& expected) {
  throw std::invalid_argument(option + " is " + found + ", expected " + expected);
}

Scene build_scene(const SimulateOptions& options) {
  return room_scene({.seed = options.seed, .light_cell = options.light_cell});
}

Path build_path(const SimulateOptions& options) { return handheld_path(room_free_space(), options.seed); }

double to_microseconds(double time) { return std::round(time * 1e6) / 1e6; }

void render_all(const SimulateOptions& options, int threads, const FrameSink& sink) {
  const Scene scene = build_scene(options);
  const RayTracer tracer(scene);
  const RgbdSensor sensor(sensor_of(options));
  const Path path = build_path(options);
  std::atomic<bool> stopped = false;
  int next = 0;
  using Item = std::shared_ptr<SimulatedFrame>;
  const auto begin =
      tbb::make_filter<void, Item>(tbb::filter_mode::serial_in_order, [&](tbb::flow_control& control) {
        if (next == options.frames || stopped) {
          control.stop();
          return Item();
        }
        return std::make_shared<SimulatedFrame>(SimulatedFrame{next++, {}, {}});
      });
  const auto render = tbb::make_filter<Item, Item>(tbb::filter_mode::parallel, [&](Item item) {
    const double time = frame_time(options, item->index);
    item->world_from_cam = path(time);
    item->frame = sensor.render(tracer, item->world_from_cam);
    item->frame.time = time;
    return item;
  });
  const auto deliver = tbb::make_filter<Item, void>(tbb::filter_mode::serial_in_order, [&](const Item& item) {
    if (!stopped && !sink(*item)) stopped = true;
  });
  tbb::parallel_pipeline(threads + 1, begin & render & deliver);
}

}  // namespace

const std::vector<std::string>& scene_names() {
  static const std::vector<std::string> names{"room"};
  return names;
}

void SimulateOptions::check() const {
  if (std::find(scene_names().begin(), scene_names().end(), scene) == scene_names().end()) {
    std::string known;
    for (const std::string& name : scene_names()) known += (known.empty() ? "" : ", ") + name;
    refuse("scene", "'" + scene + "'", "one of: " + known);
  }
  if (frames < 1) refuse("frames", std::to_string(frames), "at least 1");
  if (!(rate_hz > 0 && rate_hz <= 1000))
    refuse("rate_hz", std::to_string(rate_hz), "a rate above 0, at most 1000");
  if (width < 16 || width > 8192) refuse("width", std::to_string(width), "16 to 8192 pixels");
  if (height < 16 || height > 8192) refuse("height", std::to_string(height), "16 to 8192 pixels");
  if (threads < 0) refuse("threads", std::to_string(threads), "0 for all cores, or a number of threads");
  if (!(light_cell >= 0.01f && light_cell <= 10))
    refuse("light_cell", std::to_string(light_cell), "0.01 to 10 m");
}

RgbdOptions sensor_of(const SimulateOptions& options) {
  RgbdOptions sensor;
  sensor.camera.width = options.width;
  sensor.camera.height = options.height;
  sensor.camera.fx = sensor.camera.fy = 525.0 * options.width / 640;
  sensor.camera.cx = 0.5 * (options.width - 1);
  sensor.camera.cy = 0.5 * (options.height - 1);
  return sensor;
}

double frame_time(const SimulateOptions& options, int index) {
  return to_microseconds(index / options.rate_hz);
}

Trajectory true_trajectory(const SimulateOptions& options, int frames) {
  options.check();
  const Path path = build_path(options);
  const int steps = std::max(1, static_cast<int>(std::ceil(kTruthRateHz / options.rate_hz)));
  Trajectory truth;
  for (int i = 0; i < frames; ++i) {
    for (int k = 0; k < (i + 1 < frames ? steps : 1); ++k) {
      const double time = to_microseconds((i + static_cast<double>(k) / steps) / options.rate_hz);
      truth.add(time, path(time));
    }
  }
  return truth;
}

void simulate(const SimulateOptions& options, const FrameSink& sink) {
  options.check();
  const int threads = options.threads > 0 ? options.threads : tbb::this_task_arena::max_concurrency();
  tbb::task_arena arena(threads);
  arena.execute([&] { render_all(options, threads, sink); });
}

}  // namespace framewise
