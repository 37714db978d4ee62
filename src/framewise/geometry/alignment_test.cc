// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/geometry/alignment.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <stdexcept>
#include <vector>

#include "framewise/geometry/so3.h"

namespace framewise {
namespace {

using Points = std::vector<Eigen::Vector3d>;

class Draw {
 public:
  explicit Draw(std::uint64_t seed) : engine_(seed) {}
  double uniform(double low, double high) { return low + (high - low) * (engine_() >> 11) * 0x1.0p-53; }
  Eigen::Vector3d box() { return {uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)}; }
  Points cloud(std::size_t size, const Eigen::Vector3d& extent = {1, 1, 1}) {
    Points X(size);
    for (auto& x : X) x = box().cwiseProduct(extent);
    return X;
  }

 private:
  std::mt19937_64 engine_;
};

Points moved(const Points& X, const Pose& pose, double scale = 1) {
  Points Y;
  for (const auto& x : X) Y.push_back(pose.R * (scale * x) + pose.t);
  return Y;
}

double difference(const Pose& a, const Pose& b) { return (a.matrix() - b.matrix()).norm(); }

TEST(Kabsch, ExactDataGiveMachinePrecision) {
  Draw draw(1);
  for (int trial = 0; trial < 2000; ++trial) {
    const Points X1 = draw.cloud(3 + trial % 40);
    const Pose truth{so3_exp(M_PI * draw.box()), draw.box()};
    const auto found = kabsch(X1, moved(X1, truth));
    ASSERT_TRUE(found);
    // A nearly collinear triple amplifies rounding.
    EXPECT_LT(difference(*found, truth), X1.size() == 3 ? 1e-10 : 1e-13) << trial;
    EXPECT_LT((found->R.transpose() * found->R - Eigen::Matrix3d::Identity()).norm(), 1e-14);
    EXPECT_GT(found->R.determinant(), 0);
  }
}

TEST(Kabsch, PlaneAndHalfTurnGiveMachinePrecision) {
  Draw draw(2);
  const Eigen::Matrix3d identity = Eigen::Matrix3d::Identity();
  for (const Eigen::Vector3d& extent : {Eigen::Vector3d(1, 1, 0), Eigen::Vector3d(1, 1, 1)})
    for (const Eigen::Vector3d& axis :
         {Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(0, 1, 0), Eigen::Vector3d(0, 0, 1),
          Eigen::Vector3d(1, 1, 0).normalized().eval(), Eigen::Vector3d(1, -2, 0.5).normalized().eval()}) {
      const Points X1 = draw.cloud(20, extent);
      const Pose half_turn{2 * axis * axis.transpose() - identity, {1, 2, 3}};
      const auto found = kabsch(X1, moved(X1, half_turn));
      ASSERT_TRUE(found);
      EXPECT_LT(difference(*found, half_turn), 1e-13);
    }
}

TEST(Kabsch, AMirroredCloudStillGivesARotation) {
  Draw draw(3);
  const Points X1 = draw.cloud(30, {3, 2, 1});
  Points X2 = X1;
  for (auto& x : X2) x.z() = -x.z();
  const auto found = kabsch(X1, X2);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->R.determinant(), 1, 1e-14);
}

TEST(Kabsch, NoNeighbouringPoseFitsNoisyPointsBetter) {
  Draw draw(4);
  for (int trial = 0; trial < 100; ++trial) {
    const Points X1 = draw.cloud(10);
    Points X2 = moved(X1, {so3_exp(3 * draw.box()), draw.box()});
    std::vector<double> w;
    for (auto& x : X2) x += 0.2 * draw.box(), w.push_back(draw.uniform(0, 2));
    const auto cost = [&](const Pose& pose) {
      double sum = 0;
      for (std::size_t i = 0; i < X1.size(); ++i) sum += w[i] * (X2[i] - pose * X1[i]).squaredNorm();
      return sum;
    };
    const Pose best = kabsch(X1, X2, w).value();
    for (int k = 0; k < 6; ++k)
      for (const double h : {-1e-4, 1e-4}) {
        Pose other = best;
        if (k < 3)
          other.R = best.R * so3_exp(h * Eigen::Vector3d::Unit(k));
        else
          other.t[k - 3] += h;
        EXPECT_GT(cost(other), cost(best));
      }
  }
}

