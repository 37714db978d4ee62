// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/features/matching.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <opencv2/features2d.hpp>

#include "framewise/features/descriptors_for_tests.h"
#include "framewise/features/matching_exact.h"

namespace framewise {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;
using Kind = DescriptorKind;

std::vector<FeatureMatch> exact_matches(const cv::Mat& d1, const cv::Mat& d2, const MatchOptions& options,
                                        Instructions instructions) {
  const DescriptorPair pair(d1, d2);
  return select_matches(pair.metric, exact_neighbours(pair, options.cross_check, instructions), options);
}

void expect_what_two_loops_find(Kind kind, int rows1, int rows2, int columns) {
  SCOPED_TRACE(::testing::Message() << rows1 << " x " << rows2 << " of " << columns << " columns, kind "
                                    << static_cast<int>(kind));
  const cv::Mat d1 = random_descriptors(kind, rows1, columns, 1);
  const cv::Mat d2 = rows1 > 0 ? noisy_copies(d1, rows2, 2) : random_descriptors(kind, rows2, columns, 2);
  const cv::Mat_<float> distances = plain_distances(d1, d2);
  for (const bool cross_check : {false, true})
    for (const double max_ratio : {1.0, 0.8}) {
      MatchOptions options;
      options.cross_check = cross_check;
      options.max_ratio = max_ratio;
      const auto expected = plain_matches(distances, options, [](int, int) { return true; });
      EXPECT_TRUE(match_features(d1, d2, options) == expected);
      if (rows1 == 0 || rows2 == 0) continue;
      EXPECT_TRUE(exact_matches(d1, d2, options, Instructions::kPortable) == expected);
      EXPECT_TRUE(exact_matches(d1, d2, options, best_instructions()) == expected);
    }
}

TEST(MatchFeatures, FindsWhatTwoLoopsFindInBits) {
  for (const int bytes : {1, 3, 8, 13, 16, 32, 61, 64, 125, 300})
    for (const int rows : {0, 1, 7, 33}) expect_what_two_loops_find(Kind::kBits, rows, 65, bytes);
  expect_what_two_loops_find(Kind::kBits, 65, 0, 32);
  expect_what_two_loops_find(Kind::kBits, 65, 1, 32);
  expect_what_two_loops_find(Kind::kBits, 1000, 1000, 32);
  expect_what_two_loops_find(Kind::kBits, 300, 700, 61);
}

TEST(MatchFeatures, FindsWhatTwoLoopsFindInFloats) {
  for (const Kind kind : {Kind::kWholeNumbers, Kind::kFloats}) {
    for (const int components : {1, 2, 63, 64, 128, 300})
      for (const int rows : {0, 1, 7, 33}) expect_what_two_loops_find(kind, rows, 65, components);
    expect_what_two_loops_find(kind, 1000, 300, 64);
    expect_what_two_loops_find(kind, 200, 300, 128);
  }
}

TEST(MatchFeatures, OnlyAlmostWholeNumbersAreFloatsAndFoundAsSuch) {
  const cv::Mat d1 = random_descriptors(Kind::kWholeNumbers, 40, 128, 1);
  for (const float odd : {0.5f, -1.0f, 256.0f, 1e9f}) {
    cv::Mat d2 = noisy_copies(d1, 50, 2);
    d2.at<float>(49, 127) = odd;
    EXPECT_TRUE(match_features(d1, d2) == plain_matches(d1, d2)) << odd;
    EXPECT_TRUE(match_features(d2, d1) == plain_matches(d2, d1)) << odd;
  }
}

TEST(MatchFeatures, FindsWhatOpenCvFinds) {
  for (const Kind kind : {Kind::kBits, Kind::kWholeNumbers, Kind::kFloats}) {
    const cv::Mat d1 = random_descriptors(kind, 150, 64, 1), d2 = random_descriptors(kind, 170, 64, 2);
    std::vector<cv::DMatch> expected;
    cv::BFMatcher(kind == Kind::kBits ? cv::NORM_HAMMING : cv::NORM_L2, true).match(d1, d2, expected);
    const auto matches = match_brute_force(d1, d2);
    ASSERT_EQ(matches.size(), expected.size());
    for (std::size_t i = 0; i < matches.size(); ++i) {
      EXPECT_EQ(matches[i].index1, expected[i].queryIdx);
      EXPECT_EQ(matches[i].index2, expected[i].trainIdx);
      EXPECT_FLOAT_EQ(matches[i].distance, expected[i].distance);
    }
  }
}

TEST(MatchFeatures, WhoChooseEachOtherDoSoFromEitherSide) {
  for (const Kind kind : {Kind::kBits, Kind::kWholeNumbers, Kind::kFloats}) {
    const cv::Mat d1 = random_descriptors(kind, 90, 4, 1), d2 = noisy_copies(d1, 140, 2);
    auto swapped = match_features(d2, d1);
    for (FeatureMatch& m : swapped) std::swap(m.index1, m.index2);
    std::sort(swapped.begin(), swapped.end(), [](auto& a, auto& b) { return a.index1 < b.index1; });
    EXPECT_TRUE(match_features(d1, d2) == swapped);
  }
}

TEST(MatchFeatures, TiesGoToTheLowerIndex) {
  for (const Kind kind : {Kind::kBits, Kind::kWholeNumbers, Kind::kFloats}) {
    const cv::Mat one = random_descriptors(kind, 1, 32, 1);
    const cv::Mat same = cv::repeat(one, 70, 1);
    for (const Instructions instructions : {Instructions::kPortable, best_instructions()}) {
      const auto matches = exact_matches(same, same, {}, instructions);
      ASSERT_EQ(matches.size(), 1u);
      EXPECT_TRUE((matches[0] == FeatureMatch{0, 0, 0.0f}));
    }
  }
}

TEST(MatchFeatures, TheRatioTestDropsWhatHasARival) {
  const cv::Mat d1 = (cv::Mat_<float>(2, 2) << 0, 0, 100, 0);
  const cv::Mat d2 = (cv::Mat_<float>(3, 2) << 0, 7, 8, 0, 100, 1);
  MatchOptions options;
  options.cross_check = false;
  options.max_ratio = 0.875;  // 7 / 8: the first is not below it
  ASSERT_EQ(match_features(d1, d2, options).size(), 1u);
  EXPECT_EQ(match_features(d1, d2, options)[0].index1, 1);
  options.max_ratio = 0.876;
  EXPECT_EQ(match_features(d1, d2, options).size(), 2u);
  EXPECT_EQ(match_features(d1, d2.rowRange(0, 1), options).size(), 2u) << "nothing to compare with";
}

TEST(MatchFeatures, RowsNeedNotLieTogether) {
  const cv::Mat wide1 = random_descriptors(Kind::kBits, 60, 100, 1), wide2 = noisy_copies(wide1, 60, 2);
  const cv::Mat d1 = wide1.colRange(3, 64), d2 = wide2.colRange(3, 64);
  EXPECT_TRUE(match_features(d1, d2) == match_features(d1.clone(), d2.clone()));
}

TEST(MatchFeatures, GivesNothingForNothing) {
  const cv::Mat some = random_descriptors(Kind::kBits, 5, 32, 1);
  for (const char* matcher : {"brute-force", "flann"}) {
    MatchOptions options;
    options.matcher = matcher;
    EXPECT_TRUE(match_features(cv::Mat(), some, options).empty());
    EXPECT_TRUE(match_features(some, cv::Mat(), options).empty());
    EXPECT_TRUE(match_features(some, cv::Mat(0, 32, CV_8U), options).empty());
    EXPECT_TRUE(match_features(cv::Mat(), cv::Mat(), options).empty());
  }
}

TEST(MatchFeatures, RefusesWhatCannotBeCompared) {
  const cv::Mat bits = random_descriptors(Kind::kBits, 5, 32, 1);
  const cv::Mat floats = random_descriptors(Kind::kFloats, 5, 32, 1);
  const auto match = [](const cv::Mat& d1, const cv::Mat& d2) { return [=] { match_brute_force(d1, d2); }; };
  EXPECT_THAT(
      match(bits, bits.colRange(0, 16)),
      ThrowsMessage<std::invalid_argument>(HasSubstr("found CV_8UC1 of 32 columns and CV_8UC1 of 16")));
  EXPECT_THAT(match(bits, floats), ThrowsMessage<std::invalid_argument>(HasSubstr("CV_32FC1 of 32 columns")));
  cv::Mat doubles;
  floats.convertTo(doubles, CV_64F);
  EXPECT_THROW(match_brute_force(doubles, doubles), std::invalid_argument);
  EXPECT_THROW(match_brute_force(bits.reshape(2), bits.reshape(2)), std::invalid_argument);
  cv::Mat bad = floats.clone();
  bad.at<float>(3, 30) = NAN;
  EXPECT_THAT(match(floats, bad),
              ThrowsMessage<std::invalid_argument>(HasSubstr("descriptors2: found nan in row 3")));
  bad.at<float>(3, 30) = INFINITY;
  EXPECT_THAT(match(bad, floats), ThrowsMessage<std::invalid_argument>(HasSubstr("descriptors1: found inf")));
}

TEST(MatchOptions, SaysWhichValueIsWrong) {
  const auto refused = [](auto set, const char* what) {
    MatchOptions options;
    set(options);
    EXPECT_THAT([&] { options.check(); }, ThrowsMessage<std::invalid_argument>(HasSubstr(what)));
  };
  refused([](auto& o) { o.matcher = "bf"; }, "matcher: found 'bf', expected brute-force or flann");
  refused([](auto& o) { o.max_ratio = 0; }, "max_ratio");
  refused([](auto& o) { o.max_ratio = 1.5; }, "max_ratio");
  refused([](auto& o) { o.max_ratio = NAN; }, "max_ratio: found nan");
  refused([](auto& o) { o.window_px = -1; }, "window_px");
  refused([](auto& o) { o.flann.trees = 0; }, "flann.trees");
  refused([](auto& o) { o.flann.checks = 0; }, "flann.checks");
  refused([](auto& o) { o.flann.lsh_tables = -3; }, "flann.lsh_tables");
  refused([](auto& o) { o.flann.lsh_key_bits = 64; }, "flann.lsh_key_bits");
  refused([](auto& o) { o.flann.lsh_probe_bits = -1; }, "flann.lsh_probe_bits");
}

}  // namespace
}  // namespace framewise
