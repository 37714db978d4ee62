// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/geometry/camera.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

namespace framewise {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

Camera pinhole(double fx, double fy, double cx, double cy, const std::array<double, 5>& distortion) {
  return {CameraModel::kPinhole, 640, 480, fx, fy, cx, cy, distortion, {}};
}

const Camera kFreiburg1 = pinhole(517.3, 516.5, 318.6, 255.3, {0.2624, -0.9531, -0.0054, 0.0026, 1.1633});
const Camera kFreiburg2 = pinhole(520.9, 521.0, 325.1, 249.7, {0.2312, -0.7849, -0.0033, -0.0001, 0.9172});
const Camera kFreiburg3 = pinhole(535.4, 539.2, 320.1, 247.6, {});
const Camera kIcl = pinhole(481.2, -480, 319.5, 239.5, {});
const Camera kFisheye{
    CameraModel::kFisheye, 752, 480, 190.9, 190.8, 370.1, 239.4, {0.0035, 0.0007, -0.0021, 0.0002}, {}};
const Camera kPanorama{CameraModel::kEquirectangular, 1024, 256, 0, 0, 0, 0, {}, {0.5, 2.2}};

std::vector<Camera> all_cameras() { return {kFreiburg1, kFreiburg2, kFreiburg3, kIcl, kFisheye, kPanorama}; }

TEST(Camera, ProjectInvertsBearingOverTheWholeImage) {
  for (const Camera& camera : all_cameras()) {
    for (int v = 0; v < camera.height; v += 3) {
      for (int u = 0; u < camera.width; u += 3) {
        const Vector2d pixel(u, v);
        const auto x = camera.bearing(pixel);
        ASSERT_TRUE(x) << camera.fx << " at " << pixel.transpose();
        ASSERT_NEAR(x->norm(), 1, 1e-15);
        const auto back = camera.project(2.5 * *x);
        ASSERT_TRUE(back);
        ASSERT_LT((*back - pixel).norm(), 1e-12) << camera.fx << " at " << pixel.transpose();
      }
    }
  }
}

TEST(Camera, KnownAnswers) {
  // x = 0.2, y = -0.1, r2 = 0.05: radial 1.010882663..., tangential by hand from OpenCV's formula.
  const double radial = 1 + 0.2624 * 0.05 - 0.9531 * 0.0025 + 1.1633 * 0.000125;
  const double x = 0.2 * radial + 2 * -0.0054 * -0.02 + 0.0026 * (0.05 + 0.08);
  const double y = -0.1 * radial - 0.0054 * (0.05 + 0.02) + 2 * 0.0026 * -0.02;
  EXPECT_NEAR(radial, 1.0108826625, 1e-15);
  EXPECT_NEAR(x, 0.2027305325, 1e-15);
  EXPECT_NEAR(y, -0.10157026625, 1e-15);
  EXPECT_LT((*kFreiburg1.project({0.4, -0.2, 2}) - Vector2d(423.47250446225, 202.838957481875)).norm(),
            1e-12);
  EXPECT_LT((*kIcl.project({0.4, -0.2, 2}) - Vector2d(319.5 + 96.24, 239.5 + 48)).norm(), 1e-12);

  Camera ideal_fisheye = kFisheye;
  ideal_fisheye.distortion = {};
  EXPECT_LT((*ideal_fisheye.project({1, 0, 0}) - Vector2d(370.1 + 190.9 * M_PI / 2, 239.4)).norm(), 1e-12);

  const Camera sphere{CameraModel::kEquirectangular, 360, 180, 0, 0, 0, 0, {}, {0, M_PI}};
  EXPECT_LT((*sphere.project({0, 0, 1}) - Vector2d(179.5, 89.5)).norm(), 1e-12) << "ahead is the middle";
  EXPECT_LT((*sphere.project({1, 0, 0}) - Vector2d(269.5, 89.5)).norm(), 1e-12) << "right is to the right";
  EXPECT_LT((*sphere.project({0, -1, 1}) - Vector2d(179.5, 44.5)).norm(), 1e-12) << "up is above";
}

TEST(Camera, JacobianIsTheDerivativeOfProject) {
  for (const Camera& camera : all_cameras()) {
    for (const Vector3d& X : {Vector3d(0.3, -0.2, 1.5), Vector3d(-0.9, 0.6, 2.1), Vector3d(1e-7, 0, 1)}) {
      const auto J = camera.project_jacobian(X);
      ASSERT_TRUE(J);
      for (int k = 0; k < 3; ++k) {
        const Vector3d d = 1e-6 * Vector3d::Unit(k);
        const Vector2d numeric = (*camera.project(X + d) - *camera.project(X - d)) / 2e-6;
        EXPECT_LT((J->col(k) - numeric).norm(), 1e-5) << name_of(camera.model) << " " << X.transpose();
      }
    }
  }
}

TEST(Camera, SeesNothingWhereTheModelEnds) {
  EXPECT_FALSE(kFreiburg1.project({0.1, 0.1, -1})) << "behind";
  EXPECT_FALSE(kFreiburg1.project({0.1, 0.1, 0}));
  EXPECT_FALSE(kFreiburg1.project_jacobian({0.1, 0.1, 0}));
  EXPECT_FALSE(kFreiburg1.project({std::nan(""), 0.1, 1}));
  EXPECT_FALSE(kFreiburg1.bearing({std::nan(""), 1}));
  EXPECT_TRUE(kFisheye.project({1, 0, -0.1})) << "a fisheye sees past 90 degrees";
  for (const Camera& camera : all_cameras()) EXPECT_FALSE(camera.project({0, 0, 0}));
}

TEST(Camera, BeyondTheFoldThereIsNoRay) {
  // r (1 - 0.5 r^2) is largest, 0.5443, at r = 0.8165.
  const Camera barrel = pinhole(500, 500, 320, 240, {-0.5});
  EXPECT_TRUE(barrel.bearing({320 + 500 * 0.54, 240}));
  EXPECT_FALSE(barrel.bearing({320 + 500 * 0.55, 240}));
  EXPECT_TRUE(barrel.project({0.81, 0, 1}));
  EXPECT_FALSE(barrel.project({0.83, 0, 1})) << "would land on a pixel that another ray owns";
}

std::string refusal_of(const Camera& camera) {
  try {
    camera.check();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Camera, CheckNamesTheFieldAndWhatItFound) {
  for (const Camera& camera : all_cameras()) EXPECT_EQ(refusal_of(camera), "accepted");
  Camera bad = kFreiburg1;
  bad.fx = 0;
  EXPECT_EQ(refusal_of(bad), "camera: fx is 0, expected a positive number of pixels");
  bad.fx = -517;
  EXPECT_THAT(refusal_of(bad), testing::HasSubstr("fx is -517"));
  bad = kFreiburg1;
  bad.fy = 0;
  EXPECT_THAT(refusal_of(bad), testing::HasSubstr("fy is 0"));
  bad = kFreiburg1;
  bad.cy = std::nan("");
  EXPECT_THAT(refusal_of(bad), testing::HasSubstr("cy is nan"));
  bad = kFreiburg1;
  bad.distortion[4] = std::numeric_limits<double>::infinity();
  EXPECT_THAT(refusal_of(bad), testing::HasSubstr("distortion is inf"));
  bad = kFreiburg1;
  bad.width = 0;
  EXPECT_THAT(refusal_of(bad), testing::HasSubstr("width is 0"));
  bad = kPanorama;
  bad.theta_range = {2, 1};
  EXPECT_THAT(refusal_of(bad), testing::HasSubstr("theta_range[1] is 1"));
}

}  // namespace
}  // namespace framewise
