// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>

#include "framewise/image/depth_rays.h"

namespace framewise {

// The flexion image of a depth image: how alike two normals of the surface at a pixel are, one from its
// horizontal and vertical neighbours, one from its diagonal ones. With P(u, v) the point of a pixel and n the
// distance:
//   d0 = P(u, v+n) - P(u, v-n)        d2 = P(u-n, v+n) - P(u+n, v-n)
//   d1 = P(u+n, v) - P(u-n, v)        d3 = P(u+n, v+n) - P(u-n, v-n)
//   c0 = d0/|d0| x d1/|d1|            c1 = d2/|d2| x d3/|d3|
//   published:  flexion = min(|c0 . c1|, 1)
//   normalised: flexion = |c0 . c1| / (|c0| |c1|), the cosine of the angle between the two normals
// The published form leaves c0 and c1 as long as the sine between their differences, so that a surface also
// darkens as it turns away from the camera; in the normalised form a plane is 1 however it stands.
enum class FlexionForm { kPublished, kNormalised };

struct FlexionOptions {
  FlexionForm form = FlexionForm::kPublished;
  int distance_px = 1;  // n; a camera whose depth is coarse needs more than the published 1
  // Sigma of the smoothing of inverse depth before (pixels, see InverseDepthSmoothing); 0: none.
  double smoothing_sigma_px = 0;
  // The published images take unknown depth for a point at the camera, which draws the rims of holes. Of
  // effect in the published form without smoothing; else flexion is unknown where a depth is.
  bool unknown_at_camera = true;

  // Throws std::invalid_argument that names the value.
  void check() const;
};

// depth: CV_32F of the rays' size and type (z or range; any unit, the answer is the same), unknown where it
// is NaN, infinite or not above 0. The answer: CV_32F in [0, 1]; NaN where it is not defined: n pixels at the
// border, where a depth is unknown, and where a difference has no length. The pixel's own depth is not used.
// Throws std::invalid_argument for an image that is empty or of the wrong type or size.
// reuse: an image that is no longer wanted, whose memory becomes the answer's where it fits.
cv::Mat flexion_image(const cv::Mat& depth, const DepthRays& rays, const FlexionOptions& options,
                      cv::Mat reuse = {});

}  // namespace framewise
