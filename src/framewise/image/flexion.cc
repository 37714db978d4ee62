// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/image/flexion.h"

#include <utility>

#include "framewise/image/surface_rows.h"

namespace framewise {

void FlexionOptions::check() const { check_surface_options(distance_px, smoothing_sigma_px); }

cv::Mat flexion_image(const cv::Mat& depth, const DepthRays& rays, const FlexionOptions& options,
                      cv::Mat reuse) {
  options.check();
  const bool published = options.form == FlexionForm::kPublished;
  SurfacePass pass;
  pass.measure = published ? SurfaceMeasure::kFlexion : SurfaceMeasure::kFlexionNormalised;
  pass.distance_px = options.distance_px;
  pass.smoothing_sigma_px = options.smoothing_sigma_px;
  pass.unknown_at_camera = published && options.smoothing_sigma_px == 0 && options.unknown_at_camera;
  return measure_surface(depth, rays, pass, std::move(reuse));
}

}  // namespace framewise
