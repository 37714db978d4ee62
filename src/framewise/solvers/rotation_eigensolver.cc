// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/solvers/rotation_eigensolver.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "framewise/geometry/linear_algebra.h"
#include "framewise/geometry/so3.h"
#include "framewise/solvers/coplanar_normals.h"
#include "framewise/solvers/epipolar_moments.h"
#include "framewise/solvers/matching_sizes.h"
#include "framewise/solvers/relrot_5pt_kneip.h"
#include "framewise/solvers/rotation_npt.h"

namespace framewise {
namespace {

struct Minimum {
  Eigen::Matrix3d R;
  EpipolarMoments::Value value;
  double cost() const { return value.eigenvalues[0]; }
};

// Newton's method on the smallest eigenvalue, made positive definite and bounded by a radius (rad) that
// follows the success of the steps. Stops where the cost no longer falls.
Minimum minimise(const EpipolarMoments& moments, const Eigen::Matrix3d& start, double radius, double exact) {
  Minimum m{start, moments.evaluate(start)};
  for (int iteration = 0; iteration < 30 && m.cost() > exact; ++iteration) {
    const auto d = moments.derivatives(m.R, m.value);
    double damping = 0;
    const double scale = d.hessian.diagonal().cwiseAbs().maxCoeff();
    Cholesky<3> cholesky(d.hessian);
    while (!cholesky.positive_definite() && damping < 1e6 * scale) {
      damping = damping == 0 ? 0.1 * scale : 4 * damping;
      cholesky = Cholesky<3>(d.hessian + damping * Eigen::Matrix3d::Identity());
    }
    Eigen::Vector3d step = -cholesky.solve(d.gradient);
    if (!step.allFinite()) break;
    const double length = step.norm();
    if (length > radius) step *= radius / length;
    const Eigen::Matrix3d R = so3_exp(step) * m.R;
    const auto value = moments.evaluate(R);
    if (value.eigenvalues[0] < m.cost()) {
      const double gain = m.cost() - value.eigenvalues[0];
      m = {R, value};
      if (length > radius) radius *= 2;
      if (gain < 1e-9 * m.cost()) break;
    } else {
      if (length < 1e-7) break;
      radius = 0.25 * std::min(radius, length);
    }
  }
  return m;
}

// The two rotations of an approximate essential matrix: R = cof(E) -+ [t]x E for |t| = 1
// (Horn, Recovering baseline and orientation from essential matrix, 1990).
std::array<Eigen::Matrix3d, 2> rotations_of(const Eigen::Matrix3d& E) {
  Eigen::Matrix3d cofactors;
  for (int r = 0; r < 3; ++r) cofactors.row(r) = E.row((r + 1) % 3).cross(E.row((r + 2) % 3));
  int k = 0;
  for (int c = 1; c < 3; ++c)
    if (cofactors.col(c).squaredNorm() > cofactors.col(k).squaredNorm()) k = c;
  const Eigen::Vector3d t = cofactors.col(k).normalized();
  const double scale = std::sqrt(2.0) / E.norm();
  const Eigen::Matrix3d around = skew(t) * E * scale;
  return {nearest_rotation(scale * scale * cofactors - around),
          nearest_rotation(scale * scale * cofactors + around)};
}

using Bearings = std::span<const Bearing>;

// Points in front of both cameras with t, minus those with -t.
int votes(Bearings x1, Bearings x2, const Eigen::Matrix3d& R, const Eigen::Vector3d& t) {
  int sum = 0;
  for (std::size_t i = 0; i < x1.size(); ++i) {
    const Eigen::Vector3d h = R * x1[i], n = x2[i].cross(h);
    const double depth1 = t.cross(x2[i]).dot(n), depth2 = t.cross(h).dot(n);
    sum += (depth1 > 0 && depth2 > 0) - (depth1 < 0 && depth2 < 0);
  }
  return sum;
}

// Root mean square distance of x2 from R x1.
double parallax(Bearings x1, Bearings x2, const Eigen::Matrix3d& R) {
  double sum = 0;
  for (std::size_t i = 0; i < x1.size(); ++i) sum += (x2[i] - R * x1[i]).squaredNorm();
  return std::sqrt(sum / static_cast<double>(x1.size()));
}

// Of R and (2 t t' - I) R, t and -t, which all fit alike, the one with most points in front of the cameras.
struct Answer {
  RotationEigensolution solution;
  int votes;
};

Answer answer(Bearings x1, Bearings x2, const Minimum& m) {
  const Eigen::Vector3d t = m.value.eigenvectors.col(0);
  const Eigen::Matrix3d twin = 2 * t * (t.transpose() * m.R) - m.R;
  const int own_votes = votes(x1, x2, m.R, t), twin_votes = votes(x1, x2, twin, t);
  const bool take_twin = std::abs(twin_votes) > std::abs(own_votes);
  const int v = take_twin ? twin_votes : own_votes;
  return {{take_twin ? twin : m.R, v < 0 ? Eigen::Vector3d(-t) : t, m.value.eigenvalues}, std::abs(v)};
}

constexpr double kTurns[8][3] = {{1, 1, 1},    {-1, -1, 1}, {-1, 1, -1}, {1, -1, -1},
                                 {-1, -1, -1}, {1, 1, -1},  {1, -1, 1},  {-1, 1, 1}};

// The minima seen so far and what makes us content with the best.
class Search {
 public:
  Search(Bearings x1, Bearings x2, std::span<const double> weights)
      : x1_(x1), x2_(x2), moments_(x1, x2, weights) {}

