// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/geometry/epipolar.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <functional>
#include <random>

#include "framewise/geometry/so3.h"

namespace framewise {
namespace {

constexpr ImageSurface kSurfaces[] = {ImageSurface::kPlane, ImageSurface::kSphere};

// A pair of views and one point, not quite seen where it is.
struct View {
  Pose pose;
  Eigen::Vector3d X1, x1, x2;
};

class Draw {
 public:
  explicit Draw(std::uint64_t seed) : engine_(seed) {}
  double uniform(double low, double high) { return low + (high - low) * (engine_() >> 11) * 0x1.0p-53; }
  Eigen::Vector3d box() { return {uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)}; }
  View view(ImageSurface surface, double noise) {
    const double depth = uniform(2, 8);
    View v{{so3_exp(0.3 * box()), box().normalized()},
           {depth * uniform(-0.6, 0.6), depth * uniform(-0.4, 0.4), depth},
           {},
           {}};
    const auto seen = [&](const Eigen::Vector3d& X) -> Eigen::Vector3d {
      const bool plane = surface == ImageSurface::kPlane;
      const Eigen::Vector3d x = X / (plane ? X.z() : X.norm()) + noise * box();
      return x / (plane ? x.z() : x.norm());
    };
    v.x1 = seen(v.X1), v.x2 = seen(v.pose * v.X1);
    return v;
  }

