// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/odometry/correspond.h"

#include <cmath>
#include <optional>
#include <vector>

#include "framewise/features/matching.h"
#include "framewise/features/patch_alignment.h"
#include "framewise/features/windowed_matching.h"

namespace framewise {
namespace {

// A feature of frame 1 and where frame 2 has it.
struct Partner {
  int index1;
  std::optional<int> index2;  // of the feature found there; none where it was tracked
  cv::Point2f pixel2;
  float distance = 0;  // of the descriptors
};

std::vector<cv::Point2f> pixels_of(const Features& features) {
  std::vector<cv::Point2f> pixels;
  for (const cv::KeyPoint& keypoint : features.keypoints) pixels.push_back(keypoint.pt);
  return pixels;
}

std::vector<Partner> track(const Observation& frame1, const Observation& frame2,
                           const OdometryOptions& options) {
  const Tracks tracks = track_points(frame1.scales, frame2.scales, pixels_of(frame1.features), options.track);
  std::vector<Partner> partners;
  for (std::size_t i = 0; i < tracks.pixels.size(); ++i)
    if (tracks.found[i]) partners.push_back({static_cast<int>(i), std::nullopt, tracks.pixels[i]});
  return partners;
}

std::vector<FeatureMatch> match(const Features& features1, const Features& features2,
                                const std::string& matcher, const OdometryOptions& options) {
  MatchOptions chosen = options.match;
  chosen.seed = options.seed;
  if (matcher == "windowed")
    return match_windowed(features1.descriptors, pixels_of(features1), features2.descriptors,
                          pixels_of(features2), chosen);
  chosen.matcher = matcher;
  return match_features(features1.descriptors, features2.descriptors, chosen);
}

// Detected positions are moved to fractions of a pixel.
std::vector<Partner> match(const Observation& frame1, const Observation& frame2,
                           const OdometryOptions& options) {
  const std::vector<FeatureMatch> matches =
      match(frame1.features, frame2.features, options.matcher_for(frame1.input), options);
  std::vector<cv::Point2f> pixels1, pixels2;
  for (const FeatureMatch& match : matches) {
    pixels1.push_back(frame1.features.keypoints[match.index1].pt);
    pixels2.push_back(frame2.features.keypoints[match.index2].pt);
  }
  if (options.subpixel != "none") align_patches(frame1.gray, frame2.gray, pixels1, pixels2);
  std::vector<Partner> partners;
  for (std::size_t i = 0; i < matches.size(); ++i)
    partners.push_back({matches[i].index1, matches[i].index2, pixels2[i], matches[i].distance});
  return partners;
}

Eigen::Vector2d to_eigen(const cv::Point2f& pixel) { return {pixel.x, pixel.y}; }

}  // namespace

Correspondences correspond(const Observation& frame1, const Observation& frame2, const Camera& camera,
                           const OdometryOptions& options) {
  if (frame1.gray.empty() || frame2.gray.empty() || frame1.input != frame2.input) return {};
  const std::vector<Partner> partners =
      options.tracks() ? track(frame1, frame2, options) : match(frame1, frame2, options);
  const double sigma = options.keypoint_sigma_px / std::abs(camera.fx);
  Correspondences shared;
  shared.has_depth = !frame1.depth.empty() && !frame2.depth.empty();
  for (const Partner& partner : partners) {
    const cv::KeyPoint& keypoint1 = frame1.features.keypoints[partner.index1];
    const auto detected2 = partner.index2 ? frame2.features.keypoints[*partner.index2].pt : partner.pixel2;
    // What moved is looked up anew; where the lens model has no bearing it stays where it was detected.
    const bool is_detected = partner.index2 && partner.pixel2 == detected2;
    const auto moved =
        is_detected ? std::nullopt : sight(frame2.depth, partner.pixel2, camera, options.depth);
    if (!moved && !partner.index2) continue;
    const Sighting& first = frame1.sightings[partner.index1];
    const Sighting& second = moved ? *moved : frame2.sightings[*partner.index2];
    shared.pixels1.push_back(to_eigen(keypoint1.pt));
    shared.pixels2.push_back(to_eigen(moved ? partner.pixel2 : detected2));
    shared.x1.push_back(first.bearing);
    shared.x2.push_back(second.bearing);
    shared.z1.push_back(first.z);
    shared.z2.push_back(second.z);
    const double scale1 = frame1.features.scale(partner.index1);
    shared.sigma1.push_back(sigma * scale1);
    shared.sigma2.push_back(sigma * (partner.index2 ? frame2.features.scale(*partner.index2) : scale1));
    shared.distance.push_back(partner.distance);
  }
  return shared;
}

}  // namespace framewise
