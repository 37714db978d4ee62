// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/features/descriptors.h"

#include <algorithm>
#include <opencv2/features2d.hpp>

#include "framewise/features/keypoint_scale.h"
#ifdef FRAMEWISE_WITH_SURF
#include "framewise/features/fast_hessian.h"
#include "framewise/features/surf_descriptor.h"
#endif

namespace framewise {
namespace {

std::vector<cv::KeyPoint> converted(const std::vector<cv::KeyPoint>& keypoints, Detector detector,
                                    Descriptor descriptor, bool upright, const cv::Size& image) {
  std::vector<cv::KeyPoint> result;
  result.reserve(keypoints.size());
  for (const cv::KeyPoint& keypoint : keypoints) {
    result.push_back(keypoint_for(descriptor, keypoint, blob_sigma(keypoint, detector), image));
    if (upright) result.back().angle = 0;
  }
  return result;
}

#ifdef FRAMEWISE_WITH_SURF
cv::Mat describe_by_surf(const cv::Mat& gray, const std::vector<cv::KeyPoint>& keypoints, bool extended,
                         bool upright) {
  return describe_surf(integral_image(gray), keypoints, {extended, upright});
}
#else
cv::Mat describe_by_surf(const cv::Mat&, const std::vector<cv::KeyPoint>&, bool, bool) { return {}; }
#endif

cv::Mat describe_by(cv::Feature2D& extractor, const cv::Mat& gray, std::vector<cv::KeyPoint>& keypoints) {
  cv::Mat descriptors;
  extractor.detectAndCompute(gray, cv::noArray(), keypoints, descriptors, true);
  return descriptors;
}

// OpenCV doubles the image where any of the keypoints needs it, and then reads all from there.
cv::Mat describe_by_sift(const cv::Mat& gray, std::vector<cv::KeyPoint>& converted) {
  const bool is_doubled = std::any_of(converted.begin(), converted.end(), [](const cv::KeyPoint& k) {
    return static_cast<std::int8_t>(k.octave & 255) < 0;
  });
  if (is_doubled)
    for (cv::KeyPoint& k : converted) k.pt += sift_doubled_shift();
  return describe_by(*cv::SIFT::create(), gray, converted);
}

// ORB sorts keypoints by level and drops those at the edge: class_id, which it leaves alone, tells which is
// which.
cv::Mat describe_by_orb(const cv::Mat& gray, std::vector<cv::KeyPoint>& keypoints,
                        std::vector<cv::KeyPoint>& converted) {
  constexpr int kEdge = 16;  // half a patch; OpenCV continues the image beyond its edge
  const auto orb = cv::ORB::create();
  orb->setEdgeThreshold(kEdge);
  for (std::size_t i = 0; i < converted.size(); ++i) converted[i].class_id = static_cast<int>(i);
  const cv::Mat by_level = describe_by(*orb, gray, converted);

  std::vector<int> row_of(keypoints.size(), -1);
  for (std::size_t row = 0; row < converted.size(); ++row)
    row_of[converted[row].class_id] = static_cast<int>(row);
  std::vector<cv::KeyPoint> kept;
  cv::Mat descriptors(static_cast<int>(converted.size()), orb->descriptorSize(), CV_8U);
  for (std::size_t i = 0; i < keypoints.size(); ++i) {
    if (row_of[i] < 0) continue;
    by_level.row(row_of[i]).copyTo(descriptors.row(static_cast<int>(kept.size())));
    kept.push_back(keypoints[i]);
  }
  keypoints = std::move(kept);
  return descriptors;
}

}  // namespace

cv::Mat in_whole_words(const cv::Mat& binary_descriptors) {
  const int padding = (8 - binary_descriptors.cols % 8) % 8;
  if (binary_descriptors.empty() || padding == 0) return binary_descriptors;
  cv::Mat padded;
  cv::copyMakeBorder(binary_descriptors, padded, 0, 0, 0, padding, cv::BORDER_CONSTANT, cv::Scalar(0));
  return padded;
}

cv::Mat describe(const cv::Mat& gray, std::vector<cv::KeyPoint>& keypoints, Detector detector,
                 Descriptor descriptor, bool upright) {
  if (keypoints.empty()) return {};
  auto as_read = converted(keypoints, detector, descriptor, upright, gray.size());
  switch (descriptor) {
    case Descriptor::kSift:
      return describe_by_sift(gray, as_read);
    case Descriptor::kSurf:
    case Descriptor::kSurf128:
      return describe_by_surf(gray, as_read, descriptor == Descriptor::kSurf128, upright);
    case Descriptor::kOrb:
      return describe_by_orb(gray, keypoints, as_read);
    case Descriptor::kAkaze:
      break;
  }
  const auto type = upright ? cv::AKAZE::DESCRIPTOR_MLDB_UPRIGHT : cv::AKAZE::DESCRIPTOR_MLDB;
  return in_whole_words(describe_by(*cv::AKAZE::create(type), gray, as_read));
}

}  // namespace framewise
