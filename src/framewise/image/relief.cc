// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/image/relief.h"

#include <sstream>
#include <stdexcept>

#include "framewise/image/surface_rows.h"

namespace framewise {
namespace {

SurfacePass pass_of(const ReliefOptions& options) {
  options.check();
  SurfacePass pass;
  pass.measure = SurfaceMeasure::kNormal;
  pass.distance_px = options.distance_px;
  pass.smoothing_sigma_px = options.smoothing_sigma_px;
  return pass;
}

}  // namespace

void ReliefOptions::check() const {
  check_surface_options(distance_px, smoothing_sigma_px);
  if (light.allFinite() && light.squaredNorm() > 0) return;
  std::ostringstream message;
  message << "light: found (" << light.transpose() << "), expected a direction";
  throw std::invalid_argument(message.str());
}

cv::Mat normal_image(const cv::Mat& depth, const DepthRays& rays, const ReliefOptions& options) {
  SurfacePass pass = pass_of(options);
  pass.light = -Eigen::Vector3d::UnitZ();
  pass.light_along_ray = true;
  return measure_surface(depth, rays, pass);
}

cv::Mat shaded_relief(const cv::Mat& depth, const DepthRays& rays, const ReliefOptions& options) {
  SurfacePass pass = pass_of(options);
  pass.light = options.light.normalized();
  return measure_surface(depth, rays, pass);
}

}  // namespace framewise
