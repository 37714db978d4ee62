// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "framewise/evaluation/association.h"

namespace framewise {

// Error of one stretch of the road, by the length of the stretch.
struct SegmentError {
  std::size_t first;   // pose it starts at
  double length;       // m: 100, 200, ... 800
  double translation;  // |t(E)| / length, no unit; times 100 is the KITTI table's per cent
  double rotation;     // angle(E) / length (rad/m)
};

struct SegmentErrors {
  std::vector<SegmentError> segments;
  // Means over all segments pooled, as the KITTI odometry table ranks.
  double translation_percent = 0;
  double rotation_deg_per_100m = 0;
};

// The KITTI odometry benchmark's errors (Geiger, Lenz, Urtasun, CVPR 2012): stretches of 100 to 800 m of the
// reference from every 10th pose; a stretch ends at the first pose further than its length; E = B^-1 A.
// Path lengths are summed in single precision, as the devkit does, since a last bit moves a stretch's end.
// No segments when the path is shorter than 100 m.
SegmentErrors kitti_segment_errors(const TrajectoryPair& matched);

}  // namespace framewise
