// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "framewise/features/matching.h"

namespace framewise {

// Matches among those pairs whose second feature lies within options.window_px of where the first is expected
// in image 2: |pixels2[j] - predicted2[i]| <= window_px. Exact among them; ties, cross-check and ratio test
// as in match_features, all of them among such pairs alone. options.matcher and seed have no say. predicted2
// has an entry for every row of descriptors1, pixels2 for every row of descriptors2; one that is not finite
// (a point behind the camera, say) lies nowhere and has no match.
std::vector<FeatureMatch> match_windowed(const cv::Mat& descriptors1,
                                         const std::vector<cv::Point2f>& predicted2,
                                         const cv::Mat& descriptors2, const std::vector<cv::Point2f>& pixels2,
                                         const MatchOptions& options = {});

}  // namespace framewise
