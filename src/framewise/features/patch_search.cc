// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/features/patch_search.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "framewise/features/patch_template.h"

namespace framewise {
namespace {

// Normalised, of the template and the patch about a place; -1 where that has no contrast.
float correlation_at(const PatchTemplate& t, const cv::Mat& image, const Eigen::Vector2f& place) {
  const PatchComparison c(t, image, place);
  const float variance2 = c.variance(t);
  if (!(variance2 > static_cast<float>(t.size()))) return -1;
  return c.product / std::sqrt(variance2 * t.norm2());
}

}  // namespace

std::optional<Eigen::Vector2d> search_patch(const ImageLevels& image1, const ImageLevels& image2,
                                            const PatchWarp& warp, const Eigen::Vector2d& end,
                                            const PatchSearchOptions& options) {
  if (image1.empty() || static_cast<int>(image2.size()) <= warp.level) return std::nullopt;
  const auto t = make_patch_template(image1, warp, options.radius);
  if (!t) return std::nullopt;
  const cv::Mat& image = image2[warp.level];
  const double shrink = std::ldexp(1.0, -warp.level);
  const Eigen::Vector2f from = (warp.pixel2 * shrink).cast<float>(), to = (end * shrink).cast<float>();
  if (!from.allFinite() || !to.allFinite()) return std::nullopt;
  const float length = (to - from).norm();
  const int steps =
      std::clamp(static_cast<int>(std::ceil(std::min(length, 1e6f))), 1, options.max_places - 1);
  std::vector<float> correlations(steps + 1, -1);
  for (int i = 0; i <= steps; ++i) {
    const Eigen::Vector2f place = from + (to - from) * (static_cast<float>(i) / static_cast<float>(steps));
    if (is_inside(image, place.x(), place.y(), t->side / 2))
      correlations[i] = correlation_at(*t, image, place);
  }
  const auto best = std::max_element(correlations.begin(), correlations.end());
  if (!(*best >= options.min_correlation)) return std::nullopt;
  const int at = static_cast<int>(best - correlations.begin());
  const int apart =
      std::max(2, static_cast<int>(std::ceil(3.0f * static_cast<float>(steps) / std::max(1.0f, length))));
  constexpr float kNoise = 0.01f;  // no two images of one thing are more alike
  const double alike = options.min_distinction * (1 - *best) + kNoise;
  for (int i = 0; i <= steps; ++i)
    if (std::abs(i - at) > apart && 1 - correlations[i] < alike) return std::nullopt;
  const double share = static_cast<double>(at) / steps;
  return warp.pixel2 + share * (end - warp.pixel2);
}

}  // namespace framewise
