// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/features/warped_patch.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace framewise {
namespace {

// Smooth, so that it is known between pixels.
double pattern(double u, double v) {
  return 120 + 40 * std::sin(0.31 * u + 0.05 * v) + 35 * std::sin(0.27 * v - 0.08 * u) +
         20 * std::sin(0.11 * u * 1.3 + 0.4 * v);
}

const Eigen::Vector2d kCentre(80, 60);

// Image 2 has pixel A (p - centre) + centre + shift where image 1 has p.
cv::Mat image(const Eigen::Matrix2d& A, const Eigen::Vector2d& shift, double gain, double offset) {
  cv::Mat gray(120, 160, CV_8U);
  const Eigen::Matrix2d back = A.inverse();
  for (int v = 0; v < gray.rows; ++v)
    for (int u = 0; u < gray.cols; ++u) {
      const Eigen::Vector2d p = back * (Eigen::Vector2d(u, v) - kCentre - shift) + kCentre;
      gray.at<std::uint8_t>(v, u) = cv::saturate_cast<std::uint8_t>(gain * pattern(p.x(), p.y()) + offset);
    }
  return gray;
}

const Eigen::Matrix2d kNone = Eigen::Matrix2d::Identity();

std::optional<TrackedPatch> track(const Eigen::Matrix2d& A, const Eigen::Vector2d& shift, double gain = 1,
                                  double offset = 0, int level = 0) {
  const auto levels1 = image_levels(image(kNone, {0, 0}, 1, 0)),
             levels2 = image_levels(image(A, shift, gain, offset));
  return track_patch(levels1, levels2, {kCentre, kCentre, A, level});
}

TEST(TrackPatch, FindsAShiftToHundredthsOfAPixel) {
  const Eigen::Vector2d shift(1.37, -0.82);
  const auto found = track(kNone, shift);
  ASSERT_TRUE(found);
  EXPECT_LT((found->pixel2 - kCentre - shift).norm(), 0.03);
  EXPECT_GT(found->correlation, 0.99);
  EXPECT_LT(found->noise_px.sigma, 0.05);
}

TEST(TrackPatch, OfStripesIsCertainAcrossThemAlone) {
  const Eigen::Vector2d across = Eigen::Vector2d(2, 1).normalized(), along(-across.y(), across.x());
  const auto stripes = [&](double moved) {
    cv::Mat gray(120, 160, CV_8U);
    cv::RNG random(4);
    for (int v = 0; v < gray.rows; ++v)
      for (int u = 0; u < gray.cols; ++u) {
        const double p = across.dot(Eigen::Vector2d(u, v)) - moved;
        gray.at<std::uint8_t>(v, u) =
            cv::saturate_cast<std::uint8_t>(128 + 60 * std::sin(0.5 * p) + random.gaussian(2));
      }
    return image_levels(gray);
  };
  const auto found = track_patch(stripes(0), stripes(0.7), {kCentre, kCentre, kNone, 0});
  ASSERT_TRUE(found);
  EXPECT_LT(std::abs(across.dot(found->pixel2 - kCentre) - 0.7), 0.1);
  const Eigen::Matrix2d C = found->noise_px.covariance();
  EXPECT_GT(along.dot(C * along), 25 * across.dot(C * across));
}

// Along stripes nothing but noise, which each image has of its own: the place stays where it was
// expected, 1.5 pixels off, and says so.
TEST(TrackPatch, NoiseIsNoTexture) {
  const Eigen::Vector2d across = Eigen::Vector2d(2, 1).normalized(), along(-across.y(), across.x());
  const auto stripes = [&](int seed) {
    cv::Mat gray(120, 160, CV_8U);
    cv::RNG random(seed);
    for (int v = 0; v < gray.rows; ++v)
      for (int u = 0; u < gray.cols; ++u)
        gray.at<std::uint8_t>(v, u) = cv::saturate_cast<std::uint8_t>(
            128 + 60 * std::sin(0.5 * across.dot(Eigen::Vector2d(u, v))) + random.gaussian(4));
    return image_levels(gray);
  };
  const Eigen::Vector2d expected = kCentre + 1.5 * along;
  double nees = 0;
  int found = 0;
  for (int i = 0; i < 60; ++i) {
    const auto patch = track_patch(stripes(2 * i + 1), stripes(2 * i + 2), {kCentre, expected, kNone, 0});
    if (!patch) continue;
    ++found;
    nees += std::pow(along.dot(patch->pixel2 - kCentre), 2) / along.dot(patch->noise_px.covariance() * along);
  }
  ASSERT_GT(found, 30);
  EXPECT_LT(nees / found, 4);  // of one number
}

TEST(TrackPatch, SeesThroughTurnScaleAndLight) {
  const Eigen::Matrix2d A = 1.25 * Eigen::Rotation2Dd(0.5).toRotationMatrix();
  const Eigen::Vector2d shift(-0.9, 1.1);
  const auto found = track(A, shift, 0.7, 30);
  ASSERT_TRUE(found);
  EXPECT_LT((found->pixel2 - kCentre - shift).norm(), 0.05);
}

TEST(TrackPatch, CoarserLevelsReachFarther) {
  const Eigen::Vector2d shift(3.9, 1.9);
  EXPECT_FALSE(track(kNone, shift, 1, 0, 0));  // beyond max_shift there
  const auto found = track(kNone, shift, 1, 0, 1);
  ASSERT_TRUE(found);
  EXPECT_LT((found->pixel2 - kCentre - shift).norm(), 0.15);
}

TEST(TrackPatch, FindsNothingWhereThereIsNothingLikeIt) {
  const auto levels1 = image_levels(image(kNone, {0, 0}, 1, 0));
  const auto even = image_levels(cv::Mat(120, 160, CV_8U, cv::Scalar(90)));
  EXPECT_FALSE(track_patch(levels1, even, {kCentre, kCentre, kNone, 0}));
  EXPECT_FALSE(track_patch(even, levels1, {kCentre, kCentre, kNone, 0}));
  EXPECT_FALSE(track_patch({}, levels1, {kCentre, kCentre, kNone, 0}));
  EXPECT_FALSE(track_patch(levels1, {}, {kCentre, kCentre, kNone, 0}));
  cv::Mat noise(120, 160, CV_8U);
  cv::RNG rng(3);
  rng.fill(noise, cv::RNG::UNIFORM, 0, 256);
  EXPECT_FALSE(track_patch(levels1, image_levels(noise), {kCentre, kCentre, kNone, 0}));
}

TEST(TrackPatch, StaysInsideBothImages) {
  const auto levels = image_levels(image(kNone, {0, 0}, 1, 0));
  const double nan = std::nan("");
  for (const Eigen::Vector2d& p : {Eigen::Vector2d(-50, 60), Eigen::Vector2d(2, 2), Eigen::Vector2d(159, 119),
                                   Eigen::Vector2d(1e9, 4), Eigen::Vector2d(nan, 60)}) {
    EXPECT_FALSE(track_patch(levels, levels, {p, kCentre, kNone, 0}));
    EXPECT_FALSE(track_patch(levels, levels, {kCentre, p, kNone, 0}));
  }
  EXPECT_FALSE(track_patch(levels, levels, {kCentre, kCentre, 1e9 * kNone, 0}));
  EXPECT_FALSE(track_patch(levels, levels, {kCentre, kCentre, 0 * kNone, 0}));
}

}  // namespace
}  // namespace framewise
