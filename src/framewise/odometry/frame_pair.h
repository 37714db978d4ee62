// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "framewise/geometry/depth_noise.h"
#include "framewise/odometry/map_frame.h"
#include "framewise/odometry/map_pose.h"

namespace framewise {

// A frame as another one is related to it where no map helps: with many features, described when they are
// needed.
class FrameView {
 public:
  FrameView() = default;
  explicit FrameView(const MapFrame& frame);  // shares its images

  bool empty() const { return frame_.levels.empty(); }
  const MapFrame& frame() const { return frame_; }
  const MapFrame& described(const Camera& camera);

 private:
  MapFrame frame_;
};

struct FramePairOptions {
  double sigma_px = 1;  // of a corner, which lies at a whole pixel of its level
  double max_error_px = 4;
  int min_inliers = 40;      // of a thousand matches some ten agree with any pose
  OdometryOptions odometry;  // RANSAC, depth and its noise
};

// cam2_from_cam1 of two frames by their features alone, anywhere in the image: points that the first one's
// depth places and the second one sees, from the prior or by P3P in RANSAC (first_pose), refined. Empty where
// too few agree.
std::optional<MapPose> pose_from_pair(FrameView& first, FrameView& second, const Pose& prior,
                                      const Camera& camera, const FramePairOptions& options);

}  // namespace framewise
