// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Why Kneip's solver, the eigensolver and the 8-point algorithm came out as they did in a published
// frame-to-frame comparison: each suspicion is an experiment of its own. docs/solver_study.md says what they
// show.
//   build/bench/bench/bench_study_seed [problems a line, default 150] [experiment] > seed.csv
// One thread: OpenGV draws from a global random state.
#include <cstdio>
#include <cstdlib>

#include "framewise/solvers/decompose_essential.h"
#include "framewise/solvers/essential_8pt.h"
#include "study_scheme.h"

namespace framewise::bench {
namespace {

struct Line {
  const char* experiment;
  std::string variant;
  StudySetting setting;
  double parameter = NAN;  // what the experiment varies beside the setting
};

void print(const Line& line, const StudyErrors& e, double figure = NAN) {
  std::printf("%s,%s,%s,%g,%g,%g,%g,%g,%zu,%.5g,%.5g,%.5g,%.4g,%.5g,%.5g\n", line.experiment,
              line.variant.c_str(), name_of(line.setting.motion.direction), line.setting.motion.step_percent,
              line.setting.motion.rotation_deg, line.setting.noise_px, 100 * line.setting.inlier_share,
              line.parameter, e.problems, quantile(e.rotation_deg, 0.5), quantile(e.rotation_deg, 0.9),
              e.rms_deg(), e.failure_percent(), quantile(e.direction_deg, 0.5), figure);
  std::fflush(stdout);
}

// The same problems for every variant of a line.
template <typename Visit>
void for_problems(const StudySetting& setting, std::size_t count, const Visit& visit) {
  testing::Random random(static_cast<std::uint64_t>(1000 * setting.motion.step_percent) + 1);
  for (std::size_t i = 0; i < count; ++i) visit(make_study_problem(setting, random), random);
}

struct NamedSolver {
  std::string name;
  RotationSolver solve;
};

std::vector<NamedSolver> kneip_solvers() {
  std::vector<NamedSolver> solvers = {{"framewise", our_kneip}};
#ifdef FRAMEWISE_BENCH_OPENGV
  solvers.push_back({"opengv", opengv_kneip});
#endif
  return solvers;
}

std::vector<NamedSolver> kneip_solvers_and_overrun() {
  std::vector<NamedSolver> solvers = kneip_solvers();
#ifdef FRAMEWISE_BENCH_OPENGV
  solvers.push_back({"opengv overrun", opengv_kneip_overrun});
#endif
  return solvers;
}

std::vector<NamedSolver> eigensolvers() {
  std::vector<NamedSolver> solvers = {{"framewise", our_eigensolver}};
#ifdef FRAMEWISE_BENCH_OPENGV
  solvers.push_back({"opengv", opengv_eigensolver});
#endif
  return solvers;
}

std::optional<Pose> nearest_to_truth(const Rotations& rotations, const Pose& truth) {
  std::optional<Pose> best;
  double error = 4;
  for (const Eigen::Matrix3d& R : rotations) {
    const double next = testing::rotation_error(R, truth.R);
    if (next < error) error = next, best = Pose{R, truth.t};
  }
  return best;
}

Pairs pairs_of(const RobustProblem& p) { return {p.x1, p.x2}; }

// Is the right rotation among the solutions at all? An oracle chooses. Noise-free, and with noise; figure:
// solutions.
void solutions_by_step(std::size_t count) {
  for (const NamedSolver& solver : kneip_solvers())
    for (const double noise : {0.0, 0.5})
      for (const double step : {20.0, 5.0, 1.0, 0.5, 0.1, 0.01, 0.0}) {
        StudySetting setting{{Direction::kMixed, step, 0.4}, false, 5, 1, noise};
        StudyErrors errors;
        double solutions = 0;
        for_problems(setting, count, [&](const RobustProblem& p, testing::Random&) {
          const Rotations found = solver.solve(p.x1, p.x2);
          solutions += static_cast<double>(found.size()) / static_cast<double>(count);
          errors.add(nearest_to_truth(found, p.cam2_from_cam1), p.cam2_from_cam1);
        });
        print({"solutions", solver.name, setting}, errors, solutions);
      }
}

// Five to eight true bearings with noise: what the further ones are worth.
void bearings_kept(std::size_t count) {
  for (const NamedSolver& solver : kneip_solvers_and_overrun())
    for (const double step : {5.0, 0.7})
      for (const std::size_t bearings : {5u, 6u, 7u, 8u}) {
        StudySetting setting{{Direction::kMixed, step, 0.4}, false, bearings, 1, 0.5};
        StudyErrors errors;
        for_problems(setting, count, [&](const RobustProblem& p, testing::Random&) {
          errors.add(nearest_to_truth(solver.solve(p.x1, p.x2), p.cam2_from_cam1), p.cam2_from_cam1);
        });
        print({"bearings", solver.name, setting, double(bearings)}, errors);
      }
}

// Eight bearings, `wrong` of them outliers that survived.
void residual_outliers(std::size_t count) {
  for (const NamedSolver& solver : kneip_solvers())
    for (const double step : {5.0, 0.7})
      for (const double wrong : {0.0, 1.0, 2.0}) {
        StudySetting setting{{Direction::kMixed, step, 0.4}, false, 8, 1 - wrong / 8, 0.5};
        StudyErrors errors;
        for_problems(setting, count, [&](const RobustProblem& p, testing::Random& random) {
          const Pairs shuffled = pick(pairs_of(p), 8, random);
          errors.add(nearest_to_truth(solver.solve(shuffled.x1, shuffled.x2), p.cam2_from_cam1),
                     p.cam2_from_cam1);
        });
        print({"residual-outliers", solver.name, setting, wrong}, errors);
      }
}

using Chooser =
    std::function<std::optional<Pose>(const Rotations&, const Pairs&, const Pose&, testing::Random&)>;

Chooser by_measure(InlierMeasure measure) {
  return [measure](const Rotations& rotations, const Pairs& all, const Pose&, testing::Random& random) {
    Scheme scheme;
    scheme.measure = measure;
    return best_of(rotations, scheme, all, kEuclideanSecond, random).pose;
  };
}

// Eight true bearings; who chooses among the rotations, over 200 true pairs.
void choice_among_solutions(std::size_t count) {
  const std::vector<std::pair<std::string, Chooser>> choosers = {
      {"oracle", [](const Rotations& r, const Pairs&, const Pose& truth,
                    testing::Random&) { return nearest_to_truth(r, truth); }},
      {"bearing-euclidean", by_measure(InlierMeasure::kBearingEuclidean)},
      {"reprojection", by_measure(InlierMeasure::kReprojection)},
      {"first", [](const Rotations& r, const Pairs&, const Pose& truth, testing::Random&) {
         return r.empty() ? std::nullopt : std::optional<Pose>(Pose{r[0], truth.t});
       }}};
  for (const NamedSolver& solver : kneip_solvers_and_overrun())
    for (const double step : {5.0, 0.7})
      for (const auto& [name, choose] : choosers) {
        StudySetting setting{{Direction::kMixed, step, 0.4}, false, 200, 1, 0.5};
        StudyErrors errors;
        for_problems(setting, count, [&](const RobustProblem& p, testing::Random& random) {
          const Pairs eight = pick(pairs_of(p), 8, random);
          errors.add(choose(solver.solve(eight.x1, eight.x2), pairs_of(p), p.cam2_from_cam1, random),
                     p.cam2_from_cam1);
        });
        print({"choice", solver.name + "/" + name, setting}, errors);
      }
}

// A right rotation, composed the wrong way round: figure is the rotation itself.
void inverse_convention(std::size_t count) {
  for (const double rotation : {0.4, 2.0, 10.0}) {
    StudySetting setting{{Direction::kMixed, 0.7, rotation}, false, 5, 1, 0};
    StudyErrors errors;
    for_problems(setting, count, [&](const RobustProblem& p, testing::Random&) {
      errors.add(p.cam2_from_cam1.inverse(), p.cam2_from_cam1);
    });
    print({"inverse-convention", "-", setting}, errors, rotation);
  }
}

// A thousand rotations that know nothing.
void uniform_rotations(std::size_t count) {
  testing::Random random(1);
  StudyErrors errors;
  for (std::size_t i = 0; i < 100 * count; ++i) {
    const Eigen::Quaterniond q(random.normal(), random.normal(), random.normal(), random.normal());
    errors.add(Pose::from_quaternion(q, Eigen::Vector3d::Zero()), Pose{});
  }
  print({"uniform-rotations", "-", {}}, errors);
}

// RMS of the rotation error over `span` frames when each step is wrong as the errors say, in a direction of
// its own.
double rms_over_frames(const std::vector<Eigen::Matrix3d>& steps, std::size_t span, testing::Random& random) {
  if (steps.empty()) return NAN;
  StudyErrors errors;
  for (int trial = 0; trial < 2000; ++trial) {
    Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
    for (std::size_t i = 0; i < span; ++i) R = R * steps[random.index(steps.size())];
    errors.add(Pose{R, Eigen::Vector3d::Zero()}, Pose{});
  }
  return errors.rms_deg();
}

// The scheme as a whole, at motions like the recordings': figure: RMS over 30 frames.
void whole_scheme(std::size_t count) {
  const std::vector<Motion> motions = {{Direction::kMixed, 0.7, 0.4}, {Direction::kMixed, 13, 11}};
  for (const Motion& motion : motions)
    for (const double share : {0.9, 0.7})
      for (const InlierMeasure measure : {InlierMeasure::kBearingEuclidean, InlierMeasure::kReprojection})
        for (const NamedSolver& solver : kneip_solvers_and_overrun()) {
          Scheme scheme;
          scheme.solver = solver.solve;
          scheme.measure = measure;
          StudySetting setting{motion, false, 200, share, 0.5};
          StudyErrors errors;
          std::vector<Eigen::Matrix3d> steps;
          testing::Random random(7);
          for_problems(setting, count, [&](const RobustProblem& p, testing::Random&) {
            const auto pose = solve_by_scheme(scheme, p, random);
            errors.add(pose, p.cam2_from_cam1);
            if (pose) steps.push_back(p.cam2_from_cam1.R.transpose() * pose->R);
          });
          const bool euclidean = measure == InlierMeasure::kBearingEuclidean;
          print({"scheme", solver.name + (euclidean ? "/bearing-euclidean" : "/reprojection"), setting},
                errors, rms_over_frames(steps, 30, random));
        }
}

std::vector<NamedSolver> solvers_of_many() {
  std::vector<NamedSolver> solvers = {{"framewise eight-point", our_eight_point},
                                      {"framewise eigensolver", our_eigensolver},
                                      {"framewise eight-point + least squares", our_refined}};
#ifdef FRAMEWISE_BENCH_OPENGV
  solvers.push_back({"opengv eight-point", opengv_eight_point});
  solvers.push_back({"opengv nister-5pt", opengv_nister});
  solvers.push_back({"opengv eigensolver", opengv_eigensolver});
#endif
  return solvers;
}

// What each solver makes of all 200 true matches at once, as the last step of the scheme asks it to; chosen
// among its answers by the measure of bearings. parameter: 1 where the points lie on a plane.
void all_matches(std::size_t count) {
  const std::vector<Motion> motions = {{Direction::kMixed, 0, 0.4},
                                       {Direction::kMixed, 0.2, 0.4},
                                       {Direction::kMixed, 0.7, 0.4},
                                       {Direction::kMixed, 5, 0.4},
                                       {Direction::kMixed, 13, 11}};
  for (const bool planar : {false, true})
    for (const Motion& motion : motions)
      for (const NamedSolver& solver : solvers_of_many()) {
        StudySetting setting{motion, planar, 200, 1, 0.5};
        StudyErrors errors;
        for_problems(setting, count, [&](const RobustProblem& p, testing::Random& random) {
          const Pairs all = pairs_of(p);
          errors.add(best_of(solver.solve(all.x1, all.x2), Scheme{}, all, kEuclideanFirst, random).pose,
                     p.cam2_from_cam1);
        });
        print({"all-matches", solver.name, setting, planar ? 1.0 : 0.0}, errors);
      }
}

// The eigensolver on true matches: figure: median of (angle of the answer / true angle); 0 is a camera at
// rest.
void eigensolver_at_rest(std::size_t count) {
  for (const NamedSolver& solver : eigensolvers())
    for (const double step : {5.0, 0.7, 0.1})
      for (const double rotation : {0.4, 2.0, 10.0})
        for (const std::size_t bearings : {10u, 200u}) {
          StudySetting setting{{Direction::kMixed, step, rotation}, false, bearings, 1, 0.5};
          StudyErrors errors;
          std::vector<double> turned;
          for_problems(setting, count, [&](const RobustProblem& p, testing::Random&) {
            const Rotations found = solver.solve(p.x1, p.x2);
            if (!found.empty()) turned.push_back(rotation_angle(found[0]) * 180 / M_PI / rotation);
            errors.add(nearest_to_truth(found, p.cam2_from_cam1), p.cam2_from_cam1);
          });
          print({"eigensolver", solver.name, setting, double(bearings)}, errors, quantile(turned, 0.5));
        }
}

// The 8-point algorithm on all true matches; the pose nearest the truth of the four. figure: median of the
// component of the answer's rotation vector along the true one, over the true angle: 1 is unbiased, 0 is a
// camera at rest; parameter: median of |t_z|, 0.5 where directions are uniform.
void bias_of_linear_solution(std::size_t count) {
  for (const Direction direction : {Direction::kSideways, Direction::kForward})
    for (const double step : {5.0, 0.7, 0.1, 0.0})
      for (const double rotation : {0.4, 5.0}) {
        StudySetting setting{{direction, step, rotation}, false, 200, 1, 0.5};
        StudyErrors errors;
        std::vector<double> shrunk, forward;
        for_problems(setting, count, [&](const RobustProblem& p, testing::Random&) {
          const auto E = essential_8pt(p.x1, p.x2);
          if (!E) return errors.add(std::nullopt, p.cam2_from_cam1);
          Rotations found;
          const auto poses = decompose_essential(*E);
          for (const Pose& pose : poses) found.push_back(pose.R);
          const auto best = nearest_to_truth(found, p.cam2_from_cam1);
          const Eigen::Vector3d truth = so3_log(p.cam2_from_cam1.R);
          shrunk.push_back(so3_log(best->R).dot(truth) / truth.squaredNorm());
          forward.push_back(std::abs(poses[0].t.normalized().z()));
          errors.add(Pose{best->R, poses[0].t}, p.cam2_from_cam1);
        });
        print({"eight-point-bias", "framewise", setting, quantile(forward, 0.5)}, errors,
              quantile(shrunk, 0.5));
      }
}

// One RANSAC under |x2 - R x1| < threshold (parameter, px): figure: share of the true matches it kept, per
// cent. Variants: the rotation of its best hypothesis; the 8-point algorithm on what it kept.
void parallax(std::size_t count) {
  for (const Direction direction : {Direction::kSideways, Direction::kForward})
    for (const double step : {0.1, 0.5, 1.0, 2.0, 5.0, 10.0})
      for (const double threshold_px : {3.0, 10.0, 30.0}) {
        StudySetting setting{{direction, step, 2}, false, 200, 0.8, 0.5};
        RelativePoseOptions options;
        options.measure = InlierMeasure::kBearingEuclidean;
        options.max_error = threshold_px / kFocal;
        options.final_refinement = false;
        options.ransac.local_optimisation = false;
        options.ransac.max_iterations = study_iterations(options.solver);
        StudyErrors hypothesis, eight;
        double kept_share = 0;
        for_problems(setting, count, [&](const RobustProblem& p, testing::Random&) {
          const auto found = estimate_relative_pose(p.x1, p.x2, options);
          hypothesis.add(pose_of(found), p.cam2_from_cam1);
          Pairs kept;
          std::size_t right = 0, good = 0;
          for (std::size_t i = 0; i < p.good.size(); ++i) {
            good += p.good[i];
            if (!found || !found->inliers[i]) continue;
            kept.add(p.x1[i], p.x2[i]);
            right += p.good[i];
          }
          kept_share += 100.0 * static_cast<double>(right) / static_cast<double>(good * count);
          std::optional<Pose> pose;
          if (kept.size() >= 8)
            if (const auto E = essential_8pt(kept.x1, kept.x2))
              if (const auto vote = choose_by_cheirality(*E, kept.x1, kept.x2)) pose = vote->cam2_from_cam1;
          eight.add(pose, p.cam2_from_cam1);
        });
        print({"parallax", "hypothesis", setting, threshold_px}, hypothesis, kept_share);
        print({"parallax", "eight-point on the kept", setting, threshold_px}, eight, kept_share);
      }
}

}  // namespace
}  // namespace framewise::bench

int main(int argc, char** argv) {
  using namespace framewise::bench;
  const std::size_t count = argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 150;
  const std::string only = argc > 2 ? argv[2] : "";
  std::printf(
      "experiment,variant,direction,step_percent,rotation_deg,noise_px,inlier_percent,parameter,problems,"
      "median_deg,p90_deg,rms_deg,failure_percent,direction_median_deg,figure\n");
  const std::vector<std::pair<std::string, void (*)(std::size_t)>> experiments = {
      {"solutions", solutions_by_step},
      {"bearings", bearings_kept},
      {"residual-outliers", residual_outliers},
      {"choice", choice_among_solutions},
      {"inverse-convention", inverse_convention},
      {"uniform-rotations", uniform_rotations},
      {"scheme", whole_scheme},
      {"all-matches", all_matches},
      {"eigensolver", eigensolver_at_rest},
      {"eight-point-bias", bias_of_linear_solution},
      {"parallax", parallax}};
  for (const auto& [name, run] : experiments)
    if (name.find(only) != std::string::npos) run(count);
}
