// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "framewise/geometry/pose.h"
#include "framewise/geometry/so3.h"

// Two-view problems with a known answer, for tests and benchmarks only.
namespace framewise::testing {

enum class Scene {
  kRandom,        // wide: up to 60 deg, baseline 0.1 to 1 of the mean depth
  kOdometry,      // under 5 deg, baseline 1 to 5 % of the depth
  kPlanar,        // all points on one plane, wide motion
  kForward,       // motion along the optical axis, small rotation
  kTinyBaseline,  // baseline 1e-4 of the depth
  kPureRotation   // no baseline at all
};

inline constexpr Scene kAllScenes[] = {Scene::kRandom,  Scene::kOdometry,     Scene::kPlanar,
                                       Scene::kForward, Scene::kTinyBaseline, Scene::kPureRotation};

inline std::string name(Scene scene) {
  constexpr const char* kNames[] = {"Random",  "Odometry",     "Planar",
                                    "Forward", "TinyBaseline", "PureRotation"};
  return kNames[static_cast<int>(scene)];
}

// A generator whose values are the same on every platform (the std distributions' are not).
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  double uniform(double low, double high) { return low + (high - low) * (engine_() >> 11) * 0x1.0p-53; }
  std::size_t index(std::size_t size) { return engine_() % size; }

  // Standard normal (Box-Muller).
  double normal() {
    return std::sqrt(-2.0 * std::log(1.0 - uniform(0, 1))) * std::cos(2.0 * M_PI * uniform(0, 1));
  }
  Eigen::Vector3d normal3() { return {normal(), normal(), normal()}; }
  Eigen::Vector3d direction() { return normal3().normalized(); }

 private:
  std::mt19937_64 engine_;
};

struct TwoViewProblem {
  Pose cam2_from_cam1;                  // t in metres
  std::vector<Eigen::Vector3d> X1, X2;  // points in camera 1 and camera 2 (m), in front of both
  std::vector<Eigen::Vector3d> x1, x2;  // their bearings, exact
};

// `size` points seen by both cameras (field of view about 60 x 46 deg), depth 2 to 8 m.
inline TwoViewProblem make_problem(Scene scene, std::size_t size, Random& random) {
  const auto draw_pixel_ray = [&] {
    return Eigen::Vector3d(random.uniform(-0.61, 0.61), random.uniform(-0.457, 0.457), 1.0);
  };
  while (true) {
    TwoViewProblem p;
    const double mean_depth = 5;
    double angle = 0, baseline = 0;
    Eigen::Vector3d direction = random.direction();
    switch (scene) {
      case Scene::kRandom:
      case Scene::kPlanar:
        angle = random.uniform(0, M_PI / 3), baseline = mean_depth * random.uniform(0.1, 1.0);
        break;
      case Scene::kOdometry:
        angle = random.uniform(0, 5 * M_PI / 180), baseline = mean_depth * random.uniform(0.01, 0.05);
        break;
      case Scene::kForward:
        angle = random.uniform(0, 3 * M_PI / 180), baseline = mean_depth * random.uniform(0.02, 0.2);
        direction = Eigen::Vector3d(0, 0, random.uniform(-1, 1) < 0 ? -1 : 1);
        break;
      case Scene::kTinyBaseline:
        angle = random.uniform(0, 5 * M_PI / 180), baseline = mean_depth * 1e-4;
        break;
      case Scene::kPureRotation:
        angle = random.uniform(0, 20 * M_PI / 180);
        break;
    }
    p.cam2_from_cam1 = {so3_exp(angle * random.direction()), baseline * direction};

    // A plane that faces the camera by less than 60 degrees.
    Eigen::Vector3d normal = random.direction();
    while (std::abs(normal.z()) < 0.5) normal = random.direction();
    const double plane_distance = mean_depth * normal.z();

    for (int tries = 0; p.X1.size() < size && tries < 200 * static_cast<int>(size); ++tries) {
      const Eigen::Vector3d ray = draw_pixel_ray();
      const double depth = scene == Scene::kPlanar ? plane_distance / normal.dot(ray) : random.uniform(2, 8);
      if (!(depth > 1) || depth > 20) continue;
      const Eigen::Vector3d X1 = depth * ray;
      const Eigen::Vector3d X2 = p.cam2_from_cam1 * X1;
      if (X2.z() < 0.2 || std::abs(X2.x()) > 0.61 * X2.z() || std::abs(X2.y()) > 0.457 * X2.z()) continue;
      p.X1.push_back(X1);
      p.X2.push_back(X2);
      p.x1.push_back(X1.normalized());
      p.x2.push_back(X2.normalized());
    }
    if (p.X1.size() == size) return p;
  }
}

// Angle between two rotations, and between two translation directions (rad). NaN answers give pi, so no
// comparison is passed by a NaN.
inline double rotation_error(const Eigen::Matrix3d& a, const Eigen::Matrix3d& b) {
  const double error = rotation_angle(a.transpose() * b);
  return std::isfinite(error) ? error : M_PI;
}
inline double direction_error(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  const double error = std::atan2(a.cross(b).norm(), a.dot(b));
  return std::isfinite(error) ? error : M_PI;
}

}  // namespace framewise::testing
