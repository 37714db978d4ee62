// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/simulation/se3_spline.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "framewise/geometry/so3.h"

namespace framewise {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

// First and second derivative.
struct Derivatives {
  Vector3d first = Vector3d::Zero(), second = Vector3d::Zero();
};

// At 0 of the parabola through 0 at 0, x1 at s1, x2 at s2.
Derivatives of_parabola(double s1, const Vector3d& x1, double s2, const Vector3d& x2) {
  Derivatives d;
  d.second = 2 * (x2 / s2 - x1 / s1) / (s2 - s1);
  d.first = x1 / s1 - 0.5 * s1 * d.second;
  return d;
}

// At 0 of the quartic through 0 at 0 and these four places.
Derivatives of_quartic(const Eigen::Vector4d& s, const Eigen::Matrix<double, 4, 3>& x) {
  Eigen::Matrix4d powers;
  for (int k = 0; k < 4; ++k) powers.row(k) << s[k], s[k] * s[k], std::pow(s[k], 3), std::pow(s[k], 4);
  const Eigen::Matrix<double, 4, 3> coefficients = powers.partialPivLu().solve(x);
  return {coefficients.row(0).transpose(), 2 * coefficients.row(1).transpose()};
}

// At pose i of the polynomial through it and its neighbours, of which `from_here` tells the place.
template <typename Function>
Derivatives at_pose(const std::vector<double>& times, std::size_t i, Function from_here) {
  const std::size_t n = times.size();
  if (i >= 2 && i + 2 < n) {
    Eigen::Vector4d s;
    Eigen::Matrix<double, 4, 3> x;
    for (int k = 0; k < 4; ++k) {
      const std::size_t other = i - 2 + static_cast<std::size_t>(k < 2 ? k : k + 1);
      s[k] = times[other] - times[i];
      x.row(k) = from_here(other).transpose();
    }
    return of_quartic(s, x);
  }
  if (n == 2) return {from_here(1 - i) / (times[1 - i] - times[i]), Vector3d::Zero()};
  const std::size_t first = std::clamp<std::size_t>(i, 1, n - 2) - 1;
  std::size_t other[2];
  for (std::size_t k = first, found = 0; k < first + 3; ++k)
    if (k != i) other[found++] = k;
  return of_parabola(times[other[0]] - times[i], from_here(other[0]), times[other[1]] - times[i],
                     from_here(other[1]));
}

// From 0 to x over the time h, with these derivatives at both ends.
Eigen::Matrix<double, 3, 6> quintic(const Vector3d& x, double h, const Derivatives& begin,
                                    const Derivatives& end) {
  Eigen::Matrix<double, 3, 6> c;
  c.col(0).setZero();
  c.col(1) = h * begin.first;
  c.col(2) = 0.5 * h * h * begin.second;
  const Vector3d place = x - c.col(1) - c.col(2), rate = h * end.first - c.col(1) - 2 * c.col(2),
                 change = h * h * end.second - 2 * c.col(2);
  c.col(3) = 10 * place - 4 * rate + 0.5 * change;
  c.col(4) = -15 * place + 7 * rate - change;
  c.col(5) = 6 * place - 3 * rate + 0.5 * change;
  return c;
}

Vector3d value(const Eigen::Matrix<double, 3, 6>& c, double s) {
  return c.col(0) + s * (c.col(1) + s * (c.col(2) + s * (c.col(3) + s * (c.col(4) + s * c.col(5)))));
}

Vector3d slope(const Eigen::Matrix<double, 3, 6>& c, double s) {
  return c.col(1) + s * (2 * c.col(2) + s * (3 * c.col(3) + s * (4 * c.col(4) + s * 5 * c.col(5))));
}

Vector3d bend(const Eigen::Matrix<double, 3, 6>& c, double s) {
  return 2 * c.col(2) + s * (6 * c.col(3) + s * (12 * c.col(4) + s * 20 * c.col(5)));
}

// d Jr(phi) / dt where phi changes at this rate. Jr = I - a S + b S^2 with S = [phi]x and a, b functions of
// |phi|^2.
Matrix3d right_jacobian_rate(const Vector3d& phi, const Vector3d& phi_rate) {
  const double x = phi.squaredNorm();
  double a, b, a_slope, b_slope;  // slopes over |phi|^2
  if (x < 0.01) {
    a = 0.5 - x * (1.0 / 24 - x / 720);
    b = 1.0 / 6 - x * (1.0 / 120 - x / 5040);
    a_slope = -1.0 / 24 + x * (1.0 / 360 - x / 13440);
    b_slope = -1.0 / 120 + x * (1.0 / 2520 - x / 120960);
  } else {
    const double theta = std::sqrt(x);
    a = (1 - std::cos(theta)) / x;
    b = (theta - std::sin(theta)) / (x * theta);
    a_slope = (0.5 * std::sin(theta) / theta - a) / x;
    b_slope = 0.5 * (a - 3 * b) / x;
  }
  const Matrix3d S = skew(phi), S_rate = skew(phi_rate);
  const double x_rate = 2 * phi.dot(phi_rate);
  return -a_slope * x_rate * S - a * S_rate + b_slope * x_rate * S * S + b * (S_rate * S + S * S_rate);
}

// phi' and phi'' of an angular rate and its derivative.
Derivatives of_turn(const Vector3d& phi, const Derivatives& angular) {
  const Matrix3d inverse = so3_right_jacobian(phi).inverse();
  Derivatives d;
  d.first = inverse * angular.first;
  d.second = inverse * (angular.second - right_jacobian_rate(phi, d.first) * d.first);
  return d;
}

void check(const Trajectory& poses) {
  if (poses.size() < 2)
    throw std::invalid_argument("poses: found " + std::to_string(poses.size()) + ", expected at least 2");
  for (std::size_t i = 1; i < poses.size(); ++i)
    if (!(poses.times[i] > poses.times[i - 1]))
      throw std::invalid_argument("poses: found time " + std::to_string(poses.times[i]) + " after " +
                                  std::to_string(poses.times[i - 1]) + ", expected times that increase");
}

}  // namespace

