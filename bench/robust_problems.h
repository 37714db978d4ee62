// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "framewise/geometry/depth_noise.h"
#include "framewise/solvers/problems_for_tests.h"

// Seeded two-view problems with noise and wrong matches, as a 640x480 camera of focal length 525 sees them.
namespace framewise::bench {

constexpr double kFocal = 525, kCx = 320, kCy = 240;

struct RobustProblem {
  Pose cam2_from_cam1;
  double noise_px = 0;
  std::vector<Eigen::Vector2d> px1, px2;  // pixels, with noise
  std::vector<Bearing> x1, x2;            // their bearings
  std::vector<Eigen::Vector3d> X1, X2;    // points at the depth that the sensor measured (m)
  std::vector<char> good;                 // truth: not a wrong match
};

inline Eigen::Vector2d pixel(const Eigen::Vector3d& X) {
  return {kFocal * X.x() / X.z() + kCx, kFocal * X.y() / X.z() + kCy};
}
inline Eigen::Vector3d ray(const Eigen::Vector2d& px) {
  return {(px.x() - kCx) / kFocal, (px.y() - kCy) / kFocal, 1};
}

struct Setting {
  testing::Scene scene;
  std::size_t size;
  double inlier_share;
  double noise_px;   // of each coordinate in both images
  double scale = 1;  // of the scene: at 1 its depth is 2 to 8 m
};

// A wrong match is two pixels that have nothing in common.
inline RobustProblem make_robust_problem(const Setting& setting, testing::Random& random) {
  const std::size_t size = setting.size;
  testing::TwoViewProblem exact = testing::make_problem(setting.scene, size, random);
  for (auto* points : {&exact.X1, &exact.X2}) {
    for (auto& X : *points) X *= setting.scale;
  }
  RobustProblem p;
  p.cam2_from_cam1 = {exact.cam2_from_cam1.R, setting.scale * exact.cam2_from_cam1.t};
  p.noise_px = setting.noise_px;
  const auto anywhere = [&] { return Eigen::Vector2d(random.uniform(0, 640), random.uniform(0, 480)); };
  const auto noisy = [&](const Eigen::Vector3d& X) {
    return Eigen::Vector2d(pixel(X) + p.noise_px * Eigen::Vector2d(random.normal(), random.normal()));
  };
  const DepthNoise depth;
  const auto measured = [&](double z) { return z + depth.sigma(z) * random.normal(); };
  for (std::size_t i = 0; i < size; ++i) {
    const bool good = static_cast<double>(i) < setting.inlier_share * static_cast<double>(size);
    p.good.push_back(good);
    p.px1.push_back(good ? noisy(exact.X1[i]) : anywhere());
    p.px2.push_back(good ? noisy(exact.X2[i]) : anywhere());
    const double z2 = good ? exact.X2[i].z() : setting.scale * random.uniform(2, 8);
    p.X1.push_back(measured(exact.X1[i].z()) * ray(p.px1[i]));
    p.X2.push_back(measured(z2) * ray(p.px2[i]));
    p.x1.push_back(ray(p.px1[i]).normalized());
    p.x2.push_back(ray(p.px2[i]).normalized());
  }
  return p;
}

// The larger of rotation error and translation-direction error (deg); no answer, and none about t, counts as
// 180.
inline double two_view_error_deg(const std::optional<Pose>& pose, const Pose& truth) {
  if (!pose || !(pose->t.norm() > 0)) return 180;
  return 180 / M_PI *
         std::max(testing::rotation_error(pose->R, truth.R), testing::direction_error(pose->t, truth.t));
}

// Area under the curve "share of problems with an error below e", e from 0 to limit, in per cent.
inline double area_under_curve(const std::vector<double>& errors, double limit) {
  double area = 0;
  for (const double e : errors) area += std::max(0.0, limit - e) / limit;
  return 100 * area / static_cast<double>(errors.size());
}

inline double quantile(std::vector<double> values, double q) {
  if (values.empty()) return NAN;
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(q * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

}  // namespace framewise::bench
