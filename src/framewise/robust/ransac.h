// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>

#include "framewise/robust/ransac_iterations.h"
#include "framewise/robust/ransac_options.h"
#include "framewise/robust/sampler.h"
#include "framewise/robust/scoring.h"
#include "framewise/solvers/hypotheses.h"

namespace framewise {

// What ransac() asks of a problem:
//
//   class Problem {
//    public:
//     using Model = ...;                                  // a hypothesis, copied freely
//     static constexpr std::size_t kMaxModels = 10;       // of one sample
//     std::size_t size() const;                           // correspondences
//     std::size_t sample_size() const;                    // at most 16
//     void solve(std::span<const std::uint32_t> sample, Hypotheses<Model, kMaxModels>& models) const;
//     Tally score(const Model& model, const Judge& judge) const;
//     bool refine(Model& model) const;                    // least squares on its inliers; false: not
//     possible
//   };
//
// None of them may allocate: the loop does not.

template <typename Model>
struct RansacResult {
  Model model{};
  Tally tally;                   // of all correspondences
  int iterations = 0;            // samples drawn
  double iterations_theory = 0;  // at the share of inliers found
};

namespace detail {

// Share of inliers that a wrong hypothesis has by chance: measured while it runs, for Wald's test.
class BadShare {
 public:
  void observe(const Tally& tally, std::size_t rows) {
    if (!tally.complete) return;
    share_ += 0.05 * (static_cast<double>(tally.inliers) / static_cast<double>(rows) - share_);
  }
  double value() const { return std::clamp(share_, 0.01, 0.5); }

 private:
  double share_ = 0.1;
};

}  // namespace detail

// Draws samples, keeps the hypothesis of lowest cost, and stops when a better one is unlikely to come
// (Fischler and Bolles, CACM 1981). With local optimisation every new best is refined at once (Chum, Matas,
// Kittler, Locally Optimized RANSAC, DAGM 2003). Empty when no sample gave a hypothesis.
template <typename Problem>
std::optional<RansacResult<typename Problem::Model>> ransac(const Problem& problem,
                                                            const RansacOptions& options, double max_error) {
  using Model = typename Problem::Model;
  const std::size_t size = problem.size();
  const int sample_size = static_cast<int>(problem.sample_size());
  RandomStream random(options.seed);
  ProsacSampler prosac(size, problem.sample_size(), options.max_iterations);
  std::array<std::uint32_t, 16> storage{};
  const std::span<std::uint32_t> sample(storage.data(), problem.sample_size());
  Hypotheses<Model, Problem::kMaxModels> models;
  detail::BadShare bad_share;

  Judge judge;
  judge.max_error = max_error;
  judge.scoring = options.scoring;
  std::optional<RansacResult<Model>> best;
  double best_minimal = std::numeric_limits<double>::infinity();  // cost before local optimisation
  double enough = options.max_iterations;
  int iteration = 0;
  while (iteration < options.max_iterations && (iteration < options.min_iterations || iteration < enough)) {
    ++iteration;
    if (options.sampling == Sampling::kProsac) {
      prosac.draw(sample, random);
    } else {
      draw_distinct(size, sample, random);
    }
    models.clear();
    problem.solve(sample, models);
    for (const Model& minimal : models) {
      const Tally tally = problem.score(minimal, judge);
      if (!tally.complete || !(tally.cost < best_minimal)) {
        bad_share.observe(tally, size);
        continue;
      }
      best_minimal = tally.cost;
      RansacResult<Model> candidate{minimal, tally};
      if (options.local_optimisation) {
        Model refined = minimal;
        Judge full = judge;
        full.cost_bound = std::numeric_limits<double>::infinity();
        full.good_share = 0;
        if (problem.refine(refined)) {
          const Tally refined_tally = problem.score(refined, full);
          if (refined_tally.cost < tally.cost) candidate = {refined, refined_tally};
        }
      }
      if (best && !(candidate.tally.cost < best->tally.cost)) continue;
      best = candidate;
      const double share = static_cast<double>(best->tally.inliers) / static_cast<double>(size);
      enough = ransac_iterations(options.confidence, share, sample_size);
      if (options.early_bailout) {
        judge.cost_bound = best_minimal;
        judge.good_share = 0.5 * share;
        judge.bad_share = bad_share.value();
      }
    }
  }
  if (best) {
    best->iterations = iteration;
    best->iterations_theory =
        ransac_iterations(options.confidence,
                          static_cast<double>(best->tally.inliers) / static_cast<double>(size), sample_size);
  }
  return best;
}

}  // namespace framewise
