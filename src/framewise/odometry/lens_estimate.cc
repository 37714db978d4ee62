// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/odometry/lens_estimate.h"

#include <algorithm>
#include <cmath>

namespace framewise {
namespace {

// Of what a window says: it shares most of its views with the ones before, and what else it leaves is alike
// in neighbours.
constexpr double kShare = 0.02;

}  // namespace

double LensEstimate::information_for_window() const { return information_ / kShare; }

std::optional<Camera> LensEstimate::take_in(const WindowSummary& window, const Camera& camera) {
  constexpr double kMost = 1 / (0.0005 * 0.0005);  // it may still be learned anew
  constexpr double kNothing = 2e-5;                // a hundredth of a pixel at a corner
  information_ = std::min(kMost, std::max(information_, kShare * window.lens_information));
  if (!(std::abs(window.lens_correction) > kNothing)) return std::nullopt;
  Camera learned = camera;
  learned.distortion[0] += window.lens_correction;
  correction_ += window.lens_correction;
  return learned;
}

}  // namespace framewise
