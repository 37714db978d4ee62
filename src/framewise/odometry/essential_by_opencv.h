// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "framewise/geometry/correspondences.h"
#include "framewise/robust/estimate.h"

namespace framewise {

// Relative pose as OpenCV has it: cv::findEssentialMat with RANSAC on (x / z, y / z), then cv::recoverPose.
// Its pose is cam2_from_cam1 with |t| = 1; its inliers are those in front of both cameras. The covariance is
// not known. max_error: pixels over focal length. Empty where fewer than 5 rays look forward or OpenCV finds
// no single matrix.
std::optional<Estimate> essential_by_opencv(const Correspondences& shared, double max_error,
                                            double confidence);

}  // namespace framewise
