// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>

#include "framewise/odometry/options.h"
#include "framewise/odometry/pose_estimate.h"
#include "framewise/odometry/step.h"
#include "framewise/registration/surface_model.h"

namespace framewise {

// Steps of depth images by their surfaces: each frame is aligned with the frame before it (options.geometry
// "frame") or with a keyframe's surface that all frames since have made better ("model").
//   Features in colour then have their say once more: the two poses are weighed by their covariances, where
//   they do not contradict each other. Features of a depth image do not, they know no more than its surfaces.
//   The alignment begins at the step that features gave or at the motion so far continued, whichever fits
//   more of the surfaces. What they leave free, a corridor's length say, is taken from features in colour, or
//   else foretold by the motion so far: features in the depth image know no more than the depth image.
class GeometricRefinement {
 public:
  // Throws std::invalid_argument for cameras that surfaces cannot be made of (surface_pyramid.h).
  GeometricRefinement(const Camera& camera, const OdometryOptions& options);

  // A frame's surfaces; empty where it has no depth. Pure: may be called from any thread. A LiDAR's points
  // are made dense first.
  SurfacePyramid surface(const cv::Mat& depth) const;

  // Frames in their order. from_features: the step from the frame directly before. The answer: the step from
  // the last frame whose pose was measured. Status: ok; low-parallax where a direction was left free;
  // no-depth where the depth image shows too little and lost where it does not fit, unless the features'
  // step serves.
  // in_color: the features were found in colour.
  Step refine(double time, std::shared_ptr<const SurfacePyramid> surface, const Step& from_features,
              bool in_color);

 private:
  struct Found {
    SurfaceAlignment alignment;
    PoseEstimate cam_from_base;
    Pose world_from_cam;
  };

  // The camera whose surface frames are aligned with: the keyframe's, or the frame before.
  const Pose& world_from_base() const;
  PoseEstimate reference_from_base() const;
  Pose predicted(double time) const;
  Pose guess(const SurfacePyramid& surface, const Pose& prediction,
             const std::optional<Pose>& by_features) const;
  std::optional<Found> align(const SurfacePyramid& surface, const Pose& world_from_cam_guess) const;
  std::optional<Found> find(const SurfacePyramid& surface, const Pose& prediction,
                            const std::optional<Pose>& by_features, bool in_color) const;
  // With the features' say.
  Found weighed(const Found& found, const Step& from_features) const;
  // covariance: of cam_from_base.
  void refer_to(double time, std::shared_ptr<const SurfacePyramid> surface, const Pose& world_from_cam,
                const Matrix6d& covariance, double overlap);

  bool uses_model_;
  SurfaceMaker maker_;
  AlignmentOptions alignment_;
  SurfaceModel model_;
  std::shared_ptr<const SurfacePyramid> reference_;  // of the last frame with a measured pose
  Pose world_from_reference_;
  Matrix6d reference_covariance_ = Matrix6d::Zero();  // of reference_from_base
  bool newest_is_reference_ = false;
  double reference_time_ = 0, motion_time_ = 0;  // s
  Pose motion_;                                  // cam1_from_cam2 of the last two, over motion_time_
};

}  // namespace framewise
