// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/robust/relative_pose.h"

#include <array>
#include <vector>

#include "framewise/robust/correspondences_check.h"
#include "framewise/robust/ransac.h"
#include "framewise/solvers/decompose_essential.h"
#include "framewise/solvers/essential_8pt.h"

namespace framewise {
namespace {

constexpr char kDoor[] = "estimate_relative_pose";
using RowMajor3d = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

class EightPointProblem {
 public:
  using Model = Eigen::Matrix3d;  // E
  static constexpr std::size_t kMaxModels = 1;

  EightPointProblem(std::span<const Bearing> x1, std::span<const Bearing> x2,
                    const RelativePoseOptions& options)
      : x1_(x1), x2_(x2), columns_(x1.size(), 6, options.ransac.seed), max_error_(options.max_error) {
    for (std::size_t i = 0; i < x1.size(); ++i) {
      for (int k = 0; k < 3; ++k) columns_.set(i, k, x1[i][k]), columns_.set(i, 3 + k, x2[i][k]);
    }
    for (auto* list : {&inliers1_, &inliers2_}) list->reserve(x1.size());
    weights_.reserve(x1.size());
  }

  std::size_t size() const { return x1_.size(); }
  std::size_t sample_size() const { return 8; }

  void solve(std::span<const std::uint32_t> sample, Hypotheses<Model, kMaxModels>& models) {
    std::array<Bearing, 8> a, b;
    for (int k = 0; k < 8; ++k) a[k] = x1_[sample[k]], b[k] = x2_[sample[k]];
    if (const auto E = essential_8pt(a, b)) models.push_back(*E);
  }

  Tally score(const Model& E, const Judge& judge) {
    const RowMajor3d rows = E;
    return score_sampson_sphere(columns_, rows.data(), judge);
  }

  // The linear solution of all inliers, weighted for Sampson's distance; the threshold shrinks to the one
  // asked.
  bool refine(Model& E) {
    for (const double widening : {4.0, 2.5, 1.6, 1.0, 1.0, 1.0}) {
      inliers1_.clear(), inliers2_.clear(), weights_.clear();
      for (std::size_t i = 0; i < x1_.size(); ++i) {
        const Residual r = residual(E, i);
        if (r.squared_error() > widening * widening * max_error_ * max_error_) continue;
        inliers1_.push_back(x1_[i]);
        inliers2_.push_back(x2_[i]);
        weights_.push_back(1 / r.squared_gradient);
      }
      if (inliers1_.size() < 8) return false;
      const auto better = essential_8pt(inliers1_, inliers2_, weights_);
      if (!better) return false;
      E = *better;
    }
    return true;
  }

  bool is_inlier(const Model& E, std::size_t i) const {
    return residual(E, i).squared_error() < max_error_ * max_error_;
  }

 private:
  struct Residual {
    double algebraic, squared_gradient;
    double squared_error() const { return algebraic * algebraic / squared_gradient; }
  };
  // Sampson's distance on the unit sphere.
  Residual residual(const Model& E, std::size_t i) const {
    const Eigen::Vector3d a = E * x1_[i], b = E.transpose() * x2_[i];
    const double r = a.dot(x2_[i]);
    return {r, a.squaredNorm() + b.squaredNorm() - 2 * r * r};
  }

  std::span<const Bearing> x1_, x2_;
  Columns columns_;
  double max_error_;
  std::vector<Bearing> inliers1_, inliers2_;
  std::vector<double> weights_;
};

std::vector<Bearing> normalized(std::span<const Bearing> bearings) {
  std::vector<Bearing> result(bearings.begin(), bearings.end());
  for (Bearing& x : result) x.normalize();
  return result;
}

}  // namespace

void RelativePoseOptions::check() const {
  ransac.check();
  check_positive(kDoor, "max_error", max_error);
  check_positive(kDoor, "min_inliers", min_inliers);
}

std::optional<Estimate> estimate_relative_pose(std::span<const Bearing> x1, std::span<const Bearing> x2,
                                               const RelativePoseOptions& options) {
  options.check();
  check_same_size(kDoor, "x1", x1.size(), "x2", x2.size());
  check_bearings(kDoor, "x1", x1);
  check_bearings(kDoor, "x2", x2);
  if (x1.size() < 8) return std::nullopt;

  const std::vector<Bearing> unit1 = normalized(x1), unit2 = normalized(x2);
  EightPointProblem problem(unit1, unit2, options);
  const auto found = ransac(problem, options.ransac, options.max_error);
  if (!found) return std::nullopt;

  Estimate estimate;
  std::vector<Bearing> inliers1, inliers2;
  estimate.inliers.resize(x1.size());
  for (std::size_t i = 0; i < x1.size(); ++i) {
    estimate.inliers[i] = problem.is_inlier(found->model, i);
    if (!estimate.inliers[i]) continue;
    ++estimate.num_inliers;
    inliers1.push_back(unit1[i]);
    inliers2.push_back(unit2[i]);
  }
  if (estimate.num_inliers < static_cast<std::size_t>(options.min_inliers)) return std::nullopt;
  const auto vote = choose_by_cheirality(found->model, inliers1, inliers2);
  if (!vote) return std::nullopt;
  estimate.cam2_from_cam1 = vote->cam2_from_cam1;
  estimate.score = found->tally.cost;
  estimate.iterations = found->iterations;
  estimate.iterations_theory = found->iterations_theory;
  return estimate;
}

}  // namespace framewise
