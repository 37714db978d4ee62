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

// Of the place: by the texture that both images have. Noise and blur give each gradients that the other does
// not have; where a direction has no others, the place stays where it was expected.
Eigen::Matrix2d covariance_of_place(const PatchTemplate& t, const cv::Mat& image,
                                    const Eigen::Vector2f& place, float noise, float gain) {
  constexpr double kLeastTexture = 0.05;  // of the gradients' squares: nothing is known
  PatchRows wide, gx, gy;
  sample_patch(image, place, t.side / 2 + 1, wide);
  gradients_inside(wide, t.side, gx, gy);
  Eigen::Array4f xx = Eigen::Array4f::Zero(), xy = xx, yy = xx;
  for (int k = 0; k < t.padded_size(); k += 4) {
    xx += four(t.gx, k) * four(gx, k), yy += four(t.gy, k) * four(gy, k);
    xy += four(t.gx, k) * four(gy, k) + four(t.gy, k) * four(gx, k);
  }
  Eigen::Matrix2f both;
  both << xx.sum(), 0.5f * xy.sum(), 0.5f * xy.sum(), yy.sum();
  both /= gain;
  const Eigen::Matrix2d by_gradients = t.H_inverse.topLeftCorner<2, 2>().cast<double>();
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> eigen;
  eigen.computeDirect(by_gradients);
  Eigen::Vector2d variances;
  for (int i = 0; i < 2; ++i) {
    const double squares = 1 / eigen.eigenvalues()[i];
    const Eigen::Vector2d v = eigen.eigenvectors().col(i);
    const double all = v.dot(t.H.topLeftCorner<2, 2>().cast<double>() * v),
                 shared = v.dot(both.cast<double>() * v);
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
    const PatchComparison c(*t, image, place);
    const Eigen::Vector4f d = t->H_inverse * c.b;
    if (converged || i == options.max_iterations) {
      const float n = static_cast<float>(t->size());
      const float variance2 = c.variance(*t);
      // With a tenth of the contrast, and next to none, there is nothing to resemble.
      if (!(variance2 > 0.01f * t->norm2() && variance2 > n)) return std::nullopt;
      const float correlation = c.product / std::sqrt(std::max(1e-6f, variance2 * t->norm2()));
      if (!(correlation >= options.min_correlation)) return std::nullopt;
      const double to_pixels = std::ldexp(1.0, warp.level);
      TrackedPatch found{place.cast<double>() * to_pixels, correlation, {}};
      if (!options.measures_noise) return found;
      // What gain and offset leave of the difference is noise.
      const float noise = (1 - correlation * correlation) * t->norm2() / std::max(1.0f, n - 4);
      const float contrast = std::max(0.1f, c.product / t->norm2());
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
