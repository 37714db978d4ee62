// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/simulation/simulate.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <opencv2/features2d.hpp>
#include <stdexcept>

#include "framewise/simulation/scene_catalog.h"

namespace framewise {
namespace {

SimulateOptions small_recording(int frames, int width) {
  SimulateOptions options;
  options.frames = frames;
  options.width = width;
  options.height = width * 3 / 4;
  options.light_cell = 10;
  return options;
}

std::vector<SimulatedFrame> recording(const SimulateOptions& options) {
  std::vector<SimulatedFrame> frames;
  simulate(options, [&](const SimulatedFrame& frame) {
    frames.push_back(frame);
    return true;
  });
  return frames;
}

bool same_bytes(const cv::Mat& a, const cv::Mat& b) {
  return a.size() == b.size() && a.type() == b.type() &&
         std::memcmp(a.data, b.data, a.total() * a.elemSize()) == 0;
}

// Whether 1 / z runs nearly straight through the pixel, along both axes: so it does on a plane, and neither
// at an edge nor at a crease.
bool is_smooth(const cv::Mat& depth, int u, int v, double bend) {
  const auto inverse = [&](int x, int y) { return 1.0 / depth.at<float>(y, x); };
  const double here = inverse(u, v);
  return std::abs(inverse(u - 1, v) - 2 * here + inverse(u + 1, v)) < bend * here &&
         std::abs(inverse(u, v - 1) - 2 * here + inverse(u, v + 1)) < bend * here;
}

// Depth of another frame at a subpixel, where its four pixels see something nearly flat.
std::optional<double> depth_between_pixels(const cv::Mat& depth, const Eigen::Vector2d& pixel) {
  const int u = static_cast<int>(std::floor(pixel.x())), v = static_cast<int>(std::floor(pixel.y()));
  if (u < 1 || v < 1 || u + 2 >= depth.cols || v + 2 >= depth.rows) return std::nullopt;
  double inverse = 0;
  for (int k = 0; k < 4; ++k) {
    if (!is_smooth(depth, u + k % 2, v + k / 2, 1e-4)) return std::nullopt;
    const double s = pixel.x() - u, t = pixel.y() - v;
    inverse += (k % 2 ? s : 1 - s) * (k / 2 ? t : 1 - t) / depth.at<float>(v + k / 2, u + k % 2);
  }
  return 1 / inverse;
}

struct Agreement {
  int compared = 0, within_1_mm = 0;
  std::vector<double> errors;

  double median() {
    const auto middle = errors.begin() + static_cast<std::ptrdiff_t>(errors.size() / 2);
    std::nth_element(errors.begin(), middle, errors.end());
    return *middle;
  }
};

Agreement warp(const Camera& camera, const SimulatedFrame& from, const SimulatedFrame& to) {
  const Pose to_from_from = to.world_from_cam.inverse() * from.world_from_cam;
  Agreement agreement;
  for (int v = 0; v < camera.height; v += 2) {
    for (int u = 0; u < camera.width; u += 2) {
      const Bearing ray = *camera.bearing({u, v});
      const Eigen::Vector3d x = to_from_from * (ray * (from.frame.depth.at<float>(v, u) / ray.z()));
      const auto pixel = camera.project(x);
      if (!pixel) continue;
      const auto z = depth_between_pixels(to.frame.depth, *pixel);
      if (!z || x.z() > *z + 0.05) continue;  // hidden behind something
      ++agreement.compared;
      agreement.within_1_mm += std::abs(x.z() - *z) < 1e-3;
      agreement.errors.push_back(std::abs(x.z() - *z));
    }
  }
  return agreement;
}

// Four views that differ by decimetres, lit once for several tests.
const SimulateOptions kFourViews = [] {
  SimulateOptions options = small_recording(4, 320);
  options.rate_hz = 1.5;
  options.seed = 5;
  return options;
}();

const std::vector<SimulatedFrame>& four_views() {
  static const std::vector<SimulatedFrame> frames = recording(kFourViews);
  return frames;
}

TEST(Simulate, DepthAndTruthAgree) {
  const auto& frames = four_views();
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) {
      if (std::abs(i - j) > 2) continue;
      const Agreement agreement = warp(sensor_of(kFourViews).camera, frames[i], frames[j]);
      EXPECT_GT(agreement.compared, 2000) << i << " to " << j;
      EXPECT_GT(agreement.within_1_mm, 0.97 * agreement.compared) << i << " to " << j;
    }
  }
  // The test can see a pose that is a centimetre off.
  SimulatedFrame moved = frames[1];
  moved.world_from_cam.t += Eigen::Vector3d(0.01, 0.01, 0.01);
  const Agreement wrong = warp(sensor_of(kFourViews).camera, frames[0], moved);
  EXPECT_LT(wrong.within_1_mm, 0.5 * wrong.compared);
}

