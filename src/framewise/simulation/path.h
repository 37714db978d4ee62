// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "framewise/geometry/pose.h"

namespace framewise {

// Where a camera is at a time and how it moves then: what truth and inertial sensors need.
struct Motion {
  Pose world_from_cam;  // optical axes (x right, y down, z forward), z of the world up
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();      // along the world's axes (m/s)
  Eigen::Vector3d acceleration = Eigen::Vector3d::Zero();  // along the world's axes (m/s^2)
  Eigen::Vector3d angular_rate =
      Eigen::Vector3d::Zero();  // against the world, along the camera's axes (rad/s)
};

// The motion at any time (s). Position and rotation are twice continuously differentiable; velocity,
// acceleration and angular rate are their exact derivatives.
using Path = std::function<Motion(double time)>;

// Where a camera can be in a scene.
struct PathSpace {
  Eigen::AlignedBox3d free_space;      // nothing is in it or near it
  double pitch;                        // the angle above the horizon at which there is most to see (rad)
  std::vector<Eigen::Vector3d> route;  // corners of a closed way for those who walk and fly far
};

// A route within a box: the ellipse that reaches nine tenths of the way to its sides.
std::vector<Eigen::Vector3d> round_way(const Eigen::AlignedBox3d& box);

// Carried around the middle of a space for as long as one likes, looking across it and about: an ellipse with
// sums of sines in distance, height, heading, pitch and roll, and a hand's tremor. In a box of 4 m x 3 m it
// moves at 0.15 to 0.55 m/s and turns at up to 30 deg/s. Never leaves the box.
Path handheld_path(const PathSpace& space, std::uint64_t seed);

// Around the middle, at 0.5 m/s at the most, looking at it.
Path orbit_path(const PathSpace& space, std::uint64_t seed);

// In one place as well as a drone can: 5 cm and 3 degrees about it.
Path hover_path(const PathSpace& space, std::uint64_t seed);

// In exactly one place, turning all around at 20 deg/s and up, down and over by sums of sines.
Path pure_rotation_path(const PathSpace& space, std::uint64_t seed);

// Along the optical axis, ahead and back at up to 0.8 m/s, without any turn.
Path forward_path(const PathSpace& space, std::uint64_t seed);

// Along the route at 1.3 m/s with the head's bobbing, two steps a second.
Path walk_path(const PathSpace& space, std::uint64_t seed);

// Along the route as fast as 15 m/s, 35 m/s^2 to the side and 600 deg/s allow, banking in the turns.
Path drone_race_path(const PathSpace& space, std::uint64_t seed);

// handheld, orbit, hover, pure-rotation, forward, walk, drone-race.
const std::vector<std::string>& path_names();

// The path of that name; throws std::invalid_argument for a name that is none.
Path named_path(const std::string& name, const PathSpace& space, std::uint64_t seed);

}  // namespace framewise
