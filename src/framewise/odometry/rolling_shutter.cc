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
  seconds_ =
      std::clamp(seconds_ + information / (information_ + information) * correction, -longest, longest);
  information_ = std::min(kMost, information_ + information);
}

}  // namespace framewise
