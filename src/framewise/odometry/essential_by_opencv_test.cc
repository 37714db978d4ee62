// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/odometry/essential_by_opencv.h"

#include <gtest/gtest.h>

#include "framewise/geometry/so3.h"

namespace framewise {
namespace {

Correspondences seen_before_and_after(const Pose& cam2_from_cam1, int count) {
  Correspondences shared;
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector3d X1(std::sin(1.7 * i), std::cos(2.3 * i), 3 + std::sin(0.9 * i));
    shared.x1.push_back(X1.normalized());
    shared.x2.push_back((cam2_from_cam1 * X1).normalized());
    shared.pixels1.emplace_back(0, 0), shared.pixels2.emplace_back(0, 0);
    shared.z1.push_back(X1.z()), shared.z2.push_back((cam2_from_cam1 * X1).z());
    shared.sigma1.push_back(1e-3), shared.sigma2.push_back(1e-3), shared.distance.push_back(0);
  }
  return shared;
}

TEST(EssentialByOpencv, IsTheMotionFromCamera1ToCamera2) {
  const Pose motion{so3_exp({0.02, -0.05, 0.01}), Eigen::Vector3d(0.2, -0.1, 0.3)};
  const auto found = essential_by_opencv(seen_before_and_after(motion, 60), 1e-3, 0.999);
  ASSERT_TRUE(found);
  EXPECT_LT(rotation_angle(found->cam2_from_cam1.R.transpose() * motion.R), 1e-6);
  EXPECT_LT((found->cam2_from_cam1.t - motion.t.normalized()).norm(), 1e-5);
  EXPECT_EQ(found->num_inliers, 60u);
}

TEST(EssentialByOpencv, SaysNothingOfFewerThanFivePoints) {
  EXPECT_FALSE(essential_by_opencv(seen_before_and_after(Pose(), 4), 1e-3, 0.999));
  EXPECT_FALSE(essential_by_opencv({}, 1e-3, 0.999));
}

}  // namespace
}  // namespace framewise
