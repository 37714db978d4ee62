// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/evaluation/paired_comparison.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "framewise/evaluation/series_for_tests.h"

namespace framewise {
namespace {

// p values of pairs of methods that are equal, and of one that is worse by `shift`.
std::vector<double> p_values(std::size_t frames, double phi, double shift, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  PairedOptions options;
  options.bootstrap.resamples = 100;
  options.flips = 499;
  std::vector<double> p;
  for (int i = 0; i < 500; ++i) {
    std::vector<double> differences = ar1_noise(frames, phi, random);
    for (double& d : differences) d += shift;
    p.push_back(paired_difference(differences, options).p);
  }
  return p;
}

double share_below(const std::vector<double>& p, double level) {
  return static_cast<double>(std::count_if(p.begin(), p.end(), [&](double x) { return x <= level; })) /
         static_cast<double>(p.size());
}

TEST(PairedDifference, IsUniformInPWhereThereIsNone) {
  for (const double phi : {0.0, 0.3, 0.5}) {
    const std::vector<double> p = p_values(120, phi, 0, 1);
    for (const double level : {0.05, 0.2, 0.5, 0.8})
      EXPECT_NEAR(share_below(p, level), level, level < 0.1 ? 0.03 : 0.07) << "phi " << phi;
  }
}

TEST(PairedDifference, IsFoundWhereThereIsOne) {
  EXPECT_GT(share_below(p_values(120, 0.3, 0.8, 2), 0.01), 0.9);
  EXPECT_LT(share_below(p_values(120, 0.3, 0.2, 2), 0.01), 0.9);
}

TEST(PairedDifference, HasAnIntervalAroundItsMedian) {
  std::mt19937_64 random(3);
  std::vector<double> differences = ar1_noise(100, 0.3, random);
  for (double& d : differences) d += 2;
  const PairedDifference found = paired_difference(differences);
  ASSERT_TRUE(found.interval);
  EXPECT_LT(found.interval->low, found.median);
  EXPECT_GT(found.interval->high, found.median);
  EXPECT_GT(found.interval->low, 1);
  EXPECT_LT(found.interval->high, 3);
  EXPECT_TRUE(found.is_real);
  EXPECT_EQ(found.frames, 100u);
}

TEST(PairedDifference, OfTheOppositeIsTheOpposite) {
  std::mt19937_64 random(4);
  std::vector<double> differences = ar1_noise(61, 0.2, random);
  const PairedDifference found = paired_difference(differences);
  for (double& d : differences) d = -d;
  const PairedDifference opposite = paired_difference(differences);
  EXPECT_DOUBLE_EQ(found.median, -opposite.median);
  EXPECT_EQ(found.p, opposite.p);
}

TEST(PairedDifference, OfMethodsThatAgreeExactlyIsNothing) {
  const PairedDifference found = paired_difference(std::vector<double>(40, 0.0));
  EXPECT_EQ(found.median, 0);
  EXPECT_EQ(found.p, 1);
  EXPECT_FALSE(found.is_real);
}

TEST(PairedDifference, OfFewFramesCannotBeReal) {
  EXPECT_EQ(paired_difference(std::vector<double>{3.0}).p, 1);
  EXPECT_FALSE(paired_difference(std::vector<double>{3.0, 4.0, 5.0, 4.0}).is_real);
}

TEST(PairedDifference, RepeatsItselfBySeed) {
  std::mt19937_64 random(5);
  const std::vector<double> differences = ar1_noise(200, 0.2, random);
  const PairedDifference first = paired_difference(differences), second = paired_difference(differences);
  EXPECT_EQ(first.p, second.p);
  EXPECT_EQ(first.interval->low, second.interval->low);
}

TEST(PairedDifference, RefusesNothingAndWhatIsNotFinite) {
  EXPECT_THROW(paired_difference({}), std::invalid_argument);
  std::vector<double> differences(20, 1.0);
  differences[7] = std::numeric_limits<double>::infinity();
  EXPECT_THROW(paired_difference(differences), std::invalid_argument);
  PairedOptions options;
  options.flips = 1;
  EXPECT_THROW(paired_difference(std::vector<double>(20, 1.0), options), std::invalid_argument);
}

TEST(Holm, MultipliesByTheComparisonsThatAreLeftAndNeverFalls) {
  const std::vector<double> p{0.01, 0.04, 0.03, 0.005};  // R: p.adjust(p, "holm")
  EXPECT_THAT(holm(p), testing::ElementsAre(testing::DoubleEq(0.03), testing::DoubleEq(0.06),
                                            testing::DoubleEq(0.06), testing::DoubleEq(0.02)));
  EXPECT_THAT(holm(std::vector<double>{0.9, 0.8}), testing::ElementsAre(1, 1));
  EXPECT_TRUE(holm({}).empty());
}

TEST(Holm, KeepsTheChanceOfAnyFalseFindingBelowTheLevel) {
  std::mt19937_64 random(6);
  int families_with_a_finding = 0;
  for (int family = 0; family < 2000; ++family) {
    std::vector<double> p(20);
    for (double& value : p) value = static_cast<double>(random() >> 11) * 0x1p-53;
    const std::vector<double> corrected = holm(p);
    families_with_a_finding += *std::min_element(corrected.begin(), corrected.end()) < 0.05;
  }
  EXPECT_NEAR(families_with_a_finding / 2000.0, 0.05, 0.015);
}

TEST(CompareWithBest, TellsTheWorseFromTheEqual) {
  std::mt19937_64 random(7);
  const std::vector<double> best = ar1_noise(150, 0.2, random);
  std::vector<double> worse = best, equal = best;
  const std::vector<double> noise1 = ar1_noise(150, 0.2, random), noise2 = ar1_noise(150, 0.2, random);
  for (std::size_t i = 0; i < best.size(); ++i) {
    worse[i] += 1 + noise1[i];
    equal[i] += noise2[i];
  }
  const std::vector<std::vector<double>> errors{worse, best, equal, best};
  const BestComparison found = compare_with_best(errors, std::vector<double>{3, 1, 2, 1});
  EXPECT_EQ(found.best, 1u);
  EXPECT_FALSE(found.differences[1]);
  EXPECT_TRUE(found.differences[0]->is_real);
  EXPECT_GT(found.differences[0]->median, 0.5);
  EXPECT_GE(found.differences[0]->p_holm, found.differences[0]->p);
  EXPECT_FALSE(found.differences[2]->is_real);
  EXPECT_EQ(found.differences[3]->median, 0);
  EXPECT_FALSE(found.differences[3]->is_real);
}

TEST(CompareWithBest, RefusesWhatCannotBePaired) {
  using Errors = std::vector<std::vector<double>>;
  const std::vector<double> two{1, 2};
  EXPECT_THROW(compare_with_best({}, {}), std::invalid_argument);
  EXPECT_THROW(compare_with_best(Errors{{1, 2, 3}}, two), std::invalid_argument);
  EXPECT_THROW(compare_with_best(Errors{{1, 2, 3}, {1, 2}}, two), std::invalid_argument);
  EXPECT_EQ(compare_with_best(Errors{{1, 2, 3}}, std::vector<double>{1}).best, 0u);
}

}  // namespace
}  // namespace framewise
