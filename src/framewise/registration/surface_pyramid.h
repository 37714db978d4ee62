// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <opencv2/core.hpp>
#include <vector>

#include "framewise/geometry/camera.h"
#include "framewise/geometry/depth_noise.h"
#include "framewise/registration/surface.h"

namespace framewise {

struct SurfaceOptions {
  // The finest level has 1 / decimation of the image's width. Half of a Kinect's 640 x 480 says as much as
  // all of it: its noise is shared between neighbours.
  int decimation = 2;
  int levels = 3;           // each of half the size; fewer where the image is too small
  int reach_px = 3;         // the neighbourhood of a plane is (2 reach + 1)^2 pixels of its level
  double tolerance = 0.05;  // pixels whose inverse depths differ by more (a share) are of two surfaces
  double min_depth = 0.1, max_depth = 20;  // what is nearer or farther counts as unknown (m)
  DepthNoise noise;
  double sideways_px = 0.75;  // noise of the place of a measurement (pixels of the full image)
  double least_cosine = 0.3;  // of the angle between a surface's normal and the ray: 73 deg

  // Throws std::invalid_argument that names the value.
  void check() const;
};

// Finest level first. Empty where the image has no place for a neighbourhood.
using SurfacePyramid = std::vector<Surface>;

// Makes the surfaces of a camera's depth images. Any camera whose image a pinhole can show: where the lens
// distorts, the levels are those of a pinhole without distortion of the same focal lengths and centre.
class SurfaceMaker {
 public:
  // Throws std::invalid_argument for a camera that is none or equirectangular, and for wrong options.
  SurfaceMaker(const Camera& camera, const SurfaceOptions& options);

  // depth: CV_32F, z in metres, of the camera's size, unknown where NaN, infinite or not above 0. Throws
  // std::invalid_argument for any other image.
  SurfacePyramid operator()(const cv::Mat& depth) const;

  // The finest level's, whose `measured_inverse` is given: row by row, grid().size() numbers.
  SurfacePyramid from_inverse_depth(const std::vector<float>& inverse_depth) const;

  const SurfaceGrid& grid() const { return grid_; }  // of the finest level
  const SurfaceOptions& options() const { return options_; }

 private:
  std::vector<float> sample(const cv::Mat& depth) const;

  // Where the finest level's pixel lies in the image: between four pixels.
  struct Place {
    std::int32_t corner;  // index of the upper left one; -1: outside
    float right, down;    // shares of the right and the lower ones
  };

  Camera camera_;
  SurfaceOptions options_;
  SurfaceGrid grid_;
  std::vector<Place> places_;
};

}  // namespace framewise
