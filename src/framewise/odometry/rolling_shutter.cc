// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/odometry/rolling_shutter.h"

#include <algorithm>
#include <cmath>

#include "framewise/geometry/so3.h"

namespace framewise {
namespace {

// exp(phi) x to third order: a camera turns by a few degrees while it is read.
Eigen::Vector3d turned(const Eigen::Vector3d& phi, const Eigen::Vector3d& x) {
  const Eigen::Vector3d once = phi.cross(x), twice = phi.cross(once);
  return x + once + 0.5 * twice + phi.cross(twice) / 6;
}

}  // namespace

Eigen::Vector3d Shutter::at_middle(const Eigen::Vector3d& ray, double row) const {
  const Eigen::Vector3d x = turned(row * readout * turn_rate, ray);
  return x / x.z();
}

Eigen::Vector3d Shutter::at_middle_by_readout(const Eigen::Vector3d& ray, double row) const {
  const Eigen::Vector3d d = row * turn_rate.cross(ray);
  return d - d.z() * ray;
}

double Shutter::depth_at_middle(const Eigen::Vector3d& ray, double row, double z) const {
  return z * turned(row * readout * turn_rate, ray).z();
}

std::optional<Eigen::Vector2d> Shutter::project(const Camera& camera, const Eigen::Vector3d& x_in_cam) const {
  auto pixel = camera.project(x_in_cam);
  if (readout == 0 || !pixel) return pixel;
  constexpr int kRounds = 2;  // each is nearer by the share of the image the camera turns while it is read
  for (int i = 0; i < kRounds && pixel; ++i) {
    const double row = std::clamp(row_of(camera, pixel->y()), -0.6, 0.6);
    pixel = camera.project(turned(-row * readout * turn_rate, x_in_cam));
  }
  return pixel;
}

void ReadoutEstimate::add(double correction, double information, double longest) {
  if (!std::isfinite(correction) || !(information > 0)) return;
  constexpr double kMost = 1 / (0.001 * 0.001);  // it may still be learned anew
  const double departure = seconds() + correction - estimate_;
  const double all = information_ + information, kept = std::min(kMost, all) / all;
  estimate_ = std::clamp(estimate_ + information / all * departure, -longest, longest);
  scatter_ = kept * kept * (scatter_ + std::pow(information * departure, 2));
  information_ = kept * all;

  constexpr double kLeast = 0.004;  // s: such a skew is below what rays are certain to
  constexpr double kSure = 4;       // standard errors, as said or as the estimates scatter
  const double error = std::max(std::sqrt(scatter_) / information_, 1 / std::sqrt(information_));
  const bool was_rolling = is_rolling_;
  is_rolling_ = std::abs(estimate_) > (was_rolling ? kLeast / 2 : std::max(kLeast, kSure * error));
  if (!is_rolling_ || was_rolling) return;
  constexpr double kLeft = 0.1;  // of what was learned while rays were taken as if it were 0
  information_ *= kLeft;
  scatter_ *= kLeft * kLeft;
}

}  // namespace framewise
