// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/features/patch_template.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstring>

namespace framewise {
namespace {

// J' J of the pixels' (gx, gy, value, 1).
Eigen::Matrix4f products(const PatchTemplate& t) {
  const PatchRows* const columns[] = {&t.gx, &t.gy, &t.value, &t.inside};
  Eigen::Matrix4f H;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j <= i; ++j) {
      Eigen::Array4f sum = Eigen::Array4f::Zero();
      for (int k = 0; k < t.padded_size(); k += 4) sum += four(*columns[i], k) * four(*columns[j], k);
      H(i, j) = H(j, i) = sum.sum();
    }
  return H;
}

// As many bytes as a row has; zeros for those that the image no longer has.
void read_row(const std::uint8_t* from, int left, std::array<std::uint8_t, kPatchRow>& row) {
  if (left >= kPatchRow) {
    std::memcpy(row.data(), from, kPatchRow);
  } else {
    row.fill(0);
    std::copy(from, from + left, row.begin());
  }
}

}  // namespace

void sample_patch(const cv::Mat& image, const Eigen::Vector2f& place, int radius, PatchRows& values) {
  const int u0 = static_cast<int>(place.x()), v0 = static_cast<int>(place.y());
  const float a = place.x() - static_cast<float>(u0), b = place.y() - static_cast<float>(v0);
  const int begin = u0 - radius, side = 2 * radius + 1;
  std::array<std::uint8_t, kPatchRow> bytes;
  std::array<float, kPatchRow + 1> row{};
  std::array<float, kPatchRow> above{}, here;
  for (int y = 0; y <= side; ++y) {
    read_row(image.ptr(v0 - radius + y) + begin, image.cols - begin, bytes);
    for (int x = 0; x < kPatchRow; ++x) row[x] = bytes[x];
    for (int x = 0; x < kPatchRow; ++x) here[x] = (1 - a) * row[x] + a * row[x + 1];
    if (y > 0)
      for (int x = 0; x < kPatchRow; ++x) values[(y - 1) * kPatchRow + x] = (1 - b) * above[x] + b * here[x];
    above = here;
  }
}

PatchComparison::PatchComparison(const PatchTemplate& t, const cv::Mat& image, const Eigen::Vector2f& place) {
  PatchRows values;
  sample_patch(image, place, t.side / 2, values);
  Eigen::Array4f with_gx = Eigen::Array4f::Zero(), with_gy = with_gx, with_value = with_gx, all = with_gx,
                 squared = with_gx;
  for (int k = 0; k < t.padded_size(); k += 4) {
    const Eigen::Array4f value = four_less_mean(values, k, t);
    with_gx += value * four(t.gx, k), with_gy += value * four(t.gy, k);
    with_value += value * four(t.value, k);
    all += value, squared += value * value;
  }
  sum = all.sum(), squares = squared.sum(), product = with_value.sum();
  b = Eigen::Vector4f(with_gx.sum(), with_gy.sum(), product, sum) - t.H.col(2);
}

void gradients_inside(const PatchRows& wide, int side, PatchRows& gx, PatchRows& gy) {
  for (int y = 0; y < side; ++y) {
    const float* const row = wide.data() + (y + 1) * kPatchRow + 1;
    float *const along_x = gx.data() + y * kPatchRow, *const along_y = gy.data() + y * kPatchRow;
    for (int x = 0; x < side; ++x) {
      along_x[x] = 0.5f * (row[x + 1] - row[x - 1]);
      along_y[x] = 0.5f * (row[x + kPatchRow] - row[x - kPatchRow]);
    }
    std::fill(along_x + side, along_x + kPatchRow, 0.0f);
    std::fill(along_y + side, along_y + kPatchRow, 0.0f);
  }
}

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

  PatchRows wide{};
  for (int y = 0; y < outer_side; ++y)
    for (int x = 0; x < outer_side; ++x) {
      const Eigen::Vector2f p = centre + A * Eigen::Vector2f(x - outer, y - outer);
      wide[y * kPatchRow + x] = sampled(image1[level1], p.x(), p.y());
    }
  PatchTemplate t;
  t.side = 2 * radius + 1;
  gradients_inside(wide, t.side, t.gx, t.gy);
  for (int y = 0; y < t.side; ++y)
    for (int x = 0; x < kPatchRow; ++x) {
      const int k = y * kPatchRow + x;
      const bool is_inside = x < t.side;
      t.inside[k] = is_inside ? 1.0f : 0.0f;
      t.value[k] = is_inside ? wide[k + kPatchRow + 1] : 0;
      t.mean += t.value[k];
    }
  t.mean /= static_cast<float>(t.size());
  for (int k = 0; k < t.padded_size(); ++k) t.value[k] -= t.mean * t.inside[k];
  t.H = products(t);
  const float smaller = 0.5f * (t.H(0, 0) + t.H(1, 1) - std::hypot(t.H(0, 0) - t.H(1, 1), 2 * t.H(0, 1)));
  constexpr float kLeastGradient = 1.5f;  // grey levels a pixel, squared: camera noise alone has as much
  if (!(smaller > kLeastGradient * static_cast<float>(t.size()))) return std::nullopt;
  t.H_inverse = t.H.inverse();
  if (!t.H_inverse.allFinite()) return std::nullopt;
  return t;
}

}  // namespace framewise
