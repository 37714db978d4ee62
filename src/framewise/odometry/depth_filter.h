// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "framewise/odometry/local_map.h"
#include "framewise/odometry/map_matching.h"

namespace framewise {

// Points without depth: a feature of a keyframe with a guess of its inverse depth, which each frame that
// finds it along its epipolar line makes surer. Until then it is a direction, which tells how a camera turns.
//   Davison et al., MonoSLAM, PAMI 2007 (partially initialised features); Forster, Pizzoli, Scaramuzza, SVO:
//   fast semi-direct monocular visual odometry, ICRA 2014 (depth filter).

struct InverseDepth {
  double value, sigma;  // 1/m
};

// What is known of the depths in an image.
struct DepthAtPixel {
  Eigen::Vector2d pixel;
  double inverse_z;
};

// As its nearest neighbours have it, so uncertain that what is twice as near or at infinity is within two
// sigma. Empty where none is known.
std::optional<InverseDepth> guessed_inverse_depth(const std::vector<DepthAtPixel>& known,
                                                  const Eigen::Vector2d& pixel);

// Makes points of those features of a keyframe that no place taken is near. Returns how many.
int add_guessed_points(Keyframe& keyframe, const std::vector<Eigen::Vector2d>& taken,
                       const std::vector<DepthAtPixel>& known, const Camera& camera);

// Takes in that another camera sees the point along `ray` (z = 1), whose coordinates have `sigma`:
//   argmin |ray x (R host_ray + inverse_z t)|^2 / (z sigma)^2 + (inverse_z - known)^2 / variance.
// False, and nothing is taken, where this misses the epipolar line by more than max_error (on the plane) or
// disagrees with what was known by more than three sigma.
bool take_in(MapPoint& point, const Eigen::Vector3d& ray, double sigma, const Pose& cam_from_host,
             double max_error);

// Looks for the points of some keyframes whose depth is not known, but for those that were tracked, along
// their epipolar lines in a placed frame, and takes in what it finds. Those that are sought in vain are given
// up. Returns where they are.
std::vector<TrackedPoint> trace_points(LocalMap& map, const std::vector<int>& keyframes,
                                       const std::vector<PointRef>& tracked, const MapFrame& frame,
                                       const Pose& world_from_cam, const Shutter& shutter,
                                       const Camera& camera);

}  // namespace framewise
