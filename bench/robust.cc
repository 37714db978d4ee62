// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Robust estimation against peers, in the settings of a frame-to-frame camera: 640x480, focal length 525.
//   build/release/bench/bench_robust [problems per row, default 200] [only methods whose name has this]
//                                    [only rows whose name has this]
// AUC: area under the recall curve at 5 deg of max(rotation, translation-direction error), per cent.
#include <chrono>
#include <cstdio>
#include <cstdlib>

#include "framewise/robust/absolute_pose.h"
#include "framewise/robust/registration.h"
#include "framewise/robust/relative_pose.h"
#include "framewise/robust/rgbd_pose.h"
#include "framewise/solvers/refine_relative_pose.h"
#include "framewise/solvers/refine_rgbd_pair.h"
#include "robust_peers.h"

namespace framewise::bench {
namespace {

struct Row {
  const char* name;
  Setting setting;
};

std::vector<RobustProblem> make_problems(const Row& row, std::size_t count) {
  testing::Random random(row.setting.size + static_cast<std::size_t>(1000 * row.setting.inlier_share));
  std::vector<RobustProblem> problems;
  for (std::size_t i = 0; i < count; ++i) problems.push_back(make_robust_problem(row.setting, random));
  return problems;
}

struct Measured {
  std::vector<std::optional<Pose>> poses;
  std::vector<double> ms;
};

// Methods take turns on each problem, so that whatever else the machine does meets all of them alike.
std::vector<Measured> measure(const std::vector<Method>& methods,
                              const std::vector<RobustProblem>& problems) {
  using Clock = std::chrono::steady_clock;
  std::vector<Measured> result(methods.size());
  for (const RobustProblem& p : problems) {
    for (std::size_t k = 0; k < methods.size(); ++k) {
      const auto begin = Clock::now();
      result[k].poses.push_back(methods[k].solve(p));
      result[k].ms.push_back(std::chrono::duration<double, std::milli>(Clock::now() - begin).count());
    }
  }
  return result;
}

struct Choice {
  std::string method, row;  // parts of names
};

std::vector<Method> chosen(std::vector<Method> methods, const Choice& choice) {
  std::erase_if(methods, [&](const Method& m) { return m.name.find(choice.method) == std::string::npos; });
  return methods;
}

std::vector<Row> chosen(std::vector<Row> rows, const Choice& choice) {
  std::erase_if(rows,
                [&](const Row& r) { return std::string(r.name).find(choice.row) == std::string::npos; });
  return rows;
}

Method framewise_relative(const std::string& name, RelativePoseSolver solver) {
  return {name, [solver](const RobustProblem& p) -> std::optional<Pose> {
            RelativePoseOptions options;
            options.solver = solver;
            options.max_error = 2.0 / kFocal;
            const auto estimate = estimate_relative_pose(p.x1, p.x2, options);
            if (!estimate) return std::nullopt;
            return estimate->cam2_from_cam1;
          }};
}

RefineOptions image_noise(const RobustProblem& p) {
  RefineOptions options;
  options.sigma = p.noise_px / kFocal;
  return options;
}

// Least squares from the truth on the true inliers: nobody can be better on average.
Method oracle_relative() {
  return {"oracle", [](const RobustProblem& p) -> std::optional<Pose> {
            std::vector<Bearing> x1, x2;
            for (std::size_t i = 0; i < p.good.size(); ++i) {
              if (p.good[i]) x1.push_back(p.x1[i]), x2.push_back(p.x2[i]);
            }
            return refine_relative_pose(p.cam2_from_cam1, x1, x2, image_noise(p)).pose;
          }};
}

Method oracle_depth() {
  return {"oracle", [](const RobustProblem& p) -> std::optional<Pose> {
            std::vector<Bearing> x1, x2;
            std::vector<double> z1, z2;
            for (std::size_t i = 0; i < p.good.size(); ++i) {
              if (!p.good[i]) continue;
              x1.push_back(p.x1[i]), x2.push_back(p.x2[i]);
              z1.push_back(p.X1[i].z()), z2.push_back(p.X2[i].z());
            }
            return refine_rgbd_pair(p.cam2_from_cam1, x1, z1, x2, z2, {}, image_noise(p)).pose;
          }};
}

void two_view_rows(std::size_t count, const Choice& choice) {
  const std::vector<Row> rows = {
      {"500, 50 %, wide, 1 px", {testing::Scene::kRandom, 500, 0.5, 1.0}},
      {"500, 25 %, wide, 1 px", {testing::Scene::kRandom, 500, 0.25, 1.0}},
      {"200, 90 %, odometry, 0.5 px", {testing::Scene::kOdometry, 200, 0.9, 0.5}},
      {"500, 50 %, odometry, 0.5 px", {testing::Scene::kOdometry, 500, 0.5, 0.5}},
      {"500, 50 %, odometry, 1 px", {testing::Scene::kOdometry, 500, 0.5, 1.0}},
      {"2000, 25 %, odometry, 0.5 px", {testing::Scene::kOdometry, 2000, 0.25, 0.5}}};
  std::vector<Method> methods = {
      framewise_relative("framewise 8-point", RelativePoseSolver::kEightPoint),
      framewise_relative("framewise Nister 5-point", RelativePoseSolver::kNister5pt), oracle_relative()};
#ifdef FRAMEWISE_BENCH_POSELIB
  methods.push_back(poselib_relative(false));
  methods.push_back(poselib_relative(true));
#endif
#ifdef FRAMEWISE_BENCH_OPENCV
  methods.push_back(opencv_essential("OpenCV USAC_MAGSAC", cv::USAC_MAGSAC));
  methods.push_back(opencv_essential("OpenCV USAC_ACCURATE", cv::USAC_ACCURATE));
  methods.push_back(opencv_essential("OpenCV USAC_DEFAULT", cv::USAC_DEFAULT));
#endif
  methods = chosen(methods, choice);
  for (const Row& row : chosen(rows, choice)) {
    const auto problems = make_problems(row, count);
    const auto measured = measure(methods, problems);
    std::printf("%s\n", row.name);
    for (std::size_t k = 0; k < methods.size(); ++k) {
      std::vector<double> errors;
      for (std::size_t i = 0; i < problems.size(); ++i) {
        errors.push_back(two_view_error_deg(measured[k].poses[i], problems[i].cam2_from_cam1));
      }
      std::printf("  %-34s AUC %5.1f  median %6.3f deg  %8.3f ms\n", methods[k].name.c_str(),
                  area_under_curve(errors, 5), quantile(errors, 0.5), quantile(measured[k].ms, 0.5));
    }
    std::fflush(stdout);
  }
}

Method framewise_rgbd() {
  return {"framewise RGB-D", [](const RobustProblem& p) -> std::optional<Pose> {
            std::vector<double> z1, z2;
            for (const auto& X : p.X1) z1.push_back(X.z());
            for (const auto& X : p.X2) z2.push_back(X.z());
            const auto estimate = estimate_rgbd_pose(p.x1, z1, p.x2, z2);
            if (!estimate) return std::nullopt;
            return estimate->cam2_from_cam1;
          }};
}

Method framewise_absolute() {
  return {"framewise absolute", [](const RobustProblem& p) -> std::optional<Pose> {
            const auto estimate = estimate_absolute_pose(p.X1, p.x2);
            if (!estimate) return std::nullopt;
            return estimate->cam2_from_cam1;
          }};
}

Method framewise_registration() {
  return {"framewise registration 5 cm", [](const RobustProblem& p) -> std::optional<Pose> {
            const auto estimate = estimate_registration(p.X1, p.X2);
            if (!estimate) return std::nullopt;
            return estimate->cam2_from_cam1;
          }};
}

void depth_rows(std::size_t count, const Choice& choice) {
  // Depth of 0.8 to 3.2 m, a depth camera's range.
  const std::vector<Row> rows = {{"depth, 200, 90 %", {testing::Scene::kOdometry, 200, 0.9, 0.5, 0.4}},
                                 {"depth, 200, 25 %", {testing::Scene::kOdometry, 200, 0.25, 0.5, 0.4}}};
  std::vector<Method> methods = {framewise_registration(), framewise_absolute(), framewise_rgbd(),
                                 oracle_depth()};
#ifdef FRAMEWISE_BENCH_POSELIB
  methods.push_back(poselib_absolute(false));
  methods.push_back(poselib_absolute(true));
#endif
#ifdef FRAMEWISE_BENCH_OPENCV
  methods.push_back(opencv_pnp());
#endif
  methods = chosen(methods, choice);
  for (const Row& row : chosen(rows, choice)) {
    const auto problems = make_problems(row, count);
    const auto measured = measure(methods, problems);
    std::printf("%s\n", row.name);
    for (std::size_t k = 0; k < methods.size(); ++k) {
      std::vector<double> errors;
      for (std::size_t i = 0; i < problems.size(); ++i) {
        const auto& pose = measured[k].poses[i];
        if (pose) errors.push_back(100 * (pose->t - problems[i].cam2_from_cam1.t).norm());
      }
      std::printf("  %-34s median %7.3f cm  90 %% below %7.3f cm  answers %zu of %zu  %8.3f ms\n",
                  methods[k].name.c_str(), quantile(errors, 0.5), quantile(errors, 0.9), errors.size(),
                  problems.size(), quantile(measured[k].ms, 0.5));
    }
    std::fflush(stdout);
  }
}

}  // namespace
}  // namespace framewise::bench

int main(int argc, char** argv) {
  const std::size_t count = argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 200;
  const framewise::bench::Choice choice{argc > 2 ? argv[2] : "", argc > 3 ? argv[3] : ""};
  framewise::bench::depth_rows(count, choice);
  framewise::bench::two_view_rows(count, choice);
}
