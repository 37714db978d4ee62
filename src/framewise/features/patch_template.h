// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <opencv2/core.hpp>
#include <optional>

#include "framewise/features/warped_patch.h"

namespace framewise {

// Of a patch, with a border of one pixel: row by row, each row of as many as are worked on side by side.
constexpr int kMaxPatchRadius = 4, kPatchRow = 12;
using PatchRows = std::array<float, kPatchRow * kPatchRow>;

// Bilinear; the caller has made sure that the pixel and its neighbours are inside.
inline float sampled(const cv::Mat& image, float u, float v) {
  const int u0 = static_cast<int>(u), v0 = static_cast<int>(v);
  const float a = u - static_cast<float>(u0), b = v - static_cast<float>(v0);
  const std::uint8_t *top = image.ptr(v0) + u0, *low = top + image.step[0];
  return (1 - b) * ((1 - a) * top[0] + a * top[1]) + b * ((1 - a) * low[0] + a * low[1]);
}

inline bool is_inside(const cv::Mat& image, double u, double v, double margin) {
  return u >= margin && v >= margin && u < image.cols - 1 - margin && v < image.rows - 1 - margin;
}

// The patch as image 2 should have it, and what it says about where it is: d = H^-1 J' r. Zeros beyond each
// row's end.
struct PatchTemplate {
  int side = 0;
  float mean = 0;
  PatchRows value, gx, gy, inside;  // less the mean; 1 inside
  Eigen::Matrix4f H, H_inverse;

  int size() const { return side * side; }
  int padded_size() const { return side * kPatchRow; }
  float norm2() const { return H(2, 2); }  // sum of value^2
};

// Empty where the patch leaves image 1, has too little texture or is warped beyond use.
std::optional<PatchTemplate> make_patch_template(const ImageLevels& image1, const PatchWarp& warp,
                                                 int radius);

inline Eigen::Array4f four(const PatchRows& rows, int k) { return Eigen::Array4f::Map(rows.data() + k); }

// Four pixels that were sampled, as the template has its own.
inline Eigen::Array4f four_less_mean(const PatchRows& sampled, int k, const PatchTemplate& t) {
  return (four(sampled, k) - t.mean) * four(t.inside, k);
}

// (2 radius + 1)^2 pixels around a place, bilinear; all and their neighbours are inside. What comes after the
// end of a row is of no use.
void sample_patch(const cv::Mat& image, const Eigen::Vector2f& place, int radius, PatchRows& values);

// What the patch at a place of image 2 and the template make of each other.
struct PatchComparison {
  Eigen::Vector4f b;                        // J' r, r = image 2 - template
  float sum = 0, squares = 0, product = 0;  // of the patch less the template's mean, with the template

  PatchComparison(const PatchTemplate& t, const cv::Mat& image, const Eigen::Vector2f& place);
  // Times the count of pixels.
  float variance(const PatchTemplate& t) const { return squares - sum * sum / static_cast<float>(t.size()); }
};

// Central differences of a patch with a border, of the patch without.
void gradients_inside(const PatchRows& wide, int side, PatchRows& gx, PatchRows& gy);

}  // namespace framewise
