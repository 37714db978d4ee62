// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>

#include "framewise/geometry/image_surface.h"
#include "framewise/geometry/pose.h"

namespace framewise {

// A point seen along x1 in camera 1 and x2 in camera 2: lambda2 x2 = lambda1 R x1 + t. Depths have the unit
// of t.
struct TriangulatedPoint {
  Eigen::Vector3d X1;       // in camera 1
  double lambda1, lambda2;  // along the unit bearings; negative: behind that camera
  double parallax;          // angle between the two rays (rad)

  bool in_front() const { return lambda1 > 0 && lambda2 > 0; }
};

// Midpoint of the shortest segment between both rays, which need neither unit length nor to meet.
// Empty where the rays are parallel.
//   Hartley and Sturm, Triangulation, CVIU 1997.
std::optional<TriangulatedPoint> triangulate_midpoint(const Pose& cam2_from_cam1, const Eigen::Vector3d& x1,
                                                      const Eigen::Vector3d& x2);

// The pair nearest to (x1, x2) whose rays meet, and its cost: the sum of both squared errors, on the plane
// z = 1 (x1.z = x2.z = 1) or as squared sines of the angles on the sphere (|x1| = |x2| = 1). t must not be 0.
//   Plane: Lindstrom, Triangulation Made Easy, CVPR 2010. Sphere: Oliensis, Exact Two-Image Structure from
//   Motion, PAMI 2002; Lee and Civera, Closed-Form Optimal Two-View Triangulation Based on Angular Errors,
//   ICCV 2019.
struct MeetingRays {
  Eigen::Vector3d x1, x2;
  double cost;
};
MeetingRays nearest_meeting_rays(const Pose& cam2_from_cam1, const Eigen::Vector3d& x1,
                                 const Eigen::Vector3d& x2, ImageSurface surface);

// The maximum-likelihood point: triangulates the nearest rays that meet. Rays of any length (on the plane:
// z > 0). Empty where the corrected rays are parallel or t is 0.
std::optional<TriangulatedPoint> triangulate_optimal(const Pose& cam2_from_cam1, const Eigen::Vector3d& x1,
                                                     const Eigen::Vector3d& x2,
                                                     ImageSurface surface = ImageSurface::kSphere);

// Angle between the rays R x1 and x2 (rad): 0 where a point is too far away to tell of a translation.
double parallax(const Eigen::Matrix3d& R, const Eigen::Vector3d& x1, const Eigen::Vector3d& x2);

}  // namespace framewise
