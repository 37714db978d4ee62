// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/evaluation/evaluation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "framewise/evaluation/kitti_segments.h"
#include "framewise/evaluation/presets.h"
#include "framewise/geometry/so3.h"

namespace framewise {
namespace {

using testing::HasSubstr;

const Similarity elsewhere = {1, {so3_exp({0.4, -1.2, 2.0}), {5, -3, 8}}};
const Similarity elsewhere_too = {1, {so3_exp({-2.1, 0.3, 0.7}), {-40, 11, 2}}};

// A walk that bends in all directions, 10 poses a second.
Trajectory walk(int count = 60) {
  Trajectory trajectory;
  for (int i = 0; i < count; ++i) {
    const double s = 0.1 * i;
    trajectory.add(100 + s, {so3_exp({0.3 * std::sin(s), 0.2 * s, 0.1 * std::cos(2 * s)}),
                             {2 * std::sin(s), 0.7 * s, std::cos(1.5 * s)}});
  }
  return trajectory;
}

// The walk with errors of 1 cm and 0.01 rad that differ from pose to pose.
Trajectory noisy(Trajectory trajectory) {
  for (std::size_t i = 0; i < trajectory.size(); ++i) {
    const double s = static_cast<double>(i);
    Pose& pose = trajectory.world_from_cam[i];
    pose.t += 0.01 * Eigen::Vector3d(std::sin(7 * s), std::cos(11 * s), std::sin(13 * s + 1));
    pose.R = pose.R * so3_exp(0.01 * Eigen::Vector3d(std::cos(5 * s), std::sin(3 * s), std::cos(17 * s)));
  }
  return trajectory;
}

Trajectory straight(int count = 20) {
  Trajectory trajectory;
  for (int i = 0; i < count; ++i) trajectory.add(i, {so3_exp({0, 0, 0.01 * i}), Eigen::Vector3d(0, 0, i)});
  return trajectory;
}

EvaluationOptions with(Alignment alignment) {
  EvaluationOptions options;
  options.alignment = alignment;
  return options;
}

EvaluationOptions over(double delta, DeltaUnit unit, std::optional<PairChoice> pairs = {}) {
  EvaluationOptions options;
  options.relative.delta = delta;
  options.relative.unit = unit;
  options.relative.pairs = pairs;
  return options;
}

TEST(Evaluation, IdenticalTrajectoriesHaveNoError) {
  for (const Alignment alignment : {Alignment::kNone, Alignment::kSe3, Alignment::kSim3, Alignment::kScale,
                                    Alignment::kYaw, Alignment::kOrigin}) {
    const Evaluation e = evaluate(walk(), walk(), with(alignment));
    EXPECT_LT(e.ate.max, 1e-12) << name_of(alignment);
    EXPECT_LT(e.ate_rotation_deg.max, 1e-12) << name_of(alignment);
    EXPECT_LT(e.rpe->translation.max, 1e-12) << name_of(alignment);
    EXPECT_LT(e.rpe->rotation_deg.max, 1e-12) << name_of(alignment);
    EXPECT_EQ(e.coverage, 1);
    EXPECT_EQ(e.time_coverage, 1);
    EXPECT_NEAR(e.path_length, path_length(walk()), 1e-12);
  }
}

TEST(Evaluation, AteAfterSe3DoesNotKnowWhereTheEstimateLay) {
  const Evaluation here = evaluate(walk(), noisy(walk()), {});
  const Evaluation there = evaluate(walk(), transformed(elsewhere, noisy(walk())), {});
  EXPECT_GT(here.ate.rmse, 5e-3);
  EXPECT_NEAR(here.ate.rmse, there.ate.rmse, 1e-12);
  EXPECT_NEAR(here.ate_rotation_deg.rmse, there.ate_rotation_deg.rmse, 1e-11);
  EXPECT_GT(evaluate(walk(), transformed(elsewhere, noisy(walk())), with(Alignment::kNone)).ate.rmse, 1);
}

TEST(Evaluation, RpeDoesNotKnowWhereEitherLay) {
  const EvaluationOptions cases[] = {over(1, DeltaUnit::kFrames),
                                     over(7, DeltaUnit::kFrames, PairChoice::kAll),
                                     over(1, DeltaUnit::kSeconds),
                                     over(1, DeltaUnit::kSeconds, PairChoice::kAll),
                                     over(1, DeltaUnit::kSeconds, PairChoice::kConsecutive),
                                     over(0.5, DeltaUnit::kMetres),
                                     over(0.5, DeltaUnit::kMetres, PairChoice::kAll),
                                     over(5, DeltaUnit::kDegrees),
                                     over(0.1, DeltaUnit::kRadians, PairChoice::kAll)};
  for (EvaluationOptions options : cases) {
    options.alignment = Alignment::kNone;
    const Evaluation here = evaluate(walk(), noisy(walk()), options);
    const Evaluation there =
        evaluate(transformed(elsewhere, walk()), transformed(elsewhere_too, noisy(walk())), options);
    ASSERT_TRUE(here.rpe) << name_of(options.relative.unit);
    EXPECT_GT(here.rpe->translation.rmse, 1e-3);
    EXPECT_EQ(here.motions.size(), there.motions.size());
    EXPECT_NEAR(here.rpe->translation.rmse, there.rpe->translation.rmse, 1e-11);
    EXPECT_NEAR(here.rpe->rotation_deg.rmse, there.rpe->rotation_deg.rmse, 1e-11);
  }
}

TEST(Evaluation, Sim3RecoversAScaledCopyAndSe3DoesNot) {
  const Trajectory copy = transformed({0.25, elsewhere.pose}, walk());
  const Evaluation e = evaluate(walk(), copy, with(Alignment::kSim3));
  EXPECT_NEAR(e.reference_from_estimate.scale, 4, 1e-12);
  EXPECT_LT(e.ate.max, 1e-12);
  EXPECT_LT(e.ate_rotation_deg.max, 1e-11);
  EXPECT_LT(e.rpe->translation.max, 1e-12);
  EXPECT_GT(evaluate(walk(), copy, {}).ate.rmse, 0.5);
}

TEST(Evaluation, ScaleAloneLeavesTheWorldWhereItIs) {
  const Evaluation e = evaluate(walk(), transformed({0.25, {}}, walk()), with(Alignment::kScale));
  EXPECT_NEAR(e.reference_from_estimate.scale, 4, 1e-12);
  EXPECT_LT(e.ate.max, 1e-12);
  EXPECT_GT(evaluate(walk(), transformed({0.25, elsewhere.pose}, walk()), with(Alignment::kScale)).ate.rmse,
            1);
}

TEST(Evaluation, YawAlignmentForgivesTurnsAboutGravityOnly) {
  const Similarity turned = {1, {so3_exp({0, 0, 2.5}), {1, 2, 3}}}, tilted = {1, {so3_exp({0.2, 0, 0}), {}}};
  EXPECT_LT(evaluate(walk(), transformed(turned, walk()), with(Alignment::kYaw)).ate.max, 1e-12);
  EXPECT_GT(evaluate(walk(), transformed(tilted, walk()), with(Alignment::kYaw)).ate.rmse, 0.05);
}

TEST(Evaluation, OriginAlignmentLaysTheFirstPoseOnTheReferences) {
  const Evaluation e = evaluate(walk(), transformed(elsewhere, noisy(walk())), with(Alignment::kOrigin));
  EXPECT_LT((e.poses.estimate.world_from_cam[0].matrix() - walk().world_from_cam[0].matrix()).norm(), 1e-12);
  EXPECT_LT(e.ate.min, 1e-12);
}

TEST(Evaluation, AStraightPathTakesItsFreeTurnFromTheOrientations) {
  const Evaluation e = evaluate(straight(), transformed(elsewhere, straight()), {});
  EXPECT_LT(e.ate.max, 1e-10);
  EXPECT_LT(e.ate_rotation_deg.max, 1e-4);
}

TEST(Evaluation, TheErrorOrdersAgreeInAngleAndNotInTranslation) {
  EvaluationOptions evo = over(10, DeltaUnit::kFrames), tum = evo;
  tum.relative.order = RelativeErrorOrder::kTum;
  const Evaluation a = evaluate(walk(), noisy(walk()), evo), b = evaluate(walk(), noisy(walk()), tum);
  EXPECT_NEAR(a.rpe->rotation_deg.rmse, b.rpe->rotation_deg.rmse, 1e-12);
  EXPECT_GT(std::abs(a.rpe->translation.rmse - b.rpe->translation.rmse), 1e-6);
}

TEST(Evaluation, PairsAreThoseOfTheirDefinition) {
  const Trajectory path = straight(11);  // a metre, a second and 0.01 rad a pose
  const auto pairs = [&](double delta, DeltaUnit unit, PairChoice choice) {
    const Evaluation e = evaluate(path, path, over(delta, unit, choice));
    std::vector<std::pair<double, double>> times;
    for (const RelativeMotion& m : e.motions) times.emplace_back(m.from_time, m.to_time);
    return times;
  };
  using testing::ElementsAre;
  using testing::Pair;
  EXPECT_THAT(pairs(4, DeltaUnit::kFrames, PairChoice::kConsecutive), ElementsAre(Pair(0, 4), Pair(4, 8)));
  EXPECT_THAT(pairs(8, DeltaUnit::kFrames, PairChoice::kAll),
              ElementsAre(Pair(0, 8), Pair(1, 9), Pair(2, 10)));
  EXPECT_THAT(pairs(8, DeltaUnit::kFrames, PairChoice::kTum),
              ElementsAre(Pair(0, 8), Pair(1, 9)));  // not the last
  EXPECT_THAT(pairs(4, DeltaUnit::kSeconds, PairChoice::kConsecutive), ElementsAre(Pair(0, 4), Pair(4, 8)));
  EXPECT_THAT(pairs(8, DeltaUnit::kSeconds, PairChoice::kAll),
              ElementsAre(Pair(0, 8), Pair(1, 9), Pair(2, 10)));
  EXPECT_THAT(pairs(8, DeltaUnit::kSeconds, PairChoice::kTum), ElementsAre(Pair(0, 8), Pair(1, 9)));
  EXPECT_THAT(pairs(3, DeltaUnit::kMetres, PairChoice::kConsecutive), ElementsAre(Pair(3, 6), Pair(6, 9)));
  EXPECT_THAT(pairs(9, DeltaUnit::kMetres, PairChoice::kAll), ElementsAre(Pair(0, 9), Pair(1, 10)));
  EXPECT_THAT(pairs(0.0495, DeltaUnit::kRadians, PairChoice::kConsecutive),
              ElementsAre(Pair(0, 5), Pair(5, 10)));
  EXPECT_THAT(pairs(0.099, DeltaUnit::kRadians, PairChoice::kAll),
              ElementsAre(Pair(0, 9), Pair(0, 10), Pair(1, 10)));
}

TEST(Evaluation, ConsecutiveMetresBeginWhereToldTo) {
  EvaluationOptions options = over(3, DeltaUnit::kMetres);
  EXPECT_EQ(evaluate(straight(11), straight(11), options).motions[0].from_time, 3);
  options.relative.from_first_pose = true;
  EXPECT_EQ(evaluate(straight(11), straight(11), options).motions[0].from_time, 0);
}

TEST(Evaluation, SecondsAreTheTumToolsUnlessAskedOtherwise) {
  const Evaluation seconds = evaluate(walk(), walk(), over(1, DeltaUnit::kSeconds));
  EXPECT_EQ(seconds.options.relative.pairs, PairChoice::kTum);
  EXPECT_EQ(seconds.options.relative.order, RelativeErrorOrder::kTum);
  const Evaluation frames = evaluate(walk(), walk(), over(1, DeltaUnit::kFrames));
  EXPECT_EQ(frames.options.relative.pairs, PairChoice::kConsecutive);
  EXPECT_EQ(frames.options.relative.order, RelativeErrorOrder::kEvo);
}

TEST(Evaluation, AnEstimateThatNeverMovedScoresTheStaticBaseline) {
  Trajectory still = walk();
  for (Pose& pose : still.world_from_cam) pose = elsewhere.pose;
  for (const Alignment alignment : {Alignment::kNone, Alignment::kSe3, Alignment::kYaw, Alignment::kOrigin}) {
    const Evaluation e = evaluate(walk(), still, with(alignment));
    EXPECT_NEAR(e.ate.rmse, e.static_baseline.ate, 1e-12) << name_of(alignment);
    EXPECT_NEAR(e.rpe->translation.rmse, *e.static_baseline.rpe_translation, 1e-12) << name_of(alignment);
    EXPECT_NEAR(e.rpe->rotation_deg.rmse, *e.static_baseline.rpe_rotation_deg, 1e-12) << name_of(alignment);
  }
  const double ate = evaluate(walk(), still, {}).static_baseline.ate;
  EXPECT_NEAR(evaluate(walk(), noisy(walk()), {}).static_baseline.ate, ate, 1e-12);
}

TEST(Evaluation, TheScaleOfAnEstimateThatNeverMovedIsRefused) {
  Trajectory still = walk();
  for (Pose& pose : still.world_from_cam) pose = elsewhere.pose;
  EXPECT_THROW(evaluate(walk(), still, with(Alignment::kSim3)), std::invalid_argument);
}

TEST(Evaluation, CoverageIsTheShareOfTheEstimateThatWasJudged) {
  Trajectory half;  // truth that covers half
  for (std::size_t i = 0; i < 30; ++i) half.add(walk().times[i], walk().world_from_cam[i]);
  const Evaluation truth_ends = evaluate(half, walk(), {});
  EXPECT_EQ(truth_ends.matched, 30u);
  EXPECT_DOUBLE_EQ(truth_ends.coverage, 0.5);
  const Evaluation estimate_ends = evaluate(walk(), half, {});
  EXPECT_DOUBLE_EQ(estimate_ends.coverage, 1);
  EXPECT_NEAR(estimate_ends.time_coverage, 29.0 / 59, 1e-12);
}

TEST(Evaluation, ARecordingShorterThanDeltaHasNoRpe) {
  const Evaluation e = evaluate(walk(), walk(), over(1000, DeltaUnit::kFrames));
  EXPECT_FALSE(e.rpe);
  EXPECT_FALSE(e.static_baseline.rpe_translation);
}

TEST(Evaluation, RefusesWhatCannotBeJudged) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(evaluate({}, walk(), {}), std::invalid_argument);
  EXPECT_THROW(evaluate(walk(), {}, {}), std::invalid_argument);
  EXPECT_THROW(evaluate(walk(), walk(1), {}), std::invalid_argument);
  Trajectory bad = walk();
  bad.world_from_cam[3].t.y() = nan;
  EXPECT_THROW(evaluate(walk(), bad, {}), std::invalid_argument);
  bad = walk();
  bad.times[4] = bad.times[3];
  EXPECT_THROW(evaluate(bad, walk(), {}), std::invalid_argument);
  bad = walk();
  bad.world_from_cam[2].R *= 2;
  EXPECT_THROW(evaluate(walk(), bad, {}), std::invalid_argument);
  bad = walk();
  bad.times.pop_back();
  EXPECT_THROW(evaluate(walk(), bad, {}), std::invalid_argument);
}

TEST(Evaluation, RefusesWrongOptionsByName) {
  const auto message = [](const EvaluationOptions& options) {
    try {
      evaluate(walk(), walk(), options);
    } catch (const std::invalid_argument& error) {
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  EXPECT_THAT(message(over(0, DeltaUnit::kFrames)), HasSubstr("delta"));
  EXPECT_THAT(message(over(1.5, DeltaUnit::kFrames)), HasSubstr("whole frames"));
  EXPECT_THAT(message(over(200, DeltaUnit::kDegrees)), HasSubstr("180"));
  EvaluationOptions options;
  options.association.max_difference = -1;
  EXPECT_THAT(message(options), HasSubstr("max_difference"));
  EXPECT_THROW(alignment_from_name("se4"), std::invalid_argument);
  EXPECT_EQ(alignment_from_name("yaw"), Alignment::kYaw);
  EXPECT_EQ(delta_unit_from_name("metres"), DeltaUnit::kMetres);
}

TEST(Evaluation, ProjectionForgetsHeightAndTilt) {
  Trajectory lifted = walk();
  for (Pose& pose : lifted.world_from_cam) pose.t.z() += 3;
  EvaluationOptions options = with(Alignment::kNone);
  EXPECT_NEAR(evaluate(walk(), lifted, options).ate.rmse, 3, 1e-12);
  options.plane = Plane::kXy;
  EXPECT_LT(evaluate(walk(), lifted, options).ate.rmse, 1e-12);
}

TEST(KittiSegments, AScaledStraightRoadErrsByTheScale) {
  Trajectory road, longer;
  for (int i = 0; i < 400; ++i) {
    road.add(i, {Eigen::Matrix3d::Identity(), Eigen::Vector3d(0, 0, i)});
    longer.add(i, {Eigen::Matrix3d::Identity(), Eigen::Vector3d(0, 0, 1.02 * i)});
  }
  const SegmentErrors e = kitti_segment_errors({road, longer});
  // Starts at 0, 10, ...; a stretch of L ends at L + 1: 30 + 20 + 10 of 100, 200 and 300 m.
  EXPECT_EQ(e.segments.size(), 60u);
  EXPECT_NEAR(e.translation_percent, 2.015, 0.01);
  EXPECT_EQ(e.rotation_deg_per_100m, 0);
  EXPECT_TRUE(kitti_segment_errors({straight(), straight()}).segments.empty());
}

TEST(Evaluate, DirectionErrorIsBlindToTheLengthOfSteps) {
  Trajectory doubled = walk();
  for (Pose& pose : doubled.world_from_cam) pose.t *= 2;
  const Evaluation e = evaluate(walk(), doubled, with(Alignment::kNone));
  EXPECT_LT(e.rpe->direction.max, 1e-9);
  EXPECT_GT(e.rpe->translation.min, 1e-3);
}

TEST(Evaluate, DirectionErrorOfTheOppositeWayIsTwo) {
  Trajectory back = straight();
  for (Pose& pose : back.world_from_cam) pose.t = -pose.t;
  EXPECT_NEAR(evaluate(straight(), back, with(Alignment::kNone)).rpe->direction.min, 2, 1e-12);
}

TEST(Evaluate, KittiSegmentsStandWhereThePathIsLongEnough) {
  EXPECT_FALSE(evaluate(walk(), walk(), {}).kitti);
  Trajectory longer = straight(150);
  ASSERT_TRUE(evaluate(longer, longer, {}).kitti);
  EXPECT_LT(evaluate(longer, longer, {}).kitti->translation_percent, 1e-9);
}

TEST(Presets, EachHasItsToolsRulesAndAnUnknownOneListsThem) {
  EXPECT_EQ(evaluation_preset("evo").alignment, Alignment::kNone);
  EXPECT_EQ(evaluation_preset("tum").relative.resolved_order(), RelativeErrorOrder::kTum);
  EXPECT_EQ(evaluation_preset("kitti").association.method, AssociationMethod::kIndex);
  EXPECT_EQ(evaluation_preset("lab").association.method, AssociationMethod::kInterpolated);
  try {
    evaluation_preset("rpg");
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), HasSubstr("evo tum kitti lab"));
  }
}

}  // namespace
}  // namespace framewise
