// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/odometry/map_odometer.h"

#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>

#include <atomic>
#include <exception>
#include <memory>

#include "framewise/odometry/map_tracker.h"
#include "framewise/odometry/pipeline_failure.h"

namespace framewise {
namespace {

// A frame on its way through the stages.
struct MapPassage {
  std::size_t index = 0;
  std::shared_ptr<MapFrame> frame;
  StageSeconds seconds;
  std::exception_ptr failure;  // pipeline_failure.h
};
using MapPassagePtr = std::shared_ptr<MapPassage>;

}  // namespace

MapRun run_map_odometry(const FrameSource& frames, const Camera& camera, const OdometryOptions& options,
                        const Clock& clock, const std::function<void(const FrameResult&)>& sink,
                        const OdometryTaps& taps) {
  options.check();
  camera.check();
  MapTracker tracker(camera, options, frames.known);
  std::size_t next = 0;
  // Where the last frame needed features, so will the next as a rule: they are found while this one is
  // placed.
  std::atomic<bool> needs_features = false;

  PipelineFailure failure;

  const auto begin = [&](tbb::flow_control& flow) -> MapPassagePtr {
    if (next >= frames.size || failure.happened()) return flow.stop(), nullptr;
    auto passage = std::make_shared<MapPassage>();
    passage->index = next++;
    return passage;
  };
  const auto open = [&](MapPassagePtr passage) {
    attempt(*passage, [&] {
      const double start = clock();
      const Frame frame = frames.load(passage->index);
      const double loaded = clock();
      passage->frame = std::make_shared<MapFrame>(look_at(frame, passage->index));
      if (needs_features) find_features(*passage->frame, options.map);
      passage->seconds.load = loaded - start;
      passage->seconds.features = clock() - loaded;
    });
    return passage;
  };
  const auto place = [&](MapPassagePtr passage) {
    failure.attempt_last(*passage, [&] {
      const double start = clock(), time = passage->frame->time;
      const char* input = passage->frame->levels.empty() ? "" : "color";
      MapTrack track = tracker.add(passage->frame);
      needs_features = passage->frame->is_described;
      passage->frame.reset();
      passage->seconds.step = clock() - start;
      if (taps.pair && passage->index > 0) taps.pair(passage->index - 1, passage->index, track.seen);
      sink({passage->index, time, std::move(track.step), track.world_from_cam, passage->seconds, input});
    });
  };

  constexpr auto kInOrder = tbb::filter_mode::serial_in_order, kSideBySide = tbb::filter_mode::parallel;
  tbb::task_arena arena(options.threads == 0 ? tbb::task_arena::automatic : options.threads);
  const std::size_t in_flight = 2 * static_cast<std::size_t>(arena.max_concurrency());
  arena.execute([&] {
    tbb::parallel_pipeline(in_flight, tbb::make_filter<void, MapPassagePtr>(kInOrder, begin) &
                                          tbb::make_filter<MapPassagePtr, MapPassagePtr>(kSideBySide, open) &
                                          tbb::make_filter<MapPassagePtr, void>(kInOrder, place));
  });
  failure.rethrow();
  return {tracker.final_poses(), tracker.learned()};
}

}  // namespace framewise
