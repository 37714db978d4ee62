// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <vector>

namespace framewise {

// How evenly a recording's frames follow one another.
struct FrameRate {
  struct Gap {
    double after = 0;   // time of the frame before it (s)
    double length = 0;  // s
  };

  double median_step = 0;   // between two frames (s); 0 for fewer than two
  double jitter = 0;        // median distance of the steps from their median (s)
  double longest_step = 0;  // s
  std::vector<Gap> gaps;    // steps longer than 2.5 medians, in order

  // Cameras take between a frame in five seconds and two thousand a second: otherwise the stamps are no
  // seconds.
  bool is_plausible() const { return median_step == 0 || (median_step <= 5 && median_step >= 5e-4); }

  // The gap that looks like a pause between two recordings: longer than 10 s and 100 medians. Null where
  // there is none.
  const Gap* pause() const;
};

// times: ascending (s).
FrameRate frame_rate(std::span<const double> times);

}  // namespace framewise
