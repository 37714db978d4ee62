// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "robust_problems.h"

// Two-view problems of a named motion, for the study of which solver wins where (docs/solver_study.md): a
// camera of 640x480 pixels and focal length 525 px, points at 0.8 to 3.2 m (mean 2 m) that both views see.
namespace framewise::bench {

constexpr double kMeanDepth = 2;  // m

enum class Direction { kSideways, kForward, kMixed };

inline const char* name_of(Direction direction) {
  constexpr const char* kNames[] = {"sideways", "forward", "mixed"};
  return kNames[static_cast<int>(direction)];
}

struct Motion {
  Direction direction = Direction::kMixed;
  double step_percent = 1;  // of the mean depth
  double rotation_deg = 0;
};

struct StudySetting {
  Motion motion;
  bool planar = false;  // all points on one plane that faces the camera by less than 60 degrees
  std::size_t size = 200;
  double inlier_share = 1;
  double noise_px = 0.5;  // of each coordinate in both images
};

inline Eigen::Vector3d draw_direction(Direction direction, testing::Random& random) {
  switch (direction) {
    case Direction::kSideways: {
      const double angle = random.uniform(0, 2 * M_PI);
      return {std::cos(angle), std::sin(angle), 0};
    }
    case Direction::kForward:
      return {0, 0, random.uniform(-1, 1) < 0 ? -1.0 : 1.0};
    default:
      return random.direction();
  }
}

inline bool seen(const Eigen::Vector3d& X) {
  if (X.z() < 0.2) return false;
  const Eigen::Vector2d px = pixel(X);
  return px.x() >= 0 && px.x() <= 640 && px.y() >= 0 && px.y() <= 480;
}

// A point that both views see; nothing after many tries (a plane that has left the image).
inline std::optional<Eigen::Vector3d> draw_point(const Pose& cam2_from_cam1, const Eigen::Vector3d& normal,
                                                 bool planar, testing::Random& random) {
  for (int tries = 0; tries < 500; ++tries) {
    const Eigen::Vector3d x = ray({random.uniform(0, 640), random.uniform(0, 480)});
    const double depth = planar ? kMeanDepth * normal.z() / normal.dot(x) : random.uniform(0.8, 3.2);
    if (!(depth > 0.4) || depth > 8) continue;
    if (seen(cam2_from_cam1 * (depth * x))) return depth * x;
  }
  return std::nullopt;
}

inline std::vector<Eigen::Vector3d> draw_points(const StudySetting& setting, const Pose& cam2_from_cam1,
                                                testing::Random& random) {
  while (true) {
    Eigen::Vector3d normal = random.direction();
    while (normal.z() < 0.5) normal = random.direction();
    std::vector<Eigen::Vector3d> points;
    while (points.size() < setting.size) {
      const auto X = draw_point(cam2_from_cam1, normal, setting.planar, random);
      if (!X) break;
      points.push_back(*X);
    }
    if (points.size() == setting.size) return points;
  }
}

// Wrong matches come first: two pixels that have nothing in common. Depths carry the noise of a Kinect
// (geometry/depth_noise.h).
inline RobustProblem make_study_problem(const StudySetting& setting, testing::Random& random) {
  RobustProblem p;
  p.noise_px = setting.noise_px;
  p.cam2_from_cam1 = {
      so3_exp(setting.motion.rotation_deg * M_PI / 180 * random.direction()),
      kMeanDepth * setting.motion.step_percent / 100 * draw_direction(setting.motion.direction, random)};
  const auto points = draw_points(setting, p.cam2_from_cam1, random);
  const DepthNoise depth;
  const double wrong = (1 - setting.inlier_share) * static_cast<double>(setting.size);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector3d X[] = {points[i], p.cam2_from_cam1 * points[i]};
    const bool good = static_cast<double>(i) + 0.5 > wrong;
    p.good.push_back(good);
    for (int view = 0; view < 2; ++view) {
      const Eigen::Vector2d noise(random.normal(), random.normal());
      const Eigen::Vector2d anywhere(random.uniform(0, 640), random.uniform(0, 480));
      const Eigen::Vector2d px = good ? Eigen::Vector2d(pixel(X[view]) + setting.noise_px * noise) : anywhere;
      const double z = X[view].z() + depth.sigma(X[view].z()) * random.normal();
      (view == 0 ? p.px1 : p.px2).push_back(px);
      (view == 0 ? p.x1 : p.x2).push_back(ray(px).normalized());
      (view == 0 ? p.X1 : p.X2).push_back(z * ray(px));
    }
  }
  return p;
}

// Errors of many answers to problems of one setting.
struct StudyErrors {
  std::vector<double> rotation_deg;   // of the answers
  std::vector<double> direction_deg;  // of the answers that have one, where there is a step
  std::size_t problems = 0, failures = 0;

  // A failure is no answer, or a rotation that is wrong by more than 5 degrees.
  void add(const std::optional<Pose>& pose, const Pose& truth) {
    ++problems;
    const double rotation = pose ? 180 / M_PI * testing::rotation_error(pose->R, truth.R) : 180.0;
    failures += !pose || rotation > 5;
    if (!pose) return;
    rotation_deg.push_back(rotation);
    if (truth.t.norm() > 0 && pose->t.norm() > 0)
      direction_deg.push_back(180 / M_PI * testing::direction_error(pose->t, truth.t));
  }
  double failure_percent() const {
    return problems == 0 ? NAN : 100.0 * static_cast<double>(failures) / static_cast<double>(problems);
  }
  double rms_deg() const {
    double sum = 0;
    for (const double e : rotation_deg) sum += e * e;
    return rotation_deg.empty() ? NAN : std::sqrt(sum / static_cast<double>(rotation_deg.size()));
  }
};

}  // namespace framewise::bench
