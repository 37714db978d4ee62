// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <opencv2/core.hpp>
#include <vector>

#include "framewise/geometry/camera.h"
#include "framewise/image/registration_kernels.h"

namespace framewise {

// A depth camera beside the camera whose images are used.
struct DepthCamera {
  Camera camera;
  Pose cam_from_depth_cam;
};

// Moves depth images from the camera that took them into another camera's image, so that a pixel is the same
// ray in both: a forward warp with a z-buffer.
//   A pixel of the depth camera is a small patch of the surface, seen from its corners (u -+ 1/2, v -+ 1/2)
//   at the pixel's depth. It covers those pixels of the camera whose centres lie in the box of its corners'
//   images; where patches overlap, the nearest to the camera wins.
// So a surface stays closed where the camera resolves more than the depth camera, and what the depth camera
// did not see stays unknown: nothing is filled. Patches that lie behind the camera, or so near that they
// would cover more than 32 pixels along a side, are left out.
class DepthRegistration {
 public:
  // Throws std::invalid_argument where a camera is none, or the depth camera is no pinhole or fisheye.
  DepthRegistration(const Camera& camera, const DepthCamera& depth_camera);

  // depth: CV_32F, z in metres, of the depth camera's size, unknown where NaN, infinite or not above 0. The
  // answer: CV_32F, z in the camera, of its size, NaN where unknown.
  cv::Mat operator()(const cv::Mat& depth) const;

 private:
  void patches_of_distorted(int row, const float* depth, const PatchRow& patches) const;
  CornerRow corners(int row) const;

  Camera camera_;
  int width_, height_;  // of the depth camera
  PatchView view_;
  // R (x, y, 1) with (x, y, 1) through the upper left corner of pixel (u, v), its x, y and z apart; NaN where
  // the depth camera has no ray. One more row and column than pixels.
  std::array<std::vector<double>, 3> corners_;
};

}  // namespace framewise
