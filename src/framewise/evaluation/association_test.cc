// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/evaluation/association.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

namespace framewise {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using Times = std::vector<double>;

Trajectory along_x(const Times& times) {
  Trajectory trajectory;
  for (const double t : times) trajectory.add(t, {Eigen::Matrix3d::Identity(), Eigen::Vector3d(t, 0, 0)});
  return trajectory;
}

TEST(Association, NearestLetsOneLongStampServeTwiceAndGreedyDoesNot) {
  const Times reference = {0.0, 1.0, 2.0, 3.0}, estimate = {0.96, 1.05};
  EXPECT_THAT(associate_nearest(reference, estimate, 0.1), ElementsAre(Match{1, 0}, Match{1, 1}));
  EXPECT_THAT(associate_greedy(reference, estimate, 0.1), ElementsAre(Match{1, 0}));
}

TEST(Association, NearestWalksTheShorterTrajectory) {
  const Times reference = {1.0}, estimate = {0.9375, 1.03125};
  EXPECT_THAT(associate_nearest(reference, estimate, 0.1), ElementsAre(Match{0, 1}));
}

TEST(Association, OfTwoEquallyNearTheEarlierWins) {
  EXPECT_THAT(associate_nearest(Times{1.0, 2.0}, Times{1.5}, 0.5), ElementsAre(Match{0, 0}));
  EXPECT_EQ(nearest_index(Times{1, 2, 3}, 2.5), 1u);
  EXPECT_EQ(nearest_index(Times{1, 2, 3}, -7), 0u);
  EXPECT_EQ(nearest_index(Times{1, 2, 3}, 7), 2u);
}

TEST(Association, TheLimitItselfMatchesForNearestAndNotForGreedy) {
  EXPECT_EQ(associate_nearest(Times{1.0}, Times{1.25}, 0.25).size(), 1u);
  EXPECT_EQ(associate_greedy(Times{1.0}, Times{1.25}, 0.25).size(), 0u);
}

TEST(Association, GreedyGivesTheClosestPairFirst) {
  // 1.00 is nearest to 0.98, but 1.01 is nearer to it: the first estimate falls back on 0.90.
  EXPECT_THAT(associate_greedy(Times{0.90, 1.00}, Times{0.98, 1.01}, 0.1),
              ElementsAre(Match{0, 0}, Match{1, 1}));
}

TEST(Association, TheOffsetIsAddedToTheEstimate) {
  const Times reference = {5.0, 6.0, 7.0}, estimate = {4.0};
  EXPECT_THAT(associate_nearest(reference, estimate, 0.1, 2), ElementsAre(Match{1, 0}));
  EXPECT_THAT(associate_greedy(reference, estimate, 0.1, 2), ElementsAre(Match{1, 0}));
  EXPECT_THAT(associate_nearest(estimate, reference, 0.1, -2), ElementsAre(Match{0, 1}));
}

TEST(Association, InterpolationPutsTheReferenceAtTheStampAndNotIntoItsGaps) {
  const TrajectoryPair pair = associate(along_x({0, 0.02, 5, 5.02}), along_x({0.015, 2, 5.005}),
                                        {.method = AssociationMethod::kInterpolated});
  ASSERT_EQ(pair.size(), 2u);
  EXPECT_DOUBLE_EQ(pair.reference.world_from_cam[0].t.x(), 0.015);
  EXPECT_DOUBLE_EQ(pair.reference.world_from_cam[1].t.x(), 5.005);
}

TEST(Association, NoMatchSaysHowManyPosesWhenAndTheLimit) {
  try {
    associate(along_x({1, 2, 3}), along_x({7, 8}), {});
    FAIL() << "accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), HasSubstr("reference has 3 poses from 1.000000 s to 3.000000 s"));
    EXPECT_THAT(error.what(), HasSubstr("estimate has 2 poses from 7.000000 s to 8.000000 s"));
    EXPECT_THAT(error.what(), HasSubstr("limit 0.01 s"));
  }
}

TEST(Association, ByIndexRefusesOtherLengths) {
  EXPECT_THROW(associate(along_x({1, 2, 3}), along_x({1, 2}), {.method = AssociationMethod::kIndex}),
               std::invalid_argument);
  EXPECT_THROW(associate({}, along_x({1, 2}), {}), std::invalid_argument);
  EXPECT_THROW(associate(along_x({1, 2}), {}, {}), std::invalid_argument);
}

}  // namespace
}  // namespace framewise
