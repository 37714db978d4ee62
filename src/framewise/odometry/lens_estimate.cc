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

constexpr double kUsual = 0.01;      // most calibrations leave less; what says otherwise must be sure of it
constexpr double kSystematic = 2;    // errors that windows have in common, of their own sigma
constexpr double kCertainly = 1e12;  // information that no window moves

}  // namespace

double LensEstimate::information_for_window() const {
  constexpr double kBefore = 1 / (kUsual * kUsual);
  const double most = kBefore + told_ / (kSystematic * kSystematic);
  const double information = std::max(kBefore, information_);
  return information < most ? information / kShare : kCertainly;
}

std::optional<Camera> LensEstimate::take_in(const WindowSummary& window, const Camera& camera) {
  constexpr double kMost = 1 / (0.0005 * 0.0005);  // it may still be learned anew
  constexpr double kNothing = 2e-5;                // a hundredth of a pixel at a corner
  const double held = information_for_window();
  if (held < kCertainly)
    information_ = std::min(kMost, std::max(information_, kShare * window.lens_information));
  told_ = std::max(0.0, window.lens_information - held);
  if (!(std::abs(window.lens_correction) > kNothing)) return std::nullopt;
  Camera learned = camera;
  learned.distortion[0] += window.lens_correction;
  correction_ += window.lens_correction;
  return learned;
}

}  // namespace framewise
