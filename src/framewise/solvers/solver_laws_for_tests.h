// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "framewise/geometry/pose.h"
#include "framewise/geometry/so3.h"
#include "framewise/solvers/problems_for_tests.h"

// The laws that every relative-pose solver meets. A solver is described by a struct and enrolled by one line:
//
//   struct Relpose5pt {
//     static constexpr std::size_t kPoints = 5;
//     // What the best solution reaches on exact bearings; kNotHere where the solver's theory ends (say why).
//     static Accuracy accuracy(Scene scene) { return scene == Scene::kRandom ? Accuracy{1e-8, 1e-8} : ...; }
//     // May look at problem.cam2_from_cam1 for what the solver is told (a known rotation, gravity), nothing
//     else. static auto solve(const TwoViewProblem& problem) { return relpose_5pt(...); }  // a range of Pose
//   };
//   INSTANTIATE_TYPED_TEST_SUITE_P(Relpose5pt, SolverLaws, Relpose5pt);
namespace framewise::testing {

inline constexpr double kNotHere = std::numeric_limits<double>::infinity();

struct Accuracy {
  double rotation;   // rad
  double direction;  // rad, of the translation; kNotHere for solvers that give rotations alone
};

// Exact data at a rare near-singular choice of points are allowed to fail this often (bench/solvers counts
// them).
inline constexpr int kTrials = 200, kAllowedFailures = 2;

inline TwoViewProblem swapped(const TwoViewProblem& p) {
  return {p.cam2_from_cam1.inverse(), p.X2, p.X1, p.x2, p.x1};
}

// The same points and cameras in axes turned by Q1 and Q2.
inline TwoViewProblem turned(TwoViewProblem p, const Eigen::Matrix3d& Q1, const Eigen::Matrix3d& Q2) {
  for (auto* xs : {&p.X1, &p.x1}) {
    for (auto& x : *xs) x = Q1 * x;
  }
  for (auto* xs : {&p.X2, &p.x2}) {
    for (auto& x : *xs) x = Q2 * x;
  }
  p.cam2_from_cam1 = {Q2 * p.cam2_from_cam1.R * Q1.transpose(), Q2 * p.cam2_from_cam1.t};
  return p;
}

// Does a solution reach the wanted accuracy? The direction is not asked where there is no translation.
template <typename Poses>
bool contains(const Poses& poses, const Pose& wanted, const Accuracy& accuracy) {
  return std::any_of(poses.begin(), poses.end(), [&](const Pose& pose) {
    return rotation_error(pose.R, wanted.R) < accuracy.rotation &&
           (accuracy.direction == kNotHere || wanted.t.norm() == 0 ||
            direction_error(pose.t, wanted.t) < accuracy.direction);
  });
}

inline bool is_rigid(const Pose& pose) {
  return (pose.R.transpose() * pose.R - Eigen::Matrix3d::Identity()).norm() < 1e-9 &&
         pose.R.determinant() > 0 && pose.t.allFinite();
}

// Inputs on which no answer is asked, only that the solver comes back with rigid motions or with none.
inline std::vector<TwoViewProblem> degenerate_problems(std::size_t size, Random& random) {
  std::vector<TwoViewProblem> all;
  const auto add = [&](auto&& change) {
    TwoViewProblem p = make_problem(Scene::kRandom, size, random);
    change(p);
    all.push_back(p);
  };
  add([](TwoViewProblem& p) {  // one point, repeated
    std::fill(p.x1.begin(), p.x1.end(), p.x1[0]);
    std::fill(p.x2.begin(), p.x2.end(), p.x2[0]);
  });
  add([](TwoViewProblem& p) { p.x1.back() = p.x1[0], p.x2.back() = p.x2[0]; });  // one point twice
  add([](TwoViewProblem& p) {                                                    // points on a line
    for (std::size_t i = 0; i < p.x1.size(); ++i) {
      const Eigen::Vector3d X1 = Eigen::Vector3d(-1, 0.2, 4) + 0.4 * i * Eigen::Vector3d(1, 0.5, 0.3);
      p.x1[i] = X1.normalized();
      p.x2[i] = (p.cam2_from_cam1 * X1).normalized();
    }
  });
  add([](TwoViewProblem& p) { p.x2 = p.x1; });  // no motion
  add([](TwoViewProblem& p) {                   // opposite bearings
    for (std::size_t i = 0; i < p.x1.size(); ++i) p.x2[i] = -p.x1[i];
  });
  add([](TwoViewProblem& p) {  // axes of the camera
    for (std::size_t i = 0; i < p.x1.size(); ++i) p.x1[i] = p.x2[i] = Eigen::Vector3d::Unit(i % 3);
  });
  add([&](TwoViewProblem& p) {  // points that have nothing to do with each other
    for (auto& x : p.x2) x = random.direction();
  });
  for (int k = 0; k < 20; ++k) all.push_back(make_problem(Scene::kPureRotation, size, random));
  for (int k = 0; k < 20; ++k) all.push_back(make_problem(Scene::kPlanar, size, random));
  return all;
}

template <typename Solver>
class SolverLaws : public ::testing::Test {
 protected:
  // How many of kTrials problems the solver misses.
  template <typename Change>
  static int failures(Scene scene, Change change) {
    Random random(static_cast<std::uint64_t>(scene) + 1);
    int count = 0;
    for (int trial = 0; trial < kTrials; ++trial) {
      const TwoViewProblem p = change(make_problem(scene, Solver::kPoints, random), random);
      count += !contains(Solver::solve(p), p.cam2_from_cam1, Solver::accuracy(scene));
    }
    return count;
  }

