// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "framewise/robust/consensus.h"
#include "framewise/robust/estimate.h"
#include "framewise/robust/rival_minima.h"

namespace framewise {

// What the members of a consensus say about the motion, and the motion that is safe to state.
struct Support {
  EstimateKind kind = EstimateKind::kFull;
  Pose pose;            // for kRotationOnly: t = 0
  Matrix6d covariance;  // for kRotationOnly: the translation's part is NaN
};

// Chooses between a motion and a mere rotation, then asks how well the direction of t is known.
//   Rotation only: what remains after the best rotation is, within four standard deviations of its own, the
//   noise that the epipolar distances show. A likelihood ratio: the epipolar model has a free depth for each
//   point, so its fit cannot be compared as such (Torr, Fitzgibbon, Zisserman, The Problem of Degeneracy in
//   Structure and Motion Recovery from Uncalibrated Image Sequences, IJCV 1999); its noise level can. Low
//   parallax: the standard deviation of the direction, less what noise alone feigns, is above 6 deg; or
//   another motion fits as well, as on a plane or in a small motion.
Support what_data_support(const TwoViews& views, const Settled& settled);

// Whether differences of bearings whose rotation is taken out are mere noise: the sum of their squares over
// 2 sigma^2 (both rays have noise), of n correspondences, with sigma taken from n residuals.
bool is_mere_noise(double chi_squared, double n);

}  // namespace framewise
