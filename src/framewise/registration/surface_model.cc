// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/registration/surface_model.h"

#include <algorithm>
#include <cmath>

#include "framewise/geometry/so3.h"
#include "framewise/registration/option_check.h"

namespace framewise {

void SurfaceModelOptions::check() const {
  check_option(least_overlap >= 0 && least_overlap <= 1, "least_overlap", least_overlap, "0 to 1");
  check_option(most_turn_deg > 0, "most_turn_deg", most_turn_deg, "more than 0");
  check_option(most_distance > 0, "most_distance", most_distance, "more than 0");
  check_option(most_weight >= 1, "most_weight", most_weight, "at least 1");
  check_option(inherited_weight >= 0, "inherited_weight", inherited_weight, "0 or more");
  check_option(agreement > 0, "agreement", agreement, "more than 0");
  check_option(refit_every >= 1, "refit_every", refit_every, "at least 1");
}

SurfaceModel::SurfaceModel(const SurfaceMaker& maker, const AlignmentOptions& alignment,
                           const SurfaceModelOptions& options)
    : maker_(&maker), alignment_(alignment), options_(options) {
  alignment.check();
  options.check();
}

void SurfaceModel::start(const SurfacePyramid& frame, const Pose& world_from_cam) {
  surface_ = frame;
  world_from_keyframe_ = world_from_cam;
  frames_since_fit_ = 0;
  ++keyframes_;
  if (frame.empty()) return;
  inverse_depth_.assign(frame[0].measured_inverse.begin(),
                        frame[0].measured_inverse.begin() + frame[0].grid.size());
  weight_.assign(inverse_depth_.size(), 0);
  for (std::size_t i = 0; i < weight_.size(); ++i) weight_[i] = inverse_depth_[i] > 0 ? 1.0f : 0.0f;
}

std::optional<SurfaceAlignment> SurfaceModel::align(const SurfacePyramid& frame,
                                                    const Pose& world_from_cam_guess) const {
  return align_surfaces(surface_, frame, world_from_cam_guess.inverse() * world_from_keyframe_, alignment_);
}

bool SurfaceModel::has_moved_on(const Pose& keyframe_from_cam, double overlap) const {
  const double depth = std::max(surface_[0].centre.z(), 1e-3);
  return overlap < options_.least_overlap ||
         rotation_angle(keyframe_from_cam.R) > options_.most_turn_deg * M_PI / 180 ||
         keyframe_from_cam.t.norm() > options_.most_distance * depth;
}

void SurfaceModel::add(const SurfacePyramid& frame, const Pose& world_from_cam, double overlap) {
  if (frame.empty()) return;
  const Pose keyframe_from_cam = world_from_keyframe_.inverse() * world_from_cam;
  if (has_moved_on(keyframe_from_cam, overlap)) {
    const SurfacePyramid old_surface = std::move(surface_);
    const std::vector<float> old_weight = std::move(weight_);
    start(frame, world_from_cam);
    fuse(old_surface[0], keyframe_from_cam.inverse(), &old_weight);
    surface_ = maker_->from_inverse_depth(inverse_depth_);
    return;
  }
  fuse(frame[0], keyframe_from_cam, nullptr);
  if (++frames_since_fit_ < options_.refit_every) return;
  surface_ = maker_->from_inverse_depth(inverse_depth_);
  frames_since_fit_ = 0;
}

// Each pixel of the keyframe, at the depth it has, falls on a pixel of the frame, whose plane meets the
// keyframe's ray: (R n) . (ray / w - t) = distance.
void SurfaceModel::fuse(const Surface& frame, const Pose& keyframe_from_cam,
                        const std::vector<float>* weights) {
  const SurfaceGrid& from = surface_.empty() ? frame.grid : surface_[0].grid;
  const SurfaceGrid& to = frame.grid;
  const Pose cam_from_keyframe = keyframe_from_cam.inverse();
  const Eigen::Matrix3f R = cam_from_keyframe.R.cast<float>();
  const Eigen::Vector3f t = cam_from_keyframe.t.cast<float>();
  const float agreement = static_cast<float>(options_.agreement);
  const float most = static_cast<float>(options_.most_weight);
  for (int v = 0; v < from.height; ++v)
    for (int u = 0; u < from.width; ++u) {
      const std::size_t i = static_cast<std::size_t>(v) * from.width + u;
      const float w = inverse_depth_[i];
      if (!(w > 0)) continue;
      const Eigen::Vector3f ray((u - from.cx) / from.fx, (v - from.cy) / from.fy, 1);
      const Eigen::Vector3f turned = R * ray;
      const Eigen::Vector3f q = turned + w * t;
      if (!(q.z() > 1e-6f)) continue;
      const float column = q.x() / q.z() * to.fx + to.cx + 0.5f, row = q.y() / q.z() * to.fy + to.cy + 0.5f;
      if (!(column >= 0 && row >= 0 && column < to.width && row < to.height)) continue;
      const std::size_t k = static_cast<std::size_t>(row) * to.width + static_cast<std::size_t>(column);
      if (!(frame.precision[k] > 0)) continue;
      const Eigen::Vector3f n(frame.nx[k], frame.ny[k], frame.nz[k]);
      // The plane's slope through the pixel's own measurement: planes are rounded at edges, and what is
      // rounded twice would not fit what is rounded once. n . (turned / w + t) = distance.
      if (!(frame.measured_inverse[k] > 0)) continue;
      const float distance = frame.distance[k] * frame.inverse_depth[k] / frame.measured_inverse[k];
      const float seen = n.dot(turned) / (distance - n.dot(t));
      if (!(std::abs(seen - w) < agreement * w)) continue;
      const float weight =
          weights ? std::min((*weights)[k], static_cast<float>(options_.inherited_weight)) : 1.0f;
      if (!(weight > 0)) continue;
      inverse_depth_[i] = w + (seen - w) * (weight / (weight_[i] + weight));
      weight_[i] = std::min(weight_[i] + weight, most);
    }
}

}  // namespace framewise
