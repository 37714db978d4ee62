// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace framewise {

// How the default odometer works: each frame against a local map (--reference map).
struct MapOptions {
  // Each of these can be left out, to see what it gives.
  bool shrink = true;  // poses towards the motion before, by both uncertainties (motion_filter.h)
  // The last keyframes and their points together (window_adjustment.h), with depth: always, never or auto
  // (keyframe_choice.h).
  std::string adjust = "auto";
  bool fuse = true;        // depth of later frames into the points
  bool follow = true;      // depth to where the camera was when it was taken
  bool unskew = true;      // a rolling shutter's rows, by a readout learned with depth (rolling_shutter.h)
  bool learn_lens = true;  // without depth: what the calibration leaves of it (window_adjustment.h)
  int features = 1000;     // of a keyframe
  std::string spread = "grid";  // over the image: crowded ones say the same (spread.h)
  double keyframe_share = 0.7;  // a frame that sees less than this of what the last keyframe saw becomes one
  // Without depth also one whose motion shifted what it sees by so much of the image's width.
  double keyframe_shift = 0.006;
  int keyframes = 40;     // kept; beyond, the oldest and its points are forgotten
  int newest = 4;         // of them tracked against and adjusted whatever they see,
  int others = 4;         // and those most in view
  int points = 500;       // tracked in a frame: more take longer and add little
  double window_px = 40;  // how far from where it is expected a point is looked for
  // Depths and warps are of the plane through so many pixels around a point (depth_plane.h); 0: of its pixel.
  int plane_reach_px = 3;
  // A pose that shifts what is seen by more has its patches looked for again: half of what they find.
  double look_again_px = 2;
  double least_sigma_px = 0.1;  // lens and shutter are not known better than this, whatever a patch says
  int min_inliers = 20;         // fewer points agree by chance
  double max_coast = 1.0;       // without a measured pose the motion goes on for so long (s)

  // Throws std::invalid_argument that names the value.
  void check() const;
};

}  // namespace framewise
