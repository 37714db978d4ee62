// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "framewise/features/feature_names.h"

namespace framewise {

// The strongest keypoints crowd where the texture is, and a pose from a corner of the image is a weak one.
// Chooses at most `count` of keypoints, by index and in their order, strongest first:
//   none  the first.
//   grid  the image in about `count` / 4 square cells; the strongest of each, then the second of each, ...
//   anms  adaptive non-maximal suppression: of the strongest first, each as far from those already kept as
//         still gives `count`: Bailo, Rameau, Joo, Park, Bogdan, Kweon, Efficient adaptive non-maximal
//         suppression algorithms for homogeneous spatial keypoint distribution, PRL 2018 (suppression via
//         square covering).
std::vector<int> spread_out(const std::vector<cv::KeyPoint>& keypoints, const cv::Size& image, int count,
                            Spread spread);

}  // namespace framewise
