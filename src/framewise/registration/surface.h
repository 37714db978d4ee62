// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

namespace framewise {

// An ideal pinhole camera's image: pixel (u, v) looks along ((u - cx) / fx, (v - cy) / fy, 1).
struct SurfaceGrid {
  int width = 0, height = 0;
  float fx = 0, fy = 0, cx = 0, cy = 0;

  std::size_t size() const { return static_cast<std::size_t>(width) * height; }
};

// What a depth image says of the surfaces it saw: at every pixel the plane through its neighbourhood. Columns
// of numbers, row by row, so that loops over them vectorise.
struct Surface {
  SurfaceGrid grid;
  std::vector<float> measured_inverse;  // inverse depth as it was measured (1/m); 0: unknown
  std::vector<float> inverse_depth;     // of the plane, along the pixel's ray (1/m); 0: there is no plane
  std::vector<float> nx, ny, nz;        // unit normal, away from the camera: n . x = distance
  std::vector<float> distance;          // of the plane from the camera (m)
  std::vector<float> precision;         // 1 / standard deviation of a distance from the plane (1/m); 0: none
  std::size_t known = 0;                // pixels with a plane
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();  // mean of their points (m)
  double radius = 0;                                 // their root mean square distance from it (m)
  // Mean over them of (precision x standard deviation of a component of the normal)^2 (1/m^2): the
  // information about a motion along the surface that noise in the normals feigns.
  double feigned_information = 0;
};

}  // namespace framewise
