// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/features/tracking.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

#include "framewise/features/tracking_corners.h"
#include "framewise/geometry/so3.h"

namespace framewise {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

// Blotches of many sizes.
cv::Mat texture(int width, int height, std::uint64_t seed) {
  cv::Mat sum(height, width, CV_32F, cv::Scalar(0)), layer(height, width, CV_32F);
  cv::RNG rng(seed);
  for (const double sigma : {1.5, 4.0, 12.0}) {
    rng.fill(layer, cv::RNG::NORMAL, 0, 60 * sigma);
    cv::GaussianBlur(layer, layer, cv::Size(), sigma);
    sum += layer;
  }
  cv::Mat gray;
  sum.convertTo(gray, CV_8U, 1, 128);
  return gray;
}

Camera wide_camera(int width, int height) {
  Camera camera;
  camera.width = width, camera.height = height;
  camera.fx = camera.fy = 0.8 * width;
  camera.cx = width / 2.0, camera.cy = height / 2.0;
  return camera;
}

// What a camera sees that is turned: each pixel of the second image looks up its direction in the first.
cv::Mat turned(const cv::Mat& gray, const Camera& camera, const Eigen::Matrix3d& cam2_from_cam1) {
  cv::Mat map(gray.size(), CV_32FC2), result;
  for (int y = 0; y < gray.rows; ++y)
    for (int x = 0; x < gray.cols; ++x) {
      const Eigen::Vector3d x1 = cam2_from_cam1.transpose() * *camera.bearing({x, y});
      const Eigen::Vector2d pixel = camera.project(x1).value_or(Eigen::Vector2d(-1, -1));
      map.at<cv::Vec2f>(y, x) = cv::Vec2f(static_cast<float>(pixel.x()), static_cast<float>(pixel.y()));
    }
  cv::remap(gray, result, map, cv::noArray(), cv::INTER_LINEAR, cv::BORDER_REFLECT);
  return result;
}

// How many tracks ended within a pixel of the truth, and how many elsewhere.
std::pair<int, int> right_and_wrong(const Tracks& tracks, const std::vector<cv::Point2f>& truth) {
  int right = 0, wrong = 0;
  for (std::size_t i = 0; i < truth.size(); ++i)
    if (tracks.found[i]) (cv::norm(tracks.pixels[i] - truth[i]) < 1 ? right : wrong)++;
  return {right, wrong};
}

TEST(TrackPoints, FollowsAShiftToFractionsOfAPixel) {
  const cv::Mat big = texture(360, 280, 1);
  const cv::Mat gray1 = big(cv::Rect(30, 20, 320, 240)).clone(),
                gray2 = big(cv::Rect(17, 29, 320, 240)).clone();
  const auto corners = detect_corners(gray1);
  ASSERT_GT(corners.size(), 100u);
  const Tracks tracks = track_points(gray1, gray2, corners);
  int found = 0, exact = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (!tracks.found[i]) continue;
    const double error = cv::norm(tracks.pixels[i] - corners[i] - cv::Point2f(13, -9));
    EXPECT_LT(error, 1) << i;
    ++found;
    exact += error < 0.05;
  }
  EXPECT_GT(found, 0.8 * corners.size());
  EXPECT_GT(exact, 0.9 * found) << "but for those whose patch is cut off by the border";
}

TEST(TrackPoints, TheWayBackTellsWhatWasLost) {
  const cv::Mat gray1 = texture(320, 240, 1), gray2 = texture(320, 240, 2);  // nothing in common
  const auto corners = detect_corners(gray1);
  TrackOptions options;
  const auto count = [&] {
    return tracked_matches(corners, track_points(gray1, gray2, corners, options)).pixels1.size();
  };
  EXPECT_LT(count(), 0.1 * corners.size());
  options.max_backward_px = 1e9;
  EXPECT_GT(count(), 0.3 * corners.size()) << "without it they would have been taken for found";
}

TEST(TrackPoints, APredictedRotationFindsWhatIsTooFarOtherwise) {
  const cv::Mat gray1 = texture(320, 240, 1);
  const Camera camera = wide_camera(320, 240);
  const Eigen::Matrix3d R = so3_exp(Eigen::Vector3d(0.1, 0.25, 0.15));  // about 80 pixels
  const cv::Mat gray2 = turned(gray1, camera, R);
  const auto corners = detect_corners(gray1);
  const auto truth = predict_by_rotation(camera, R, corners);
  const auto guess = predict_by_rotation(camera, so3_exp(Eigen::Vector3d(0.09, 0.26, 0.14)), corners);
  const auto [without, wrong_without] = right_and_wrong(track_points(gray1, gray2, corners), truth);
  const auto [with, wrong_with] = right_and_wrong(track_points(gray1, gray2, corners, {}, guess), truth);
  EXPECT_GT(with, 100);
  EXPECT_GT(with, 2 * without) << "of " << corners.size();
  EXPECT_LT(wrong_with, 0.05 * with);
}

TEST(TrackPoints, APredictionDoesNotMoveWhatIsFoundAnyway) {
  const cv::Mat big = texture(340, 260, 3);
  const cv::Mat gray1 = big(cv::Rect(3, 4, 320, 240)).clone(), gray2 = big(cv::Rect(0, 0, 320, 240)).clone();
  const auto corners = detect_corners(gray1);
  std::vector<cv::Point2f> guess = corners;
  for (cv::Point2f& p : guess) p += cv::Point2f(2, 5);
  const Tracks plain = track_points(gray1, gray2, corners),
               guided = track_points(gray1, gray2, corners, {}, guess);
  for (std::size_t i = 0; i < corners.size(); ++i)
    if (plain.found[i] && guided.found[i]) {
      EXPECT_LT(cv::norm(plain.pixels[i] - guided.pixels[i]), 0.1);
    }
}

