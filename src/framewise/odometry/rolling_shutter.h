// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>

#include "framewise/geometry/camera.h"

namespace framewise {

// A rolling shutter reads an image row by row while the camera turns: each row has its own axes. Between
// frames that turn alike nothing of it shows; against a map it is many pixels. Rays are turned to the axes of
// the middle row,
//   x_middle = exp(turn_rate * row * readout) x,
// with row from -1/2 at the first row to 1/2 at the last, readout the time between these (s, negative where
// the last is read first, 0: all at once), turn_rate the camera's (rad/s, in its own axes).
//   Hedborg, Forssén, Felsberg, Ringaby, Rolling shutter bundle adjustment, CVPR 2012.
struct Shutter {
  double readout = 0;  // s
  Eigen::Vector3d turn_rate = Eigen::Vector3d::Zero();

  // Of a ray on the plane z = 1 seen in a row, on that plane.
  Eigen::Vector3d at_middle(const Eigen::Vector3d& ray, double row) const;
  // Its derivative by the readout.
  Eigen::Vector3d at_middle_by_readout(const Eigen::Vector3d& ray, double row) const;
  // Depth of a point that has depth z along a row's axis, along the middle one's.
  double depth_at_middle(const Eigen::Vector3d& ray, double row, double z) const;
  // Where a point in the axes of the middle is seen.
  std::optional<Eigen::Vector2d> project(const Camera& camera, const Eigen::Vector3d& x_in_cam) const;
};

// Of a pixel.
inline double row_of(const Camera& camera, double v) {
  return camera.height > 1 ? v / (camera.height - 1) - 0.5 : 0;
}

// The readout, learned from what residuals say of it while a camera turns now faster, now slower. Most
// shutters are global, and what then is learned of one is only noise that all rays of an image share: it is 0
// until it is surely more than that.
class ReadoutEstimate {
 public:
  double seconds() const { return is_rolling_ ? estimate_ : 0; }

  // An estimate of how far seconds() is off, with its information (1/s^2). longest: that a frame may take
  // (s).
  void add(double correction, double information, double longest);

 private:
  double estimate_ = 0;
  bool is_rolling_ = false;
  double information_ = 1 / (0.02 * 0.02);  // 1/s^2; most shutters are global or slower than some 10 ms
  double scatter_ = 0;                      // sum of squared (information times departure from the estimate)
};

}  // namespace framewise
