// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "framewise/geometry/pose.h"
#include "framewise/odometry/local_map.h"
#include "framewise/odometry/motion_filter.h"
#include "framewise/odometry/residual_noise.h"

namespace framewise {

// How far the last camera and the keyframes may be off, jointly, to first order. A camera is placed by
// points: it has a share in the errors of their hosts, in the points' own errors, which the next camera that
// sees them repeats, and in the noise of its measurements, which none repeats. What of the residuals is
// noise, and what is repeated, shows in how they change from one frame to the next.
//   Errors are exp(xi) world_from_cam, xi = (rotation, translation) about the world's origin: one that all
//   keyframes share is shared by all cameras that are placed by them.
//   Residuals that are alike in neighbours do not average out: sums over clusters of them tell by how much,
//   as in Liang, Zeger, Longitudinal data analysis using generalized linear models, Biometrika 1986.
class PoseErrors {
 public:
  // Keyframes and a last camera that are where they are by definition.
  void start(int first_id, int count);

  // The next camera, placed by points. Fewer than three tell nothing: as if it were `moved` by an unknown
  // way.
  void placed(const Pose& world_from_cam, const std::vector<PlacedBy>& points);

  // What `placed` told was taken only in part, the rest is as the motion before foretold it: the last camera
  // has so much less of its noise, and what the prediction erred by.
  void drawn_to_prior(const Pose& world_from_cam, const PriorDraw& draw);

  // The next camera, known only relative to the last: covariance of its rotation (in its own axes) and
  // position (in the world's) if the last one were certain.
  void moved(const Pose& world_from_cam, const Matrix6d& covariance);

  // The last camera was moved by an adjustment of the map: by so much, or less, the camera before may be off
  // that was not.
  void corrected(const Pose& new_from_old);

  // The last camera is the next keyframe; those of ids below first_id are gone.
  void become_keyframe(int first_id);

  // Of the step between the last two cameras: of cam2_from_cam1's tangent as PoseEstimate has it.
  Matrix6d step_covariance(const Pose& world_from_cam1, const Pose& world_from_cam2) const;

 private:
  // How a camera's error follows from one point's: xi = by_error (ray, depth).
  struct Gain {
    PointRef ref;
    Eigen::Matrix<double, 6, 3> by_error;
    Eigen::Matrix3d repeated;  // covariance of what the next camera repeats
    Eigen::Vector3d residual;  // (ray, depth)
  };
  struct CameraErrors {
    Matrix6d covariance = Matrix6d::Zero();
    Eigen::Matrix<double, 6, Eigen::Dynamic> with_keyframes;
    std::vector<Gain> gains;  // by ref, rising
    bool is_keyframe = false;
  };
  // The last camera's gain of each point; null where it was not placed by it.
  std::vector<const Gain*> gains_before(const std::vector<PlacedBy>& points) const;
  static ResidualChanges changes_since_last(const std::vector<PlacedBy>& points,
                                            const std::vector<const Gain*>& earlier);

  int first_id_ = 0;           // of the keyframes
  Eigen::MatrixXd keyframes_;  // joint covariance, six rows each
  CameraErrors last_, earlier_;
  Matrix6d last_with_earlier_ = Matrix6d::Zero();
  Matrix6d difference_ = Matrix6d::Zero();  // of the last two cameras' xi
};

}  // namespace framewise
