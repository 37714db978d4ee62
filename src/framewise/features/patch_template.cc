// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/features/patch_template.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace framewise {

std::optional<PatchTemplate> make_patch_template(const ImageLevels& image1, const PatchWarp& warp,
                                                 int radius) {
  radius = std::min(radius, kMaxPatchRadius);
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
  if (!is_inside(image1[level1], centre.x(), centre.y(), reach)) return std::nullopt;

  std::array<float, kMaxPatchSide * kMaxPatchSide> wide;
  for (int y = -outer, k = 0; y <= outer; ++y)
    for (int x = -outer; x <= outer; ++x, ++k) {
      const Eigen::Vector2f p = centre + A * Eigen::Vector2f(x, y);
      wide[k] = sampled(image1[level1], p.x(), p.y());
    }
  PatchTemplate t;
  t.side = 2 * radius + 1;
  float mean = 0;
  for (int y = 0, k = 0; y < t.side; ++y)
    for (int x = 0; x < t.side; ++x, ++k) {
      const float* w = wide.data() + (y + 1) * outer_side + x + 1;
      t.value[k] = w[0];
      const Eigen::Vector2f gradient = gradient_at(w, outer_side);
      t.gx[k] = gradient.x(), t.gy[k] = gradient.y();
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

}  // namespace framewise
