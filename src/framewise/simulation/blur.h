// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>
#include <span>

#include "framewise/simulation/sensor_view.h"

namespace framewise {

// The mean of the light of views from about the same place, CV_32FC3, by one ray a pixel and view. What
// surfaces show is taken from the middle view, which has no distortion, where that sees the same place to
// half a pixel. A ray is not even traced where nothing near its pixel could hide what the middle view sees
// there.
cv::Mat mean_of_views(const View& middle, std::span<const View> views);

}  // namespace framewise
