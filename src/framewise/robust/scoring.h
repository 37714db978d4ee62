// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "framewise/robust/ransac_options.h"

// What a hypothesis costs over all correspondences: plain loops over columns of floats, compiled for several
// instruction sets and chosen when the program starts. The order of every sum is fixed and no product is
// fused with an addition, so that all of them give the same bits. No Eigen here: a header of templates
// compiled under two instruction sets in one program breaks the one-definition rule.
namespace framewise {

// Numbers of a correspondence in columns, in a shuffled order, so that the first ones are a fair sample.
class Columns {
 public:
  static constexpr std::size_t kMaxWidth = 6;
  static constexpr std::size_t kLanes = 16;  // rows are filled up to a multiple with NaN: never an inlier

  Columns(std::size_t rows, std::size_t width, std::uint64_t seed);

  std::size_t rows() const { return order_.size(); }
  std::size_t padded_rows() const { return padded_; }
  // The place of the correspondence in the columns.
  void set(std::size_t correspondence, std::size_t column, double value) {
    values_[column * padded_ + order_[correspondence]] = static_cast<float>(value);
  }
  const float* column(std::size_t i) const { return values_.data() + i * padded_; }

 private:
  std::size_t padded_;
  std::vector<std::uint32_t> order_;
  std::vector<float> values_;
};

// How a hypothesis is judged: the threshold, the price, and when to give up.
struct Judge {
  double max_error = 1;  // T
  Scoring scoring = Scoring::kMsac;
  double cost_bound = std::numeric_limits<double>::infinity();  // give up when the sum passes it
  // Wald's test: give up when an inlier share this low or less explains the points seen so far by more than
  // `hopeless_odds` better than `good_share` does. No test where good_share <= bad_share.
  //   Matas and Chum, Randomized RANSAC with Sequential Probability Ratio Test, ICCV 2005.
  double good_share = 0;
  double bad_share = 0;
  double hopeless_odds = 1e4;
};

struct Tally {
  double cost = 0;
  std::size_t inliers = 0;
  bool complete = true;  // false: given up, cost and inliers are those of the points seen
};

// The measures. Matrices are 3x3 row-major; the residual r is compared with Judge::max_error.

// First-order distance to the epipolar constraint x2' E x1 = 0, on the image planes z = 1: columns u1 v1 u2
// v2.
//   Sampson; Hartley and Zisserman, Multiple View Geometry, 2nd ed., Eq. (11.9).
Tally score_sampson_plane(const Columns& columns, const double* E, const Judge& judge);
// The same on the unit sphere (rad), for any camera: columns x1 (3) and x2 (3), unit vectors.
Tally score_sampson_sphere(const Columns& columns, const double* E, const Judge& judge);
// Angles (rad) between both bearings and the point midway between their rays, root of the sum of squares;
// behind a camera is no inlier: columns x1 (3) and x2 (3).
Tally score_triangulated(const Columns& columns, const double* R, const double* t, const Judge& judge);
// |R X1 + t - X2|: columns X1 (3) and X2 (3).
Tally score_distance(const Columns& columns, const double* R, const double* t, const Judge& judge);
// Distance of the projection of R X1 + t from (u2, v2) on the plane z = 1: columns X1 (3), u2, v2.
Tally score_projection_plane(const Columns& columns, const double* R, const double* t, const Judge& judge);
// Sine of the angle between R X1 + t and the bearing x2: columns X1 (3) and x2 (3).
Tally score_projection_sphere(const Columns& columns, const double* R, const double* t, const Judge& judge);

// The price of one residual, q = r^2 / T^2: what the loops above sum. The marginalised price is
//   rho(r) = integral from 0 to r of x w(x) dx, scaled to rho(T) = 1,  w(x) = erfc(x / sqrt(2) s) - erfc(T /
//   sqrt(2) s)
// with s = T / 2.576: the weight of MAGSAC++ (Eq. (4)) for residuals of two degrees of freedom, whose noise
// level is anywhere between 0 and s with equal probability.
double price(double q, Scoring scoring);

}  // namespace framewise
