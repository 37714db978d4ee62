// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/features/detectors.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <opencv2/features2d.hpp>
#include <tuple>

#include "framewise/features/blob_strengths.h"
#include "framewise/features/keypoint_scale.h"
#ifdef FRAMEWISE_WITH_SURF
#include "framewise/features/fast_hessian.h"
#include "framewise/features/surf_descriptor.h"
#endif

namespace framewise {
namespace {

constexpr double kEnough = 0.9;  // of the count wanted

bool is_stronger(const cv::KeyPoint& a, const cv::KeyPoint& b) {
  return std::tie(b.response, a.pt.y, a.pt.x, a.size, a.angle) <
         std::tie(a.response, b.pt.y, b.pt.x, b.size, b.angle);
}

Detection strongest(const Detection& all, int count) {
  std::vector<int> order(all.keypoints.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](int a, int b) { return is_stronger(all.keypoints[a], all.keypoints[b]); });
  if (static_cast<int>(order.size()) > count) order.resize(count);
  Detection kept;
  if (!all.descriptors.empty())
    kept.descriptors.create(static_cast<int>(order.size()), all.descriptors.cols, all.descriptors.type());
  for (const int i : order) {
    if (!all.descriptors.empty())
      all.descriptors.row(i).copyTo(kept.descriptors.row(static_cast<int>(kept.keypoints.size())));
    kept.keypoints.push_back(all.keypoints[i]);
  }
  return kept;
}

Detection run(cv::Feature2D& detector, const cv::Mat& gray, const cv::Mat& mask,
              const DetectOptions& options) {
  Detection found;
  if (options.describe_too)
    detector.detectAndCompute(gray, mask, found.keypoints, found.descriptors);
  else
    detector.detect(gray, found.keypoints, mask);
  return found;
}

// Detects at a threshold, and again at lower ones while fewer than nine tenths of `count` were found. `with`
// detects at a threshold.
template <typename With>
Detection at_falling_thresholds(double threshold, double lowest, int count, const With& with) {
  constexpr int kTries = 3;
  Detection found;
  for (int i = 0; i < kTries; ++i) {
    threshold = i + 1 < kTries ? std::max(threshold, lowest) : lowest;
    found = with(threshold);
    const double share = static_cast<double>(found.keypoints.size()) / count;
    if (share >= kEnough || threshold <= lowest) break;
    // In most images the count grows with about the 0.7th power of 1 / threshold.
    threshold *= 0.7 * std::pow(share, 1.5);
  }
  return found;
}

// The strength of the blob that `count` others surpass, 0 where there are fewer.
double strength_of(const cv::Mat& gray, const cv::Mat& mask, int count, const BlobStrengthOptions& options) {
  const std::vector<float> strengths = blob_strengths(gray, mask, options);
  return static_cast<std::size_t>(count) < strengths.size() ? strengths[count] : 0;
}

// Contrasts go with the square root of determinants. The factor finds the count in most images or somewhat
// more (of indoor, street and facade images: 0.0067 to 0.012); what is too much costs little.
Detection detect_sift(const cv::Mat& gray, const cv::Mat& mask, const DetectOptions& options) {
  constexpr double kContrastPerStrength = 0.0073, kLowest = 0.006;
  const double strength = strength_of(gray, mask, options.candidates, {1.0, 1});
  const int cap = mask.empty() ? options.candidates : 0;  // OpenCV caps before it masks
  return at_falling_thresholds(
      kContrastPerStrength * std::sqrt(strength), kLowest, options.count,
      [&](double threshold) { return run(*cv::SIFT::create(cap, 3, threshold), gray, mask, options); });
}

// Of the same images the factor that finds the count is 5.4e-5 to 14e-5.
Detection detect_akaze(const cv::Mat& gray, const cv::Mat& mask, const DetectOptions& options) {
  constexpr double kResponsePerStrength = 6.2e-5, kLowest = 1e-5;
  const double strength = strength_of(gray, mask, options.candidates, {1.5, 3});
  const auto type = options.upright ? cv::AKAZE::DESCRIPTOR_MLDB_UPRIGHT : cv::AKAZE::DESCRIPTOR_MLDB;
  return at_falling_thresholds(
      kResponsePerStrength * strength, kLowest, options.count, [&](double threshold) {
        return run(*cv::AKAZE::create(type, 0, 3, static_cast<float>(threshold)), gray, mask, options);
      });
}

// FAST's default finds enough in most images, and what Harris thinks of the corners decides.
Detection detect_orb(const cv::Mat& gray, const cv::Mat& mask, const DetectOptions& options) {
  constexpr int kDefault = 20, kLower = 10, kLowest = 5;
  const auto orb = cv::ORB::create(options.candidates);
  Detection found;
  for (const int threshold : {kDefault, kLower, kLowest}) {
    orb->setFastThreshold(threshold);
    found = run(*orb, gray, mask, options);
    if (static_cast<double>(found.keypoints.size()) >= kEnough * options.count) break;
  }
  return found;
}

#ifdef FRAMEWISE_WITH_SURF
Detection detect_surf(const cv::Mat& gray, const cv::Mat& mask, const DetectOptions& options) {
  constexpr float kLowest = 1;  // grey levels^2; noise of one grey level makes 0.02
  const cv::Mat integral = integral_image(gray);
  Detection found{detect_fast_hessian(integral, kLowest), {}};
  if (!mask.empty()) cv::KeyPointsFilter::runByPixelsMask(found.keypoints, mask);
  if (static_cast<int>(found.keypoints.size()) > options.candidates)
    found.keypoints.resize(options.candidates);
  if (!options.upright) orient_surf(integral, found.keypoints);
  return found;
}
#else
Detection detect_surf(const cv::Mat&, const cv::Mat&, const DetectOptions&) { return {}; }
#endif

Detection detect_with(const cv::Mat& gray, const cv::Mat& mask, const DetectOptions& options) {
  switch (options.detector) {
    case Detector::kSift:
      return detect_sift(gray, mask, options);
    case Detector::kSurf:
      return detect_surf(gray, mask, options);
    case Detector::kOrb:
      return detect_orb(gray, mask, options);
    case Detector::kAkaze:
      break;
  }
  return detect_akaze(gray, mask, options);
}

// SIFT gives a place once for each of its directions.
void make_upright(std::vector<cv::KeyPoint>& keypoints) {
  for (cv::KeyPoint& keypoint : keypoints) keypoint.angle = 0;
  const auto last = std::unique(keypoints.begin(), keypoints.end(), [](const auto& a, const auto& b) {
    return a.pt == b.pt && a.size == b.size;
  });
  keypoints.erase(last, keypoints.end());
}

}  // namespace

Detection detect(const cv::Mat& gray, const cv::Mat& mask, const DetectOptions& options) {
  // A smaller image has nothing to recognise, and OpenCV's detectors read beyond the smallest.
  constexpr int kSmallestSide = 16;
  if (std::min(gray.rows, gray.cols) < kSmallestSide) return {};
  Detection found = detect_with(gray, mask, options);
  if (options.detector != Detector::kOrb || static_cast<int>(found.keypoints.size()) > options.candidates)
    found = strongest(found, options.candidates);
  for (cv::KeyPoint& keypoint : found.keypoints)
    keypoint.pt = true_place(keypoint, options.detector, gray.size());
  if (options.upright && found.descriptors.empty()) make_upright(found.keypoints);
  return found;
}

}  // namespace framewise
