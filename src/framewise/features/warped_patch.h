// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <opencv2/core.hpp>
#include <optional>
#include <vector>

#include "framewise/geometry/place_noise.h"

namespace framewise {

// An image and its halvings: the pixel (u, v) of the image is (u, v) / 2^k on level k.
using ImageLevels = std::vector<cv::Mat>;

// gray: CV_8U. As many levels as have a side of 32 pixels or more, at most `count`.
ImageLevels image_levels(const cv::Mat& gray, int count = 4);

struct PatchTrackOptions {
  int radius = 4;                // patches are (2 radius + 1)^2 pixels of the level; at most 4
  int max_iterations = 12;       // the steps shrink by ten or more each time where it succeeds at all
  double min_step_px = 0.02;     // done at a shorter step, in pixels of the level
  double max_shift = 4;          // one that wants to go farther was expected elsewhere: pixels of the level
  double min_correlation = 0.8;  // normalised; what is not the same thing seldom reaches 0.7
  bool measures_noise = true;    // else the place alone is wanted
};

// Where a patch of image 1 is expected in image 2.
struct PatchWarp {
  Eigen::Vector2d pixel1, pixel2;
  Eigen::Matrix2d pixel2_from_pixel1;  // how an offset from pixel1 looks in image 2
  int level;                           // of image 2 that is looked at
};

struct TrackedPatch {
  Eigen::Vector2d pixel2;
  double correlation;
  PlaceNoise noise_px;  // under the noise the patch shows, where that was measured
};

// Moves pixel2 to where image 2 looks most like the warped patch of image 1, but for brightness and contrast;
// what has too little texture, leaves either image or does not resemble is not found.
//   Baker, Matthews, Lucas-Kanade 20 years on: a unifying framework, IJCV 2004 (inverse compositional); with
//   gain and offset as Forster, Pizzoli, Scaramuzza, SVO, ICRA 2014, has the offset.
std::optional<TrackedPatch> track_patch(const ImageLevels& image1, const ImageLevels& image2,
                                        const PatchWarp& warp, const PatchTrackOptions& options = {});

}  // namespace framewise
