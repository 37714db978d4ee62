// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/odometry/window_adjustment.h"

#include <gtest/gtest.h>

#include <limits>

#include "framewise/geometry/so3.h"

namespace framewise {
namespace {

constexpr int kKeyframes = 4, kPoints = 60;
const double kUnknown = std::numeric_limits<double>::quiet_NaN();

Pose true_pose(int k) { return {so3_exp({0.02 * k, -0.03 * k, 0.01 * k}), {0.1 * k, -0.05 * k, 0.04 * k}}; }

// Points spread before the first keyframe, which hosts them, seen by all others without noise.
LocalMap exact_map(bool with_depth) {
  LocalMap map(10);
  for (int k = 0; k < kKeyframes; ++k) map.add(std::make_shared<MapFrame>(), true_pose(k));
  for (int i = 0; i < kPoints; ++i) {
    const Eigen::Vector3d ray(0.4 * std::sin(1.7 * i), 0.3 * std::cos(2.9 * i), 1);
    const double z = 2 + std::sin(0.8 * i);
    MapPoint point{i, ray, 1 / z, 1e-4, 0, 0, {}, 0, 0};
    if (with_depth) point.measured = 1 / z, point.information = 1e5;
    for (int k = 1; k < kKeyframes; ++k) {
      const Eigen::Vector3d x = true_pose(k).inverse() * (z * ray);
      point.views.push_back({k, x / x.z(), {1e-3}, with_depth ? x.z() : kUnknown, x / x.z(), 0});
    }
    map.at(0).points.push_back(point);
  }
  return map;
}

void disturb(LocalMap& map) {
  for (int k = 1; k < kKeyframes; ++k) {
    map.at(k).world_from_cam.R = map.at(k).world_from_cam.R * so3_exp({0.004, -0.003 * k, 0.002});
    map.at(k).world_from_cam.t += Eigen::Vector3d(0.01, -0.008, 0.005 * k);
  }
  for (int i = 0; i < kPoints; ++i) map.at(0).points[i].inverse_z *= 1 + 0.03 * std::sin(3.3 * i);
}

double worst_position(const LocalMap& map) {
  double worst = 0;
  for (int k = 0; k < kKeyframes; ++k)
    worst = std::max(worst, (map.at(k).world_from_cam.t - true_pose(k).t).norm());
  return worst;
}

TEST(AdjustWindow, BringsBackPosesAndPointsThatWereDisturbed) {
  LocalMap map = exact_map(true);
  disturb(map);
  WindowOptions options;
  options.max_iterations = 30;
  options.tolerance = 1e-12;
  const WindowSummary summary = adjust_window(map, {1, 2, 3}, {0}, options);
  EXPECT_EQ(summary.views, kPoints * (kKeyframes - 1));
  EXPECT_LT(summary.cost, 1e-6 * summary.first_cost);
  EXPECT_LT(worst_position(map), 1e-6);
  for (const MapPoint& point : map.at(0).points)
    EXPECT_NEAR(1 / point.inverse_z, 2 + std::sin(0.8 * point.feature), 1e-5);
}

TEST(AdjustWindow, LeavesExactPosesWhereTheyAre) {
  LocalMap map = exact_map(true);
  adjust_window(map, {1, 2, 3}, {0});
  EXPECT_LT(worst_position(map), 1e-9);
}

TEST(AdjustWindow, WithoutDepthTwoStillKeyframesHoldTheScale) {
  LocalMap map = exact_map(false);
  disturb(map);
  map.at(1).world_from_cam = true_pose(1);
  WindowOptions options;
  options.max_iterations = 40;
  options.tolerance = 1e-12;
  adjust_window(map, {2, 3}, {0, 1}, options);
  EXPECT_LT(worst_position(map), 1e-5);
}

TEST(AdjustWindow, WrongViewsAreTakenOutAndDoNotPull) {
  LocalMap map = exact_map(true);
  for (int i = 0; i < 6; ++i) map.at(0).points[i].views[1].ray += Eigen::Vector3d(0.08, -0.05, 0);
  WindowOptions options;
  options.max_iterations = 20;
  adjust_window(map, {1, 2, 3}, {0}, options);
  EXPECT_LT(worst_position(map), 2e-3);
  for (int i = 0; i < kPoints; ++i)
    EXPECT_EQ(map.at(0).points[i].views.size(), i < 6 ? kKeyframes - 2u : kKeyframes - 1u) << i;
}

// All rays as a lens bends them that is not the one they are taken for.
LocalMap bent_map(double k1) {
  LocalMap map = exact_map(true);
  const auto bend = [&](Eigen::Vector3d& ray) { ray.head<2>() *= 1 + k1 * ray.head<2>().squaredNorm(); };
  for (MapPoint& point : map.at(0).points) {
    bend(point.ray);
    for (PointView& view : point.views) bend(view.ray);
  }
  return map;
}

TEST(AdjustWindow, LearnsWhatTheLensBendsAndPosesAreThoseOfTheTruth) {
  LocalMap map = bent_map(0.01);
  WindowOptions options;
  options.max_iterations = 30;
  options.tolerance = 1e-12;
  options.lens_information = 1;
  const WindowSummary summary = adjust_window(map, {1, 2, 3}, {0}, options);
  EXPECT_NEAR(summary.lens_correction, 0.01, 3e-4);  // the bend's square is left
  EXPECT_GT(summary.lens_information, 1);
  EXPECT_LT(worst_position(map), 1e-3);
}

TEST(AdjustWindow, ALensThatIsWellKnownStaysAsItIs) {
  LocalMap map = bent_map(0.01);
  WindowOptions options;
  options.lens_information = 1e14;
  EXPECT_NEAR(adjust_window(map, {1, 2, 3}, {0}, options).lens_correction, 0, 1e-5);
  LocalMap as_said = bent_map(0.01);
  EXPECT_EQ(adjust_window(as_said, {1, 2, 3}, {0}).lens_correction, 0);
}

TEST(AdjustWindow, StillKeyframesStayAndNothingToDoIsNoCrash) {
  LocalMap map = exact_map(true);
  disturb(map);
  const Pose before = map.at(2).world_from_cam;
  adjust_window(map, {3}, {0, 1, 2});
  EXPECT_EQ(map.at(2).world_from_cam.matrix(), before.matrix());
  LocalMap empty(4);
  empty.add(std::make_shared<MapFrame>(), {});
  EXPECT_EQ(adjust_window(empty, {}, {0}).views, 0);
}

}  // namespace
}  // namespace framewise
