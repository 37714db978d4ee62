// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/features/warped_patch.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace framewise {
namespace {

constexpr int kMaxRadius = 7, kMaxSide = 2 * kMaxRadius + 3;

// Bilinear; the caller has made sure that the pixel and its neighbours are inside.
float sampled(const cv::Mat& image, float u, float v) {
  const int u0 = static_cast<int>(u), v0 = static_cast<int>(v);
  const float a = u - static_cast<float>(u0), b = v - static_cast<float>(v0);
  const std::uint8_t *top = image.ptr(v0) + u0, *low = top + image.step[0];
  return (1 - b) * ((1 - a) * top[0] + a * top[1]) + b * ((1 - a) * low[0] + a * low[1]);
}

bool has(const cv::Mat& image, double u, double v, double margin) {
  return u >= margin && v >= margin && u < image.cols - 1 - margin && v < image.rows - 1 - margin;
}

// The patch as image 2 should have it, and what it says about where it is: d = H^-1 J' r.
struct Template {
  int side = 0;
  std::array<float, kMaxSide * kMaxSide> value, gx, gy;  // of the inner patch, zero mean
  float norm2 = 0;                                       // sum of value^2
  Eigen::Matrix4f H_inverse;
  Eigen::Matrix2f H_place;

  int size() const { return side * side; }
};

std::optional<Template> make_template(const ImageLevels& image1, const PatchWarp& warp, int radius) {
  const Eigen::Matrix2d pixel1_from_level2 = warp.pixel2_from_pixel1.inverse() * std::ldexp(1.0, warp.level);
  const double spacing = std::sqrt(std::abs(pixel1_from_level2.determinant()));
  if (!(spacing > 0.1 && spacing < 64)) return std::nullopt;
  const int level1 =
      std::clamp(static_cast<int>(std::lround(std::log2(spacing))), 0, static_cast<int>(image1.size()) - 1);
  const double shrink = std::ldexp(1.0, -level1);
  const Eigen::Matrix2f A = (pixel1_from_level2 * shrink).cast<float>();
  const Eigen::Vector2f centre = (warp.pixel1 * shrink).cast<float>();
  const int outer = radius + 1, outer_side = 2 * outer + 1;
  const double reach = outer * A.cwiseAbs().rowwise().sum().maxCoeff();
  if (!has(image1[level1], centre.x(), centre.y(), reach)) return std::nullopt;

  std::array<float, kMaxSide * kMaxSide> wide;
  for (int y = -outer, k = 0; y <= outer; ++y)
    for (int x = -outer; x <= outer; ++x, ++k) {
      const Eigen::Vector2f p = centre + A * Eigen::Vector2f(x, y);
      wide[k] = sampled(image1[level1], p.x(), p.y());
    }
  Template t;
  t.side = 2 * radius + 1;
  float mean = 0;
  for (int y = 0, k = 0; y < t.side; ++y)
    for (int x = 0; x < t.side; ++x, ++k) {
      const float* w = wide.data() + (y + 1) * outer_side + x + 1;
      t.value[k] = w[0];
      t.gx[k] = 0.5f * (w[1] - w[-1]);
      t.gy[k] = 0.5f * (w[outer_side] - w[-outer_side]);
      mean += w[0];
    }
  mean /= static_cast<float>(t.size());
  Eigen::Matrix4f H = Eigen::Matrix4f::Zero();
  for (int k = 0; k < t.size(); ++k) {
    t.value[k] -= mean;
    const Eigen::Vector4f J(t.gx[k], t.gy[k], t.value[k], 1);
    H += J * J.transpose();
  }
  t.norm2 = H(2, 2);
  t.H_place = H.topLeftCorner<2, 2>();
  const float smaller = 0.5f * (H(0, 0) + H(1, 1) - std::hypot(H(0, 0) - H(1, 1), 2 * H(0, 1)));
  constexpr float kLeastGradient = 1.5f;  // grey levels a pixel, squared: camera noise alone has as much
  if (!(smaller > kLeastGradient * static_cast<float>(t.size()))) return std::nullopt;
  t.H_inverse = H.inverse();
  if (!t.H_inverse.allFinite()) return std::nullopt;
  return t;
}

// What the patch at a place of image 2 and the template make of each other.
struct Comparison {
  Eigen::Vector4f b = Eigen::Vector4f::Zero();  // J' r, r = image 2 - template
  float sum = 0, squares = 0, product = 0;

  Comparison(const Template& t, const cv::Mat& image, const Eigen::Vector2f& place) {
    const int radius = t.side / 2;
    for (int y = -radius, k = 0; y <= radius; ++y)
      for (int x = -radius; x <= radius; ++x, ++k) {
        const float value =
            sampled(image, place.x() + static_cast<float>(x), place.y() + static_cast<float>(y));
        const float r = value - t.value[k];
        b += r * Eigen::Vector4f(t.gx[k], t.gy[k], t.value[k], 1);
        sum += value, squares += value * value, product += value * t.value[k];
      }
  }
};

}  // namespace

ImageLevels image_levels(const cv::Mat& gray, int count) {
  constexpr int kLeastSide = 32;
  ImageLevels levels{gray};
  while (static_cast<int>(levels.size()) < count &&
         std::min(levels.back().rows, levels.back().cols) >= 2 * kLeastSide) {
    cv::Mat half;
    cv::pyrDown(levels.back(), half);
    levels.push_back(half);
  }
  return levels;
}

std::optional<TrackedPatch> track_patch(const ImageLevels& image1, const ImageLevels& image2,
                                        const PatchWarp& warp, const PatchTrackOptions& options) {
  if (image1.empty() || static_cast<int>(image2.size()) <= warp.level) return std::nullopt;
  const auto t = make_template(image1, warp, std::min(options.radius, kMaxRadius));
  if (!t) return std::nullopt;
  const cv::Mat& image = image2[warp.level];
  const Eigen::Vector2f start = (warp.pixel2 * std::ldexp(1.0, -warp.level)).cast<float>();
  Eigen::Vector2f place = start;
  bool converged = false;
  for (int i = 0; i <= options.max_iterations; ++i) {
    if (!place.allFinite() || !has(image, place.x(), place.y(), options.radius)) return std::nullopt;
    if ((place - start).norm() > options.max_shift) return std::nullopt;
    const Comparison c(*t, image, place);
    const Eigen::Vector4f d = t->H_inverse * c.b;
    if (converged || i == options.max_iterations) {
      const float n = static_cast<float>(t->size());
      const float variance2 = c.squares - c.sum * c.sum / n;
      // With a tenth of the contrast, and next to none, there is nothing to resemble.
      if (!(variance2 > 0.01f * t->norm2 && variance2 > n)) return std::nullopt;
      const float correlation = c.product / std::sqrt(std::max(1e-6f, variance2 * t->norm2));
      if (!(correlation >= options.min_correlation)) return std::nullopt;
      // What gain and offset leave of the difference is noise.
      const float noise = (1 - correlation * correlation) * t->norm2 / std::max(1.0f, n - 4);
      const float sigma = std::sqrt(noise * 0.5f * t->H_inverse.topLeftCorner<2, 2>().trace());
      const double to_pixels = std::ldexp(1.0, warp.level);
      return TrackedPatch{place.cast<double>() * to_pixels, correlation, sigma * to_pixels};
    }
    const float gain = std::max(0.3f, 1 + d[2]);
    const Eigen::Vector2f step = d.head<2>() / gain;
    place -= step;
    converged = step.norm() < options.min_step_px;
  }
  return std::nullopt;
}

}  // namespace framewise
