// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <span>

#include "framewise/geometry/pose.h"

namespace framewise {

// How poses in a file may have been written other than as world_from_camera with quaternions x y z w.
enum class PoseConvention {
  kAsRead,
  kScalarFirst,  // quaternions w x y z
  kScalarLast,   // quaternions x y z w, in a format that has w x y z
  kInverse,      // camera_from_world
  kBodyFrame,    // of a body whose axes differ from the camera's by a constant rotation
  kNone,         // none of these fits what the images show
  kUntold        // too little motion to tell
};

// Two frames: the truth's poses, and the motion that the images show.
struct ObservedMotion {
  Pose world_from_cam1, world_from_cam2;  // as read
  Pose cam2_from_cam1;                    // measured; the length of t does not matter
  double parallax = 0;                    // what t moves things by: median angle between R x1 and x2 (rad)
};

struct ConventionJudgement {
  PoseConvention convention = PoseConvention::kUntold;
  // Of the poses as read, against the images: median angle between the rotations, and between the directions
  // of translation (rad); NaN where no motion was large enough.
  double rotation_error = 0, direction_error = 0;
  double median_rotation = 0;  // of the motions that tell about rotations (rad)
  Eigen::Matrix3d cam_from_body = Eigen::Matrix3d::Identity();  // for kBodyFrame
  int motions = 0;                                              // that were large enough to tell
};

// Which convention explains the motions. Rotations of at least 2 degrees and directions under at least 1.5
// degrees of parallax count, from four motions on. The poses as read are right where, in the median,
// rotations agree to half of what the camera turned and directions to 45 degrees; another convention explains
// them where it agrees to a third and to 30 degrees, tried in the enumeration's order. The body's rotation is
// fitted to the rotation vectors, or to the directions of a camera that hardly turns (Kabsch). A wrong order
// of quaternions cannot be told from the truth alone: it permutes the components of all quaternions alike,
// which keeps every angle between them.
ConventionJudgement judge_convention(std::span<const ObservedMotion> motions);

}  // namespace framewise