  void run(const Eigen::Matrix3d& rotation_only, const std::optional<Eigen::Matrix3d>& guess);
  // Moments are sums of squares of what exact data make tiny: the points themselves give the lost half of the
  // digits.
  void sharpen(std::span<const double> weights);
  const RotationEigensolution& best() const { return best_->solution; }

 private:
  void attempt(const Eigen::Matrix3d& start);
  void attempt_five_point_rotations();
  bool content() const;

  Bearings x1_, x2_;
  EpipolarMoments moments_;
  double reach_ = 0;     // rad, first bound of a step
  double exact_ = 0;     // a cost that is rounding
  double expected_ = 0;  // a cost that the linear solution's residual explains
  std::optional<Answer> best_;
  int hits_ = 0;  // starts that ended in the best minimum
};

bool Search::content() const {
  if (!best_ || best_->votes < 0.75 * static_cast<double>(x1_.size())) return false;
  const double cost = best_->solution.eigenvalues[0];
  return cost <= exact_ || (cost <= expected_ && hits_ >= 2);
}

void Search::attempt(const Eigen::Matrix3d& start) {
  if (content()) return;
  const Minimum m = minimise(moments_, start, reach_, exact_);
  const double best_cost = best_ ? best_->solution.eigenvalues[0] : 0;
  const double equal = std::max(exact_, 1e-6 * best_cost);
  if (best_ && m.cost() > best_cost + equal) return;
  const Answer found = answer(x1_, x2_, m);
  if (best_ && m.cost() >= best_cost - equal) {
    ++hits_;
    if (found.votes > best_->votes) best_ = found;  // of two exact ones (a plane)
    return;
  }
  hits_ = 1;
  best_ = found;
}

// The rotations of five of the bearings, those first that fit all of them best.
void Search::attempt_five_point_rotations() {
  std::array<Bearing, 5> five1, five2;
  for (std::size_t i = 0; i < 5; ++i) five1[i] = x1_[i * x1_.size() / 5], five2[i] = x2_[i * x2_.size() / 5];
  const auto rotations = relrot_5pt_kneip(five1, five2);
  struct Start {
    double cost;
    std::size_t index;
  };
  Hypotheses<Start, 10> starts;
  for (std::size_t i = 0; i < rotations.size(); i += 2)
    starts.push_back({moments_.evaluate(rotations[i]).eigenvalues[0], i});
  std::sort(starts.begin(), starts.end(), [](const Start& a, const Start& b) { return a.cost < b.cost; });
  for (std::size_t i = 0; i < std::min<std::size_t>(starts.size(), 4); ++i)
    attempt(rotations[starts[i].index]);
}

void Search::run(const Eigen::Matrix3d& rotation_only, const std::optional<Eigen::Matrix3d>& guess) {
  const double N = static_cast<double>(x1_.size());
  reach_ = std::clamp(parallax(x1_, x2_, rotation_only), 1e-9, 0.5);
  exact_ = 1e-15 * moments_.total();
  double residual = 0;
  const Eigen::Matrix3d E = moments_.linear_solution(residual);
  // Noise leaves N - 5 squares in the cost where it leaves N - 8 in the linear one, which has |e|^2 = 2 for
  // |t| = 1.
  if (N > 8) expected_ = 2 * residual * 4 * (N - 5) / (N - 8);

  if (guess) attempt(*guess);
  attempt(rotation_only);
  if (N >= 8 && !content()) attempt(rotations_of(E)[0]);
  if (!content()) attempt_five_point_rotations();
  for (const auto& turn : kTurns)
    attempt(so3_exp(reach_ * Eigen::Vector3d(turn[0], turn[1], turn[2])) * rotation_only);
}

void Search::sharpen(std::span<const double> weights) {
  RotationEigensolution& s = best_->solution;
  if (s.eigenvalues[0] > exact_) return;
  const auto sharp = polish_coplanar_normals(x1_, x2_, {s.R, s.t}, reach_, weights);
  if (!sharp) return;
  s.R = sharp->R, s.t = sharp->t;
}

}  // namespace

std::optional<RotationEigensolution> rotation_eigensolver(std::span<const Bearing> x1,
                                                          std::span<const Bearing> x2,
                                                          std::optional<Eigen::Matrix3d> guess,
                                                          std::span<const double> weights) {
  check_matching_sizes("rotation_eigensolver", x1.size(), x2.size(), weights.size());
  if (x1.size() < 5) return std::nullopt;
  const auto rotation_only = rotation_npt(x1, x2, weights);
  if (!rotation_only) return std::nullopt;

  Search search(x1, x2, weights);
  search.run(*rotation_only, guess);
  search.sharpen(weights);
  return search.best();
}

}  // namespace framewise
