// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "inspect_sampling.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>

#include "framewise/evaluation/statistics.h"
#include "framewise/image/depth.h"
#include "framewise/odometry/correspond.h"
#include "framewise/odometry/step.h"
#include "framewise/robust/registration.h"

namespace framewise::apps {
namespace {

constexpr std::size_t kSampledFrames = 12, kAnchors = 20;
constexpr std::array<std::size_t, 4> kSpans = {1, 3, 9, 27};  // frames between the two of a motion
constexpr int kDepthStride = 5;                               // of the pixels whose depth is counted
constexpr std::size_t kMostViews = 20;
constexpr int kFewestInliers = 40;
constexpr double kLeastLength = 0.03;        // of a step by truth, to be compared (m)
constexpr double kPointErrorOfDepth = 0.03;  // of an inlier, as a share of the depth
constexpr double kLeastShareOfInliers = 0.3;
// Median distance of the inliers from their middle, as a share of the image's width: points in a small part
// of the image cannot tell turning from moving.
constexpr double kLeastSpread = 0.12;

// `count` of `size` indices, evenly, from the first to the last.
std::vector<std::size_t> spread_evenly(std::size_t size, std::size_t count) {
  std::vector<std::size_t> indices;
  const std::size_t taken = std::min(size, count);
  for (std::size_t k = 0; k < taken; ++k) indices.push_back(taken == 1 ? 0 : k * (size - 1) / (taken - 1));
  return indices;
}

// Depths of many images, counted pixel by pixel.
class DepthCounter {
 public:
  void add(const cv::Mat& depth) {
    ++images_;
    for (int v = 0; v < depth.rows; v += kDepthStride)
      for (int u = 0; u < depth.cols; u += kDepthStride) {
        ++pixels_;
        if (const float z = depth.at<float>(v, u); is_known_depth(z)) known_.push_back(z);
      }
  }

  std::optional<DepthSummary> summary() {
    if (images_ == 0) return std::nullopt;
    DepthSummary summary;
    summary.images = images_;
    summary.unknown = 1 - static_cast<double>(known_.size()) / static_cast<double>(pixels_);
    std::sort(known_.begin(), known_.end());
    for (std::size_t k = 0; k < summary.quantiles.size(); ++k)
      summary.quantiles[k] = known_.empty()
                                 ? std::numeric_limits<double>::quiet_NaN()
                                 : known_[static_cast<std::size_t>(DepthSummary::kShares[k] *
                                                                   static_cast<double>(known_.size() - 1))];
    return summary;
  }

 private:
  std::size_t images_ = 0, pixels_ = 0;
  std::vector<float> known_;
};

void sample_depth_and_edges(const Dataset& dataset, ImageEvidence& evidence) {
  DepthCounter depths;
  EdgeAlignment alignment;
  bool has_both = false;
  for (const std::size_t i : spread_evenly(dataset.frames.size(), kSampledFrames)) {
    const Frame frame = load_frame(dataset, i);
    const cv::Mat& image = frame.gray.empty() ? frame.depth : frame.gray;
    evidence.width = image.cols;
    evidence.height = image.rows;
    if (!frame.depth.empty()) depths.add(frame.depth);
    if (frame.gray.empty() || frame.depth.empty() || frame.gray.size() != frame.depth.size()) continue;
    alignment.add(frame.gray, frame.depth);
    has_both = true;
  }
  evidence.depth = depths.summary();
  if (has_both) evidence.edges = alignment.fit();
}

double median_parallax(const Correspondences& shared, const Step& step) {
  std::vector<double> angles;
  for (std::size_t i = 0; i < shared.size(); ++i) {
    if (step.inlier_mask[i] == 0) continue;
    const Eigen::Vector3d turned = step.cam2_from_cam1.R * shared.x1[i];
    angles.push_back(std::atan2(turned.cross(shared.x2[i]).norm(), turned.dot(shared.x2[i])));
  }
  return angles.empty() ? 0 : median(angles);
}

bool are_spread(const Correspondences& shared, const Step& step, int width) {
  std::vector<double> u, v, distances;
  for (std::size_t i = 0; i < shared.size(); ++i) {
    if (step.inlier_mask[i] == 0) continue;
    u.push_back(shared.pixels1[i].x());
    v.push_back(shared.pixels1[i].y());
  }
  if (u.empty()) return false;
  const double middle_u = median(u), middle_v = median(v);
  for (std::size_t i = 0; i < u.size(); ++i)
    distances.push_back(std::hypot(u[i] - middle_u, v[i] - middle_v));
  return median(distances) >= kLeastSpread * width;
}

// The translation of cam2_from_cam1 by depth alone (m): of the rigid motion between the points that both
// frames have with depth, which no unit of depth turns. Empty where they are too few.
std::optional<Eigen::Vector3d> translation_by_depth(const Correspondences& shared, std::uint64_t seed) {
  std::vector<Eigen::Vector3d> X1, X2;
  std::vector<double> depths;
  for (std::size_t i = 0; i < shared.size(); ++i) {
    if (!std::isfinite(shared.z1[i]) || !std::isfinite(shared.z2[i])) continue;
    X1.push_back(shared.z1[i] / shared.x1[i].z() * shared.x1[i]);
    X2.push_back(shared.z2[i] / shared.x2[i].z() * shared.x2[i]);
    depths.push_back(shared.z1[i]);
  }
  if (X1.size() < static_cast<std::size_t>(kFewestInliers)) return std::nullopt;
  RegistrationOptions options;
  options.ransac.seed = seed;
  options.max_error = kPointErrorOfDepth * median(depths);
  options.min_inliers = kFewestInliers;
  const auto estimate = estimate_registration(X1, X2, options);
  return estimate ? std::optional(estimate->cam2_from_cam1.t) : std::nullopt;
}

// Bearings alone tell the motion: no mistake in depth touches it.
OdometryOptions motion_options() {
  OdometryOptions options;
  options.solver = "nister-5pt";
  options.scale = "none";
  options.depth.min_depth = 0;  // of whatever unit
  options.depth.max_depth = 1e9;
  return options;
}

class MotionSampler {
  using SharedView = std::shared_ptr<const Observation>;

