// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <opencv2/core.hpp>
#include <optional>

#include "framewise/features/warped_patch.h"

namespace framewise {

constexpr int kMaxPatchRadius = 7, kMaxPatchSide = 2 * kMaxPatchRadius + 3;

// Bilinear; the caller has made sure that the pixel and its neighbours are inside.
inline float sampled(const cv::Mat& image, float u, float v) {
  const int u0 = static_cast<int>(u), v0 = static_cast<int>(v);
  const float a = u - static_cast<float>(u0), b = v - static_cast<float>(v0);
  const std::uint8_t *top = image.ptr(v0) + u0, *low = top + image.step[0];
  return (1 - b) * ((1 - a) * top[0] + a * top[1]) + b * ((1 - a) * low[0] + a * low[1]);
}

// Of a patch that is stored row by row: central differences.
inline Eigen::Vector2f gradient_at(const float* value, int row_length) {
  return {0.5f * (value[1] - value[-1]), 0.5f * (value[row_length] - value[-row_length])};
}

inline bool is_inside(const cv::Mat& image, double u, double v, double margin) {
  return u >= margin && v >= margin && u < image.cols - 1 - margin && v < image.rows - 1 - margin;
}

// The patch as image 2 should have it, and what it says about where it is: d = H^-1 J' r.
struct PatchTemplate {
  int side = 0;
  std::array<float, kMaxPatchSide * kMaxPatchSide> value, gx, gy;  // of the inner patch, zero mean
  float norm2 = 0;                                                 // sum of value^2
  Eigen::Matrix4f H_inverse;
  Eigen::Matrix2f H_place;

  int size() const { return side * side; }
};

// Empty where the patch leaves image 1, has too little texture or is warped beyond use.
std::optional<PatchTemplate> make_patch_template(const ImageLevels& image1, const PatchWarp& warp,
                                                 int radius);

}  // namespace framewise
