// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "framewise/geometry/camera.h"
#include "framewise/geometry/pose.h"
#include "framewise/image/frame.h"
#include "framewise/simulation/ray_tracer.h"

namespace framewise {

struct RgbdOptions {
  Camera camera{CameraModel::kPinhole, 640, 480, 525, 525, 319.5, 239.5, {}, {}};
  double max_depth = 10;  // farther is invalid (m)
  int edge_samples =
      4;  // rays a pixel where its neighbours differ, 1 or 4; elsewhere textures filter themselves
  double exposure = 1;  // light that turns 1.0 into white

  void check() const;
};

// A camera that measures colour and depth of the same ray, without blur or noise.
class RgbdSensor {
 public:
  explicit RgbdSensor(const RgbdOptions& options);

  const RgbdOptions& options() const { return options_; }

  // What is seen from a pose. Depth is exact, along the ray through the centre of the pixel. The frame's time
  // is left to the caller. Works on all threads of the caller's arena; the bytes do not depend on how many.
  Frame render(const RayTracer& tracer, const Pose& world_from_cam) const;

 private:
  RgbdOptions options_;
  std::vector<Eigen::Vector3f> rays_in_cam_;  // row by row, z = 1 where the camera allows
};

}  // namespace framewise
