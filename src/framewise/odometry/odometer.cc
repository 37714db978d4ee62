// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/odometry/odometer.h"

#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>

#include <exception>
#include <memory>
#include <stdexcept>

#include "framewise/odometry/correspond.h"
#include "framewise/odometry/first_pair_scale.h"
#include "framewise/odometry/geometric_refinement.h"
#include "framewise/odometry/pipeline_failure.h"
#include "framewise/odometry/trajectory_joiner.h"

namespace framewise {
namespace {

using SharedObservation = std::shared_ptr<const Observation>;

// A frame on its way through the stages.
struct Passage {
  std::size_t index = 0;
  double time = 0;
  SharedObservation current, previous;            // only where there are images
  std::shared_ptr<const SurfacePyramid> surface;  // where options.geometry wants it
  std::optional<Correspondences> with_previous;   // none for the first frame
  Step step;
  StageSeconds seconds;
  std::exception_ptr failure;  // pipeline_failure.h
};
using PassagePtr = std::shared_ptr<Passage>;

// Each pair of frames draws from its own seed, whoever computes it and when (splitmix64's finaliser).
std::uint64_t pair_seed(std::uint64_t seed, std::size_t index1, std::size_t index2) {
  std::uint64_t z = seed + 0x9e3779b97f4a7c15ull * (index2 + 1) + 0xd1b54a32d192ed03ull * (index1 + 1);
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
  return z ^ (z >> 31);
}

// Correspondences from images. Observing and corresponding are pure and run side by side; the rest sees the
// frames in order.
class ImageFront {
 public:
  ImageFront(const FrameSource& frames, const Camera& camera, const OdometryOptions& options,
             const Clock& clock, const OdometryTaps& taps)
      : frames_(frames),
        camera_(camera),
        options_(options),
        clock_(clock),
        taps_(taps),
        input_(std::make_shared<InputImage>(options.input, camera, options.depth.max_depth)) {
    if (options.uses_surfaces()) refinement_ = std::make_shared<GeometricRefinement>(camera, options);
  }

  void open(Passage& passage) const {
    const double start = clock_();
    const Frame frame = frames_.load(passage.index);
    const double loaded = clock_();
    passage.time = frame.time;
    passage.current = std::make_shared<Observation>(observe(frame, *input_, camera_, options_));
    if (refinement_)
      passage.surface = std::make_shared<const SurfacePyramid>(refinement_->surface(frame.depth));
    passage.seconds.load = loaded - start;
    passage.seconds.features = clock_() - loaded;
  }

  void pair(Passage& passage) {
    passage.previous = newest_;
    newest_ = passage.current;
  }

  void correspond_with_previous(Passage& passage) const {
    if (passage.previous && passage.current)
      passage.with_previous = correspond(*passage.previous, *passage.current, camera_, options_);
  }

  void before_joining(const Passage& passage) const {
    if (taps_.features) taps_.features(passage.index, passage.current->features);
    if (taps_.pair && passage.with_previous)
      taps_.pair(passage.index - 1, passage.index, *passage.with_previous);
  }

  std::optional<Correspondences> with_reference(const Passage& passage, std::size_t reference_index) const {
    auto found = correspond(*reference_, *passage.current, camera_, options_);
    if (taps_.pair) taps_.pair(reference_index, passage.index, found);
    return found;
  }

  // The step from the last frame whose pose was measured, by surfaces; none where they are not used.
  std::optional<Step> refine(const Passage& passage) const {
    if (!passage.surface) return std::nullopt;
    const bool in_color = passage.current && passage.current->input == "color";
    return refinement_->refine(passage.time, passage.surface, passage.step, in_color);
  }

  void refer_to(const Passage& passage) { reference_ = passage.current; }

 private:
  const FrameSource& frames_;
  const Camera& camera_;
  const OdometryOptions& options_;
  const Clock& clock_;
  const OdometryTaps& taps_;
  std::shared_ptr<const InputImage> input_;
  std::shared_ptr<GeometricRefinement> refinement_;
  SharedObservation newest_, reference_;
};

// Correspondences that were found before.
class PairFront {
 public:
  PairFront(const PairSource& pairs, const Clock& clock) : pairs_(pairs), clock_(clock) {}

  void open(Passage& passage) const {
    const double start = clock_();
    passage.time = pairs_.time(passage.index);
    if (passage.index > 0) passage.with_previous = pairs_.pair(passage.index - 1, passage.index);
    passage.seconds.load = clock_() - start;
  }
  void pair(Passage&) const {}
  void correspond_with_previous(Passage&) const {}
  void before_joining(const Passage&) const {}
  std::optional<Correspondences> with_reference(const Passage& passage, std::size_t reference_index) const {
    return pairs_.pair(reference_index, passage.index);
  }
  std::optional<Step> refine(const Passage&) const { return std::nullopt; }
  void refer_to(const Passage&) const {}

 private:
  const PairSource& pairs_;
  const Clock& clock_;
};

// The stages. Opening and relating are pure and run side by side; pairing and joining see the frames in
// order.
template <typename Front>
class Odometer {
 public:
  Odometer(Front front, std::size_t size, const PriorKnowledge& known, const Camera& camera,
           const OdometryOptions& options, const Clock& clock)
      : front_(std::move(front)),
        size_(size),
        known_(known),
        camera_(camera),
        options_(options),
        clock_(clock),
        joiner_(options.max_bridge) {}

