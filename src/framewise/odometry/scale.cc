// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/odometry/scale.h"

#include <algorithm>

namespace framewise {
namespace {

constexpr std::size_t kFewest = 5;

}  // namespace

std::optional<double> length_from_depth(const Pose& cam2_from_cam1, std::span<const Eigen::Vector3d> X1,
                                        std::span<const Eigen::Vector3d> X2,
                                        std::span<const std::uint8_t> inliers) {
  std::vector<double> lengths;
  for (std::size_t i = 0; i < X1.size(); ++i)
    if (inliers[i] && X1[i].allFinite() && X2[i].allFinite())
      lengths.push_back(cam2_from_cam1.t.dot(X2[i] - cam2_from_cam1.R * X1[i]));
  if (lengths.size() < kFewest) return std::nullopt;
  const auto middle = lengths.begin() + lengths.size() / 2;
  std::nth_element(lengths.begin(), middle, lengths.end());
  return *middle;
}

std::optional<Eigen::Vector3d> translation_from_centroids(const Eigen::Matrix3d& R,
                                                          std::span<const Eigen::Vector3d> X1,
                                                          std::span<const Eigen::Vector3d> X2,
                                                          std::span<const std::uint8_t> inliers) {
  Eigen::Vector3d sum1 = Eigen::Vector3d::Zero(), sum2 = Eigen::Vector3d::Zero();
  std::size_t count = 0;
  for (std::size_t i = 0; i < X1.size(); ++i) {
    if (!inliers[i] || !X1[i].allFinite() || !X2[i].allFinite()) continue;
    sum1 += X1[i];
    sum2 += X2[i];
    ++count;
  }
  if (count < kFewest) return std::nullopt;
  return (sum2 - R * sum1) / static_cast<double>(count);
}

}  // namespace framewise
