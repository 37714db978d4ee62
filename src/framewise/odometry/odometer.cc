// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/odometry/odometer.h"

#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>

#include <exception>
#include <memory>

#include "framewise/odometry/trajectory_joiner.h"

namespace framewise {
namespace {

using SharedObservation = std::shared_ptr<const Observation>;

// A frame on its way through the stages.
struct Passage {
  std::size_t index = 0;
  SharedObservation current, previous;
  Step step;
  StageSeconds seconds;
  std::exception_ptr failure;  // kept until all earlier frames have been handed over
};
using PassagePtr = std::shared_ptr<Passage>;

// Each pair of frames draws from its own seed, whoever computes it and when (splitmix64's finaliser).
std::uint64_t pair_seed(std::uint64_t seed, std::size_t index1, std::size_t index2) {
  std::uint64_t z = seed + 0x9e3779b97f4a7c15ull * (index2 + 1) + 0xd1b54a32d192ed03ull * (index1 + 1);
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
  return z ^ (z >> 31);
}

// The stages. Observing and relating are pure and run side by side; pairing and joining see the frames in
// order.
class Odometer {
 public:
  Odometer(const FrameSource& frames, const Camera& camera, const OdometryOptions& options,
           const Clock& clock)
      : frames_(frames), camera_(camera), options_(options), clock_(clock), joiner_(options.max_bridge) {}

  PassagePtr begin() {
    auto passage = std::make_shared<Passage>();
    passage->index = next_++;
    return passage;
  }
  bool at_end() const { return next_ >= frames_.size; }

  void observe(Passage& passage) const {
    try {
      const double start = clock_();
      const Frame frame = frames_.load(passage.index);
      const double loaded = clock_();
      passage.current = std::make_shared<Observation>(
          framewise::observe(frame, camera_, options_.features, options_.depth));
      passage.seconds.load = loaded - start;
      passage.seconds.features = clock_() - loaded;
    } catch (...) {
      passage.failure = std::current_exception();
    }
  }

  void pair(Passage& passage) {
    passage.previous = newest_;
    newest_ = passage.current;
  }

  void relate(Passage& passage) const {
    if (!passage.previous || !passage.current) return;
    const double start = clock_();
    passage.step = relate(*passage.previous, passage.index - 1, *passage.current, passage.index);
    passage.seconds.step = clock_() - start;
  }

  FrameResult join(Passage& passage) {
    if (passage.failure) std::rethrow_exception(passage.failure);
    const auto to_reference = [&](const Observation& reference, std::size_t reference_index) {
      return relate(reference, reference_index, *passage.current, passage.index);
    };
    const auto joined = passage.index == 0 ? joiner_.start(passage.current)
                                           : joiner_.add(passage.current, passage.step, to_reference);
    return {passage.index, passage.current->time, joined.step, joined.world_from_cam, passage.seconds};
  }

 private:
  Step relate(const Observation& frame1, std::size_t index1, const Observation& frame2,
              std::size_t index2) const {
    std::optional<double> true_length;
    if (options_.scale == "truth") {
      const auto world_from_cam1 = frames_.truth(index1), world_from_cam2 = frames_.truth(index2);
      if (world_from_cam1 && world_from_cam2) true_length = (world_from_cam2->t - world_from_cam1->t).norm();
    }
    return estimate_step(frame1, frame2, camera_, options_, pair_seed(options_.seed, index1, index2),
                         true_length);
  }

  const FrameSource& frames_;
  const Camera& camera_;
  const OdometryOptions& options_;
  const Clock& clock_;
  TrajectoryJoiner joiner_;
  std::size_t next_ = 0;
  SharedObservation newest_;
};

}  // namespace

void run_odometry(const FrameSource& frames, const Camera& camera, const OdometryOptions& options,
                  const Clock& clock, const std::function<void(const FrameResult&)>& sink) {
  options.check();
  camera.check();
  Odometer odometer(frames, camera, options, clock);
  constexpr auto kInOrder = tbb::filter_mode::serial_in_order, kSideBySide = tbb::filter_mode::parallel;

  tbb::task_arena arena(options.threads == 0 ? tbb::task_arena::automatic : options.threads);
  const std::size_t in_flight = 2 * static_cast<std::size_t>(arena.max_concurrency());
  arena.execute([&] {
    tbb::parallel_pipeline(
        in_flight,
        tbb::make_filter<void, PassagePtr>(kInOrder, [&](tbb::flow_control& flow) -> PassagePtr {
          if (!odometer.at_end()) return odometer.begin();
          flow.stop();
          return nullptr;
        }) & tbb::make_filter<PassagePtr, PassagePtr>(kSideBySide, [&](PassagePtr p) {
          return odometer.observe(*p), p;
        }) & tbb::make_filter<PassagePtr, PassagePtr>(kInOrder, [&](PassagePtr p) {
          return odometer.pair(*p), p;
        }) & tbb::make_filter<PassagePtr, PassagePtr>(kSideBySide, [&](PassagePtr p) {
          return odometer.relate(*p), p;
        }) & tbb::make_filter<PassagePtr, void>(kInOrder, [&](PassagePtr p) { sink(odometer.join(*p)); }));
  });
}

}  // namespace framewise
