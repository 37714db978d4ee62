// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/odometry/essential_by_opencv.h"

#include <algorithm>
#include <opencv2/calib3d.hpp>
#include <vector>

namespace framewise {

std::optional<Estimate> essential_by_opencv(const Correspondences& shared, double max_error,
                                            double confidence) {
  std::vector<cv::Point2d> points1, points2;
  std::vector<std::size_t> index;
  for (std::size_t i = 0; i < shared.size(); ++i) {
    const Bearing &a = shared.x1[i], &b = shared.x2[i];
    if (!(a.z() > 1e-6 && b.z() > 1e-6)) continue;
    points1.emplace_back(a.x() / a.z(), a.y() / a.z());
    points2.emplace_back(b.x() / b.z(), b.y() / b.z());
    index.push_back(i);
  }
  if (index.size() < 5) return std::nullopt;
  const cv::Mat K = cv::Mat::eye(3, 3, CV_64F);
  cv::Mat mask, R, t;
  const cv::Mat E =
      cv::findEssentialMat(points1, points2, K, cv::RANSAC, std::min(confidence, 0.999999), max_error, mask);
  if (E.rows != 3) return std::nullopt;
  Estimate estimate;
  estimate.num_inliers =
      static_cast<std::size_t>(std::max(0, cv::recoverPose(E, points1, points2, K, R, t, mask)));
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) estimate.cam2_from_cam1.R(i, j) = R.at<double>(i, j);
    estimate.cam2_from_cam1.t[i] = t.at<double>(i);
  }
  estimate.inliers.assign(shared.size(), 0);
  for (std::size_t k = 0; k < index.size(); ++k)
    estimate.inliers[index[k]] = mask.at<unsigned char>(static_cast<int>(k)) != 0;
  return estimate;
}

}  // namespace framewise
