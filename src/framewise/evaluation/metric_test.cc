// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/evaluation/metric.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "framewise/geometry/so3.h"

namespace framewise {
namespace {

using testing::ElementsAre;

// A metre a second along x, standing still in the last second; the estimate is 1 m up at times 1 and 2, and
// turned by 90 degrees at time 3.
Evaluation stop_and_go() {
  const Eigen::Matrix3d I = Eigen::Matrix3d::Identity();
  Trajectory reference, estimate;
  const double x[] = {0, 1, 2, 2}, y[] = {0, 1, 1, 0};
  for (int i = 0; i < 4; ++i) {
    reference.add(i, {I, {x[i], 0, 0}});
    estimate.add(i + 0.25, {i < 3 ? I : so3_exp({0, 0, M_PI / 2}), {x[i], y[i], 0}});
  }
  EvaluationOptions options;
  options.association.max_difference = 0.5;
  options.alignment = Alignment::kNone;
  return evaluate(reference, estimate, options);
}

TEST(Metric, NamesComeBack) {
  for (const char* name :
       {"ate", "ate-rotation", "ate-full", "ate-rotation-part", "rpe-translation", "rpe-rotation", "rpe-full",
        "rpe-rotation-part", "rpe-distance", "rpe-distance-ratio", "rpe-direction"})
    EXPECT_EQ(name_of(metric_from_name(name)), name);
  EXPECT_THROW(metric_from_name("ATE"), std::invalid_argument);
}

TEST(Metric, AbsoluteErrorsStandAtTheirPoses) {
  const MetricErrors errors = errors_of(stop_and_go(), metric_from_name("ate"));
  EXPECT_THAT(errors.values, ElementsAre(0, 1, 1, 0));
  EXPECT_THAT(errors.poses.estimate.times, ElementsAre(0.25, 1.25, 2.25, 3.25));
  EXPECT_EQ(errors.poses.reference.times, errors.poses.estimate.times);
}

TEST(Metric, RelativeErrorsStandAtTheLaterPose) {
  const MetricErrors errors = errors_of(stop_and_go(), metric_from_name("rpe-translation"));
  EXPECT_THAT(errors.values, ElementsAre(1, 0, 1));
  EXPECT_THAT(errors.poses.estimate.times, ElementsAre(1.25, 2.25, 3.25));
  EXPECT_EQ(errors.poses.reference.world_from_cam[1].t, Eigen::Vector3d(2, 0, 0));
  EXPECT_EQ(errors.poses.estimate.world_from_cam[1].t, Eigen::Vector3d(2, 1, 0));
}

TEST(Metric, AnglesAreDegreesAndRatiosPerCent) {
  const Evaluation e = stop_and_go();
  EXPECT_NEAR(errors_of(e, metric_from_name("rpe-rotation")).values.back(), 90, 1e-9);
  EXPECT_NEAR(errors_of(e, metric_from_name("ate-rotation")).values.back(), 90, 1e-9);
  const double longer = 100 * (std::sqrt(2.0) - 1);
  EXPECT_THAT(errors_of(e, metric_from_name("rpe-distance-ratio")).values,
              ElementsAre(testing::DoubleNear(longer, 1e-9), 0));
}

TEST(Metric, ARatioToAStepOfNoLengthHasNoPlace) {
  const MetricErrors errors = errors_of(stop_and_go(), metric_from_name("rpe-distance-ratio"));
  EXPECT_THAT(errors.poses.estimate.times, ElementsAre(1.25, 2.25));
}

TEST(Metric, AbsoluteErrorsHaveNoDirection) {
  EXPECT_THROW(errors_of(stop_and_go(), {false, PoseRelation::kDirection}), std::invalid_argument);
}

}  // namespace
}  // namespace framewise
