// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>

#include "framewise/geometry/camera.h"

namespace framewise {

// What a depth image holds: z along the optical axis, or the Euclidean distance along the pixel's ray.
enum class DepthType { kZ, kRange };
const char* name_of(DepthType type);

// The directions in which a camera's pixels look, in the form in which the images of a surface need them:
// made once a camera, used for every frame.
struct DepthRays {
  // Throws std::invalid_argument where the camera makes none, or where z is asked of an equirectangular
  // camera.
  DepthRays(const Camera& camera, DepthType type);

  // kPlane: a pinhole without distortion. kSphere: equirectangular. kTable: any other, in double precision.
  enum class Kind { kPlane, kSphere, kTable };

  Camera camera;
  DepthType type;
  Kind kind;
  cv::Mat z_per_range;  // CV_32F, kPlane with ranges only
  // CV_64F, kTable only: point = depth (x, y, z). NaN where a pixel has no ray.
  cv::Mat x, y, z;
};

// Range along the rays to z along the optical axis: z = range * bearing.z. NaN where the range is unknown,
// where the pixel has no ray, and where the ray does not look forward. range: CV_32F, the camera's size.
cv::Mat z_from_range(const cv::Mat& range, const Camera& camera);

}  // namespace framewise
