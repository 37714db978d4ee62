// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/features/features.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <opencv2/features2d.hpp>

#include "framewise/features/feature_names.h"
#include "framewise/features/matching.h"
#include "framewise/features/synthetic_images_for_tests.h"

namespace framewise {
namespace {

using testing::discs;
using testing::turned;

FeatureOptions pair_of(const std::string& detector, const std::string& descriptor, int count = 300) {
  FeatureOptions options;
  options.detector = detector;
  options.descriptor = descriptor;
  options.count = count;
  return options;
}

bool same_bytes(const Features& a, const Features& b) {
  if (a.keypoints.size() != b.keypoints.size() || a.descriptors.size() != b.descriptors.size()) return false;
  for (std::size_t i = 0; i < a.keypoints.size(); ++i) {
    const cv::KeyPoint &ka = a.keypoints[i], &kb = b.keypoints[i];
    if (ka.pt != kb.pt || ka.size != kb.size || ka.angle != kb.angle || ka.response != kb.response)
      return false;
  }
  return a.descriptors.empty() || cv::norm(a.descriptors, b.descriptors, cv::NORM_INF) == 0;
}

class EveryPair : public ::testing::TestWithParam<std::tuple<std::string, std::string>> {
 protected:
  std::string detector() const { return std::get<0>(GetParam()); }
  std::string descriptor() const { return std::get<1>(GetParam()); }
};
INSTANTIATE_TEST_SUITE_P(Features, EveryPair,
                         ::testing::Combine(::testing::ValuesIn(detector_names()),
                                            ::testing::ValuesIn(descriptor_names())),
                         [](const auto& info) {
                           std::string name = std::get<0>(info.param) + "_" + std::get<1>(info.param);
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

TEST_P(EveryPair, DescribesEveryKeypoint) {
  const cv::Mat image = discs({280, 220}, 1, 200);
  for (const bool upright : {false, true}) {
    FeatureOptions options = pair_of(detector(), descriptor());
    options.upright = upright;
    const Features features = extract_features(image, options);
    EXPECT_GT(features.keypoints.size(), 100u);
    EXPECT_LE(features.keypoints.size(), 300u);
    ASSERT_EQ(features.descriptors.rows, static_cast<int>(features.keypoints.size()));
    const bool binary = descriptor() == "orb" || descriptor() == "akaze";
    EXPECT_EQ(features.descriptors.type(), binary ? CV_8UC1 : CV_32FC1);
    const std::map<std::string, int> columns{
        {"sift", 128}, {"surf", 64}, {"surf-128", 128}, {"orb", 32}, {"akaze", 64}};
    EXPECT_EQ(features.descriptors.cols, columns.at(descriptor()));
    if (!binary) {
      EXPECT_TRUE(cv::checkRange(features.descriptors));
    }
    for (std::size_t i = 0; i < features.keypoints.size(); ++i)
      EXPECT_GE(features.scale(static_cast<int>(i)), 1);
  }
}

// Turned by 40 degrees: what the descriptors match is where the turning takes it.
TEST_P(EveryPair, RecognisesATurnedImage) {
  const cv::Mat image = discs({360, 280}, 2, 250);
  const auto warp = turned(image, 40, 1.0);
  const FeatureOptions options = pair_of(detector(), descriptor());
  const Features f1 = extract_features(image, options), f2 = extract_features(warp.image, options);
  std::vector<cv::DMatch> matches;
  cv::BFMatcher(f1.descriptors.depth() == CV_8U ? cv::NORM_HAMMING : cv::NORM_L2, true)
      .match(f1.descriptors, f2.descriptors, matches);
  int seen = 0, right = 0;
  for (const cv::DMatch& m : matches) {
    const cv::Point2d there = warp(f1.keypoints[m.queryIdx].pt);
    if (!cv::Rect2d(20, 20, 320, 240).contains(there)) continue;
    ++seen;
    right += cv::norm(cv::Point2d(f2.keypoints[m.trainIdx].pt) - there) < 3;
  }
  EXPECT_GT(right, 40);
  EXPECT_GT(right, 0.5 * seen);
}

TEST_P(EveryPair, GivesNothingWhereThereIsNothing) {
  const FeatureOptions options = pair_of(detector(), descriptor());
  for (const cv::Size& size :
       {cv::Size(0, 0), cv::Size(1, 1), cv::Size(5, 400), cv::Size(17, 17), cv::Size(160, 120)}) {
    const Features features = extract_features(cv::Mat(size, CV_8U, cv::Scalar(0)), options);
    EXPECT_TRUE(features.keypoints.empty()) << size;
    EXPECT_TRUE(features.descriptors.empty()) << size;
  }
}

TEST_P(EveryPair, BearsSmallAndNarrowImagesOfNoise) {
  for (const cv::Size& size :
       {cv::Size(2, 2), cv::Size(16, 16), cv::Size(33, 20), cv::Size(79, 81), cv::Size(300, 40)}) {
    cv::Mat noise(size, CV_8U);
    cv::RNG(7).fill(noise, cv::RNG::UNIFORM, 0, 256);
    const Features features = extract_features(noise, pair_of(detector(), descriptor(), 2000));
    EXPECT_EQ(features.descriptors.rows, static_cast<int>(features.keypoints.size())) << size;
  }
}

class EveryDetector : public ::testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Features, EveryDetector, ::testing::ValuesIn(detector_names()));

TEST_P(EveryDetector, IsTheSameWithAnyNumberOfThreads) {
  const cv::Mat image = discs({280, 220}, 3, 200);
  for (const auto& [descriptor, spread] : std::vector<std::pair<std::string, std::string>>{
           {GetParam(), "none"}, {"sift", "grid"}, {"akaze", "anms"}, {"orb", "none"}}) {
    FeatureOptions options = pair_of(GetParam(), descriptor, 200);
    options.spread = spread;
    const int threads = cv::getNumThreads();
    cv::setNumThreads(1);
    const Features one = extract_features(image, options);
    cv::setNumThreads(2);
    const Features two = extract_features(image, options), again = extract_features(image, options);
    cv::setNumThreads(threads);
    EXPECT_TRUE(same_bytes(one, two)) << spread;
    EXPECT_TRUE(same_bytes(two, again)) << spread;
  }
}

TEST_P(EveryDetector, KeepsTheCountAskedFor) {
  for (const auto& [contrast, seed] : {std::pair(1.0, 4), std::pair(0.25, 5)}) {
    cv::Mat image;
    discs({320, 240}, seed, 600).convertTo(image, CV_8U, contrast, 60);
    for (const int count : {100, 250})
      for (const char* spread : {"none", "grid", "anms"}) {
        FeatureOptions options = pair_of(GetParam(), GetParam(), count);
        options.spread = spread;
        const auto found = extract_features(image, options).keypoints.size();
        EXPECT_NEAR(static_cast<double>(found), count, 0.1 * count) << contrast << " " << spread;
      }
  }
}

// Pyramids shift places easily. In a mirrored image they would shift the other way.
TEST_P(EveryDetector, FindsPlacesThatAMirrorKeeps) {
  const cv::Mat image = discs({400, 300}, 11, 300);
  cv::Mat mirrored;
  cv::flip(image, mirrored, -1);
  const FeatureOptions options = pair_of(GetParam(), GetParam(), 500);
  const Features f1 = extract_features(image, options), f2 = extract_features(mirrored, options);
  std::vector<double> fine_x, coarse_x, fine_y, coarse_y;
  for (std::size_t i = 0; i < f1.keypoints.size(); ++i)
    for (const cv::KeyPoint& k2 : f2.keypoints) {
      const cv::KeyPoint& k1 = f1.keypoints[i];
      const cv::Point2f shift = k1.pt + k2.pt - cv::Point2f(399, 299);
      if (cv::norm(shift) > 3 || std::abs(k1.size / k2.size - 1) > 0.05) continue;
      const bool is_fine = f1.scale(static_cast<int>(i)) < 1.6;
      (is_fine ? fine_x : coarse_x).push_back(shift.x / 2);
      (is_fine ? fine_y : coarse_y).push_back(shift.y / 2);
    }
  for (auto* shifts : {&fine_x, &coarse_x, &fine_y, &coarse_y}) {
    ASSERT_GT(shifts->size(), 30u);
    std::nth_element(shifts->begin(), shifts->begin() + shifts->size() / 2, shifts->end());
    EXPECT_NEAR((*shifts)[shifts->size() / 2], 0, 0.06);
  }
}

TEST_P(EveryDetector, LooksOnlyWhereTheMaskAllows) {
  const cv::Mat image = discs({320, 240}, 6, 250);
  cv::Mat mask(image.size(), CV_8U, cv::Scalar(0));
  mask(cv::Rect(100, 60, 150, 120)).setTo(255);
  const Features features = extract_features(image, pair_of(GetParam(), GetParam(), 100), mask);
  EXPECT_GT(features.keypoints.size(), 60u);
  for (const cv::KeyPoint& k : features.keypoints)
    EXPECT_TRUE(cv::Rect2f(99, 59, 152, 122).contains(k.pt)) << k.pt;
  const cv::Mat nowhere(image.size(), CV_8U, cv::Scalar(0));
  EXPECT_TRUE(extract_features(image, pair_of(GetParam(), GetParam()), nowhere).keypoints.empty());
}

TEST_P(EveryDetector, CoversMoreOfTheImageWhenSpread) {
  cv::Mat image;
  discs({400, 300}, 8, 600).convertTo(image, CV_8U, 0.3, 70);
  discs({130, 130}, 9, 80).copyTo(image(cv::Rect(0, 0, 130, 130)));  // the strong texture
  const auto outside = [&](const char* spread) {
    FeatureOptions options = pair_of(GetParam(), "orb", 150);
    options.spread = spread;
    int count = 0;
    for (const cv::KeyPoint& k : extract_features(image, options).keypoints)
      count += k.pt.x > 130 || k.pt.y > 130;
    return count;
  };
  EXPECT_GT(outside("grid"), outside("none") + 30);
  EXPECT_GT(outside("anms"), outside("none") + 30);
}

TEST(Features, RefusesWhatItDoesNotKnow) {
  const cv::Mat image = discs({64, 64}, 1, 10);
  const auto message = [&](FeatureOptions options, const cv::Mat& gray, const cv::Mat& mask) -> std::string {
    try {
      extract_features(gray, options, mask);
    } catch (const std::invalid_argument& e) {
      return e.what();
    }
    return "accepted";
  };
  using ::testing::HasSubstr;
  EXPECT_THAT(message(pair_of("fast", "orb"), image, {}),
              HasSubstr("detector: found 'fast', expected one of sift"));
  EXPECT_THAT(message(pair_of("orb", "brief"), image, {}), HasSubstr("descriptor: found 'brief'"));
  EXPECT_THAT(message(pair_of("orb", "orb", 0), image, {}), HasSubstr("count: found 0"));
  FeatureOptions spread;
  spread.spread = "even";
  EXPECT_THAT(message(spread, image, {}), HasSubstr("spread: found 'even', expected one of none grid anms"));
  EXPECT_THAT(message({}, cv::Mat(64, 64, CV_8UC3), {}), HasSubstr("gray: found 3 channel(s) of 8 bits"));
  EXPECT_THAT(message({}, cv::Mat(64, 64, CV_16U), {}), HasSubstr("gray: found 1 channel(s) of 16 bits"));
  EXPECT_THAT(message({}, image, cv::Mat(64, 63, CV_8U)), HasSubstr("mask: found 63 x 64 pixels"));
  EXPECT_THAT(message({}, image, cv::Mat(64, 64, CV_32F)), HasSubstr("mask: found 1 channel(s) of 32 bits"));
}

TEST(Features, SaysThatSurfWasLeftOut) {
  if (std::count(detector_names().begin(), detector_names().end(), "surf") > 0)
    GTEST_SKIP() << "this build has SURF";
  try {
    extract_features(discs({64, 64}, 1, 10), pair_of("surf", "orb"));
    FAIL() << "accepted";
  } catch (const std::invalid_argument& e) {
    EXPECT_THAT(e.what(), ::testing::HasSubstr("FRAMEWISE_WITH_SURF=OFF"));
  }
}

}  // namespace
}  // namespace framewise
