// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/simulation/route.h"

#include <algorithm>
#include <cmath>

#include "framewise/simulation/se3_spline.h"

namespace framewise {

using Eigen::Vector3d;

namespace {

constexpr int kPointsPerLeg = 512;    // of the curve between two corners
constexpr double kSpacing = 0.01;     // of points on the way (m)
constexpr double kSmoothing = 0.6;    // of the speed along the way (m)
constexpr double kSmoothTime = 0.06;  // of the positions (s)

std::vector<double> mean_of_neighbours(const std::vector<double>& values, int reach) {
  const int n = static_cast<int>(values.size());
  reach = std::min(reach, (n - 1) / 2);
  std::vector<double> means(values.size());
  double sum = 0;
  for (int k = -reach; k <= reach; ++k) sum += values[(k + n) % n];
  for (int i = 0; i < n; ++i) {
    means[i] = sum / (2 * reach + 1);
    sum += values[(i + reach + 1) % n] - values[(i - reach + n) % n];
  }
  return means;
}

// Through the corners, parametrised by the distances between them, with two corners more on either side so
// that the round closes smoothly.
std::vector<Vector3d> closed_curve(const std::vector<Vector3d>& corners) {
  const int n = static_cast<int>(corners.size());
  Trajectory knots;
  double at = 0;
  for (int i = -2; i <= n + 2; ++i) {
    const Vector3d &corner = corners[(i + n) % n], &before = corners[(i + n - 1) % n];
    at += (corner - before).norm();
    knots.add(at, {Eigen::Matrix3d::Identity(), corner});
  }
  const Se3Spline spline(knots);
  std::vector<Vector3d> points;
  for (int i = 0; i < n; ++i)
    for (int k = 0; k < kPointsPerLeg; ++k) {
      const double s = static_cast<double>(k) / kPointsPerLeg;
      points.push_back(spline((1 - s) * knots.times[i + 2] + s * knots.times[i + 3]).world_from_cam.t);
    }
  return points;
}

// Points at even distances along a closed line.
std::vector<Vector3d> even_points(const std::vector<Vector3d>& line) {
  const std::size_t n = line.size();
  std::vector<double> length{0};
  for (std::size_t i = 0; i < n; ++i) length.push_back(length.back() + (line[(i + 1) % n] - line[i]).norm());
  const int count = std::max(16, static_cast<int>(length.back() / kSpacing));
  std::vector<Vector3d> points;
  std::size_t leg = 0;
  for (int i = 0; i < count; ++i) {
    const double at = length.back() * i / count;
    while (length[leg + 1] <= at) ++leg;
    const double s = (at - length[leg]) / (length[leg + 1] - length[leg]);
    points.push_back((1 - s) * line[leg] + s * line[(leg + 1) % n]);
  }
  return points;
}

std::vector<double> speeds(const std::vector<Vector3d>& points, double spacing, const RouteLimits& limits) {
  const int n = static_cast<int>(points.size()), reach = std::clamp(n / 8, 1, 10);
  std::vector<double> speed(points.size());
  for (int i = 0; i < n; ++i) {
    const Vector3d before = points[i] - points[(i + n - reach) % n],
                   after = points[(i + reach) % n] - points[i];
    const double angle = std::atan2(before.cross(after).norm(), before.dot(after));
    const double curvature = std::max(1e-6, angle / (reach * spacing));
    speed[i] = std::min({limits.speed, std::sqrt(limits.sideways / curvature), limits.turn_rate / curvature});
  }
  // Twice round, so that the end knows of the beginning.
  const double gain = 2 * limits.lengthways * spacing;
  for (int k = 0; k < 2 * n; ++k) {
    double& next = speed[(k + 1) % n];
    next = std::min(next, std::sqrt(speed[k % n] * speed[k % n] + gain));
  }
  for (int k = 2 * n; k > 0; --k) {
    double& next = speed[(k - 1) % n];
    next = std::min(next, std::sqrt(speed[k % n] * speed[k % n] + gain));
  }
  return smoothed(speed, static_cast<int>(kSmoothing / spacing));
}

// Accelerations change gently where positions are means over some time.
void smooth(std::vector<Vector3d>& positions, int reach) {
  for (int k = 0; k < 3; ++k) {
    std::vector<double> values;
    for (const Vector3d& position : positions) values.push_back(position[k]);
    values = smoothed(values, reach);
    for (std::size_t i = 0; i < values.size(); ++i) positions[i][k] = values[i];
  }
}

}  // namespace

std::vector<double> smoothed(std::vector<double> values, int reach) {
  for (int pass = 0; pass < 4; ++pass) values = mean_of_neighbours(values, reach);
  return values;
}

Round ride(const std::vector<Vector3d>& corners, const RouteLimits& limits, double step) {
  const std::vector<Vector3d> points = even_points(closed_curve(corners));
  const std::size_t n = points.size();
  const double spacing = (points[1] - points[0]).norm();
  const std::vector<double> speed = speeds(points, spacing, limits);
  std::vector<double> time{0};
  for (std::size_t i = 0; i < n; ++i)
    time.push_back(time.back() + 2 * spacing / (speed[i] + speed[(i + 1) % n]));
  const int count = std::max(16, static_cast<int>(std::lround(time.back() / step)));
  Round round{time.back() / count, {}};
  std::size_t leg = 0;
  for (int i = 0; i < count; ++i) {
    const double at = round.step * i;
    while (time[leg + 1] <= at) ++leg;
    const double s = (at - time[leg]) / (time[leg + 1] - time[leg]);
    round.positions.push_back((1 - s) * points[leg] + s * points[(leg + 1) % n]);
  }
  smooth(round.positions, static_cast<int>(kSmoothTime / round.step));
  return round;
}

}  // namespace framewise
