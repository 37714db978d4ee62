// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/odometry/scale.h"

#include <gtest/gtest.h>

#include <limits>

#include "framewise/geometry/so3.h"

namespace framewise {
namespace {

struct Points {
  Pose cam2_from_cam1{so3_exp({0.05, -0.1, 0.02}), Eigen::Vector3d(0.6, -0.64, 0.48)};
  std::vector<Eigen::Vector3d> X1, X2;
  std::vector<std::uint8_t> inliers;

  explicit Points(double length, int count = 20) {
    for (int i = 0; i < count; ++i) {
      X1.emplace_back(0.1 * i - 1, 0.05 * (i % 7), 2 + 0.1 * i);
      X2.push_back(cam2_from_cam1.R * X1.back() + length * cam2_from_cam1.t);
      inliers.push_back(1);
    }
  }
  auto length() const { return length_from_depth(cam2_from_cam1, X1, X2, inliers); }
};

TEST(LengthFromDepth, IsExactWithoutNoiseWhateverTheSign) {
  for (const double length : {0.0, 0.01, 0.5, 3.0, -0.2})
    EXPECT_NEAR(Points(length).length().value(), length, 1e-14);
}

TEST(LengthFromDepth, DoesNotHearOutliersAndWrongDepths) {
  Points points(0.5);
  for (int i = 0; i < 5; ++i) points.X2[i] *= 3;
  for (int i = 5; i < 9; ++i) points.X1[i].setConstant(std::numeric_limits<double>::quiet_NaN());
  for (int i = 9; i < 14; ++i) points.X2[i] *= 0.1, points.inliers[i] = 0;
  EXPECT_NEAR(points.length().value(), 0.5, 1e-14);
}

TEST(LengthFromDepth, NeedsFivePoints) {
  EXPECT_FALSE(Points(0.5, 4).length());
  EXPECT_TRUE(Points(0.5, 5).length());
}

TEST(TranslationFromCentroids, IsExactWithoutNoiseAndNeedsNoDirection) {
  const Points points(0.5);
  const auto t = translation_from_centroids(points.cam2_from_cam1.R, points.X1, points.X2, points.inliers);
  EXPECT_LT((t.value() - 0.5 * points.cam2_from_cam1.t).norm(), 1e-13);
}

TEST(TranslationFromCentroids, LeavesOutWhatIsUnknownAndWhatDisagrees) {
  Points points(0.5);
  for (int i = 0; i < 4; ++i) points.X1[i].setConstant(std::numeric_limits<double>::quiet_NaN());
  for (int i = 4; i < 8; ++i) points.X2[i] *= 5, points.inliers[i] = 0;
  const auto t = translation_from_centroids(points.cam2_from_cam1.R, points.X1, points.X2, points.inliers);
  EXPECT_LT((t.value() - 0.5 * points.cam2_from_cam1.t).norm(), 1e-13);
}

TEST(TranslationFromCentroids, NeedsFivePoints) {
  const Points four(0.5, 4), five(0.5, 5);
  EXPECT_FALSE(translation_from_centroids(four.cam2_from_cam1.R, four.X1, four.X2, four.inliers));
  EXPECT_TRUE(translation_from_centroids(five.cam2_from_cam1.R, five.X1, five.X2, five.inliers));
}

}  // namespace
}  // namespace framewise
