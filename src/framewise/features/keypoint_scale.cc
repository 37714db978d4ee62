// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/features/keypoint_scale.h"

#include <algorithm>
#include <cmath>

namespace framewise {
namespace {

constexpr float kSurfSizePerSigma = 0.71f * 9 / 1.2f;
constexpr float kOrbPatch = 31, kOrbBlur = 2, kOrbLevelFactor = 1.2f;
constexpr float kSiftSigma = 1.6f, kSiftSizePerSigma = 2 * 0.89f;
constexpr int kSiftLayers = 3;
constexpr float kAkazeSigma = 1.5f * 1.6f;
constexpr int kAkazeLayers = 4, kAkazeOctaves = 4;

int nearest_level(float sigma, float finest_sigma, float levels_per_octave) {
  return static_cast<int>(std::lround(levels_per_octave * std::log2(sigma / finest_sigma)));
}

// SIFT packs the octave (from -1, the image doubled) into the lowest byte and the layer into the next.
int sift_octave(float sigma, int shorter_side) {
  const int coarsest_octave = std::max(0, static_cast<int>(std::log2(shorter_side)) - 4);
  const int level = std::clamp(nearest_level(sigma, kSiftSigma, kSiftLayers), 1 - kSiftLayers,
                               (coarsest_octave + 1) * kSiftLayers);
  const int octave = (level + kSiftLayers - 1) / kSiftLayers - 1;  // layers 1 to 3; level is above -3
  return (octave & 255) | (level - octave * kSiftLayers) << 8;
}

// How much smaller a level of ORB's pyramid is by its name, and how many pixels of the image one of its
// pixels truly spans.
struct OrbLevel {
  float factor, pixels_x, pixels_y;

  OrbLevel(int level, const cv::Size& image)
      : factor(std::pow(kOrbLevelFactor, static_cast<float>(level))),
        pixels_x(static_cast<float>(image.width) / std::round(static_cast<float>(image.width) / factor)),
        pixels_y(static_cast<float>(image.height) / std::round(static_cast<float>(image.height) / factor)) {}
};

int orb_level(float sigma, int shorter_side) {
  constexpr float kSmallestSide = 2 * kOrbPatch;
  const float per_octave = 1 / std::log2(kOrbLevelFactor);
  const int coarsest = static_cast<int>(per_octave * std::log2(std::max(1.0f, shorter_side / kSmallestSide)));
  return std::clamp(nearest_level(sigma, kOrbBlur, per_octave), 0, coarsest);
}

// OpenCV's AKAZE has no level narrower than 80 or lower than 40 pixels but the first octave's.
int akaze_level(float sigma, const cv::Size& image) {
  int octaves = 1;
  while (octaves < kAkazeOctaves && image.width >> octaves >= 80 && image.height >> octaves >= 40) ++octaves;
  return std::clamp(nearest_level(sigma, kAkazeSigma, kAkazeLayers), 0, octaves * kAkazeLayers - 1);
}

}  // namespace

float blob_sigma(const cv::KeyPoint& keypoint, Detector detector) {
  switch (detector) {
    case Detector::kSurf:
      return keypoint.size / kSurfSizePerSigma;
    case Detector::kOrb:
      return keypoint.size * (kOrbBlur / kOrbPatch);
    case Detector::kSift:
      return keypoint.size / kSiftSizePerSigma;
    case Detector::kAkaze:
      break;
  }
  return keypoint.size / 2;
}

cv::Point2f true_place(const cv::KeyPoint& keypoint, Detector detector, const cv::Size& image) {
  if (detector == Detector::kSift) return keypoint.pt - sift_doubled_shift();
  if (detector != Detector::kOrb) return keypoint.pt;
  const OrbLevel level(keypoint.octave, image);
  return {(keypoint.pt.x / level.factor + 0.5f) * level.pixels_x - 0.5f,
          (keypoint.pt.y / level.factor + 0.5f) * level.pixels_y - 0.5f};
}

float finest_size_of(Detector detector) {
  switch (detector) {
    case Detector::kSift:
      return 2.0f;
    case Detector::kSurf:
      return 12.0f;
    case Detector::kOrb:
      return kOrbPatch;
    case Detector::kAkaze:
      break;
  }
  return 2 * kAkazeSigma;
}

cv::KeyPoint keypoint_for(Descriptor descriptor, const cv::KeyPoint& keypoint, float sigma,
                          const cv::Size& image) {
  cv::KeyPoint converted = keypoint;
  const int shorter_side = std::min(image.width, image.height);
  switch (descriptor) {
    case Descriptor::kSift: {
      const float size = kSiftSizePerSigma * sigma;
      converted.octave = sift_octave(size / 2, shorter_side);
      converted.size = std::clamp(size, 2.0f, static_cast<float>(shorter_side) / 6);
      break;
    }
    case Descriptor::kSurf:
    case Descriptor::kSurf128:
      converted.size = kSurfSizePerSigma * sigma;
      break;
    case Descriptor::kOrb: {
      converted.octave = orb_level(sigma, shorter_side);
      const OrbLevel level(converted.octave, image);
      converted.size = kOrbPatch * level.factor;
      converted.pt = {((keypoint.pt.x + 0.5f) / level.pixels_x - 0.5f) * level.factor,
                      ((keypoint.pt.y + 0.5f) / level.pixels_y - 0.5f) * level.factor};
      break;
    }
    case Descriptor::kAkaze: {
      converted.class_id = akaze_level(sigma, image);
      converted.octave = converted.class_id / kAkazeLayers;
      const float level_sigma =
          kAkazeSigma * std::exp2(static_cast<float>(converted.class_id) / kAkazeLayers);
      converted.size = 2 * std::clamp(sigma, kAkazeSigma, 1.2f * level_sigma);
      break;
    }
  }
  return converted;
}

}  // namespace framewise
