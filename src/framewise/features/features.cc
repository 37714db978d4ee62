// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/features/features.h"

#include <stdexcept>

#include "framewise/features/descriptors.h"
#include "framewise/features/detectors.h"
#include "framewise/features/keypoint_scale.h"
#include "framewise/features/spread.h"

namespace framewise {
namespace {

std::string size_text(const cv::Mat& image) {
  return std::to_string(image.cols) + " x " + std::to_string(image.rows);
}

void require_gray(const char* name, const cv::Mat& image) {
  if (image.type() != CV_8UC1)
    throw std::invalid_argument(std::string(name) + ": found " + std::to_string(image.channels()) +
                                " channel(s) of " + std::to_string(8 * image.elemSize1()) +
                                " bits, expected one of 8 bits");
}

void check_images(const cv::Mat& gray, const cv::Mat& mask) {
  if (!gray.empty()) require_gray("gray", gray);
  if (mask.empty()) return;
  require_gray("mask", mask);
  if (mask.size() != gray.size())
    throw std::invalid_argument("mask: found " + size_text(mask) + " pixels, expected the image's " +
                                size_text(gray));
}

// OpenCV builds the pyramid once where its detector and its descriptor are asked for in one call.
bool take_one_pass(Detector detector, Descriptor descriptor, bool upright) {
  return (detector == Detector::kAkaze && descriptor == Descriptor::kAkaze) ||
         (!upright && ((detector == Detector::kOrb && descriptor == Descriptor::kOrb) ||
                       (detector == Detector::kSift && descriptor == Descriptor::kSift)));
}

// Keypoints to choose each feature from when they are to be spread out. ORB's strongest crowd more than
// others do.
int candidates_per_feature(Detector detector, Spread spread) {
  if (spread == Spread::kNone) return 1;
  return detector == Detector::kOrb ? 15 : 4;
}

std::vector<cv::KeyPoint> chosen(const std::vector<cv::KeyPoint>& keypoints,
                                 const std::vector<int>& indices) {
  std::vector<cv::KeyPoint> result;
  for (const int i : indices) result.push_back(keypoints[i]);
  return result;
}

}  // namespace

void FeatureOptions::check() const {
  detector_of(detector);
  descriptor_of(descriptor);
  spread_of(spread);
  if (count < 8 || count > 1000000)
    throw std::invalid_argument("count: found " + std::to_string(count) + ", expected 8 to 1000000");
}

Features extract_features(const cv::Mat& gray, const FeatureOptions& options, const cv::Mat& mask) {
  options.check();
  check_images(gray, mask);
  const Detector detector = detector_of(options.detector);
  const Descriptor descriptor = descriptor_of(options.descriptor);
  const Spread spread = spread_of(options.spread);

  Features features;
  features.finest_size = finest_size_of(detector);
  const bool one_pass =
      options.describe && spread == Spread::kNone && take_one_pass(detector, descriptor, options.upright);
  Detection found = detect(gray, mask,
                           {.detector = detector,
                            .count = options.count,
                            .candidates = options.count * candidates_per_feature(detector, spread),
                            .upright = options.upright,
                            .describe_too = one_pass});
  features.keypoints =
      chosen(found.keypoints, spread_out(found.keypoints, gray.size(), options.count, spread));
  if (!options.describe) return features;
  features.descriptors = one_pass ? in_whole_words(found.descriptors)
                                  : describe(gray, features.keypoints, detector, descriptor, options.upright);
  return features;
}

}  // namespace framewise
