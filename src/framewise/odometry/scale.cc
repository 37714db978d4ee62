// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/odometry/scale.h"

#include <algorithm>

namespace framewise {

std::optional<double> length_from_depth(const Pose& cam2_from_cam1, std::span<const Eigen::Vector3d> X1,
                                        std::span<const Eigen::Vector3d> X2,
                                        std::span<const std::uint8_t> inliers) {
  std::vector<double> lengths;
  for (std::size_t i = 0; i < X1.size(); ++i)
    if (inliers[i] && X1[i].allFinite() && X2[i].allFinite())
      lengths.push_back(cam2_from_cam1.t.dot(X2[i] - cam2_from_cam1.R * X1[i]));
  if (lengths.size() < 5) return std::nullopt;
  const auto middle = lengths.begin() + lengths.size() / 2;
  std::nth_element(lengths.begin(), middle, lengths.end());
  return *middle;
}

}  // namespace framewise
