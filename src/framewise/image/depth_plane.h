// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <opencv2/core.hpp>
#include <optional>

#include "framewise/geometry/camera.h"
#include "framewise/geometry/depth_noise.h"
#include "framewise/image/depth.h"

namespace framewise {

struct DepthPlaneOptions {
  int reach_px = 3;         // the neighbourhood is (2 reach + 1)^2 pixels; wider ones cut corners off rooms
  double tolerance = 0.05;  // pixels whose inverse depths differ by more (a share) are of two surfaces
  // So many pixels share their noise: a structured-light camera compares windows, and rounds.
  double noise_area_px = 9;
  double usual_slope = 1;  // of surfaces, in d ln(inverse depth) / d ray: 45 degrees
};

// A surface where a ray meets it.
struct DepthPlane {
  double z;                     // m
  double noise_share = 1;       // what is left in z of a single pixel's standard deviation
  Eigen::Vector2d slope{0, 0};  // d (1/z) / d ray, of the ray on the plane z = 1 (1/m)
};

// The plane through the pixels around a place between pixels. Its inverse depth is linear in the pixels,
//   1 / z(u + du, v + dv) = w + a du + b dv,
// here by least squares over the pixels of one surface with the nearest one, and with slopes that are taken
// for small as far as the noise leaves them unknown: (a, b) ~ N(0, (usual_slope w / focal)^2). Empty where
// depth_at is.
std::optional<DepthPlane> depth_plane_at(const cv::Mat& depth, const Eigen::Vector2d& pixel,
                                         const Camera& camera, const DepthNoise& noise,
                                         const DepthLookupOptions& lookup,
                                         const DepthPlaneOptions& options = {});

}  // namespace framewise
