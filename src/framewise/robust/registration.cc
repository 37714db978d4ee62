// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/robust/registration.h"

#include <vector>

#include "framewise/geometry/alignment.h"
#include "framewise/geometry/so3.h"
#include "framewise/robust/bearings.h"
#include "framewise/robust/correspondences_check.h"
#include "framewise/robust/ransac.h"

namespace framewise {
namespace {

constexpr char kDoor[] = "estimate_registration";

class RegistrationProblem {
 public:
  using Model = Pose;
  static constexpr std::size_t kMaxModels = 1;

  RegistrationProblem(std::span<const Eigen::Vector3d> X1, std::span<const Eigen::Vector3d> X2,
                      const RegistrationOptions& options)
      : X1_(X1), X2_(X2), max_error_(options.max_error), columns_(X1.size(), 6, options.ransac.seed) {
    for (std::size_t i = 0; i < X1.size(); ++i) {
      for (int k = 0; k < 3; ++k) columns_.set(i, k, X1[i][k]), columns_.set(i, 3 + k, X2[i][k]);
    }
    inliers1_.reserve(X1.size());
    inliers2_.reserve(X1.size());
  }

  std::size_t size() const { return X1_.size(); }
  std::size_t sample_size() const { return 3; }

  void solve(std::span<const std::uint32_t> sample, Hypotheses<Pose, 1>& models) const {
    std::array<Eigen::Vector3d, 3> a, b;
    for (int k = 0; k < 3; ++k) a[k] = X1_[sample[k]], b[k] = X2_[sample[k]];
    if (const auto pose = kabsch(a, b)) models.push_back(*pose);
  }

  Tally score(const Pose& pose, const Judge& judge) const {
    const RowMajor3d R = pose.R;
    return score_distance(columns_, R.data(), pose.t.data(), judge);
  }

  // Kabsch of the inliers, until their number no longer grows.
  bool refine(Pose& pose) const {
    constexpr int kMaxRounds = 10;
    std::size_t before = 0;
    for (int round = 0; round < kMaxRounds; ++round) {
      gather(pose);
      if (inliers1_.size() < 3 || inliers1_.size() == before) break;
      before = inliers1_.size();
      const auto better = kabsch(inliers1_, inliers2_);
      if (!better) return false;
      pose = *better;
    }
    return before >= 3;
  }

  bool is_inlier(const Pose& pose, std::size_t i) const {
    return (pose * X1_[i] - X2_[i]).squaredNorm() < max_error_ * max_error_;
  }

 private:
  void gather(const Pose& pose) const {
    inliers1_.clear();
    inliers2_.clear();
    for (std::size_t i = 0; i < size(); ++i) {
      if (!is_inlier(pose, i)) continue;
      inliers1_.push_back(X1_[i]);
      inliers2_.push_back(X2_[i]);
    }
  }

  std::span<const Eigen::Vector3d> X1_, X2_;
  double max_error_;
  Columns columns_;
  mutable std::vector<Eigen::Vector3d> inliers1_, inliers2_;  // kept, so that refining allocates nothing
};

// Of least squares on points with the same isotropic noise in X2, its variance from the residuals: with
// right-perturbed rotation the residual's derivative is [-R [X1]x, I].
Matrix6d registration_covariance(std::span<const Eigen::Vector3d> X1, std::span<const Eigen::Vector3d> X2,
                                 const std::vector<std::uint8_t>& inliers, const Pose& pose) {
  Matrix6d information = Matrix6d::Zero();
  double squares = 0;
  int count = 0;
  for (std::size_t i = 0; i < X1.size(); ++i) {
    if (!inliers[i]) continue;
    Eigen::Matrix<double, 3, 6> J;
    J << -pose.R * skew(X1[i]), Eigen::Matrix3d::Identity();
    information += J.transpose() * J;
    squares += (pose * X1[i] - X2[i]).squaredNorm();
    ++count;
  }
  const double variance = squares / (3 * count - 6);
  return variance * information.inverse();
}

}  // namespace

void RegistrationOptions::check() const {
  ransac.check();
  check_positive(kDoor, "max_error", max_error);
  check_positive(kDoor, "min_inliers", min_inliers);
}

std::optional<Estimate> estimate_registration(std::span<const Eigen::Vector3d> X1,
                                              std::span<const Eigen::Vector3d> X2,
                                              const RegistrationOptions& options) {
  options.check();
  check_same_size(kDoor, "X1", X1.size(), "X2", X2.size());
  check_points(kDoor, "X1", X1);
  check_points(kDoor, "X2", X2);
  if (X1.size() < 3) return std::nullopt;

  RegistrationProblem problem(X1, X2, options);
  const auto found = ransac(problem, options.ransac, options.max_error);
  if (!found) return std::nullopt;

  Estimate estimate;
  estimate.cam2_from_cam1 = found->model;
  problem.refine(estimate.cam2_from_cam1);
  estimate.inliers.resize(X1.size());
  for (std::size_t i = 0; i < X1.size(); ++i) {
    estimate.inliers[i] = problem.is_inlier(estimate.cam2_from_cam1, i);
    estimate.num_inliers += estimate.inliers[i];
  }
  if (estimate.num_inliers < static_cast<std::size_t>(options.min_inliers)) return std::nullopt;
  Judge judge;
  judge.max_error = options.max_error;
  judge.scoring = options.ransac.scoring;
  estimate.score = problem.score(estimate.cam2_from_cam1, judge).cost;
  estimate.iterations = found->iterations;
  estimate.iterations_theory = found->iterations_theory;
  estimate.covariance = registration_covariance(X1, X2, estimate.inliers, estimate.cam2_from_cam1);
  return estimate;
}

}  // namespace framewise
