// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "framewise/robust/registration.h"
#include "framewise/robust/relative_pose.h"
#include "framewise/robust/rgbd_pose.h"
#include "framewise/robust/two_stage.h"
#include "study_problems.h"

// The solvers of the study, each under three schemes:
//   two-stage/bearing-euclidean, two-stage/reprojection: RANSAC twice and the solver itself on what remains,
//   no
//     local optimisation (robust/two_stage.h), as the comparison of the literature has it
//   robust: estimate_relative_pose as it stands
// and the two that use depth.
namespace framewise::bench {

struct StudyMethod {
  std::string solver, scheme;
  std::function<std::optional<Pose>(const RobustProblem&)> solve;
};

// A RANSAC may try so many hypotheses: what some tenths of a second allow.
inline int study_iterations(RelativePoseSolver solver) {
  switch (solver) {
    case RelativePoseSolver::kEigensolver:
      return 100;
    case RelativePoseSolver::kKneip5ptRotation:
      return 300;
    default:
      return 1000;
  }
}

// Of a bearing against the rotated other one (rad): it must let the parallax pass. Of the reprojection
// (pixels): eight and four times the noise.
constexpr double kEuclideanFirst = 20 / kFocal, kEuclideanSecond = 10 / kFocal;
constexpr double kReprojectionFirst = 4 / kFocal, kReprojectionSecond = 2 / kFocal;

inline std::optional<Pose> pose_of(const std::optional<Estimate>& estimate) {
  if (!estimate) return std::nullopt;
  return estimate->cam2_from_cam1;
}

inline TwoStageOptions two_stage_options(RelativePoseSolver solver, InlierMeasure measure) {
  const bool euclidean = measure == InlierMeasure::kBearingEuclidean;
  TwoStageOptions options;
  options.first.solver = solver;
  options.first.measure = measure;
  options.first.ransac.local_optimisation = false;
  options.first.ransac.max_iterations = study_iterations(solver);
  options.first.max_error = euclidean ? kEuclideanFirst : kReprojectionFirst;
  options.second_max_error = euclidean ? kEuclideanSecond : kReprojectionSecond;
  return options;
}

inline StudyMethod two_stage(const std::string& name, RelativePoseSolver solver, InlierMeasure measure) {
  const auto options = two_stage_options(solver, measure);
  const bool euclidean = measure == InlierMeasure::kBearingEuclidean;
  return {name, euclidean ? "two-stage/bearing-euclidean" : "two-stage/reprojection",
          [options](const RobustProblem& p) {
            return pose_of(estimate_relative_pose_two_stage(p.x1, p.x2, options));
          }};
}

inline StudyMethod robust(const std::string& name, RelativePoseSolver solver) {
  RelativePoseOptions options;
  options.solver = solver;
  options.ransac.max_iterations = study_iterations(solver);
  return {name, "robust",
          [options](const RobustProblem& p) { return pose_of(estimate_relative_pose(p.x1, p.x2, options)); }};
}

inline std::vector<StudyMethod> depth_methods() {
  return {
      {"kabsch", "5 cm", [](const RobustProblem& p) { return pose_of(estimate_registration(p.X1, p.X2)); }},
      {"p3p", "covariance-weighted", [](const RobustProblem& p) {
         std::vector<double> z1, z2;
         for (const auto& X : p.X1) z1.push_back(X.z());
         for (const auto& X : p.X2) z2.push_back(X.z());
         return pose_of(estimate_rgbd_pose(p.x1, z1, p.x2, z2));
       }}};
}

inline std::vector<StudyMethod> study_methods() {
  const std::vector<std::pair<std::string, RelativePoseSolver>> solvers = {
      {"eight-point", RelativePoseSolver::kEightPoint},
      {"seven-point", RelativePoseSolver::kSevenPoint},
      {"nister-5pt", RelativePoseSolver::kNister5pt},
      {"stewenius-5pt", RelativePoseSolver::kStewenius5pt},
      {"kneip-5pt-rotation", RelativePoseSolver::kKneip5ptRotation},
      {"eigensolver", RelativePoseSolver::kEigensolver}};
  std::vector<StudyMethod> methods = depth_methods();
  for (const auto& [name, solver] : solvers) {
    methods.push_back(two_stage(name, solver, InlierMeasure::kBearingEuclidean));
    methods.push_back(two_stage(name, solver, InlierMeasure::kReprojection));
    methods.push_back(robust(name, solver));
  }
  // A camera that is said never to have moved.
  methods.push_back({"static", "-", [](const RobustProblem&) { return std::optional<Pose>(Pose{}); }});
  return methods;
}

}  // namespace framewise::bench