 public:
  MotionSampler(const Dataset& dataset, double max_truth_gap, std::uint64_t seed)
      : dataset_(dataset), max_truth_gap_(max_truth_gap), seed_(seed) {}

  void add_motions_from(std::size_t first, ImageEvidence& evidence) {
    const auto truth1 = truth(first);
    if (!truth1) return;
    const SharedView view1 = view(first);
    for (const std::size_t span : kSpans) {
      if (first + span >= dataset_.frames.size()) return;
      const auto truth2 = truth(first + span);
      if (truth2 && !add_motion(*view1, *view(first + span), *truth1, *truth2, evidence)) return;
    }
  }

 private:
  std::optional<Pose> truth(std::size_t i) const {
    return pose_at(dataset_.truth, dataset_.frames[i].time, max_truth_gap_);
  }
  // In a short recording a frame is seen several times.
  SharedView view(std::size_t i) {
    SharedView& kept = views_[i];
    if (!kept)
      kept = std::make_shared<Observation>(
          observe(load_frame(dataset_, i), dataset_.calibration.camera, options_));
    const SharedView answer = kept;
    if (views_.size() > kMostViews) views_.erase(views_.begin());
    return answer;
  }

  // Whether the two frames still show the same.
  bool add_motion(const Observation& view1, const Observation& view2, const Pose& truth1, const Pose& truth2,
                  ImageEvidence& evidence) const {
    const Camera& camera = dataset_.calibration.camera;
    const Correspondences shared = correspond(view1, view2, camera, options_);
    const Step step = estimate_step(shared, camera, options_, seed_);
    if (!is_measured(step.status) || step.inliers < kFewestInliers ||
        step.inliers < kLeastShareOfInliers * step.matches)
      return false;
    if (!are_spread(shared, step, camera.width)) return true;
    evidence.motions.push_back({truth1, truth2, step.cam2_from_cam1, median_parallax(shared, step)});
    // Along the true step: noise across it makes every step longer.
    const Eigen::Vector3d true_step = (truth2.inverse() * truth1).t;
    if (true_step.norm() < kLeastLength) return true;
    if (const auto t = translation_by_depth(shared, seed_))
      evidence.length_ratios.push_back(t->dot(true_step) / true_step.squaredNorm());
    return true;
  }

  const Dataset& dataset_;
  double max_truth_gap_;
  std::uint64_t seed_;
  OdometryOptions options_ = motion_options();
  std::map<std::size_t, SharedView> views_;
};

}  // namespace

ImageEvidence sample_images(const Dataset& dataset, double max_truth_gap, std::uint64_t seed) {
  ImageEvidence evidence;
  sample_depth_and_edges(dataset, evidence);
  if (!dataset.has_camera() || dataset.frames_with_color == 0 || dataset.truth.empty()) return evidence;
  MotionSampler motions(dataset, max_truth_gap, seed);
  for (const std::size_t i : spread_evenly(dataset.frames.size(), kAnchors))
    motions.add_motions_from(i, evidence);
  return evidence;
}

}  // namespace framewise::apps
