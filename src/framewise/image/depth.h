// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <limits>
#include <opencv2/core.hpp>
#include <optional>

namespace framewise {

inline constexpr float kUnknownDepth = std::numeric_limits<float>::quiet_NaN();

// Whether a float is a depth: unknown is NaN, infinite or not above 0.
inline bool is_known_depth(float depth) { return depth > 0 && std::isfinite(depth); }

// What a depth file holds to metres. raw: CV_16U, value / factor; or CV_32F, metres already. What is not
// above 0, not finite or beyond max_depth becomes NaN. The answer: CV_32F of the same size.
cv::Mat depth_from_raw(const cv::Mat& raw, double factor, double max_depth);

// The way back: value x factor to the nearest of 16 bits, 0 where the depth is unknown or has no such value.
cv::Mat depth_to_raw(const cv::Mat& depth, double factor);

struct DepthLookupOptions {
  // A pixel this near to the image's border has no depth: sensors smear and registration shifts there
  // (pixels).
  int border_px = 2;
  // Where the neighbours' depths differ by more than this share of the depth, the pixel is on an edge of an
  // object and either surface may be meant.
  double max_edge = 0.03;
  double min_depth = 0.3;  // nearer than this, structured light sees nothing it can be trusted with (m)
  double max_depth = 8.0;  // at 8 m a Kinect's depth step is already 0.2 m (m)

  // Throws std::invalid_argument that names the value.
  void check() const;
};

// Depth (m) at a sub-pixel position, from the 3 x 3 pixels around the nearest one. Empty when the pixel or
// more than half of its neighbours are unknown, at the border, and on depth edges.
std::optional<double> depth_at(const cv::Mat& depth, const Eigen::Vector2d& pixel,
                               const DepthLookupOptions& options);

}  // namespace framewise