  PassagePtr begin() {
    auto passage = std::make_shared<Passage>();
    passage->index = next_++;
    return passage;
  }
  bool at_end() const { return next_ >= size_; }

  void open(Passage& passage) const { front_.open(passage); }

  void pair(Passage& passage) { front_.pair(passage); }

  void relate(Passage& passage) const {
    const double start = clock_();
    front_.correspond_with_previous(passage);
    const double matched = clock_();
    if (passage.with_previous) passage.step = solve(*passage.with_previous, passage.index - 1, passage.index);
    passage.seconds.match = matched - start;
    passage.seconds.step = clock_() - matched;
  }

  FrameResult join(Passage& passage) {
    front_.before_joining(passage);
    const double start = clock_();
    const std::optional<Step> refined = front_.refine(passage);
    if (refined) passage.step = *refined;
    passage.seconds.refine = clock_() - start;
    const auto to_reference = [&](std::size_t reference_index) {
      if (refined) return *refined;
      const auto shared = front_.with_reference(passage, reference_index);
      return shared ? metric(solve(*shared, reference_index, passage.index)) : Step();
    };
    const auto joined = passage.index == 0 ? joiner_.start(passage.time)
                                           : joiner_.add(passage.time, metric(passage.step), to_reference);
    if (joiner_.reference_index() == passage.index) front_.refer_to(passage);
    return {passage.index,         passage.time,    joined.step,
            joined.world_from_cam, passage.seconds, passage.current ? passage.current->input : ""};
  }

 private:
  Step solve(const Correspondences& shared, std::size_t index1, std::size_t index2) const {
    StepKnowledge known;
    if (options_.scale == "truth") {
      const auto world_from_cam1 = known_.truth(index1), world_from_cam2 = known_.truth(index2);
      if (world_from_cam1 && world_from_cam2)
        known.true_length = (world_from_cam2->t - world_from_cam1->t).norm();
    }
    if (options_.needs_rotation()) known.rotation = known_.rotation(index1, index2);
    return estimate_step(shared, camera_, options_, pair_seed(options_.seed, index1, index2), known);
  }

  // Steps come here in the order of the frames.
  Step metric(const Step& step) {
    return options_.scale == "first-pair" ? first_pair_scale_.apply(step) : step;
  }

  Front front_;
  std::size_t size_, next_ = 0;
  const PriorKnowledge& known_;
  const Camera& camera_;
  const OdometryOptions& options_;
  const Clock& clock_;
  TrajectoryJoiner joiner_;
  FirstPairScale first_pair_scale_;
};

void check_known(const PriorKnowledge& known, const OdometryOptions& options) {
  if (options.scale == "truth" && !known.truth)
    throw std::invalid_argument("scale: found 'truth' and no truth, expected true poses to take it from");
  if (options.needs_rotation() && !known.rotation)
    throw std::invalid_argument("solver: found 'two-point' and no rotation, expected a source of rotations");
}

template <typename Front>
void run(Odometer<Front>& odometer, int threads, const std::function<void(const FrameResult&)>& sink) {
  constexpr auto kInOrder = tbb::filter_mode::serial_in_order, kSideBySide = tbb::filter_mode::parallel;
  tbb::task_arena arena(threads == 0 ? tbb::task_arena::automatic : threads);
  const std::size_t in_flight = 2 * static_cast<std::size_t>(arena.max_concurrency());
  PipelineFailure failure;
  const auto begin = [&](tbb::flow_control& flow) -> PassagePtr {
    if (!odometer.at_end() && !failure.happened()) return odometer.begin();
    flow.stop();
    return nullptr;
  };
  const auto open = [&](PassagePtr p) { return attempt(*p, [&] { odometer.open(*p); }), p; };
  const auto pair = [&](PassagePtr p) { return attempt(*p, [&] { odometer.pair(*p); }), p; };
  const auto relate = [&](PassagePtr p) { return attempt(*p, [&] { odometer.relate(*p); }), p; };
  const auto join = [&](PassagePtr p) { failure.attempt_last(*p, [&] { sink(odometer.join(*p)); }); };
  arena.execute([&] {
    tbb::parallel_pipeline(in_flight, tbb::make_filter<void, PassagePtr>(kInOrder, begin) &
                                          tbb::make_filter<PassagePtr, PassagePtr>(kSideBySide, open) &
                                          tbb::make_filter<PassagePtr, PassagePtr>(kInOrder, pair) &
                                          tbb::make_filter<PassagePtr, PassagePtr>(kSideBySide, relate) &
                                          tbb::make_filter<PassagePtr, void>(kInOrder, join));
  });
  failure.rethrow();
}

}  // namespace

void run_odometry(const FrameSource& frames, const Camera& camera, const OdometryOptions& options,
                  const Clock& clock, const std::function<void(const FrameResult&)>& sink,
                  const OdometryTaps& taps) {
  options.check();
  check_known(frames.known, options);
  camera.check();
  Odometer odometer(ImageFront(frames, camera, options, clock, taps), frames.size, frames.known, camera,
                    options, clock);
  run(odometer, options.threads, sink);
}

void run_odometry(const PairSource& pairs, const Camera& camera, const OdometryOptions& options,
                  const Clock& clock, const std::function<void(const FrameResult&)>& sink) {
  options.check();
  check_known(pairs.known, options);
  camera.check();
  Odometer odometer(PairFront(pairs, clock), pairs.size, pairs.known, camera, options, clock);
  run(odometer, options.threads, sink);
}

}  // namespace framewise
