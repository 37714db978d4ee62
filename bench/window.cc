// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A window of keyframes adjusted by the odometer and by Ceres: the same residuals, loss, start and stop.
//   build/release/bench/bench_window
#include <array>
#include <limits>
#include <numeric>
#include <random>

#include "framewise/geometry/so3.h"
#include "framewise/odometry/window_adjustment.h"
#include "interleaved.h"

#ifdef FRAMEWISE_BENCH_CERES
#include <ceres/ceres.h>
#include <ceres/rotation.h>
#endif

namespace framewise::bench {
namespace {

constexpr int kStill = 4, kMoving = 6, kKeyframes = kStill + kMoving, kIterations = 5;
constexpr double kSigma = 0.2 / 525, kTolerance = 1e-3;

std::vector<int> numbers(int begin, int end) {
  std::vector<int> result(end - begin);
  std::iota(result.begin(), result.end(), begin);
  return result;
}

// A camera that moves sideways along a wall with reliefs. Each keyframe hosts some points that the next four
// see; one view in twenty is of something else.
LocalMap make_window(int points_each, bool with_depth, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform(-1, 1);
  const DepthNoise noise;
  LocalMap map(kKeyframes);
  std::vector<Pose> truth;
  for (int k = 0; k < kKeyframes; ++k) {
    truth.push_back({so3_exp({0.02 * normal(random), 0.04 * k, 0.02 * normal(random)}),
                     {0.12 * k, 0.02 * normal(random), 0.03 * normal(random)}});
    Pose start = truth.back();
    if (k >= kStill) {
      start.R = start.R * so3_exp(0.002 * Eigen::Vector3d(normal(random), normal(random), normal(random)));
      start.t += 0.005 * Eigen::Vector3d(normal(random), normal(random), normal(random));
    }
    map.add(std::make_shared<MapFrame>(), start);
  }
  const auto measured_depth = [&](double z) {
    return with_depth ? z + noise.sigma(z) * normal(random) : std::numeric_limits<double>::quiet_NaN();
  };
  for (int host = 0; host < kKeyframes; ++host)
    for (int i = 0; i < points_each; ++i) {
      const Eigen::Vector3d ray(0.6 * uniform(random), 0.45 * uniform(random), 1);
      const double z = 2.5 + uniform(random), z_measured = z + noise.sigma(z) * normal(random);
      MapPoint point{i, ray, 1 / z_measured, 1e-4};
      if (with_depth) {
        const double sigma = noise.sigma(z) / (z * z);
        point.measured = 1 / z_measured, point.information = 1 / (sigma * sigma);
      }
      for (int k = host + 1; k < std::min(kKeyframes, host + 5); ++k) {
        const Eigen::Vector3d x = truth[k].inverse() * (truth[host] * (z * ray));
        Eigen::Vector3d seen = x / x.z() + kSigma * Eigen::Vector3d(normal(random), normal(random), 0);
        if (uniform(random) > 0.9) seen += 0.02 * Eigen::Vector3d(normal(random), normal(random), 0);
        point.views.push_back({k, seen, {kSigma}, measured_depth(x.z()), seen, 0});
      }
      map.at(host).points.push_back(point);
    }
  return map;
}

#ifdef FRAMEWISE_BENCH_CERES
// Poses are world_from_cam as a rotation vector and a translation.
struct ViewError {
  Eigen::Vector3d ray;
  PointView view;
  double sigma_z;

