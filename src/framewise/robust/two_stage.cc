// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/robust/two_stage.h"

#include <array>
#include <stdexcept>
#include <vector>

#include "framewise/geometry/epipolar.h"
#include "framewise/robust/bearings.h"
#include "framewise/robust/correspondences_check.h"
#include "framewise/robust/epipolar_problem.h"
#include "framewise/robust/random_stream.h"
#include "framewise/robust/sampler.h"
#include "framewise/solvers/decompose_essential.h"
#include "framewise/solvers/essential_8pt.h"
#include "framewise/solvers/refine_relative_pose.h"
#include "framewise/solvers/relrot_5pt_kneip.h"
#include "framewise/solvers/rotation_eigensolver.h"
#include "framewise/solvers/translation_npt.h"

namespace framewise {
namespace {

constexpr std::size_t kRedrawn = 8;
constexpr int kAnswersOfKneip = 20;  // one set of eight may lie badly

struct Matches {
  std::vector<Bearing> x1, x2;
  std::vector<std::uint32_t> origin;  // place in the input
};

Matches inliers_of(const Matches& matches, const Estimate& estimate) {
  Matches kept;
  for (std::size_t i = 0; i < matches.x1.size(); ++i) {
    if (!estimate.inliers[i]) continue;
    kept.x1.push_back(matches.x1[i]);
    kept.x2.push_back(matches.x2[i]);
    kept.origin.push_back(matches.origin[i]);
  }
  return kept;
}

void add_essential(const std::optional<Eigen::Matrix3d>& E, std::span<const Bearing> x1,
                   std::span<const Bearing> x2, std::vector<Pose>& poses) {
  if (!E) return;
  if (const auto vote = choose_by_cheirality(*E, x1, x2)) poses.push_back(vote->cam2_from_cam1);
}

// A translation is the more certain the more points it rests on: all that the rotation leaves. Of a rotation
// and its twin about t, which Sampson's distance does not tell apart, the one with most points in front of
// both cameras.
void add_kneip(std::span<const Bearing> x1, std::span<const Bearing> x2, const Matches& all,
               std::vector<Pose>& poses) {
  for (const Eigen::Matrix3d& R : relrot_5pt_kneip(x1, x2))
    if (const auto t = translation_npt(all.x1, all.x2, R))
      add_essential(essential_from_pose({R, *t}), all.x1, all.x2, poses);
}

// All that the solver says about these bearings, some or all of `all`.
std::vector<Pose> solutions(RelativePoseSolver solver, std::span<const Bearing> x1,
                            std::span<const Bearing> x2, const Matches& all, const Pose& start) {
  std::vector<Pose> poses;
  switch (solver) {
    case RelativePoseSolver::kEightPoint:
      if (x1.size() >= 8) add_essential(essential_8pt(x1, x2), x1, x2, poses);
      break;
    case RelativePoseSolver::kEigensolver:
      if (const auto found = rotation_eigensolver(x1, x2)) poses.push_back({found->R, found->t});
      break;
    case RelativePoseSolver::kKneip5ptRotation:
      if (x1.size() >= 5 && x1.size() <= 8) add_kneip(x1, x2, all, poses);
      break;
    case RelativePoseSolver::kSevenPoint:
    case RelativePoseSolver::kNister5pt:
    case RelativePoseSolver::kStewenius5pt: {
      RefineOptions refine;
      refine.surface = common_surface(x1, x2);
      if (x1.size() >= 5) poses.push_back(refine_relative_pose(start, x1, x2, refine).pose);
      break;
    }
    case RelativePoseSolver::kTwoPoint:
      poses.push_back(start);
  }
  return poses;
}

// Whether the solver estimates from any number of bearings.
bool takes_all(RelativePoseSolver solver) { return solver != RelativePoseSolver::kKneip5ptRotation; }

// Eight of the inliers, drawn at random.
Matches redraw(const Matches& matches, RandomStream& random) {
  std::array<std::uint32_t, kRedrawn> sample{};
  draw_distinct(matches.x1.size(), sample, random);
  Matches drawn;
  for (const std::uint32_t i : sample) {
    drawn.x1.push_back(matches.x1[i]);
    drawn.x2.push_back(matches.x2[i]);
  }
  return drawn;
}

// The lowest score among the solutions over all matches.
struct Choice {
  Pose pose;
  Tally tally;
};
std::optional<Choice> choose(const EpipolarProblem& problem, std::span<const Pose> poses,
                             const Judge& judge) {
  std::optional<Choice> best;
  for (const Pose& pose : poses) {
    const Tally tally = problem.score({essential_from_pose(pose), pose}, judge);
    if (!best || tally.cost < best->tally.cost) best = Choice{pose, tally};
  }
  return best;
}

}  // namespace

void TwoStageOptions::check() const {
  first.check();
  check_positive("estimate_relative_pose_two_stage", "second_max_error", second_max_error);
  if (!(second_confidence > 0 && second_confidence < 1)) {
    throw std::invalid_argument("estimate_relative_pose_two_stage: second_confidence is " +
                                std::to_string(second_confidence) +
                                ", expected a probability between 0 and 1");
  }
}

std::optional<Estimate> estimate_relative_pose_two_stage(std::span<const Bearing> x1,
                                                         std::span<const Bearing> x2,
                                                         const TwoStageOptions& options) {
  options.check();
  RelativePoseOptions stage = options.first;
  stage.final_refinement = false;
  const auto first = estimate_relative_pose(x1, x2, stage);
  if (!first) return std::nullopt;

  Matches matches{normalized(x1), normalized(x2), {}};
  for (std::uint32_t i = 0; i < x1.size(); ++i) matches.origin.push_back(i);
  matches = inliers_of(matches, *first);
  stage.max_error = options.second_max_error;
  stage.ransac.confidence = options.second_confidence;
  const auto second = estimate_relative_pose(matches.x1, matches.x2, stage);
  if (!second) return std::nullopt;
  const Matches kept = inliers_of(matches, *second);

  const EpipolarProblem problem(kept.x1, kept.x2, stage);
  Judge judge;
  judge.max_error = stage.max_error;
  judge.scoring = stage.ransac.scoring;
  auto choice =
      choose(problem, solutions(stage.solver, kept.x1, kept.x2, kept, second->cam2_from_cam1), judge);
  RandomStream random(stage.ransac.seed);
  int draws = 0, missing = takes_all(stage.solver) ? (choice ? 0 : 1) : kAnswersOfKneip;
  for (; missing > 0 && kept.x1.size() >= kRedrawn && draws < stage.ransac.max_iterations; ++draws) {
    const Matches eight = redraw(kept, random);
    const auto next =
        choose(problem, solutions(stage.solver, eight.x1, eight.x2, kept, second->cam2_from_cam1), judge);
    missing -= next.has_value();
    if (next && (!choice || next->tally.cost < choice->tally.cost)) choice = next;
  }
  if (!choice) return std::nullopt;

  Estimate estimate;
  estimate.cam2_from_cam1 = choice->pose;
  estimate.score = choice->tally.cost;
  estimate.iterations = first->iterations + second->iterations + draws;
  estimate.iterations_theory = first->iterations_theory + second->iterations_theory;
  estimate.inliers.assign(x1.size(), 0);
  for (const std::uint32_t i : kept.origin) estimate.inliers[i] = 1;
  estimate.num_inliers = kept.origin.size();
  return estimate;
}

}  // namespace framewise
