// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/features/matching_flann.h"

#include <gtest/gtest.h>

#include <thread>

#include "framewise/features/descriptors_for_tests.h"

namespace framewise {
namespace {

using Kind = DescriptorKind;

MatchOptions flann_options(std::uint64_t seed) {
  MatchOptions options;
  options.matcher = "flann";
  options.max_ratio = 0.8;
  options.seed = seed;
  return options;
}

struct FlannProblem {
  cv::Mat d1, d2;
  std::vector<FeatureMatch> match(std::uint64_t seed) const {
    return match_features(d1, d2, flann_options(seed));
  }
};

FlannProblem flann_problem(Kind kind, int columns, std::uint64_t seed) {
  const cv::Mat d1 = random_descriptors(kind, 500, columns, seed);
  return {d1, noisy_copies(d1, 400, seed + 1)};
}

const std::vector<FlannProblem>& flann_problems() {
  static const std::vector<FlannProblem> problems = {
      flann_problem(Kind::kBits, 32, 1), flann_problem(Kind::kBits, 61, 3),
      flann_problem(Kind::kFloats, 64, 5), flann_problem(Kind::kWholeNumbers, 128, 7)};
  return problems;
}

TEST(MatchFlann, FindsMostOfWhatIsThereAndItsExactDistance) {
  for (const FlannProblem& p : flann_problems()) {
    MatchOptions exact = flann_options(1);
    exact.matcher = "brute-force";
    const auto all = match_features(p.d1, p.d2, exact);
    const auto found = p.match(1);
    std::size_t right = 0;
    for (const FeatureMatch& m : found) {
      EXPECT_EQ(m.distance, plain_distance(p.d1, m.index1, p.d2, m.index2));
      for (const FeatureMatch& o : all) right += m == o;
    }
    EXPECT_GT(right, 0.8 * all.size());
    EXPECT_GT(right, 0.9 * found.size());
  }
}

TEST(MatchFlann, TheSameSeedGivesTheSameMatchesWhateverWasDrawnBefore) {
  for (const FlannProblem& p : flann_problems()) {
    cv::theRNG() = cv::RNG(1);
    const auto first = p.match(3);
    cv::theRNG() = cv::RNG(77);
    EXPECT_TRUE(p.match(3) == first);
    EXPECT_TRUE(p.match(3) == first);
  }
}

TEST(MatchFlann, AnotherSeedSearchesElsewhere) {
  std::size_t different = 0;
  for (const FlannProblem& p : flann_problems()) {
    MatchOptions few = flann_options(0);
    few.max_ratio = 1;
    few.flann.checks = 4;
    few.flann.lsh_tables = 1;
    const auto first = match_features(p.d1, p.d2, few);
    few.seed = 1;
    different += !(match_features(p.d1, p.d2, few) == first);
  }
  EXPECT_EQ(different, flann_problems().size());
}

TEST(MatchFlann, LeavesTheGeneratorOfTheThreadAsItWas) {
  cv::theRNG() = cv::RNG(5);
  const std::uint64_t before = cv::theRNG().state;
  flann_problems()[0].match(3);
  flann_problems()[2].match(3);
  EXPECT_EQ(cv::theRNG().state, before);
}

TEST(MatchFlann, ThreadsAtOnceAndInAnyOrderFindTheSame) {
  const auto& problems = flann_problems();
  std::vector<std::vector<FeatureMatch>> expected;
  for (const FlannProblem& p : problems) expected.push_back(p.match(9));
  constexpr int kThreads = 4, kRounds = 3;
  std::vector<int> wrong(kThreads);
  std::vector<std::thread> threads;
  for (int t = 0; t < kThreads; ++t)
    threads.emplace_back([&, t] {
      for (std::size_t k = 0; k < kRounds * problems.size(); ++k) {
        const std::size_t i =
            (t % 2 ? k + t : 5 * problems.size() + t - k % problems.size()) % problems.size();
        wrong[t] += !(problems[i].match(9) == expected[i]);
      }
    });
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(wrong, std::vector<int>(kThreads));
}

TEST(MatchFlann, CopesWithFewDescriptorsAndEqualOnes) {
  for (const Kind kind : {Kind::kBits, Kind::kFloats})
    for (const int columns : {1, 8, 61})
      for (const int rows : {1, 2, 3}) {
        const cv::Mat d = random_descriptors(kind, rows, columns, 1);
        MatchOptions options = flann_options(1);
        options.max_ratio = 1;
        const auto matches = match_features(d, d, options);
        EXPECT_FALSE(matches.empty()) << columns << " " << rows;
        for (const FeatureMatch& m : matches) EXPECT_EQ(m.distance, 0);
        const cv::Mat same = cv::repeat(d.row(0), 50, 1);
        EXPECT_LE(match_features(same, same, options).size(), 50u);
      }
}

}  // namespace
}  // namespace framewise
