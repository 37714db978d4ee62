// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "framewise/evaluation/association.h"

namespace framewise {

// What of a pose error is counted. E is the rigid motion that is the identity where there is no error.
enum class PoseRelation {
  kTranslation,         // |t(E)| (m); of absolute errors: the distance of the positions
  kRotationAngle,       // angle of R(E) (rad)
  kRotationPart,        // |R(E) - I|, Frobenius
  kFull,                // |E - I|, Frobenius of the 4x4 matrices: metres and radians mixed
  kPointDistance,       // absolute: as translation. Relative: ||t(A)| - |t(B)|| (m), blind to rotation
  kPointDistanceRatio,  // relative only: point_distance / |t(A)|; pairs that truly stood still are left out
  kDirection,           // relative only: distance of the unit vectors along t(A) and t(B), 0 to 2, for steps
                        // whose length is unknown
};

// Which way round the relative error of a true motion A and an estimated motion B is formed. The angles
// agree, the translations do not.
//   evo: E = B^-1 A, as evo and the KITTI devkit have it
//   tum: E = A B^-1, as the TUM RGB-D benchmark's tools have it
enum class RelativeErrorOrder { kEvo, kTum };

// The motion of one pair of poses, from_cam_to: pose of the later camera in the earlier one.
struct RelativeMotion {
  double from_time;  // s, the estimate's stamps
  double to_time;
  Pose reference;  // A
  Pose estimate;   // B
  // |t(A)| and |t(B)| from the positions themselves, which rounding of the rotations does not touch (m).
  double reference_distance;
  double estimate_distance;
  // world_from_cam at to_time, both in the reference's world.
  Pose reference_at_end;
  Pose estimate_at_end;
};

// One error a pose. point_distance_ratio and direction throw std::invalid_argument.
std::vector<double> absolute_errors(const TrajectoryPair& matched, PoseRelation relation);

// One error a motion.
std::vector<double> relative_errors(std::span<const RelativeMotion> motions, PoseRelation relation,
                                    RelativeErrorOrder order);

// A plane of the world, for figures of vehicles that drive on one.
enum class Plane { kXy, kXz, kYz };

// The positions in the plane; of the orientation the turn about its normal alone, which is that component of
// the Euler angles R = Rz Ry Rx (as evo has it; about y it is therefore within +-90 degrees).
Trajectory projected(const Trajectory& trajectory, Plane plane);

}  // namespace framewise
