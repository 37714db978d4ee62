// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "inspect_checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "framewise/evaluation/statistics.h"
#include "framewise/evaluation/trajectory_jumps.h"
#include "framewise/geometry/so3.h"

namespace framewise::apps {
namespace {

constexpr double kInStep = 0.010;  // s; a third of the time between two frames of a Kinect
constexpr double kDegreesPerRadian = 180 / M_PI;

Check fine(const char* name, std::string text) { return {name, Verdict::kFine, std::move(text)}; }
Check warning(const char* name, std::string text) { return {name, Verdict::kWarning, std::move(text)}; }
Check untold(const char* name, std::string text) { return {name, Verdict::kUntold, std::move(text)}; }

Check nothing(const char* name, std::string text) {
  return {name, Verdict::kNothingToCheck, std::move(text)};
}

// Depth and truth agree on the length of a step, or disagree all alike: a camera that hardly moves has
// neither.
std::optional<double> length_ratio(std::vector<double> ratios) {
  if (ratios.size() < 5) return std::nullopt;
  const double middle = median(ratios);
  for (double& ratio : ratios) ratio = std::abs(ratio - middle);
  return median(ratios) < 0.15 * middle ? std::optional(middle) : std::nullopt;
}

double share(std::size_t part, std::size_t whole) {
  return whole > 0 ? static_cast<double>(part) / static_cast<double>(whole) : 0;
}

Check check_time_unit(const Inspection& x) {
  const char* name = "time-unit";
  if (x.dataset.frames.size() < 2) return nothing(name, "a single frame has no rate");
  for (const auto& [rate, what] :
       {std::pair(&x.frames, "frames"), std::pair(&x.truth_poses, "poses of the truth")})
    if (!rate->is_plausible())
      return warning(name, fmt::format("{} are {} s apart: are the stamps seconds, or milli- or nanoseconds?",
                                       what, rate->median_step));
  return fine(name, "stamps are plausible as seconds");
}

Check check_one_run(const Inspection& x) {
  const char* name = "one-run";
  if (!x.truth_jumps.empty())
    return warning(name, fmt::format("the truth leaps {} time(s), first at {} s: two runs in one file?",
                                     x.truth_jumps.size(), x.dataset.truth.times[x.truth_jumps.front()]));
  if (const FrameRate::Gap* pause = x.frames.pause())
    return warning(name, fmt::format("no frames for {:.1f} s after {} s: two runs in one recording?",
                                     pause->length, pause->after));
  return fine(name, "no pause in the frames, no leap in the truth");
}

Check check_lists(const Inspection& x) {
  const char* name = "lists-match";
  const Dataset& d = x.dataset;
  const std::size_t depths = d.frames_with_depth + d.unmatched_depth;
  if (d.frames_with_color == 0 || depths == 0) return nothing(name, "there are no two lists to match");
  const std::size_t without = d.frames.size() - d.frames_with_depth;
  const std::string text = fmt::format("{} of {} frames have depth, {} of {} depth images have a frame",
                                       d.frames_with_depth, d.frames.size(), d.frames_with_depth, depths);
  return share(without, d.frames.size()) > 0.2 || share(d.unmatched_depth, depths) > 0.5 ? warning(name, text)
                                                                                         : fine(name, text);
}

Check check_in_step(const Inspection& x) {
  const char* name = "in-step";
  if (x.dataset.frames_with_color == 0 || x.dataset.frames_with_depth == 0)
    return nothing(name, "there are not both colour and depth");
  const std::string text = fmt::format(
      "{} of {} frames have depth that was taken more than {:.0f} ms before or after (median {:.1f} ms)",
      x.out_of_step, x.dataset.frames_with_depth, 1e3 * kInStep, 1e3 * x.median_delay);
  return share(x.out_of_step, x.dataset.frames_with_depth) > 0.1 ? warning(name, text) : fine(name, text);
}

Check check_depth_unit(const Inspection& x) {
  const char* name = "depth-factor";
  if (!x.images.depth) return nothing(name, "there is no depth");
  const double z = x.images.depth->median();
  if (!std::isfinite(z))
    return warning(name,
                   "no pixel of the sampled depth images is known: is the factor, or depth-max, wrong?");
  const double factor = x.dataset.calibration.depth_factor;
  if (z < 0.1 || z > 20)
    return warning(
        name,
        fmt::format("the median depth is {:.3g} m with {} raw units in a metre: another --depth-factor?", z,
                    factor));
  // Lengths between poses that are read the wrong way are no lengths of steps.
  const PoseConvention convention = judge_convention(x.images.motions).convention;
  const bool has_lengths = convention == PoseConvention::kAsRead || convention == PoseConvention::kUntold;
  const auto measured = length_ratio(x.images.length_ratios);
  if (!has_lengths || !measured) return fine(name, fmt::format("the median depth is {:.3g} m", z));
  const double ratio = *measured;
  if (ratio < 0.6 || ratio > 1.7)
    return warning(
        name,
        fmt::format("steps are {} times as long by depth as by truth: --depth-factor {:.4g} instead of {}?",
                    ratio < 100 ? fmt::format("{:.2g}", ratio) : fmt::format("{:.0f}", ratio), factor * ratio,
                    factor));
  return fine(name,
              fmt::format("the median depth is {:.3g} m; steps are {:.2f} times as long by depth as by truth",
                          z, ratio));
}

Check check_registered(const Inspection& x) {
  const char* name = "depth-registered";
  if (x.dataset.frames_with_color == 0 || !x.images.depth)
    return nothing(name, "there are not both colour and depth");
  if (!x.images.edges) return untold(name, "too few edges in depth");
  const EdgeFit& fit = *x.images.edges;
  if (!fit.is_elsewhere()) return fine(name, "edges of depth lie on edges of the images");
  return warning(
      name, fmt::format("edges of depth fit the images far better zoomed by {:.2f} and moved by {} {} pixels "
                        "(score {:.2f} instead of {:.2f}): depth is not registered to colour",
                        fit.zoom, fit.du, fit.dv, fit.score, fit.as_it_is));
}

Check check_coverage(const Inspection& x) {
  const char* name = "truth-coverage";
  if (x.dataset.truth.empty()) return nothing(name, "there is no truth");
  const std::string text = fmt::format("{:.0f} % of the frames have truth", 100 * x.truth_coverage);
  return x.truth_coverage < 0.9 ? warning(name, text) : fine(name, text);
}

Check check_quaternions(const Inspection& x) {
  const char* name = "quaternion-length";
  if (x.dataset.truth.empty()) return nothing(name, "there is no truth");
  if (x.dataset.truth_norm_error > 0.01)
    return warning(
        name, fmt::format("a quaternion of {} has a length that is {:.3g} off 1: are its columns in order?",
                          x.dataset.truth_source, x.dataset.truth_norm_error));
  return fine(name, "lengths are 1, or the file has matrices");
}

std::string axes_text(const Eigen::Matrix3d& R) {
  const Eigen::Vector3d angles = kDegreesPerRadian * so3_log(R);
  return fmt::format("{:.0f} degrees ({:.0f} {:.0f} {:.0f} as a rotation vector)", angles.norm(), angles.x(),
                     angles.y(), angles.z());
}

Check check_poses(const Inspection& x) {
  const char* name = "pose-convention";
  if (x.dataset.truth.empty()) return nothing(name, "there is no truth");
  if (!x.dataset.has_camera()) return untold(name, "without a calibration images say nothing about poses");
  if (x.dataset.frames_with_color == 0) return nothing(name, "there are no images to compare poses with");
  const ConventionJudgement found = judge_convention(x.images.motions);
  const std::string by = fmt::format(" (by {} motions)", found.motions);
  switch (found.convention) {
    case PoseConvention::kAsRead:
      return fine(name, "the truth turns and moves as the images do" + by);
    case PoseConvention::kScalarFirst:
      return warning("quaternion-order",
                     "the truth fits the images when its quaternions are read as w x y z" + by);
    case PoseConvention::kScalarLast:
      return warning("quaternion-order",
                     "the truth fits the images when its quaternions are read as x y z w" + by);
    case PoseConvention::kInverse:
      return warning("pose-direction",
                     "the truth fits the images when its poses are inverted: it is camera_from_world, not "
                     "world_from_camera" +
                         by);
    case PoseConvention::kBodyFrame:
      return warning("body-frame", "the truth fits the images when its axes are turned by " +
                                       axes_text(found.cam_from_body) + ": it is a body's, not the camera's" +
                                       by);
    case PoseConvention::kNone:
      return warning(
          name, fmt::format(
                    "the truth does not move as the images do (rotations differ by {:.1f} of {:.1f} degrees, "
                    "directions by {:.0f}), and no usual mistake explains it{}",
                    kDegreesPerRadian * found.rotation_error, kDegreesPerRadian * found.median_rotation,
                    kDegreesPerRadian * found.direction_error, by));
    case PoseConvention::kUntold:
      break;
  }
  return untold(name, "too little motion between frames that show the same" + by);
}

Check check_calibration(const Inspection& x) {
  const char* name = "calibration";
  if (!x.dataset.has_camera()) return warning(name, "none is known: --camera FILE");
  const Camera& camera = x.dataset.calibration.camera;
  const bool centred = camera.model == CameraModel::kEquirectangular ||
                       (std::abs(camera.cx - 0.5 * camera.width) < 0.25 * camera.width &&
                        std::abs(camera.cy - 0.5 * camera.height) < 0.25 * camera.height);
  return centred
             ? fine(name, "the principal point is near the middle")
             : warning(name,
                       fmt::format("the principal point {} {} is far from the middle of {} x {}: is this the "
                                   "calibration of another resolution?",
                                   camera.cx, camera.cy, camera.width, camera.height));
}

void measure_steps(Inspection& x) {
  std::vector<double> delays;
  for (const FrameFiles& frame : x.dataset.frames)
    if (!frame.depth.empty() && !frame.color.empty()) delays.push_back(std::abs(frame.depth_delay));
  x.out_of_step = static_cast<std::size_t>(
      std::count_if(delays.begin(), delays.end(), [](double delay) { return delay > kInStep; }));
  if (!delays.empty()) x.median_delay = median(delays);
}

}  // namespace

Inspection inspect_recording(Dataset dataset, double max_truth_gap, std::uint64_t seed) {
  Inspection x;
  x.dataset = std::move(dataset);
  std::vector<double> times;
  for (const FrameFiles& frame : x.dataset.frames) times.push_back(frame.time);
  x.frames = frame_rate(times);
  x.truth_poses = frame_rate(x.dataset.truth.times);
  x.truth_coverage = share(truth_at_frames(x.dataset, max_truth_gap).size(), x.dataset.frames.size());
  x.truth_jumps = find_jumps(x.dataset.truth);
  measure_steps(x);
  x.images = sample_images(x.dataset, max_truth_gap, seed);
  return x;
}

std::vector<Check> check_recording(const Inspection& x) {
  return {check_calibration(x), check_time_unit(x),  check_one_run(x),    check_lists(x),
          check_in_step(x),     check_depth_unit(x), check_registered(x), check_coverage(x),
          check_quaternions(x), check_poses(x)};
}

}  // namespace framewise::apps
