// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/odometry/keyframe_choice.h"

#include <algorithm>

namespace framewise {

bool wants_keyframe(const KeyframeNeed& need, int image_width, const MapOptions& options) {
  if (need.known < options.keyframe_share * need.known_at_keyframe) return true;
  if (!need.lives_on_motion) return false;
  return !need.shift_px || *need.shift_px > options.keyframe_shift * image_width;
}

bool needs_adjustment(const KeyframeNeed& need, bool follows_keyframe, int image_width,
                      const MapOptions& options) {
  if (need.lives_on_motion || options.adjust == "always") return true;
  const bool has_moved = need.shift_px && *need.shift_px > options.keyframe_shift * image_width;
  return follows_keyframe && has_moved && options.adjust == "auto";
}

std::optional<double> median_shift(const std::vector<Eigen::Vector3d>& x_in_keyframe,
                                   const Pose& world_from_keyframe, const Pose& world_from_cam) {
  std::vector<double> shifts;
  for (const Eigen::Vector3d& X : x_in_keyframe) {
    if (X.z() <= 0) continue;
    const Eigen::Vector3d turned = world_from_cam.R.transpose() * world_from_keyframe.R * X;
    const Eigen::Vector3d x = world_from_cam.inverse() * (world_from_keyframe * X);
    if (turned.z() > 0 && x.z() > 0)
      shifts.push_back((turned.head<2>() / turned.z() - x.head<2>() / x.z()).norm());
  }
  if (shifts.empty()) return std::nullopt;
  const auto middle = shifts.begin() + static_cast<std::ptrdiff_t>(shifts.size() / 2);
  std::nth_element(shifts.begin(), middle, shifts.end());
  return *middle;
}

}  // namespace framewise
