// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/robust/ransac.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <new>

#include "framewise/robust/absolute_pose_problem.h"
#include "framewise/robust/epipolar_problem.h"
#include "framewise/robust/robust_problems_for_tests.h"

namespace {
std::size_t allocations = 0;
}  // namespace

// Counts what the loop below allocates.
void* operator new(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace framewise {
namespace {

using testing::kPixel;
using testing::make_noisy_problem;
using testing::Random;
using testing::Scene;

TEST(Ransac, AllocatesNothing) {
  Random random(1);
  const auto p = make_noisy_problem(Scene::kRandom, 200, 100, 0.5 * kPixel, random);
  RelativePoseOptions options;
  options.solver = RelativePoseSolver::kNister5pt;
  options.ransac.min_iterations = 100;
  options.ransac.max_iterations = 200;
  const EpipolarProblem two_views(p.x1, p.x2, options);
  const AbsolutePoseProblem absolute(p.X1, p.x2, options.max_error, 0);

  std::size_t before = allocations;
  EXPECT_TRUE(ransac(two_views, options.ransac, options.max_error));
  EXPECT_EQ(allocations, before);
  before = allocations;
  EXPECT_TRUE(ransac(absolute, options.ransac, options.max_error));
  EXPECT_EQ(allocations, before);
}

// A line through the origin's slope from one point: the loop's own behaviour, without geometry.
struct Slopes {
  using Model = double;
  static constexpr std::size_t kMaxModels = 1;
  std::vector<double> slopes;

  std::size_t size() const { return slopes.size(); }
  std::size_t sample_size() const { return 1; }
  void solve(std::span<const std::uint32_t> sample, Hypotheses<double, 1>& models) const {
    models.push_back(slopes[sample[0]]);
  }
  Tally score(double slope, const Judge& judge) const {
    Tally tally;
    for (const double s : slopes) {
      const double q = (s - slope) * (s - slope) / (judge.max_error * judge.max_error);
      tally.cost += price(q, judge.scoring);
      tally.inliers += q < 1;
    }
    return tally;
  }
  bool refine(double&) const { return false; }
};

TEST(Ransac, StopsWhenTheoryIsSatisfied) {
  Slopes problem{std::vector<double>(100, 2.0)};
  RansacOptions options;
  options.min_iterations = 7;
  EXPECT_EQ(ransac(problem, options, 0.1)->iterations, 7);
  for (int i = 0; i < 90; ++i) problem.slopes[i] = i;
  options.min_iterations = 1;
  const auto found = ransac(problem, options, 0.1);
  EXPECT_DOUBLE_EQ(found->model, 2);
  EXPECT_EQ(found->tally.inliers, 11u);
  EXPECT_GE(found->iterations, found->iterations_theory);
  EXPECT_LT(found->iterations, found->iterations_theory + 1);
  options.max_iterations = 3;
  EXPECT_EQ(ransac(problem, options, 0.1)->iterations, 3);
}

}  // namespace
}  // namespace framewise
