// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/simulation/depth_sensors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "framewise/image/depth.h"

namespace framewise {
namespace {

const Camera kCamera{CameraModel::kPinhole, 320, 240, 262.5, 262.5, 159.5, 119.5, {}, {}};

// A wall across the view.
SurfaceImage wall(double z, double facing = 1) {
  return {cv::Mat(kCamera.height, kCamera.width, CV_32F, cv::Scalar(z)),
          cv::Mat(kCamera.height, kCamera.width, CV_32F, cv::Scalar(facing))};
}

// A nearer wall in the right half.
SurfaceImage step(double near, double far) {
  SurfaceImage surface = wall(far);
  surface.depth.colRange(160, 320).setTo(near);
  return surface;
}

struct Statistics {
  int count = 0;
  double mean = 0, deviation = 0;
};

// Within so many pixels of the image's middle, where ranges and z are alike.
Statistics statistics(const cv::Mat& depth, int reach) {
  Statistics s;
  double sum = 0, sum2 = 0;
  const double about = 1e-3;
  for (int v = 120 - reach; v < 120 + reach; ++v)
    for (int u = 160 - reach; u < 160 + reach; ++u) {
      const float z = depth.at<float>(v, u);
      if (!is_known_depth(z)) continue;
      ++s.count;
      sum += z - about;
      sum2 += (z - about) * (z - about);
    }
  s.mean = sum / s.count + about;
  s.deviation = std::sqrt(std::max(0.0, sum2 / s.count - (sum / s.count) * (sum / s.count)));
  return s;
}

TEST(KinectDepth, NoiseFollowsItsFormula) {
  KinectOptions options;
  options.step_px = 1e-4;  // so fine that only the noise is left
  for (const double z : {0.8, 1.7, 3.0, 5.0}) {
    const Statistics s = statistics(kinect_depth(wall(z), kCamera, options, 3), 110);
    const double sigma = 0.0012 + 0.0019 * (z - 0.4) * (z - 0.4);
    EXPECT_NEAR(s.mean, z, 0.05 * sigma) << z;
    EXPECT_NEAR(s.deviation, sigma, 0.02 * sigma) << z;
  }
}

TEST(KinectDepth, DisparitiesLieOnTheLattice) {
  const cv::Mat depth = kinect_depth(wall(2.3), kCamera, {}, 3);
  int known = 0;
  for (int u = 0; u < 320; ++u) {
    const float z = depth.at<float>(100, u);
    if (!is_known_depth(z)) continue;
    ++known;
    const double steps = 580 * 0.075 / z / 0.125;
    EXPECT_NEAR(steps, std::round(steps), 1e-3);
  }
  EXPECT_GT(known, 300);
}

// The nearer wall on the right keeps the projector, which is further right, from a strip of the other.
TEST(KinectDepth, WhatTheProjectorDoesNotReachIsUnknown) {
  const cv::Mat depth = kinect_depth(step(1.0, 2.0), kCamera, {}, 3);
  const double shadow = 262.5 * 0.075 * (1 / 1.0 - 1 / 2.0);  // pixels
  int unknown = 0;
  for (int u = 0; u < 320; ++u) unknown += !is_known_depth(depth.at<float>(50, u));
  EXPECT_NEAR(unknown, shadow + 1, 2) << "the shadow, and the pixel of the near side";
  for (int u = 151; u < 160; ++u) EXPECT_FALSE(is_known_depth(depth.at<float>(50, u))) << u;
}

TEST(KinectDepth, GrazingAndNearSurfacesAreUnknown) {
  EXPECT_EQ(statistics(kinect_depth(wall(2, 0.1), kCamera, {}, 3), 100).count, 0);
  EXPECT_EQ(statistics(kinect_depth(wall(0.3), kCamera, {}, 3), 100).count, 0);
}

TEST(TimeOfFlightDepth, NoiseGrowsWithTheSquareOfTheRangeAndTheSlant) {
  for (const double z : {1.0, 3.0, 5.0}) {
    for (const double cosine : {1.0, 0.5}) {
      const Statistics s = statistics(time_of_flight_depth(wall(z, cosine), kCamera, {}, 5), 20);
      const double sigma = 0.0015 * z * z / cosine;
      ASSERT_EQ(s.count, 1600);
      EXPECT_NEAR(s.mean, z, 0.1 * sigma);
      EXPECT_NEAR(s.deviation, sigma, 0.06 * sigma);
    }
  }
}

TEST(TimeOfFlightDepth, BeyondTheAmbiguityItBeginsAgain) {
  EXPECT_NEAR(statistics(time_of_flight_depth(wall(9), kCamera, {}, 5), 10).mean, 1.5, 0.05);
}

TEST(TimeOfFlightDepth, EdgesFlyBetweenTheSurfaces) {
  const cv::Mat depth = time_of_flight_depth(step(1.0, 2.0), kCamera, {.sigma_1m = 0}, 5);
  int flying = 0;
  for (int v = 0; v < 240; ++v) flying += depth.at<float>(v, 159) < 1.95 && depth.at<float>(v, 159) > 1.4;
  EXPECT_GT(flying, 180);
  EXPECT_NEAR(depth.at<float>(100, 150), 2, 1e-6);
}

TEST(LidarDepth, IsSparseAndTrueButForItsNoise) {
  const cv::Mat depth = lidar_depth(wall(12), kCamera, {}, 5);
  const Statistics s = statistics(depth, 119);
  EXPECT_GT(s.count, 1000);
  EXPECT_LT(s.count, 238 * 238 / 3) << "most pixels see no shot";
  EXPECT_NEAR(s.mean, 12, 0.002);
  EXPECT_NEAR(s.deviation, 0.0185, 0.002) << "the noise is along the ray";
  const cv::Mat exact = lidar_depth(wall(12), kCamera, {.sigma = 0}, 5);
  EXPECT_LT(statistics(exact, 119).deviation, 1e-5);
  for (int v = 0; v < 100; ++v)
    EXPECT_FALSE(is_known_depth(depth.at<float>(v, 160))) << "no beam rises above 2 degrees";
}

TEST(DepthSensors, SameSeedSameBytes) {
  const SurfaceImage surface = step(1, 2);
  for (const std::string& name : depth_sensor_names()) {
    const DepthSensorOptions options{depth_sensor_from_name(name), {}, {}, {}};
    const auto measured = [&](std::uint64_t seed) {
      cv::Mat depth = measure_depth(surface, kCamera, options, seed);
      cv::patchNaNs(depth, 0);
      return depth;
    };
    EXPECT_EQ(cv::norm(measured(1), measured(1), cv::NORM_INF), 0) << name;
    EXPECT_EQ(cv::norm(measured(1), measured(2), cv::NORM_INF) > 0, name != "exact") << name;
  }
  EXPECT_THROW(depth_sensor_from_name("sonar"), std::invalid_argument);
}

TEST(DepthSensors, NothingToSeeIsNothingMeasured) {
  SurfaceImage surface = wall(2);
  surface.depth.setTo(kUnknownDepth);
  for (const std::string& name : depth_sensor_names())
    EXPECT_EQ(
        statistics(measure_depth(surface, kCamera, {depth_sensor_from_name(name), {}, {}, {}}, 1), 100).count,
        0);
}

}  // namespace
}  // namespace framewise
