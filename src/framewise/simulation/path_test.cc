// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/simulation/path.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "framewise/geometry/so3.h"
#include "framewise/simulation/scene_catalog.h"

namespace framewise {
namespace {

class EveryPath : public testing::TestWithParam<std::tuple<std::string, std::string>> {
 protected:
  Path path(std::uint64_t seed) const { return named_path(std::get<1>(GetParam()), space(), seed); }
  const PathSpace& space() const { return scene_kind(std::get<0>(GetParam())).space; }
};

double times_of(int i) { return 0.3 + 0.137 * i; }

// Central differences of the next lower derivative.
TEST_P(EveryPath, VelocityAccelerationAndRateAreItsDerivatives) {
  const Path path = this->path(1);
  constexpr double h = 1e-5;
  for (int i = 0; i < 200; ++i) {
    const double t = times_of(i);
    const Motion here = path(t), before = path(t - h), after = path(t + h);
    const Eigen::Vector3d velocity = (after.world_from_cam.t - before.world_from_cam.t) / (2 * h);
    const Eigen::Vector3d acceleration = (after.velocity - before.velocity) / (2 * h);
    const Eigen::Vector3d rate =
        so3_log(before.world_from_cam.R.transpose() * after.world_from_cam.R) / (2 * h);
    ASSERT_LT((velocity - here.velocity).norm(), 1e-6 * (1 + here.velocity.norm())) << "at " << t;
    ASSERT_LT((acceleration - here.acceleration).norm(), 0.02 + 1e-3 * here.acceleration.norm())
        << "at " << t;
    ASSERT_LT((rate - here.angular_rate).norm(), 1e-5 * (1 + here.angular_rate.norm())) << "at " << t;
  }
}

// A jump would not shrink with the step.
TEST_P(EveryPath, AccelerationAndAngularRateAreContinuous) {
  const Path path = this->path(2);
  double acceleration_step = 0, rate_step = 0;
  Motion before = path(0);
  for (int i = 1; i < 10000; ++i) {
    const Motion here = path(2e-4 * i);
    acceleration_step = std::max(acceleration_step, (here.acceleration - before.acceleration).norm());
    rate_step = std::max(rate_step, (here.angular_rate - before.angular_rate).norm());
    before = here;
  }
  EXPECT_LT(acceleration_step, 0.6);
  EXPECT_LT(rate_step, 0.06);
}

TEST_P(EveryPath, DependsOnlyOnItsSeed) {
  EXPECT_EQ(path(3)(7.7).world_from_cam.matrix(), path(3)(7.7).world_from_cam.matrix());
  EXPECT_NE(path(3)(7.7).world_from_cam.matrix(), path(4)(7.7).world_from_cam.matrix());
}

std::vector<std::string> all_scenes() {
  std::vector<std::string> names;
  for (const SceneKind& kind : scene_kinds()) names.push_back(kind.name);
  return names;
}

std::string test_name(const testing::TestParamInfo<std::tuple<std::string, std::string>>& info) {
  std::string name = std::get<0>(info.param) + "_" + std::get<1>(info.param);
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Paths, EveryPath,
                         testing::Combine(testing::ValuesIn(all_scenes()), testing::ValuesIn(path_names())),
                         test_name);

TEST(NamedPath, RefusesANameThatIsNone) {
  EXPECT_THROW(named_path("stroll", scene_kinds().front().space, 0), std::invalid_argument);
}

TEST(PureRotationPath, StaysInOnePlaceExactly) {
  const Path path = pure_rotation_path(scene_kind("room").space, 0);
  for (int i = 0; i < 100; ++i) ASSERT_EQ(path(times_of(i)).world_from_cam.t, path(0).world_from_cam.t);
}

TEST(ForwardPath, MovesAlongTheOpticalAxisWithoutTurning) {
  const Path path = forward_path(scene_kind("room").space, 0);
  for (int i = 0; i < 100; ++i) {
    const Motion motion = path(times_of(i));
    ASSERT_EQ(motion.world_from_cam.R, path(0).world_from_cam.R);
    ASSERT_LT(motion.world_from_cam.R.col(2).cross(motion.velocity).norm(), 1e-12);
  }
}

TEST(WalkPath, GoesAtTheSpeedOfAWalker) {
  const Path path = walk_path(scene_kind("room").space, 0);
  double sum = 0;
  for (int i = 0; i < 1000; ++i) sum += path(0.05 * i).velocity.norm() / 1000;
  EXPECT_GT(sum, 0.7);
  EXPECT_LT(sum, 1.5);
}

TEST(DroneRacePath, StaysWithinItsLimitsInEveryScene) {
  for (const SceneKind& kind : scene_kinds()) {
    const Path path = drone_race_path(kind.space, 0);
    double fastest = 0, fastest_turn = 0;
    for (int i = 0; i < 20000; ++i) {
      const Motion motion = path(0.003 * i);
      fastest = std::max(fastest, motion.velocity.norm());
      fastest_turn = std::max(fastest_turn, motion.angular_rate.norm());
    }
    EXPECT_LE(fastest, 15) << kind.name;
    EXPECT_LE(fastest_turn, 600 * M_PI / 180) << kind.name;
    EXPECT_GT(fastest, 2) << kind.name;
    RecordProperty(kind.name,
                   std::to_string(fastest) + " m/s, " + std::to_string(fastest_turn * 180 / M_PI) + " deg/s");
  }
}

}  // namespace
}  // namespace framewise