// How far before the point x of a camera the first surface on its ray lies (m, along the axis); less than 0
// where x floats before it.
double gap_before(const RayTracer& tracer, const Pose& world_from_cam, const Eigen::Vector3d& x) {
  const Eigen::Vector3d direction = world_from_cam.R * x;
  Rays8 rays;
  rays.set(0, world_from_cam.t.cast<float>(), direction.cast<float>(), 1e-3f, 1e4f);
  for (int i = 1; i < 8; ++i) rays.switch_off(i);
  Hits8 hits;
  tracer.intersect(rays, false, hits);
  if (hits.triangle[0] == kNoHit) return -1e4;
  return x.z() * (1 - tracer.exact_t(hits.triangle[0], world_from_cam.t, direction));
}

struct Reprojection {
  int hidden = 0, floating = 0;
  std::vector<double> errors;  // of what is neither, to 1 mm
};

Reprojection reproject(const RayTracer& tracer, const Camera& camera, const cv::Mat& depth, const Pose& from,
                       const Pose& to) {
  Reprojection result;
  for (int v = 0; v < camera.height; ++v) {
    for (int u = 0; u < camera.width; ++u) {
      const double z = depth.at<float>(v, u);
      const Bearing ray = *camera.bearing({u, v});
      const Eigen::Vector3d x = to.inverse() * (from * (ray * (z / ray.z())));
      if (const auto pixel = camera.project(x); !pixel || !camera.contains(*pixel)) continue;
      const double gap = gap_before(tracer, to, x);
      result.hidden += gap > 1e-3;
      result.floating += gap < -1e-3;
      if (std::abs(gap) <= 1e-3) result.errors.push_back(std::abs(gap));
    }
  }
  return result;
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// Every scene by every depth sensor without its noise.
class TruthOfScene : public testing::TestWithParam<std::string> {
 protected:
  void SetUp() override {
    options_ = small_recording(3, 160);
    options_.scene = GetParam();
    options_.rate_hz = options_.scene == "race" ? 20 : 5;
    options_.distortion = {-0.1, 0.02, 1e-3, -5e-4, 0};
    options_.depth_max = 30;
    options_.depth.noise = 0;
    options_.depth.time_of_flight.ambiguity = 100;  // farther than the scenes reach
  }

  SimulateOptions options_;
};

TEST_P(TruthOfScene, DepthOfEverySensorWithoutNoiseLiesOnTheSurfaceThatOtherFramesSee) {
  const Scene scene = scene_kind(options_.scene).build({.light_cell = 10, .lit = false});
  const RayTracer tracer(scene);
  const RgbdSensor sensor(sensor_of(options_));
  const Camera& camera = sensor.options().camera;
  std::vector<Pose> poses;
  std::vector<SurfaceImage> surfaces;
  for (int i = 0; i < 3; ++i) {
    poses.push_back(path_of(options_)(frame_time(options_, i)).world_from_cam);
    surfaces.push_back(sensor.surface(tracer, poses.back()));
  }
  for (const std::string& name : depth_sensor_names()) {
    options_.depth.sensor = depth_sensor_from_name(name);
    for (const auto& [i, j] : {std::pair(0, 1), {1, 2}, {2, 0}}) {
      SCOPED_TRACE(name + ", " + std::to_string(i) + " to " + std::to_string(j));
      const cv::Mat depth = measure_depth(surfaces[i], camera, options_.depth, 1);
      const Reprojection seen = reproject(tracer, camera, depth, poses[i], poses[j]);
      ASSERT_GT(seen.errors.size(), 500u);
      EXPECT_LT(median(seen.errors), 1e-4);
      EXPECT_EQ(seen.floating, 0);
      EXPECT_LT(seen.hidden, 0.2 * static_cast<double>(seen.errors.size()));
    }
  }
  // The test can see a pose that is a centimetre off.
  Pose moved = poses[0];
  moved.t += Eigen::Vector3d(0.01, 0.01, 0.01);
  const Reprojection wrong = reproject(tracer, camera, surfaces[0].depth, moved, poses[1]);
  EXPECT_GT(wrong.floating + wrong.hidden, wrong.errors.size());
}

INSTANTIATE_TEST_SUITE_P(Scenes, TruthOfScene,
                         testing::Values("room", "corridor", "mine", "race", "plane", "sphere-field"),
                         [](const auto& info) {
                           std::string name = info.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

TEST(Simulate, SensorsWithFaultsKeepTheTruthBesideThem) {
  SimulateOptions options = small_recording(2, 96);
  options.scene = "plane";
  const auto exact = recording(options);
  EXPECT_TRUE(exact[0].true_depth.empty());
  for (const DepthSensor sensor : {DepthSensor::kKinect, DepthSensor::kTimeOfFlight, DepthSensor::kLidar}) {
    options.depth.sensor = sensor;
    options.depth_max = 10;
    options.imaging = {.exposure_time = 0.02, .blur_samples = 2, .photons = 500};
    options.threads = 1;
    const auto one = recording(options);
    options.threads = 2;
    const auto two = recording(options);
    EXPECT_TRUE(same_bytes(one[1].true_depth, exact[1].frame.depth));
    EXPECT_FALSE(same_bytes(one[1].frame.depth, exact[1].frame.depth));
    EXPECT_TRUE(same_bytes(one[1].frame.depth, two[1].frame.depth)) << "whatever the threads";
    EXPECT_TRUE(same_bytes(one[1].frame.color, two[1].frame.color)) << "whatever the threads";
  }
}

TEST(Simulate, AHeadlampLightsTheDark) {
  SimulateOptions options = small_recording(1, 96);
  options.scene = "mine";
  options.headlamp = 12;
  const auto lit = recording(options);
  EXPECT_GT(cv::mean(lit[0].frame.gray)[0], 30);
  options.headlamp = 0;
  EXPECT_EQ(cv::mean(recording(options)[0].frame.gray)[0], 0);
  options.headlamp = 12;
  options.exposure = 0.1;
  const double dim = cv::mean(recording(options)[0].frame.gray)[0];
  EXPECT_LT(dim, 0.6 * cv::mean(lit[0].frame.gray)[0]);
  EXPECT_GT(dim, 1);
}

// At its own times and between them, and no further than they last.
TEST(Simulate, FollowsPosesThatAreGiven) {
  SimulateOptions options = small_recording(1, 64);
  options.scene = "plane";
  const Path path = path_of(options);
  for (const double time : {5.0, 5.2, 5.5, 6.0}) options.poses.add(time, path(time).world_from_cam);
  options.frames.reset();
  options.rate_hz = 10;
  EXPECT_EQ(frame_count(options), 11);
  const auto frames = recording(options);
  ASSERT_EQ(frames.size(), 11u);
  EXPECT_EQ(frames[0].frame.time, 5);
  for (const auto& [frame, pose] : {std::pair(0, 0), {2, 1}, {5, 2}, {10, 3}})
    EXPECT_LT((frames[frame].world_from_cam.matrix() - options.poses.world_from_cam[pose].matrix()).norm(),
              1e-9);
  options.frames = 12;
  EXPECT_THROW(options.check(), std::invalid_argument);
  options.frames = 11;
  options.path = "orbit";
  EXPECT_THROW(options.check(), std::invalid_argument);
}

TEST(Simulate, InertialReadingsCoverTheFramesAndTruthHasTheirTimes) {
  SimulateOptions options = small_recording(10, 64);
  EXPECT_TRUE(imu_recording(options, 10).truth.empty());
  options.imu = ImuOptions{.rate_hz = 250};
  const ImuRecording imu = imu_recording(options, 10);
  ASSERT_EQ(imu.truth.size(), 76u);
  EXPECT_EQ(imu.truth.size(), imu.readings.size());
  const Trajectory truth = true_trajectory(options, 10);
  for (const ImuReading& reading : imu.truth) EXPECT_TRUE(pose_at(truth, reading.time, 0)) << reading.time;
}

TEST(Simulate, SameBytesAtAnyThreadCountAndOnlyWithTheSameSeed) {
  SimulateOptions options = small_recording(3, 96);
  options.rate_hz = 3;
  options.threads = 1;
  const auto one = recording(options);
  options.threads = 2;
  const auto two = recording(options);
  ASSERT_EQ(one.size(), 3u);
  ASSERT_EQ(two.size(), 3u);
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(one[i].index, i);
    EXPECT_EQ(one[i].frame.time, frame_time(options, i));
    EXPECT_TRUE(same_bytes(one[i].frame.color, two[i].frame.color));
    EXPECT_TRUE(same_bytes(one[i].frame.gray, two[i].frame.gray));
    EXPECT_TRUE(same_bytes(one[i].frame.depth, two[i].frame.depth));
  }
  options.scene = "plane";
  options.frames = 1;
  const auto plane = recording(options);
  options.seed = 1;
  EXPECT_FALSE(same_bytes(plane[0].frame.color, recording(options)[0].frame.color));
}

TEST(Simulate, EveryFrameHasTextureAndDepth) {
  SimulateOptions options = small_recording(8, 320);
  options.rate_hz = 0.2;  // twice round the room
  for (const SimulatedFrame& simulated : recording(options)) {
    std::vector<cv::KeyPoint> corners;
    cv::FAST(simulated.frame.gray, corners, 20);
    EXPECT_GT(corners.size(), 300u) << simulated.index;
    const cv::Mat valid = simulated.frame.depth == simulated.frame.depth;
    EXPECT_GT(cv::countNonZero(valid), 0.9 * valid.total()) << simulated.index;
  }
}

TEST(Simulate, TruthHoldsEveryFrameAndAtLeastHundredPosesASecond) {
  const Trajectory truth = true_trajectory(kFourViews, 4);
  for (const SimulatedFrame& simulated : four_views()) {
    const auto pose = pose_at(truth, simulated.frame.time, 0);
    ASSERT_TRUE(pose) << "no line with exactly the time of frame " << simulated.index;
    EXPECT_EQ(pose->matrix(), simulated.world_from_cam.matrix());
  }
  EXPECT_EQ(truth.times.back(), four_views().back().frame.time);
  for (std::size_t i = 1; i < truth.size(); ++i) EXPECT_LE(truth.times[i] - truth.times[i - 1], 0.010001);
}

TEST(Simulate, TheSinkCanEndARecording) {
  int seen = 0;
  SimulateOptions options = small_recording(50, 64);
  options.scene = "plane";
  simulate(options, [&](const SimulatedFrame& frame) {
    EXPECT_EQ(frame.index, seen);
    return ++seen < 4;
  });
  EXPECT_EQ(seen, 4);
}

TEST(Simulate, AnErrorOfTheSinkReachesTheCaller) {
  SimulateOptions options = small_recording(9, 64);
  options.scene = "plane";
  EXPECT_THROW(
      simulate(options, [](const SimulatedFrame&) -> bool { throw std::runtime_error("disk is full"); }),
      std::runtime_error);
}

std::string refusal_of(const SimulateOptions& options) {
  try {
    options.check();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Simulate, RefusesOptionsByName) {
  SimulateOptions options;
  EXPECT_EQ(refusal_of(options), "accepted");
  options.scene = "moon";
  EXPECT_EQ(refusal_of(options),
            "scene is 'moon', expected one of: room, corridor, mine, race, plane, sphere-field");
  options = {};
  options.frames = 0;
  EXPECT_THAT(refusal_of(options), testing::HasSubstr("frames is 0"));
  options = {};
  options.rate_hz = std::nan("");
  EXPECT_THAT(refusal_of(options), testing::HasSubstr("rate_hz is nan"));
  options = {};
  options.width = -640;
  EXPECT_THAT(refusal_of(options), testing::HasSubstr("width is -640"));
  EXPECT_THROW(simulate(options, {}), std::invalid_argument);
}

}  // namespace
}  // namespace framewise
