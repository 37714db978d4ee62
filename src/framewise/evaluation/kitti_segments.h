// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "framewise/evaluation/association.h"

namespace framewise {

// Error of one stretch of the road, by the length of the stretch; in single precision, as the devkit has it.
struct SegmentError {
  std::size_t first;      // pose it starts at
  double length;          // m: 100, 200, ... 800
  double translation;     // |t(E)| / length, no unit
  double rotation;        // angle(E) / length (rad/m), the devkit's
  double exact_rotation;  // the same in double precision
};

struct SegmentErrors {
  std::vector<SegmentError> segments;
  // Means over all segments pooled, by which the KITTI odometry table ranks.
  double translation_percent = 0;
  double rotation_deg_per_100m = 0;
  double exact_rotation_deg_per_100m = 0;
};

// The KITTI odometry benchmark's errors (Geiger, Lenz, Urtasun, CVPR 2012): stretches of 100 to 800 m of the
// reference from every 10th pose; a stretch ends at the first pose further than its length; E = B^-1 A.
// Path lengths and errors are rounded to single precision where the devkit does it: a last bit moves a
// stretch's end, and an angle that is the arc cosine of a float near 1 is a multiple of some 3e-4 rad.
// Figures meant for that table must have it so; exact_rotation is what small errors should be judged by. No
// segments when the path is shorter than 100 m.
SegmentErrors kitti_segment_errors(const TrajectoryPair& matched);

}  // namespace framewise