Se3Spline::Se3Spline(const Trajectory& poses) : times_(poses.times) {
  check(poses);
  const auto& pose = poses.world_from_cam;
  std::vector<Derivatives> linear, angular;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    linear.push_back(at_pose(times_, i, [&](std::size_t k) -> Vector3d { return pose[k].t - pose[i].t; }));
    angular.push_back(at_pose(
        times_, i, [&](std::size_t k) -> Vector3d { return so3_log(pose[i].R.transpose() * pose[k].R); }));
  }
  for (std::size_t i = 0; i + 1 < poses.size(); ++i) {
    const double h = times_[i + 1] - times_[i];
    const Vector3d phi = so3_log(pose[i].R.transpose() * pose[i + 1].R);
    Segment segment;
    segment.R = pose[i].R;
    segment.position = quintic(pose[i + 1].t - pose[i].t, h, linear[i], linear[i + 1]);
    segment.position.col(0) = pose[i].t;
    segment.turn = quintic(phi, h, angular[i], of_turn(phi, angular[i + 1]));
    segments_.push_back(segment);
  }
}

Motion Se3Spline::operator()(double time) const {
  if (!(time >= begin() && time <= end()))
    throw std::invalid_argument("time: found " + std::to_string(time) + ", expected " +
                                std::to_string(begin()) + " to " + std::to_string(end()));
  const auto after = std::upper_bound(times_.begin() + 1, times_.end() - 1, time);
  const std::size_t i = static_cast<std::size_t>(after - times_.begin()) - 1;
  const double h = times_[i + 1] - times_[i], s = (time - times_[i]) / h;
  const auto &position = segments_[i].position, &turn = segments_[i].turn;
  const Vector3d phi = value(turn, s);
  Motion motion;
  motion.world_from_cam = {segments_[i].R * so3_exp(phi), value(position, s)};
  motion.velocity = slope(position, s) / h;
  motion.acceleration = bend(position, s) / (h * h);
  motion.angular_rate = so3_right_jacobian(phi) * slope(turn, s) / h;
  return motion;
}

}  // namespace framewise
