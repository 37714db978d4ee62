// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/odometry/correspond.h"

#include <cmath>
#include <vector>

#include "framewise/features/matching.h"
#include "framewise/features/patch_alignment.h"

namespace framewise {
namespace {

// Where the partners of the first frame's features are in frame 2, to fractions of a pixel.
std::vector<cv::Point2f> positions_in_frame2(const Observation& frame1, const Observation& frame2,
                                             const std::vector<FeatureMatch>& matches,
                                             const OdometryOptions& options) {
  std::vector<cv::Point2f> pixels1, pixels2;
  for (const FeatureMatch& match : matches) {
    pixels1.push_back(frame1.features.keypoints[match.index1].pt);
    pixels2.push_back(frame2.features.keypoints[match.index2].pt);
  }
  if (options.subpixel != "none") align_patches(frame1.gray, frame2.gray, pixels1, pixels2);
  return pixels2;
}

Eigen::Vector2d to_eigen(const cv::Point2f& pixel) { return {pixel.x, pixel.y}; }

}  // namespace

Correspondences correspond(const Observation& frame1, const Observation& frame2, const Camera& camera,
                           const OdometryOptions& options) {
  const auto matches = match_brute_force(frame1.features.descriptors, frame2.features.descriptors);
  const auto positions2 = positions_in_frame2(frame1, frame2, matches, options);
  const double sigma = options.keypoint_sigma_px / std::abs(camera.fx);
  Correspondences shared;
  shared.has_depth = !frame1.depth.empty() && !frame2.depth.empty();
  for (std::size_t i = 0; i < matches.size(); ++i) {
    const auto [index1, index2, distance] = matches[i];
    const cv::Point2f detected = frame2.features.keypoints[index2].pt;
    // What moved is looked up anew; where the lens model has no bearing it stays where it was detected.
    const auto moved =
        positions2[i] != detected ? sight(frame2.depth, positions2[i], camera, options.depth) : std::nullopt;
    const Sighting& first = frame1.sightings[index1];
    const Sighting& second = moved ? *moved : frame2.sightings[index2];
    shared.pixels1.push_back(to_eigen(frame1.features.keypoints[index1].pt));
    shared.pixels2.push_back(to_eigen(moved ? positions2[i] : detected));
    shared.x1.push_back(first.bearing);
    shared.x2.push_back(second.bearing);
    shared.z1.push_back(first.z);
    shared.z2.push_back(second.z);
    shared.sigma1.push_back(sigma * frame1.features.scale(index1));
    shared.sigma2.push_back(sigma * frame2.features.scale(index2));
    shared.distance.push_back(static_cast<float>(distance));
  }
  return shared;
}

}  // namespace framewise