TEST(Kabsch, AWeightIsARepeatedPoint) {
  Draw draw(5);
  const Points X1 = draw.cloud(6), X2 = draw.cloud(6);
  const std::vector<double> w = {1, 2, 0, 3, 1, 1};
  Points Y1, Y2;
  for (std::size_t i = 0; i < X1.size(); ++i)
    for (int k = 0; k < w[i]; ++k) Y1.push_back(X1[i]), Y2.push_back(X2[i]);
  EXPECT_LT(difference(*kabsch(X1, X2, w), *kabsch(Y1, Y2)), 1e-13);
}

TEST(Kabsch, FarFromTheOriginOnlyTheInputsOwnRoundingIsLost) {
  Draw draw(6);
  const Points X1 = draw.cloud(50);
  const Pose truth{so3_exp({0.3, -1, 2}), {0, 0, 0}};
  Points far1, far2;
  for (const auto& x : X1) {
    far1.push_back(x + Eigen::Vector3d(1e6, -2e6, 3e6));
    far2.push_back(truth * x + Eigen::Vector3d(-3e6, 1e6, 1e6));
  }
  EXPECT_LT((kabsch(far1, far2)->R - truth.R).norm(), 1e-9);
}

TEST(Kabsch, NoUniqueRotationIsNoAnswer) {
  const Eigen::Vector3d d(0.3, -0.7, 1.1), p(10, 20, 30);
  Points line, point(5, p);
  for (int i = 0; i < 20; ++i) line.push_back(p + 0.37 * i * d);
  EXPECT_FALSE(kabsch(line, line));
  EXPECT_FALSE(kabsch(line, moved(line, {so3_exp({1, 2, 3}), {4, 5, 6}})));
  EXPECT_FALSE(kabsch(point, point));
  EXPECT_FALSE(kabsch(Points(2, d), Points(2, d)));
  EXPECT_FALSE(kabsch({}, {}));
  Draw draw(7);
  const Points X = draw.cloud(5);
  EXPECT_FALSE(kabsch(X, X, std::vector<double>(5, 0.0)));
  Points nan = X;
  nan[3].y() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(kabsch(X, nan));
  // The corners of an octahedron, inverted: every axis is as good a mirror as any other.
  const Points octahedron = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  Points inverted;
  for (const auto& x : octahedron) inverted.push_back(-x);
  EXPECT_FALSE(kabsch(octahedron, inverted));
}

TEST(Kabsch, WrongUseThrows) {
  const Points X(4, Eigen::Vector3d::Zero());
  EXPECT_THROW(kabsch(X, Points(3)), std::invalid_argument);
  EXPECT_THROW(kabsch(X, X, std::vector<double>(3, 1.0)), std::invalid_argument);
  EXPECT_THROW(kabsch(X, X, std::vector<double>{1, 1, -1, 1}), std::invalid_argument);
  EXPECT_THROW(umeyama(X, Points(5)), std::invalid_argument);
}

TEST(Umeyama, FindsScaleRotationAndTranslation) {
  Draw draw(8);
  for (int trial = 0; trial < 500; ++trial) {
    const Points X1 = draw.cloud(4 + trial);
    const double scale = std::exp(draw.uniform(-5, 5));
    const Pose truth{so3_exp(M_PI * draw.box()), draw.box()};
    const auto found = umeyama(X1, moved(X1, truth, scale));
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->scale / scale, 1, 1e-12);
    EXPECT_LT((found->pose.R - truth.R).norm(), 1e-12);
    EXPECT_LT((found->pose.t - truth.t).norm(), 1e-12 * (1 + scale));
  }
}

TEST(Umeyama, ScaleIsTheLeastSquaresScaleOfNoisyPoints) {
  Draw draw(9);
  const Points X1 = draw.cloud(40);
  Points X2 = moved(X1, {so3_exp({1, 2, -1}), {1, 2, 3}}, 2.5);
  for (auto& x : X2) x += 0.3 * draw.box();
  const auto found = umeyama(X1, X2);
  const auto cost = [&](double scale) {
    Points scaled;
    for (const auto& x : X1) scaled.push_back(scale * x);
    const Pose pose = *kabsch(scaled, X2);
    double sum = 0;
    for (std::size_t i = 0; i < X1.size(); ++i) sum += (X2[i] - pose * scaled[i]).squaredNorm();
    return sum;
  };
  EXPECT_LT(cost(found->scale), cost(found->scale * 1.001));
  EXPECT_LT(cost(found->scale), cost(found->scale * 0.999));
}

}  // namespace
}  // namespace framewise