TEST(TrackPoints, ThreadsDoNotChangeABit) {
  const cv::Mat gray1 = texture(640, 480, 1),
                gray2 = turned(gray1, wide_camera(640, 480), so3_exp({0, 0.02, 0.01}));
  const auto work = [&] {
    const auto corners = detect_corners(gray1);
    return std::pair(corners, track_points(gray1, gray2, corners));
  };
  const int threads = cv::getNumThreads();
  cv::setNumThreads(1);
  const auto [corners1, tracks1] = work();
  cv::setNumThreads(2);
  const auto [corners2, tracks2] = work();
  cv::setNumThreads(threads);
  EXPECT_EQ(corners2, corners1);
  EXPECT_EQ(tracks2.found, tracks1.found);
  EXPECT_EQ(tracks2.pixels, tracks1.pixels);
}

TEST(TrackPoints, AnImageMadeOnceServesAllItsPairs) {
  const cv::Mat gray1 = texture(160, 120, 1);
  const cv::Mat gray2 = turned(gray1, wide_camera(160, 120), so3_exp({0, 0.01, 0}));
  const auto corners = detect_corners(gray1);
  const TrackedImage image1 = tracked_image(gray1), image2 = tracked_image(gray2);
  const Tracks apart = track_points(gray1, gray2, corners);
  for (int i = 0; i < 2; ++i) EXPECT_EQ(track_points(image1, image2, corners).pixels, apart.pixels);
}

TEST(TrackPoints, WhatIsNowhereOrHasNoTextureIsLost) {
  const cv::Mat gray = texture(160, 120, 1), even(120, 160, CV_8U, cv::Scalar(90));
  const std::vector<cv::Point2f> pixels{{NAN, 5}, {5, INFINITY}, {-9, 5}, {5, 119.6f}, {1e30f, -1e30f}};
  EXPECT_THAT(track_points(gray, gray, pixels).found, ::testing::Each(0));
  EXPECT_THAT(track_points(gray, gray, std::vector<cv::Point2f>(5, {80, 60}), {}, pixels).found,
              ::testing::Each(0));
  EXPECT_THAT(track_points(even, even, {{80, 60}, {0, 0}}).found, ::testing::Each(0));
  const cv::Mat dot(1, 1, CV_8U, cv::Scalar(7));
  EXPECT_THAT(track_points(dot, dot, {{0, 0}}).found, ::testing::Each(0));
  EXPECT_TRUE(track_points(gray, gray, {}).pixels.empty());
  EXPECT_TRUE(tracked_matches(pixels, track_points(gray, gray, pixels)).pixels1.empty());
}

TEST(TrackPoints, RefusesWhatItCannotTrack) {
  const cv::Mat gray = texture(160, 120, 1);
  EXPECT_THAT(
      [&] {
        track_points(cv::Mat(), gray, {{1, 1}});
      },
      ThrowsMessage<std::invalid_argument>(HasSubstr("gray: found no pixels")));
  EXPECT_THAT(
      [&] {
        track_points(gray, cv::Mat(9, 9, CV_16U, cv::Scalar(0)), {{1, 1}});
      },
      ThrowsMessage<std::invalid_argument>(HasSubstr("found CV_16UC1")));
  EXPECT_THAT(
      [&] {
        track_points(gray, gray, {{1, 1}}, {}, {{1, 1}, {2, 2}});
      },
      ThrowsMessage<std::invalid_argument>(HasSubstr("predicted2: found 2 for 1")));
  EXPECT_THROW(track_points(TrackedImage(), tracked_image(gray), {{1, 1}}), std::invalid_argument);
  EXPECT_THAT(
      [&] {
        track_points(gray, gray(cv::Rect(0, 0, 80, 60)), {{1, 1}});
      },
      ThrowsMessage<std::invalid_argument>(HasSubstr("expected images of one size")));
  TrackOptions options;
  options.window = 20;
  EXPECT_THAT([&] { options.check(); }, ThrowsMessage<std::invalid_argument>(HasSubstr("window: found 20")));
  options.window = 11;
  EXPECT_THROW(track_points(tracked_image(gray), tracked_image(gray), {{1, 1}}, options),
               std::invalid_argument);
  options = {};
  options.max_backward_px = NAN;
  EXPECT_THROW(options.check(), std::invalid_argument);
}

TEST(PredictByRotation, IsTheHomographyAtInfinity) {
  const Camera camera = wide_camera(320, 240);
  const Eigen::Matrix3d R = so3_exp(Eigen::Vector3d(0.1, -0.2, 0.3));
  Eigen::Matrix3d K;
  K << camera.fx, 0, camera.cx, 0, camera.fy, camera.cy, 0, 0, 1;
  const Eigen::Vector3d expected = K * R * K.inverse() * Eigen::Vector3d(50, 70, 1);
  const cv::Point2f found = predict_by_rotation(camera, R, {{50, 70}})[0];
  EXPECT_NEAR(found.x, expected.x() / expected.z(), 1e-3);
  EXPECT_NEAR(found.y, expected.y() / expected.z(), 1e-3);
  const cv::Point2f behind = predict_by_rotation(camera, so3_exp({0, 3.0, 0}), {{50, 70}})[0];
  EXPECT_TRUE(std::isnan(behind.x) && std::isnan(behind.y));
}

}  // namespace
}  // namespace framewise
