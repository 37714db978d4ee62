// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "framewise/geometry/correspondences.h"
#include "framewise/odometry/frame_pair.h"
#include "framewise/odometry/local_map.h"
#include "framewise/odometry/map_matching.h"
#include "framewise/odometry/map_pose.h"
#include "framewise/odometry/pose_errors.h"
#include "framewise/odometry/recent_turns.h"

namespace framewise {

// A frame's pose measured against the map, in the axes of the frame before.
struct Placed {
  MapPose pose;
  std::vector<TrackedPoint> points;
  std::vector<MapMatch> matches;  // the same points
  Shutter shutter;
  int sought = 0, matched = 0, iterations = 0;
  bool is_foretold = false;  // its position; measured is the rotation alone
};

// What a frame is placed against.
struct MapView {
  const LocalMap& map;
  const Camera& camera;
  const OdometryOptions& options;
  const RecentTurns& turns;
  double readout;  // of the shutter (s)
  Pose world_from_before;
  double time_before;
  double usual_noise_px = 0;  // of the rays of the frames placed lately
};

// A frame that is predicted to be at world_from_cam. Patches are looked for where that foretells them, a few
// from afar and then all; where too few are found, or what is found is noisy, features are matched, near and
// then anywhere, and what explains the frame better is taken. Empty where what is found is not credible.
// unsure: what the patches alone told, where that is no more than chance may.
std::optional<Placed> place(MapFrame& frame, const Pose& predicted, const MapView& view,
                            std::optional<Placed>& unsure);

// Where the map has nothing that a frame shows: by what it has in common with an earlier frame that has depth
// (frame_pair.h), and, from there, with the map all the same. Without points where only the pair tells the
// pose.
std::optional<Placed> place_by_pair(const MapFrame& frame, FrameView& frame_view, FrameView& earlier,
                                    const Pose& world_from_earlier, const Pose& predicted,
                                    const MapView& view);

// The same where the earlier frame has no depth, or too little of it where both see anything: by their rays
// and the depths that are known (view_pair.h).
std::optional<Placed> place_by_views(const MapFrame& frame, FrameView& frame_view, FrameView& earlier,
                                     const Pose& world_from_earlier, const Pose& predicted,
                                     const MapView& view);

// By patches alone: points of some keyframes, at most max_points, each looked for from `coarser` levels above
// its own, and the pose refined over what is found.
Placed place_near(const MapFrame& frame, const Pose& cam_from_before, const std::vector<int>& keyframes,
                  int coarser, int max_points, const MapView& view);

// Enough is found, and most of it agrees, to the noise of a place that is found at all. least_found: the
// share of the patches; a fifth is found anywhere.
bool is_credible(const Placed& placed, const MapOptions& options, double least_found = 0.2);

// Whether one place of a frame has more of its points agree, to less noise, than another: the larger sum of
// inverse variances. Patches far from where they were expected are drawn to what looks alike, and their pose
// is one that half of them agree with to a pixel; the true one has most agree to a tenth.
bool explains_better(const Placed& one, const Placed& other);

// Noise of its rays that its residuals show (pixels).
double shown_noise_px(const Placed& placed, const MapOptions& options);

// The inliers, as they count for the errors of the pose.
std::vector<PlacedBy> placed_by(const Placed& placed, const DepthNoise& noise);

// The shutter of a frame that is turned so against the one before.
Shutter shutter_of(const Pose& cam_from_before, double time, const MapView& view);

// Map points where the frame before would see them and where this one does.
Correspondences seen_from_before(const Placed& placed, const Camera& camera);

}  // namespace framewise