  template <typename Change>
  static void expect_exact_everywhere(Change change) {
    for (const Scene scene : kAllScenes) {
      if (Solver::accuracy(scene).rotation == kNotHere) continue;
      EXPECT_LE(failures(scene, change), kAllowedFailures) << name(scene);
    }
  }
};

TYPED_TEST_SUITE_P(SolverLaws);

TYPED_TEST_P(SolverLaws, ExactOnExactBearings) {
  this->expect_exact_everywhere([](const TwoViewProblem& p, Random&) { return p; });
}

TYPED_TEST_P(SolverLaws, ExactWithTheViewsSwapped) {
  this->expect_exact_everywhere([](const TwoViewProblem& p, Random&) { return swapped(p); });
}

TYPED_TEST_P(SolverLaws, ExactInAnyAxes) {
  this->expect_exact_everywhere([](const TwoViewProblem& p, Random& random) {
    return turned(p, so3_exp(2 * random.normal3()), so3_exp(2 * random.normal3()));
  });
}

// Not the true solution only: all of them turn with the axes.
TYPED_TEST_P(SolverLaws, AllSolutionsTurnWithTheAxes) {
  Random random(11);
  int differ = 0;
  for (int trial = 0; trial < kTrials; ++trial) {
    const TwoViewProblem p = make_problem(Scene::kRandom, TypeParam::kPoints, random);
    const Eigen::Matrix3d Q1 = so3_exp(random.normal3()), Q2 = so3_exp(random.normal3());
    const auto before = TypeParam::solve(p);
    const auto after = TypeParam::solve(turned(p, Q1, Q2));
    const Accuracy accuracy{1e-4,
                            TypeParam::accuracy(Scene::kRandom).direction == kNotHere ? kNotHere : 1e-4};
    differ +=
        before.size() != after.size() || !std::all_of(before.begin(), before.end(), [&](const Pose& pose) {
          return contains(after, Pose{Q2 * pose.R * Q1.transpose(), Q2 * pose.t}, accuracy);
        });
  }
  EXPECT_LE(differ, kAllowedFailures);
}

TYPED_TEST_P(SolverLaws, EverySolutionIsARigidMotion) {
  Random random(12);
  for (const Scene scene : kAllScenes) {
    for (int trial = 0; trial < 50; ++trial) {
      const TwoViewProblem p = make_problem(scene, TypeParam::kPoints, random);
      for (const Pose& pose : TypeParam::solve(p)) EXPECT_TRUE(is_rigid(pose)) << name(scene);
    }
  }
}

TYPED_TEST_P(SolverLaws, DegenerateInputComesBackWithRigidMotionsOrNone) {
  Random random(13);
  for (const TwoViewProblem& p : degenerate_problems(TypeParam::kPoints, random)) {
    for (const Pose& pose : TypeParam::solve(p)) EXPECT_TRUE(is_rigid(pose));
  }
}

TYPED_TEST_P(SolverLaws, NotANumberComesBackWithNone) {
  Random random(14);
  TwoViewProblem p = make_problem(Scene::kRandom, TypeParam::kPoints, random);
  p.x2[0].y() = std::numeric_limits<double>::quiet_NaN();
  for (const Pose& pose : TypeParam::solve(p)) EXPECT_TRUE(is_rigid(pose));
  p = make_problem(Scene::kRandom, TypeParam::kPoints, random);
  p.x1[1].z() = std::numeric_limits<double>::infinity();
  for (const Pose& pose : TypeParam::solve(p)) EXPECT_TRUE(is_rigid(pose));
}

TYPED_TEST_P(SolverLaws, SameInputGivesTheSameBytes) {
  Random random(15);
  const TwoViewProblem p = make_problem(Scene::kRandom, TypeParam::kPoints, random);
  const auto a = TypeParam::solve(p), b = TypeParam::solve(p);
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_EQ(a[i].matrix(), b[i].matrix());
}

REGISTER_TYPED_TEST_SUITE_P(SolverLaws, ExactOnExactBearings, ExactWithTheViewsSwapped, ExactInAnyAxes,
                            AllSolutionsTurnWithTheAxes, EverySolutionIsARigidMotion,
                            DegenerateInputComesBackWithRigidMotionsOrNone, NotANumberComesBackWithNone,
                            SameInputGivesTheSameBytes);

}  // namespace framewise::testing