  template <typename T>
  bool operator()(const T* host, const T* viewer, const T* inverse_z, T* r) const {
    T X[3] = {ray.x() / *inverse_z, ray.y() / *inverse_z, T(1) / *inverse_z}, world[3], x[3];
    ceres::AngleAxisRotatePoint(host, X, world);
    for (int i = 0; i < 3; ++i) world[i] += host[3 + i] - viewer[3 + i];
    const T back[3] = {-viewer[0], -viewer[1], -viewer[2]};
    ceres::AngleAxisRotatePoint(back, world, x);
    if (!(x[2] > 1e-3)) return false;
    r[0] = (x[0] / x[2] - view.ray.x()) / view.noise.sigma;
    r[1] = (x[1] / x[2] - view.ray.y()) / view.noise.sigma;
    r[2] = view.z > 0 ? (x[2] - view.z) / sigma_z : T(0);
    return true;
  }
};

struct DepthError {
  double measured, weight;
  template <typename T>
  bool operator()(const T* inverse_z, T* r) const {
    r[0] = weight * (*inverse_z - measured);
    return true;
  }
};

double adjust_by_ceres(LocalMap& map) {
  std::vector<std::array<double, 6>> poses(kKeyframes);
  ceres::Problem problem;
  for (int k = 0; k < kKeyframes; ++k) {
    const Eigen::Vector3d w = so3_log(map.at(k).world_from_cam.R);
    const Eigen::Vector3d& t = map.at(k).world_from_cam.t;
    poses[k] = {w.x(), w.y(), w.z(), t.x(), t.y(), t.z()};
    problem.AddParameterBlock(poses[k].data(), 6);
    if (k < kStill) problem.SetParameterBlockConstant(poses[k].data());
  }
  auto* ordering = new ceres::ParameterBlockOrdering;
  const DepthNoise noise;
  for (int host = 0; host < kKeyframes; ++host)
    for (MapPoint& point : map.at(host).points) {
      if (point.views.empty()) continue;
      for (const PointView& view : point.views) {
        const ViewError error{point.ray, view, view.z > 0 ? noise.sigma(view.z) : 1};
        problem.AddResidualBlock(new ceres::AutoDiffCostFunction<ViewError, 3, 6, 6, 1>(new ViewError(error)),
                                 new ceres::CauchyLoss(2), poses[host].data(), poses[view.keyframe].data(),
                                 &point.inverse_z);
      }
      if (point.information > 0)
        problem.AddResidualBlock(new ceres::AutoDiffCostFunction<DepthError, 1, 1>(
                                     new DepthError{point.measured, std::sqrt(point.information)}),
                                 new ceres::CauchyLoss(2), &point.inverse_z);
      ordering->AddElementToGroup(&point.inverse_z, 0);
    }
  for (auto& pose : poses) ordering->AddElementToGroup(pose.data(), 1);
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_SCHUR;
  options.linear_solver_ordering.reset(ordering);
  options.max_num_iterations = kIterations;
  options.function_tolerance = kTolerance;
  options.logging_type = ceres::SILENT;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);
  for (int k = kStill; k < kKeyframes; ++k)
    map.at(k).world_from_cam = {so3_exp({poses[k][0], poses[k][1], poses[k][2]}),
                                {poses[k][3], poses[k][4], poses[k][5]}};
  return 2 * summary.final_cost;
}
#endif

WindowSummary adjust_by_odometer(LocalMap& map) {
  WindowOptions options;
  options.max_iterations = kIterations;
  options.tolerance = kTolerance;
  return adjust_window(map, numbers(kStill, kKeyframes), numbers(0, kStill), options);
}

void race(int points_each, bool with_depth) {
  constexpr std::size_t kProblems = 8;
  std::vector<LocalMap> maps;
  for (std::size_t i = 0; i < kProblems; ++i)
    maps.push_back(make_window(points_each, with_depth, static_cast<unsigned>(i)));
  std::vector<Rival> rivals = {{"framewise adjust_window", [&](std::size_t i) {
                                  LocalMap map = maps[i];
                                  return adjust_by_odometer(map).cost;
                                }}};
#ifdef FRAMEWISE_BENCH_CERES
  rivals.push_back({"Ceres DENSE_SCHUR, one thread", [&](std::size_t i) {
                      LocalMap map = maps[i];
                      return adjust_by_ceres(map);
                    }});
#endif
  print_race(std::to_string(kKeyframes) + " keyframes, " + std::to_string(points_each) + " points each, " +
                 (with_depth ? "with depth" : "without depth"),
             rivals, kProblems, 5);
  for (const Rival& rival : rivals) {
    double cost = 0;
    for (std::size_t i = 0; i < kProblems; ++i) cost += rival.call(i);
    std::printf("  %-44s mean cost at the end %.3f\n", rival.name.c_str(), cost / kProblems);
  }
}

}  // namespace
}  // namespace framewise::bench

int main() {
  for (const int points_each : {100, 400})
    for (const bool with_depth : {true, false}) framewise::bench::race(points_each, with_depth);
}
