// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/robust/single_sample.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "framewise/geometry/alignment.h"
#include "framewise/robust/bearings.h"
#include "framewise/robust/correspondences_check.h"
#include "framewise/robust/epipolar_problem.h"
#include "framewise/robust/sampler.h"
#include "framewise/solvers/decompose_essential.h"

namespace framewise {
namespace {

constexpr std::size_t kToChoose = 3;  // correspondences beside the sample that tell its solutions apart

Estimate all_agree(const Pose& pose, std::size_t size) {
  Estimate estimate;
  estimate.cam2_from_cam1 = pose;
  estimate.inliers.assign(size, 1);
  estimate.num_inliers = size;
  estimate.iterations = 1;
  estimate.iterations_theory = 1;
  return estimate;
}

// The poses that a hypothesis stands for. Under Sampson's distance that is its essential matrix: the one of
// its four with most of the drawn points in front of both cameras, any where none has.
Pose pose_of(const EpipolarModel& model, const RelativePoseOptions& options, std::span<const Bearing> drawn1,
             std::span<const Bearing> drawn2) {
  if (options.solver == RelativePoseSolver::kTwoPoint || options.measure == InlierMeasure::kReprojection)
    return model.pose;
  const auto vote = choose_by_cheirality(model.E, drawn1, drawn2);
  Pose pose = vote ? vote->cam2_from_cam1 : decompose_essential(model.E)[0];
  if (options.measure == InlierMeasure::kBearingEuclidean) pose.R = model.pose.R;
  return pose;
}

}  // namespace

std::optional<Estimate> estimate_relative_pose_from_one_sample(std::span<const Bearing> x1,
                                                               std::span<const Bearing> x2,
                                                               const RelativePoseOptions& options) {
  constexpr char kDoor[] = "estimate_relative_pose_from_one_sample";
  options.check();
  check_same_size(kDoor, "x1", x1.size(), "x2", x2.size());
  check_bearings(kDoor, "x1", x1);
  check_bearings(kDoor, "x2", x2);
  const std::size_t sample_size = epipolar_sample_size(options.solver);
  if (x1.size() < sample_size) return std::nullopt;

  const std::vector<Bearing> unit1 = normalized(x1), unit2 = normalized(x2);
  std::vector<std::uint32_t> drawn(std::min(sample_size + kToChoose, x1.size()));
  RandomStream random(options.ransac.seed);
  draw_distinct(x1.size(), drawn, random);
  EpipolarModels models;
  solve_epipolar(options, unit1, unit2, std::span(drawn).first(sample_size), models);

  std::vector<Bearing> drawn1, drawn2;
  for (const std::uint32_t i : drawn) drawn1.push_back(unit1[i]), drawn2.push_back(unit2[i]);
  const EpipolarProblem judge(drawn1, drawn2, options);
  std::optional<Pose> best;
  double least = std::numeric_limits<double>::infinity();
  for (const EpipolarModel& model : models) {
    const Pose pose = pose_of(model, options, drawn1, drawn2);
    double squares = 0;
    for (std::size_t i = 0; i < drawn.size(); ++i)
      squares += std::min(std::pow(judge.residual(pose, i), 2), 1.0);  // behind a camera counts 1
    if (best && !(squares < least)) continue;
    best = pose;
    least = squares;
  }
  if (!best) return std::nullopt;
  return all_agree(*best, x1.size());
}

std::optional<Estimate> estimate_registration_from_one_sample(std::span<const Eigen::Vector3d> X1,
                                                              std::span<const Eigen::Vector3d> X2,
                                                              std::uint64_t seed) {
  constexpr char kDoor[] = "estimate_registration_from_one_sample";
  check_same_size(kDoor, "X1", X1.size(), "X2", X2.size());
  check_points(kDoor, "X1", X1);
  check_points(kDoor, "X2", X2);
  if (X1.size() < 3) return std::nullopt;
  std::array<std::uint32_t, 3> drawn{};
  RandomStream random(seed);
  draw_distinct(X1.size(), drawn, random);
  std::array<Eigen::Vector3d, 3> a, b;
  for (std::size_t k = 0; k < 3; ++k) a[k] = X1[drawn[k]], b[k] = X2[drawn[k]];
  const auto pose = kabsch(a, b);
  if (!pose) return std::nullopt;
  return all_agree(*pose, X1.size());
}

}  // namespace framewise
