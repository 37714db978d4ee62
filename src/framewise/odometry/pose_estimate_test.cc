// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/odometry/pose_estimate.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "framewise/geometry/linear_algebra.h"
#include "framewise/geometry/so3.h"

namespace framewise {
namespace {

Vector6d random_vector(std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  Vector6d v;
  for (int i = 0; i < 6; ++i) v[i] = normal(random);
  return v;
}

PoseEstimate random_estimate(std::mt19937_64& random, double sigma = 1e-3) {
  const Vector6d motion = random_vector(random);
  Matrix6d root;
  for (int i = 0; i < 6; ++i) root.col(i) = sigma * random_vector(random);
  return {{so3_exp(motion.head<3>()), motion.tail<3>()}, root * root.transpose()};
}

Pose moved(const Pose& pose, const Vector6d& tangent) {
  return {pose.R * so3_exp(tangent.head<3>()), pose.t + tangent.tail<3>()};
}

Vector6d difference(const Pose& from, const Pose& to) {
  Vector6d tangent;
  tangent << so3_log(from.R.transpose() * to.R), to.t - from.t;
  return tangent;
}

// J S J' with J by numeric differentiation of f at no motion.
template <typename F>
Matrix6d carried(const F& f, const Matrix6d& covariance) {
  constexpr double kStep = 1e-6;
  Matrix6d J;
  for (int i = 0; i < 6; ++i)
    J.col(i) = (f(kStep * Vector6d::Unit(i)) - f(-kStep * Vector6d::Unit(i))) / (2 * kStep);
  return J * covariance * J.transpose();
}

TEST(PoseEstimate, CovariancesOfChainsAreThoseOfNumericDerivatives) {
  std::mt19937_64 random(1);
  for (int k = 0; k < 20; ++k) {
    const PoseEstimate a = random_estimate(random), b = random_estimate(random);
    const Pose &A = a.cam2_from_cam1, &B = b.cam2_from_cam1;
    const PoseEstimate chain = chained(a, b);
    EXPECT_LT((chain.cam2_from_cam1.matrix() - (A * B).matrix()).norm(), 1e-14);
    const Matrix6d of_chain =
        carried([&](const Vector6d& v) { return difference(A * B, moved(A, v) * B); }, a.covariance) +
        carried([&](const Vector6d& v) { return difference(A * B, A * moved(B, v)); }, b.covariance);
    EXPECT_LT((chain.covariance - of_chain).norm(), 1e-8 * of_chain.norm());

    const PoseEstimate step = between(a, b);
    const Pose motion = A * B.inverse();
    EXPECT_LT((step.cam2_from_cam1.matrix() - motion.matrix()).norm(), 1e-14);
    const Matrix6d of_step =
        carried([&](const Vector6d& v) { return difference(motion, moved(A, v) * B.inverse()); },
                a.covariance) +
        carried([&](const Vector6d& v) { return difference(motion, A * moved(B, v).inverse()); },
                b.covariance);
    EXPECT_LT((step.covariance - of_step).norm(), 1e-8 * of_step.norm());
  }
}

TEST(PoseEstimate, FusedErrorsAreSmallerAndWhatTheirCovarianceSays) {
  std::mt19937_64 random(2);
  double nees = 0;
  constexpr int kTrials = 2000;
  int fusions = 0;
  const PoseEstimate truth = random_estimate(random), other = random_estimate(random);
  const auto disturbed = [&](const Matrix6d& covariance) {
    const Cholesky<6> root(covariance);
    const Matrix6d L = root.L().triangularView<Eigen::Lower>();
    return PoseEstimate{moved(truth.cam2_from_cam1, L * random_vector(random)), covariance};
  };
  for (int k = 0; k < kTrials; ++k) {
    const auto both = fused(disturbed(truth.covariance), disturbed(other.covariance));
    if (!both) continue;
    ++fusions;
    const Vector6d error = difference(truth.cam2_from_cam1, both->cam2_from_cam1);
    nees += error.dot(Cholesky<6>(both->covariance).solve(error));
    EXPECT_LE(both->covariance.trace(), std::min(truth.covariance.trace(), other.covariance.trace()));
  }
  EXPECT_GT(fusions, 0.995 * kTrials);  // a thousandth is thought to contradict
  EXPECT_NEAR(nees / fusions, 6, 0.3);
}

TEST(PoseEstimate, ACertainEstimateIsTakenAsItIs) {
  std::mt19937_64 random(3);
  PoseEstimate a = random_estimate(random);
  const PoseEstimate certain{moved(a.cam2_from_cam1, 1e-4 * random_vector(random)), Matrix6d::Zero()};
  a.covariance = 1e-6 * Matrix6d::Identity();
  for (const auto& both : {fused(a, certain), fused(certain, a)}) {
    ASSERT_TRUE(both);
    EXPECT_LT(difference(certain.cam2_from_cam1, both->cam2_from_cam1).norm(), 1e-12);
  }
}

TEST(PoseEstimate, ContradictionsAndWhatIsNotKnownAreNotFused) {
  std::mt19937_64 random(4);
  const PoseEstimate a = random_estimate(random);
  PoseEstimate b = a;
  EXPECT_TRUE(fused(a, b));
  b.cam2_from_cam1.t.x() += 1;
  EXPECT_FALSE(fused(a, b));
  b = a;
  b.covariance(2, 2) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(fused(a, b));
  EXPECT_FALSE(fused({a.cam2_from_cam1}, {a.cam2_from_cam1}));
}

}  // namespace
}  // namespace framewise
