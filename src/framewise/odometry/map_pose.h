// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

#include "framewise/geometry/depth_noise.h"
#include "framewise/geometry/place_noise.h"
#include "framewise/geometry/pose.h"
#include "framewise/robust/ransac_options.h"

namespace framewise {

// A point of the map, in the axes of a reference, and what a camera saw of it.
struct MapMatch {
  Eigen::Vector3d X;    // m
  Eigen::Matrix3d S;    // its covariance (m^2)
  Eigen::Vector3d ray;  // on the plane z = 1
  PlaceNoise noise;     // of the ray
  double z;             // measured depth (m); NaN where unknown
  double z_share = 1;   // what z has of a single pixel's noise
  // d (where the point is seen - ray) / d readout, on the plane.
  Eigen::Vector2d by_readout = Eigen::Vector2d::Zero();
  double skew = 0;  // how much a shutter shifts the host's view or this one, whichever is more, likewise
};

// Whether a pose has the point before the camera and within max_error of where it is seen (pixels / focal
// length).
bool agrees(const MapMatch& match, const Pose& cam_from_reference, double max_error);

struct FirstPoseOptions {
  double max_error = 4.0 / 525;  // reprojection error of a match that agrees (pixels / focal length)
  int min_inliers = 15;          // fewer agree by chance
  RansacOptions ransac;
};

// A pose cam_from_reference that matches agree with, some of which are wrong: from the prior by robust least
// squares where most of them agree with what comes out, else by P3P in RANSAC. Empty where too few agree.
struct FirstPose {
  Pose cam_from_reference;
  int inliers = 0;
  int iterations = 0;  // of RANSAC; 0: the prior sufficed
};
std::optional<FirstPose> first_pose(const std::vector<MapMatch>& matches, const Pose& prior,
                                    const FirstPoseOptions& options);

// The most likely pose under the noise of rays, depths and map points, with that noise scaled to what the
// residuals show. A depth that disagrees by more than three sigma counts for nothing; its ray still does.
struct MapPose {
  Pose cam_from_reference;
  Matrix6d covariance;  // of the tangent (rotation, translation) as of Pose
  std::vector<std::uint8_t> inliers;
  int num_inliers = 0;
  double ray_scale = 1, depth_scale = 1;  // noise shown over noise said
};
// How far the shutter's readout is off, as the residuals of a refined pose have it, with the pose free to
// follow: Gauss-Newton's seventh unknown.
struct ReadoutCorrection {
  double seconds = 0, information = 0;  // 1/s^2
};
ReadoutCorrection readout_correction(const std::vector<MapMatch>& matches, const MapPose& pose);

// How far apart two poses see the points, root mean square (pixels / focal length).
double shift_between(const std::vector<MapMatch>& matches, const Pose& pose1, const Pose& pose2);

MapPose refine_map_pose(const std::vector<MapMatch>& matches, const Pose& initial, const DepthNoise& noise);

}  // namespace framewise
