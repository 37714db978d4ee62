// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>

#include "framewise/features/feature_names.h"

namespace framewise {

// KeyPoint::size means something else to every detector and to every descriptor. What they share is the
// standard deviation sigma (pixels) of the Gaussian blob that a keypoint stands for:
//
//   detector  size is                                sigma            because
//   sift      twice the sigma of its level           size / 2 / 0.89  a blob of 1 answers most at 0.89
//   surf      the side 9 s / 1.2 of its box filter   s / 0.71         likewise at s = 0.71
//   akaze     twice the spacing of its derivatives   size / 2         likewise at 1; levels are far apart
//   orb       the patch of 31 pixels of its level    size / 15.5      it is read after a blur of sigma 2
//
//   descriptor  window       read from                                            finest sigma
//   sift        12 size / 2  the nearest level; octave packs octave and layer     1.1, image doubled
//   surf        20 s         the integral image                                   any
//   akaze       20 size / 2  level class_id of octave, whose spacing this is      2.4
//   orb         31 pixels    level octave of a pyramid                            2
//
// A keypoint finer than a descriptor's finest is described at that. Levels stop where the image would be
// too small for them.
float blob_sigma(const cv::KeyPoint& keypoint, Detector detector);

// OpenCV's pyramids keep the edges of the image where they are, its keypoints the centre of the first pixel:
// a keypoint of sift (the image doubled) is 0.25 pixels off both ways, one of orb up to 2 (the image shrunk
// to whole pixels). Where it is, of where OpenCV has it.
cv::Point2f true_place(const cv::KeyPoint& keypoint, Detector detector, const cv::Size& image);

// What sift's extractor wants added to places where it doubles the image: where any octave is -1.
inline cv::Point2f sift_doubled_shift() { return {0.25f, 0.25f}; }

// The size of the finest keypoints a detector gives.
float finest_size_of(Detector detector);

// The keypoint with place, size, octave and class_id as a descriptor's extractor reads them; sift's place is
// for an image that is not doubled.
cv::KeyPoint keypoint_for(Descriptor descriptor, const cv::KeyPoint& keypoint, float sigma,
                          const cv::Size& image);

}  // namespace framewise