 private:
  std::mt19937_64 engine_;
};

using Residual = std::function<Eigen::VectorXd(const Pose&)>;

Eigen::MatrixXd numeric_jacobian(const Residual& residual, const Pose& pose) {
  const double h = 1e-6;
  Eigen::MatrixXd J(residual(pose).size(), 6);
  for (int k = 0; k < 6; ++k) {
    Pose plus = pose, minus = pose;
    if (k < 3) {
      plus.R = pose.R * so3_exp(h * Eigen::Vector3d::Unit(k));
      minus.R = pose.R * so3_exp(-h * Eigen::Vector3d::Unit(k));
    } else {
      plus.t[k - 3] += h;
      minus.t[k - 3] -= h;
    }
    J.col(k) = (residual(plus) - residual(minus)) / (2 * h);
  }
  return J;
}

Eigen::VectorXd scalar(double value) { return Eigen::VectorXd::Constant(1, value); }

TEST(Epipolar, EssentialMatrixVanishesOnExactPairs) {
  Draw draw(1);
  for (int trial = 0; trial < 100; ++trial) {
    const View v = draw.view(ImageSurface::kSphere, 0);
    EXPECT_NEAR(v.x2.dot(essential_from_pose(v.pose) * v.x1), 0, 1e-15);
    EXPECT_NEAR(algebraic_residual(v.pose, v.x1, v.x2), 0, 1e-15);
    EXPECT_NEAR(epipolar_plane_angle(v.pose, v.x1, v.x2), 0, 1e-14);
    EXPECT_NEAR(sampson_residual(v.pose, v.x1, v.x2, ImageSurface::kSphere), 0, 1e-14);
    EXPECT_LT(reprojection_residual(v.pose, v.X1, v.x2).norm(), 1e-14);
    EXPECT_LT(bearing_angle_residual(v.pose, v.X1, v.x2).norm(), 1e-14);
  }
}

TEST(Epipolar, SphereTangentIsAnOrthonormalBasisAcross) {
  Draw draw(2);
  for (int trial = 0; trial < 100; ++trial) {
    const Eigen::Vector3d t = trial < 3 ? Eigen::Vector3d::Unit(trial).eval() : draw.box();
    const auto B = sphere_tangent(t);
    EXPECT_LT((B.transpose() * B - Eigen::Matrix2d::Identity()).norm(), 1e-15);
    EXPECT_LT((B.transpose() * t).norm(), 1e-15);
    const Eigen::Vector2d step(draw.uniform(-1, 1), draw.uniform(-1, 1));
    const Eigen::Vector3d moved = sphere_exp(t.normalized(), step);
    EXPECT_NEAR(std::atan2(moved.cross(t).norm(), moved.dot(t)), step.norm(), 1e-14);
  }
}

TEST(Epipolar, JacobiansAreTheNumericDerivatives) {
  Draw draw(3);
  for (const ImageSurface surface : kSurfaces)
    for (const double noise : {0.0, 1e-3, 0.1})
      for (int trial = 0; trial < 50; ++trial) {
        const View v = draw.view(surface, noise);
        Jacobian16 J1;
        algebraic_residual(v.pose, v.x1, v.x2, &J1);
        EXPECT_LT((J1 - numeric_jacobian(
                            [&](const Pose& p) { return scalar(algebraic_residual(p, v.x1, v.x2)); }, v.pose))
                      .norm(),
                  1e-8);
        epipolar_plane_angle(v.pose, v.x1, v.x2, &J1);
        EXPECT_LT(
            (J1 - numeric_jacobian([&](const Pose& p) { return scalar(epipolar_plane_angle(p, v.x1, v.x2)); },
                                   v.pose))
                .norm(),
            1e-8 * (1 + J1.squaredNorm()));
        sampson_residual(v.pose, v.x1, v.x2, surface, &J1);
        EXPECT_LT((J1 - numeric_jacobian(
                            [&](const Pose& p) { return scalar(sampson_residual(p, v.x1, v.x2, surface)); },
                            v.pose))
                      .norm(),
                  1e-8 * (1 + J1.squaredNorm()));
        Jacobian26 J2;
        reprojection_residual(v.pose, v.X1, v.x2, &J2);
        EXPECT_LT((J2 - numeric_jacobian([&](const Pose& p) { return reprojection_residual(p, v.X1, v.x2); },
                                         v.pose))
                      .norm(),
                  1e-8 * (1 + J2.squaredNorm()));
        const Eigen::Vector3d bearing = v.x2.normalized();
        bearing_angle_residual(v.pose, v.X1, bearing, &J2);
        EXPECT_LT((J2 - numeric_jacobian(
                            [&](const Pose& p) { return bearing_angle_residual(p, v.X1, bearing); }, v.pose))
                      .norm(),
                  1e-8);
      }
}

TEST(Epipolar, SampsonAndPlaneAngleDoNotDependOnTheBaselinesLength) {
  Draw draw(4);
  for (const ImageSurface surface : kSurfaces) {
    const View v = draw.view(surface, 0.01);
    const Pose longer{v.pose.R, 17 * v.pose.t};
    EXPECT_NEAR(sampson_residual(longer, v.x1, v.x2, surface), sampson_residual(v.pose, v.x1, v.x2, surface),
                1e-15);
    EXPECT_NEAR(epipolar_plane_angle(longer, v.x1, v.x2), epipolar_plane_angle(v.pose, v.x1, v.x2), 1e-15);
  }
}

TEST(Epipolar, SampsonSeesBothViewsAlike) {
  Draw draw(5);
  for (const ImageSurface surface : kSurfaces)
    for (int trial = 0; trial < 20; ++trial) {
      const View v = draw.view(surface, 0.01);
      EXPECT_NEAR(std::abs(sampson_residual(v.pose, v.x1, v.x2, surface)),
                  std::abs(sampson_residual(v.pose.inverse(), v.x2, v.x1, surface)), 1e-14);
    }
}

TEST(Epipolar, BearingResidualIsAsLongAsTheAngle) {
  Draw draw(6);
  for (int trial = 0; trial < 100; ++trial) {
    const View v = draw.view(ImageSurface::kSphere, 0);
    const Eigen::Vector3d x2 = draw.box().normalized(), seen = (v.pose * v.X1).normalized();
    EXPECT_NEAR(bearing_angle_residual(v.pose, v.X1, x2).norm(),
                std::atan2(x2.cross(seen).norm(), x2.dot(seen)), 1e-14);
  }
}

}  // namespace
}  // namespace framewise
