// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "framewise/geometry/camera.h"
#include "framewise/odometry/window_adjustment.h"

namespace framewise {

// The lens's first radial coefficient, learned from what windows of keyframes without depth say of it. A
// camera that goes straight ahead sees little of it, and what is left of other errors looks the same in all
// its windows: they may say no more together than one of them would whose sigma is twice as large.
//   How far calibrations are off: Cvišić, Marković, Petrović, Recalibrating the KITTI dataset camera setup
//   for improved odometry accuracy, ECMR 2021.
class LensEstimate {
 public:
  // What the next window is to hold for known (WindowOptions::lens_information): so much that the lens stays
  // as it is, where windows like the last one have said what they can.
  double information_for_window() const;

  // Takes in what a window found. The camera that it teaches; empty where that is the one that was.
  std::optional<Camera> take_in(const WindowSummary& window, const Camera& camera);

  // By how much k1 is another than the calibration has it.
  double correction() const { return correction_; }

 private:
  double information_ = 1 / (0.02 * 0.02);  // of k1: what calibrations leave of it
  double told_ = 1 / (0.02 * 0.02);         // by the last window
  double correction_ = 0;
};

}  // namespace framewise
