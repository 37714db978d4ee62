// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "framewise/geometry/triangulation.h"
#include "framewise/solvers/decompose_essential.h"
#include "framewise/solvers/essential_8pt.h"
#include "framewise/solvers/refine_relative_pose.h"
#include "framewise/solvers/relrot_5pt_kneip.h"
#include "framewise/solvers/rotation_eigensolver.h"
#include "framewise/solvers/translation_2pt.h"
#include "study_methods.h"

#ifdef FRAMEWISE_BENCH_OPENGV
#include <opengv/relative_pose/CentralRelativeAdapter.hpp>
#include <opengv/relative_pose/methods.hpp>
#endif

// The frame-to-frame scheme of the literature around a solver that gives rotations alone, with the parts that
// may be at fault exchangeable.
namespace framewise::bench {

using Rotations = std::vector<Eigen::Matrix3d>;  // cam2_from_cam1
using Bearings = std::vector<Bearing>;
using RotationSolver = std::function<Rotations(const Bearings& x1, const Bearings& x2)>;

inline Rotations our_kneip(const Bearings& x1, const Bearings& x2) {
  const auto found = relrot_5pt_kneip(std::span<const Bearing>(x1), std::span<const Bearing>(x2));
  return {found.begin(), found.end()};
}

inline Rotations our_eigensolver(const Bearings& x1, const Bearings& x2) {
  const auto found = rotation_eigensolver(x1, x2);
  return found ? Rotations{found->R} : Rotations{};
}

inline Rotations our_eight_point(const Bearings& x1, const Bearings& x2) {
  Rotations rotations;
  if (const auto E = essential_8pt(x1, x2))
    for (const Pose& pose : decompose_essential(*E)) rotations.push_back(pose.R);
  return rotations;
}

// The 8-point solution, then least squares on the Sampson distance.
inline Rotations our_refined(const Bearings& x1, const Bearings& x2) {
  const auto E = essential_8pt(x1, x2);
  const auto vote = E ? choose_by_cheirality(*E, x1, x2) : std::nullopt;
  if (!vote) return {};
  return {refine_relative_pose(vote->cam2_from_cam1, x1, x2).pose.R};
}

#ifdef FRAMEWISE_BENCH_OPENGV
// The motions of OpenGV's essential matrices; it solves for view 2 to view 1.
template <typename Essentials>
Rotations rotations_of_essentials(const Essentials& essentials) {
  Rotations rotations;
  for (const auto& E : essentials)
    if (E.real().allFinite() && E.imag().norm() <= 1e-6 * E.norm())
      for (const Pose& pose : decompose_essential(E.real().transpose())) rotations.push_back(pose.R);
  return rotations;
}

inline Rotations opengv_nister(const Bearings& x1, const Bearings& x2) {
  const opengv::bearingVectors_t f1(x1.begin(), x1.end()), f2(x2.begin(), x2.end());
  const opengv::relative_pose::CentralRelativeAdapter adapter(f1, f2);
  std::vector<opengv::complexEssential_t> complex;
  for (const auto& E : opengv::relative_pose::fivept_nister(adapter))
    complex.push_back(E.template cast<std::complex<double>>());
  return rotations_of_essentials(complex);
}

inline Rotations opengv_eight_point(const Bearings& x1, const Bearings& x2) {
  const opengv::bearingVectors_t f1(x1.begin(), x1.end()), f2(x2.begin(), x2.end());
  const opengv::relative_pose::CentralRelativeAdapter adapter(f1, f2);
  const opengv::complexEssential_t E =
      opengv::relative_pose::eightpt(adapter).template cast<std::complex<double>>();
  return rotations_of_essentials(std::vector<opengv::complexEssential_t>{E});
}

// Of the first five bearings: OpenGV's function takes five and, built without assertions, does not look.
// Its rotations take view 2 to view 1: ours, transposed.
inline Rotations opengv_kneip(const Bearings& x1, const Bearings& x2) {
  const opengv::bearingVectors_t f1(x1.begin(), x1.end()), f2(x2.begin(), x2.end());
  const opengv::relative_pose::CentralRelativeAdapter adapter(f1, f2);
  Rotations rotations;
  for (const auto& R : opengv::relative_pose::fivept_kneip(adapter, {0, 1, 2, 3, 4}))
    if (R.allFinite()) rotations.push_back(R.transpose());
  return rotations;
}

// What six to eight bearings do to it. It copies them into two arrays of five columns, f1 and f2, on the
// stack; columns 6 to 8 of the lower array land on the first ones of the upper, after those were filled.
// (What the upper array spills over does not matter to the answer, if the program survives it.) Here f1 is
// the lower.
inline Rotations opengv_kneip_overrun(const Bearings& x1, const Bearings& x2) {
  Bearings f1(x1.begin(), x1.begin() + 5), f2(x2.begin(), x2.begin() + 5);
  for (std::size_t i = 5; i < x1.size(); ++i) f2[i - 5] = x1[i];
  return opengv_kneip(f1, f2);
}

// Started, as its adapter has it when nothing is said, from no rotation.
inline Rotations opengv_eigensolver(const Bearings& x1, const Bearings& x2) {
  const opengv::bearingVectors_t f1(x1.begin(), x1.end()), f2(x2.begin(), x2.end());
  const opengv::relative_pose::CentralRelativeAdapter adapter(f1, f2);
  const opengv::rotation_t R = opengv::relative_pose::eigensolver(adapter);
  return R.allFinite() ? Rotations{R.transpose()} : Rotations{};
}
#endif

struct Pairs {
  Bearings x1, x2;
  std::size_t size() const { return x1.size(); }
  void add(const Bearing& a, const Bearing& b) { x1.push_back(a), x2.push_back(b); }
};

inline Pairs pick(const Pairs& pairs, std::size_t count, testing::Random& random) {
  std::vector<std::size_t> order(pairs.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  Pairs picked;
  for (std::size_t i = 0; i < std::min(count, order.size()); ++i) {
    std::swap(order[i], order[i + random.index(order.size() - i)]);
    picked.add(pairs.x1[order[i]], pairs.x2[order[i]]);
  }
  return picked;
}

inline double residual(InlierMeasure measure, const Pose& pose, const Bearing& x1, const Bearing& x2) {
  if (measure == InlierMeasure::kBearingEuclidean) return (x2 - pose.R * x1).norm();
  const auto point = triangulate_midpoint(pose, x1, x2);
  if (!point || !point->in_front()) return std::numeric_limits<double>::infinity();
  return std::hypot(point->X1.normalized().cross(x1).norm(),
                    (pose * point->X1).normalized().cross(x2).norm());
}

// Sum over all of min(r^2 / T^2, 1).
inline double cost(InlierMeasure measure, const Pose& pose, const Pairs& pairs, double max_error) {
  double sum = 0;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const double r = residual(measure, pose, pairs.x1[i], pairs.x2[i]) / max_error;
    sum += std::min(r * r, 1.0);
  }
  return sum;
}

// The translation of each rotation from two of the pairs, drawn at random, as the literature does.
inline Pose with_two_point_translation(const Eigen::Matrix3d& R, const Pairs& pairs,
                                       testing::Random& random) {
  const Pairs two = pick(pairs, 2, random);
  const auto t = translation_2pt({two.x1[0], two.x1[1]}, {two.x2[0], two.x2[1]}, R);
  return {R, t ? *t : Eigen::Vector3d(0, 0, 1)};
}

struct Scheme {
  RotationSolver solver;
  std::size_t sample = 5, last_sample = 8;  // bearings of a hypothesis, and of the answer
  InlierMeasure measure = InlierMeasure::kBearingEuclidean;
  int max_iterations = 200;
};

struct BestPose {
  std::optional<Pose> pose;
  double cost = std::numeric_limits<double>::infinity();
};

inline BestPose best_of(const Rotations& rotations, const Scheme& scheme, const Pairs& pairs,
                        double max_error, testing::Random& random) {
  BestPose best;
  for (const Eigen::Matrix3d& R : rotations) {
    const Pose pose = with_two_point_translation(R, pairs, random);
    const double c = cost(scheme.measure, pose, pairs, max_error);
    if (c < best.cost) best = {pose, c};
  }
  return best;
}

inline Pairs ransac_inliers(const Scheme& scheme, const Pairs& pairs, double max_error,
                            testing::Random& random) {
  BestPose best;
  double wanted = scheme.max_iterations;
  for (int i = 0; i < scheme.max_iterations && i < wanted; ++i) {
    const Pairs sample = pick(pairs, scheme.sample, random);
    const BestPose next = best_of(scheme.solver(sample.x1, sample.x2), scheme, pairs, max_error, random);
    if (!(next.cost < best.cost)) continue;
    best = next;
    const double share = std::clamp(1 - best.cost / static_cast<double>(pairs.size()), 0.01, 0.999);
    wanted = std::max(20.0, std::log(0.01) / std::log1p(-std::pow(share, double(scheme.sample))));
  }
  Pairs kept;
  if (!best.pose) return kept;
  for (std::size_t i = 0; i < pairs.size(); ++i)
    if (residual(scheme.measure, *best.pose, pairs.x1[i], pairs.x2[i]) < max_error)
      kept.add(pairs.x1[i], pairs.x2[i]);
  return kept;
}

// RANSAC, RANSAC among its inliers with a tighter threshold, then the solver on some of what remains; drawn
// again where it finds nothing.
inline std::optional<Pose> solve_by_scheme(const Scheme& scheme, const RobustProblem& p,
                                           testing::Random& random) {
  const bool euclidean = scheme.measure == InlierMeasure::kBearingEuclidean;
  const double first = euclidean ? kEuclideanFirst : kReprojectionFirst;
  const double second = euclidean ? kEuclideanSecond : kReprojectionSecond;
  const Pairs inliers = ransac_inliers(scheme, {p.x1, p.x2}, first, random);
  if (inliers.size() < scheme.last_sample) return std::nullopt;
  const Pairs kept = ransac_inliers(scheme, inliers, second, random);
  if (kept.size() < scheme.last_sample) return std::nullopt;
  for (int i = 0; i < scheme.max_iterations; ++i) {
    const Pairs sample = pick(kept, scheme.last_sample, random);
    const BestPose best = best_of(scheme.solver(sample.x1, sample.x2), scheme, kept, second, random);
    if (best.pose) return best.pose;
  }
  return std::nullopt;
}

}  // namespace framewise::bench
