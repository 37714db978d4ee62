// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Which solver wins at which motion and inlier ratio: a grid of simulated two-view problems with known truth,
// one CSV line for each cell and method. docs/solver_study.md says what it shows.
//   build/bench/bench/bench_study_solvers [problems in a cell, default 8] [threads, default 2] > grid.csv
// The figures depend on the number of problems alone, not on the threads.
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <thread>

#include "study_methods.h"

namespace framewise::bench {
namespace {

// Every direction and step at a rotation; and no step.
std::vector<Motion> motions_at(double rotation_deg) {
  std::vector<Motion> list;
  for (const Direction direction : {Direction::kSideways, Direction::kForward, Direction::kMixed})
    for (const double step : {0.1, 0.5, 1.0, 5.0}) list.push_back({direction, step, rotation_deg});
  list.push_back({Direction::kMixed, 0, rotation_deg});
  return list;
}

std::vector<StudySetting> settings() {
  std::vector<StudySetting> list;
  const auto add = [&](const std::vector<Motion>& motions, bool planar, std::vector<double> shares,
                       double noise_px) {
    for (const Motion& motion : motions)
      for (const double share : shares) list.push_back({motion, planar, 200, share, noise_px});
  };
  const std::vector<double> all = {1.0, 0.9, 0.7, 0.5, 0.3};
  add(motions_at(0.4), false, all, 0.5);
  add(motions_at(0.4), true, all, 0.5);
  add(motions_at(5.0), false, all, 0.5);
  add(motions_at(0.4), false, {0.7}, 1.0);
  add({{Direction::kMixed, 0, 0},
       {Direction::kMixed, 0, 10},
       {Direction::kMixed, 1, 0},
       {Direction::kMixed, 1, 10}},
      false, {0.7}, 0.5);
  return list;
}

std::vector<StudyErrors> measure(const StudySetting& setting, const std::vector<StudyMethod>& methods,
                                 std::size_t cell, std::size_t problems) {
  testing::Random random(cell + 1);
  std::vector<StudyErrors> errors(methods.size());
  for (std::size_t i = 0; i < problems; ++i) {
    const RobustProblem p = make_study_problem(setting, random);
    for (std::size_t k = 0; k < methods.size(); ++k) errors[k].add(methods[k].solve(p), p.cam2_from_cam1);
  }
  return errors;
}

void print(const StudySetting& s, const std::vector<StudyMethod>& methods,
           const std::vector<StudyErrors>& errors) {
  for (std::size_t k = 0; k < methods.size(); ++k) {
    const StudyErrors& e = errors[k];
    std::printf("%s,%g,%g,%s,%g,%g,%s,%s,%zu,%.5g,%.5g,%.5g,%.5g,%.4g\n",
                s.motion.step_percent > 0 ? name_of(s.motion.direction) : "standing", s.motion.step_percent,
                s.motion.rotation_deg, s.planar ? "plane" : "depth", s.noise_px, 100 * s.inlier_share,
                methods[k].solver.c_str(), methods[k].scheme.c_str(), e.problems,
                quantile(e.rotation_deg, 0.5), quantile(e.rotation_deg, 0.9), quantile(e.direction_deg, 0.5),
                quantile(e.direction_deg, 0.9), e.failure_percent());
  }
}

void run(std::size_t problems, unsigned threads) {
  const auto cells = settings();
  const auto methods = study_methods();
  std::vector<std::vector<StudyErrors>> results(cells.size());
  std::atomic<std::size_t> next{0};
  std::vector<std::thread> workers;
  for (unsigned t = 0; t < threads; ++t)
    workers.emplace_back([&] {
      for (std::size_t cell = next++; cell < cells.size(); cell = next++) {
        results[cell] = measure(cells[cell], methods, cell, problems);
      }
    });
  for (std::thread& worker : workers) worker.join();
  std::printf(
      "motion,step_percent,rotation_deg,scene,noise_px,inlier_percent,solver,scheme,problems,"
      "rotation_median_deg,rotation_p90_deg,direction_median_deg,direction_p90_deg,failure_percent\n");
  for (std::size_t cell = 0; cell < cells.size(); ++cell) print(cells[cell], methods, results[cell]);
}

}  // namespace
}  // namespace framewise::bench

int main(int argc, char** argv) {
  const std::size_t problems = argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 8;
  const unsigned threads = argc > 2 ? static_cast<unsigned>(std::strtoul(argv[2], nullptr, 10)) : 2;
  framewise::bench::run(problems, std::max(1u, threads));
}
