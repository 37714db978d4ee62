// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Data that fit no motion, or many: an estimate or none, never an exception and never a rotation that is
// none.
#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "framewise/robust/absolute_pose.h"
#include "framewise/robust/registration.h"
#include "framewise/robust/relative_pose.h"
#include "framewise/robust/robust_problems_for_tests.h"
#include "framewise/robust/translation.h"

namespace framewise {
namespace {

using testing::Random;

enum class Arrangement { kLine, kPlane, kOnePoint, kTwoPoints, kRays, kAnything };
constexpr Arrangement kArrangements[] = {Arrangement::kLine,     Arrangement::kPlane,
                                         Arrangement::kOnePoint, Arrangement::kTwoPoints,
                                         Arrangement::kRays,     Arrangement::kAnything};

struct Views {
  std::vector<Eigen::Vector3d> X1, X2;
  std::vector<Bearing> x1, x2;
};

// Points of that arrangement but for `off` of them, in metres or in millimetres or in kilometres, seen after
// a motion that is large, tiny or none, with noise that is none or as large as the image.
Views views_of(Arrangement arrangement, Random& random) {
  const double off = std::pow(10, random.uniform(-12, -1)), unit = std::pow(10, random.uniform(-3, 3));
  const double noise = std::pow(10, random.uniform(-12, 0)), baseline = std::pow(10, random.uniform(-12, 0));
  const Eigen::Vector3d origin = Eigen::Vector3d(0, 0, 4) + 0.3 * random.normal3(), other = random.normal3();
  const Eigen::Vector3d along = random.direction(), across = random.direction();
  const Pose motion{so3_exp(random.uniform(0, 0.5) * random.direction()), baseline * random.direction()};
  Views views;
  for (int i = 0; i < 40; ++i) {
    const double a = random.uniform(-1, 1), b = random.uniform(-1, 1);
    Eigen::Vector3d X = origin + off * random.normal3();
    if (arrangement == Arrangement::kLine) X += a * along;
    if (arrangement == Arrangement::kPlane) X += a * along + b * across;
    if (arrangement == Arrangement::kTwoPoints) X += (i % 2) * other;
    if (arrangement == Arrangement::kRays) X *= std::exp(2 * a);
    if (arrangement == Arrangement::kAnything) X += random.normal3();
    views.X1.push_back(unit * X);
    views.X2.push_back(unit * (motion * X + noise * random.normal3()));
    views.x1.push_back(X.normalized());
    views.x2.push_back((motion * X / X.norm() + noise * random.normal3()).normalized());
  }
  return views;
}

void expect_rotation_or_none(const std::optional<Estimate>& estimate) {
  if (!estimate) return;
  const Eigen::Matrix3d& R = estimate->cam2_from_cam1.R;
  EXPECT_LT((R.transpose() * R - Eigen::Matrix3d::Identity()).norm(), 1e-6);
  EXPECT_GT(R.determinant(), 0);
  EXPECT_TRUE(estimate->cam2_from_cam1.t.allFinite());
}

class HostileData : public ::testing::TestWithParam<Arrangement> {
 protected:
  template <typename Estimator>
  void try_out(int trials, const Estimator& estimator) {
    Random random(static_cast<std::uint64_t>(GetParam()) + 1);
    for (int trial = 0; trial < trials; ++trial) {
      const Views views = views_of(GetParam(), random);
      std::optional<Estimate> estimate;
      ASSERT_NO_THROW(estimate = estimator(views)) << trial;
      expect_rotation_or_none(estimate);
    }
  }
};

RansacOptions few_iterations() {
  RansacOptions ransac;
  ransac.min_iterations = 20;
  ransac.max_iterations = 40;
  return ransac;
}

TEST_P(HostileData, AbsolutePose) {
  AbsolutePoseOptions options;
  options.ransac = few_iterations();
  try_out(300, [&](const Views& v) { return estimate_absolute_pose(v.X1, v.x2, options); });
}

TEST_P(HostileData, Registration) {
  RegistrationOptions options;
  options.ransac = few_iterations();
  try_out(300, [&](const Views& v) { return estimate_registration(v.X1, v.X2, options); });
}

TEST_P(HostileData, RelativePoseByEverySolverAndMeasure) {
  for (const RelativePoseSolver solver :
       {RelativePoseSolver::kEightPoint, RelativePoseSolver::kSevenPoint, RelativePoseSolver::kNister5pt,
        RelativePoseSolver::kStewenius5pt, RelativePoseSolver::kKneip5ptRotation,
        RelativePoseSolver::kEigensolver})
    for (const InlierMeasure measure :
         {InlierMeasure::kSampson, InlierMeasure::kReprojection, InlierMeasure::kBearingEuclidean}) {
      SCOPED_TRACE(std::to_string(static_cast<int>(solver)) + " " +
                   std::to_string(static_cast<int>(measure)));
      RelativePoseOptions options;
      options.ransac = few_iterations();
      options.solver = solver;
      options.measure = measure;
      try_out(10, [&](const Views& v) { return estimate_relative_pose(v.x1, v.x2, options); });
    }
}

TEST_P(HostileData, Translation) {
  TranslationOptions options;
  options.ransac = few_iterations();
  try_out(300, [&](const Views& v) {
    return estimate_translation(v.x1, v.x2, Eigen::Matrix3d::Identity(), options);
  });
}

INSTANTIATE_TEST_SUITE_P(Arrangements, HostileData, ::testing::ValuesIn(kArrangements));

}  // namespace
}  // namespace framewise
