// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace framewise {

// How many samples are to be drawn so that with probability `confidence` one is free of outliers:
//   N = log(1 - p) / log(1 - w^s), p the confidence, w the share of inliers, s the sample size
//   Fischler and Bolles, CACM 1981. At w = 1 a single sample does; at w = 0 the answer is infinity.
double ransac_iterations(double confidence, double inlier_share, int sample_size);

}  // namespace framewise
