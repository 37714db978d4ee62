// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/features/warped_patch.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "framewise/features/patch_template.h"

namespace framewise {
namespace {

// What the patch at a place of image 2 and the template make of each other.
struct Comparison {
  Eigen::Vector4f b = Eigen::Vector4f::Zero();  // J' r, r = image 2 - template
  float sum = 0, squares = 0, product = 0;

  Comparison(const PatchTemplate& t, const cv::Mat& image, const Eigen::Vector2f& place) {
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

// Of the place: by the texture that both images have. Noise and blur give each gradients that the other does
// not have; where a direction has no others, the place stays where it was expected.
Eigen::Matrix2d covariance_of_place(const PatchTemplate& t, const cv::Mat& image,
                                    const Eigen::Vector2f& place, float noise, float gain) {
  constexpr double kLeastTexture = 0.05;  // of the gradients' squares: nothing is known
  const int radius = t.side / 2;
  std::array<float, kMaxPatchSide * kMaxPatchSide> wide;
  for (int y = -radius - 1, k = 0; y <= radius + 1; ++y)
    for (int x = -radius - 1; x <= radius + 1; ++x, ++k)
      wide[k] = sampled(image, place.x() + static_cast<float>(x), place.y() + static_cast<float>(y));
  const int outer = t.side + 2;
  Eigen::Matrix2f both = Eigen::Matrix2f::Zero();
  for (int y = 0, k = 0; y < t.side; ++y)
    for (int x = 0; x < t.side; ++x, ++k) {
      const float* w = wide.data() + (y + 1) * outer + x + 1;
      both += Eigen::Vector2f(t.gx[k], t.gy[k]) * gradient_at(w, outer).transpose();
    }
  both /= gain;
  const Eigen::Matrix2d by_gradients = t.H_inverse.topLeftCorner<2, 2>().cast<double>();
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> eigen;
  eigen.computeDirect(by_gradients);
  Eigen::Vector2d variances;
  for (int i = 0; i < 2; ++i) {
    const double squares = 1 / eigen.eigenvalues()[i];
    const Eigen::Vector2d v = eigen.eigenvectors().col(i);
    const double all = v.dot(t.H_place.cast<double>() * v), shared = v.dot(both.cast<double>() * v);
    const double texture = std::clamp(shared / all, kLeastTexture, 1.0);
    variances[i] = noise / (squares * texture * texture);
  }
  return eigen.eigenvectors() * variances.asDiagonal() * eigen.eigenvectors().transpose();
}

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
  const auto t = make_patch_template(image1, warp, options.radius);
  if (!t) return std::nullopt;
  const cv::Mat& image = image2[warp.level];
  const Eigen::Vector2f start = (warp.pixel2 * std::ldexp(1.0, -warp.level)).cast<float>();
  Eigen::Vector2f place = start;
  bool converged = false;
  for (int i = 0; i <= options.max_iterations; ++i) {
    if (!place.allFinite() || !is_inside(image, place.x(), place.y(), options.radius + 1))
      return std::nullopt;
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
      const double to_pixels = std::ldexp(1.0, warp.level);
      TrackedPatch found{place.cast<double>() * to_pixels, correlation, {}};
      if (!options.measures_noise) return found;
      // What gain and offset leave of the difference is noise.
      const float noise = (1 - correlation * correlation) * t->norm2 / std::max(1.0f, n - 4);
      const float contrast = std::max(0.1f, c.product / t->norm2);
      found.noise_px =
          PlaceNoise::of(to_pixels * to_pixels * covariance_of_place(*t, image, place, noise, contrast));
      return found;
    }
    const float gain = std::max(0.3f, 1 + d[2]);
    const Eigen::Vector2f step = d.head<2>() / gain;
    place -= step;
    converged = step.norm() < options.min_step_px;
  }
  return std::nullopt;
}

}  // namespace framewise
