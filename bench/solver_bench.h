// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "framewise/solvers/problems_for_tests.h"

// A registry of solvers, ours and peers', measured on the same noise-free problems in one run.
namespace framewise::bench {

using testing::Scene;
using testing::TwoViewProblem;

// One solver, its input already in its own types.
class Contestant {
 public:
  virtual ~Contestant() = default;
  virtual void load(const std::vector<TwoViewProblem>& problems) = 0;
  virtual std::size_t run(std::size_t begin, std::size_t end) = 0;               // what is timed
  virtual double error(std::size_t i, const TwoViewProblem& problem) const = 0;  // rad, of the best solution
};

// prepare(problem) -> input (not timed); solve(input) -> output (timed); judge(output, problem) -> rad.
template <typename Prepare, typename Solve, typename Judge>
class ContestantOf : public Contestant {
 public:
  ContestantOf(Prepare prepare, Solve solve, Judge judge)
      : prepare_(std::move(prepare)), solve_(std::move(solve)), judge_(std::move(judge)) {}

  void load(const std::vector<TwoViewProblem>& problems) override {
    inputs_.clear();
    for (const TwoViewProblem& problem : problems) inputs_.push_back(prepare_(problem));
  }
  std::size_t run(std::size_t begin, std::size_t end) override {
    for (std::size_t i = begin; i < end; ++i) {
      const auto output = solve_(inputs_[i]);
      asm volatile("" : : "g"(&output) : "memory");  // keeps the result
    }
    return end - begin;
  }
  double error(std::size_t i, const TwoViewProblem& problem) const override {
    return judge_(solve_(inputs_[i]), problem);
  }

 private:
  Prepare prepare_;
  Solve solve_;
  Judge judge_;
  std::vector<decltype(std::declval<Prepare>()(std::declval<const TwoViewProblem&>()))> inputs_;
};

// What is asked (solvers of one task are compared), by whom it is answered, from how many points.
struct Entry {
  std::string task, who;
  std::size_t points;
  std::shared_ptr<Contestant> contestant;
};

class Registry {
 public:
  template <typename Prepare, typename Solve, typename Judge>
  void add(std::string task, std::string who, std::size_t points, Prepare prepare, Solve solve, Judge judge) {
    entries_.push_back({std::move(task), std::move(who), points,
                        std::make_shared<ContestantOf<Prepare, Solve, Judge>>(prepare, solve, judge)});
  }
  const std::vector<Entry>& entries() const { return entries_; }

 private:
  std::vector<Entry> entries_;
};

struct Row {
  double microseconds = 0;                 // a call
  double failures = 0;                     // share of problems
  double median_error = 0, max_error = 0;  // rad
};

// Many short batches, each repeated; the lower quartile of the repetitions, so that what else runs on the
// machine has little say. Contestants take turns batch by batch.
inline std::vector<double> time_all(const std::vector<Entry>& entries, std::size_t problems,
                                    int repetitions) {
  constexpr std::size_t kBatch = 50;
  std::vector<double> total(entries.size(), 0);
  std::size_t batches = 0;
  for (std::size_t begin = 0; begin + kBatch <= problems; begin += kBatch, ++batches) {
    std::vector<std::vector<double>> times(entries.size());
    for (int repetition = 0; repetition < repetitions; ++repetition) {
      for (std::size_t k = 0; k < entries.size(); ++k) {
        const auto start = std::chrono::steady_clock::now();
        entries[k].contestant->run(begin, begin + kBatch);
        const std::chrono::duration<double, std::micro> elapsed = std::chrono::steady_clock::now() - start;
        times[k].push_back(elapsed.count() / kBatch);
      }
    }
    for (std::size_t k = 0; k < entries.size(); ++k) {
      std::nth_element(times[k].begin(), times[k].begin() + repetitions / 4, times[k].end());
      total[k] += times[k][repetitions / 4];
    }
  }
  for (double& t : total) t /= std::max<std::size_t>(batches, 1);
  return total;
}

// Failure: the best solution is further than this from the truth, or there is none.
inline constexpr double kFailure = 1e-4;  // rad

inline void judge(const Entry& entry, const std::vector<TwoViewProblem>& problems, Row& row) {
  std::vector<double> errors;
  for (std::size_t i = 0; i < problems.size(); ++i) errors.push_back(entry.contestant->error(i, problems[i]));
  const auto failed = std::count_if(errors.begin(), errors.end(), [](double e) { return !(e <= kFailure); });
  row.failures = static_cast<double>(failed) / errors.size();
  std::nth_element(errors.begin(), errors.begin() + errors.size() / 2, errors.end());
  row.median_error = errors[errors.size() / 2];
  row.max_error = *std::max_element(errors.begin(), errors.end());
}

}  // namespace framewise::bench
