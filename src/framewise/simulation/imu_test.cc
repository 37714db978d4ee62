// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/simulation/imu.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <string>
#include <tuple>

#include "framewise/geometry/gyroscope.h"
#include "framewise/geometry/so3.h"
#include "framewise/simulation/scene_catalog.h"

namespace framewise {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

struct State {
  Pose world_from_unit;
  Vector3d velocity;
};

// Over three readings a step h apart: classical Runge-Kutta with a step of 2 h, the rotation in the tangent
// space of its beginning (Munthe-Kaas, High order Runge-Kutta methods on manifolds, 1999).
State integrate(const State& from, const ImuReading& a, const ImuReading& b, const ImuReading& c) {
  const double h = c.time - a.time;
  const auto tangent_rate = [](const Vector3d& phi, const Vector3d& w) -> Vector3d {
    return so3_right_jacobian(phi).inverse() * w;
  };
  const Vector3d k1 = a.angular_rate, k2 = tangent_rate(h / 2 * k1, b.angular_rate),
                 k3 = tangent_rate(h / 2 * k2, b.angular_rate), k4 = tangent_rate(h * k3, c.angular_rate);
  const Matrix3d& R = from.world_from_unit.R;
  const Vector3d g(0, 0, -kGravity);
  // The integral to the middle of the parabola through the three rates.
  const Matrix3d R_b = R * so3_exp(h / 24 * (5 * a.angular_rate + 8 * b.angular_rate - c.angular_rate));
  const Vector3d at_a = R * a.specific_force + g, at_b = R_b * b.specific_force + g;
  const Matrix3d R_c = R * so3_exp(h / 6 * (k1 + 2 * k2 + 2 * k3 + k4));
  const Vector3d at_c = R_c * c.specific_force + g;
  State to;
  to.world_from_unit = {R_c, from.world_from_unit.t + h * from.velocity + h * h / 6 * (at_a + 2 * at_b)};
  to.velocity = from.velocity + h / 6 * (at_a + 4 * at_b + at_c);
  return to;
}

class ImuOfPath : public testing::TestWithParam<std::tuple<std::string, std::string>> {};

TEST_P(ImuOfPath, ReadingsWithoutNoiseIntegrateToThePath) {
  const auto& [scene, name] = GetParam();
  const Path path = named_path(name, scene_kind(scene).space, 3);
  const auto readings = true_imu_readings(path, 1, 11, 1000);
  ASSERT_EQ(readings.size(), 10001u);
  State state{path(1).world_from_cam, path(1).velocity};
  for (std::size_t i = 0; i + 2 < readings.size(); i += 2) {
    state = integrate(state, readings[i], readings[i + 1], readings[i + 2]);
    const Pose truth = path(readings[i + 2].time).world_from_cam;
    ASSERT_LT((state.world_from_unit.t - truth.t).norm(), 1e-4) << "at " << readings[i + 2].time;
    ASSERT_LT(rotation_angle(truth.R.transpose() * state.world_from_unit.R), 1e-4);
  }
}

INSTANTIATE_TEST_SUITE_P(Paths, ImuOfPath,
                         testing::Combine(testing::Values("room", "corridor", "mine", "race", "plane",
                                                          "sphere-field"),
                                          testing::ValuesIn(path_names())),
                         [](const auto& info) {
                           std::string name = std::get<0>(info.param) + "_" + std::get<1>(info.param);
                           for (char& c : name) c = c == '-' ? '_' : c;
                           return name;
                         });

TEST(Imu, RatesAreWhatRotationBetweenIntegrates) {
  const Path path = handheld_path(scene_kind("room").space, 0);
  Gyroscope gyroscope;
  for (const ImuReading& reading : true_imu_readings(path, 0, 2, 200)) {
    gyroscope.times.push_back(reading.time);
    gyroscope.rates.push_back(reading.angular_rate);
  }
  const auto cam2_from_cam1 = rotation_between(gyroscope, 0.3, 1.7, 0.1);
  ASSERT_TRUE(cam2_from_cam1);
  const Matrix3d truth = path(1.7).world_from_cam.R.transpose() * path(0.3).world_from_cam.R;
  EXPECT_LT(rotation_angle(*cam2_from_cam1 * truth.transpose()), 1e-5);
}

TEST(Imu, AtRestItFeelsItsWeightUpwards) {
  const Path still = [](double) { return Motion(); };  // looks along the world's z
  const ImuReading reading = true_imu_readings(still, 0, 1, 100).front();
  EXPECT_EQ(reading.specific_force, Vector3d(0, 0, kGravity));
  EXPECT_EQ(reading.angular_rate, Vector3d(0, 0, 0));
}

std::vector<ImuReading> rest(double rate_hz, int count) {
  std::vector<ImuReading> readings;
  for (int i = 0; i < count; ++i) readings.push_back({i / rate_hz, Vector3d::Zero(), Vector3d::Zero()});
  return readings;
}

constexpr ImuOptions kNoNoise{
    .gyroscope_noise = 0, .gyroscope_bias_walk = 0, .accelerometer_noise = 0, .accelerometer_bias_walk = 0};

double mean_square(const std::vector<ImuReading>& readings, Vector3d ImuReading::*part, std::size_t step) {
  double sum = 0;
  std::size_t count = 0;
  for (std::size_t i = step; i < readings.size(); i += step, ++count)
    sum += (readings[i].*part - readings[i - step].*part).squaredNorm() / 3;
  return sum / static_cast<double>(count);
}

// The difference of two readings has twice the variance density^2 rate.
TEST(Imu, WhiteNoiseHasItsDensityAtAnyRate) {
  for (const double rate : {200.0, 1000.0}) {
    ImuOptions options = kNoNoise;
    options.rate_hz = rate;
    options.gyroscope_noise = 2e-4;
    options.accelerometer_noise = 3e-3;
    const auto readings = imu_readings(rest(rate, 20000), options, 9);
    EXPECT_NEAR(mean_square(readings, &ImuReading::angular_rate, 1), 2 * 4e-8 * rate, 0.04 * 2 * 4e-8 * rate);
    EXPECT_NEAR(mean_square(readings, &ImuReading::specific_force, 1), 2 * 9e-6 * rate,
                0.04 * 2 * 9e-6 * rate);
  }
}

// Over a time t the bias wanders by walk sqrt(t), whatever the rate.
TEST(Imu, BiasWalksWithTheRootOfTime) {
  for (const double rate : {200.0, 1000.0}) {
    ImuOptions options = kNoNoise;
    options.rate_hz = rate;
    options.gyroscope_bias_walk = 2e-5;
    options.accelerometer_bias_walk = 3e-3;
    const auto readings = imu_readings(rest(rate, static_cast<int>(200 * rate)), options, 9);
    const auto step = static_cast<std::size_t>(0.5 * rate);
    EXPECT_NEAR(mean_square(readings, &ImuReading::angular_rate, step), 0.5 * 4e-10, 0.2 * 0.5 * 4e-10);
    EXPECT_NEAR(mean_square(readings, &ImuReading::specific_force, step), 0.5 * 9e-6, 0.2 * 0.5 * 9e-6);
    EXPECT_EQ(readings.front().angular_rate, Vector3d(0, 0, 0));
  }
}

TEST(Imu, TheOffsetMovesStampsAndNothingElse) {
  ImuOptions options = kNoNoise;
  options.time_offset = 0.012;
  const auto truth = rest(200, 10), readings = imu_readings(truth, options, 0);
  for (int i = 0; i < 10; ++i) {
    EXPECT_DOUBLE_EQ(readings[i].time, truth[i].time + 0.012);
    EXPECT_EQ(readings[i].angular_rate, truth[i].angular_rate);
  }
  options.time_offset = -0.012;
  EXPECT_EQ(imu_readings(truth, options, 0).size(), 7u) << "stamps before 0 are left out";
}

TEST(Imu, RefusesOptionsByName) {
  ImuOptions options;
  options.rate_hz = 0;
  EXPECT_THROW(options.check(), std::invalid_argument);
  options = {};
  options.gyroscope_noise = -1;
  EXPECT_THROW(options.check(), std::invalid_argument);
  options = {};
  options.time_offset = std::nan("");
  EXPECT_THROW(options.check(), std::invalid_argument);
}

}  // namespace
}  // namespace framewise
