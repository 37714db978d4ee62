// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/image/depth_plane.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace framewise {
namespace {

// Normal equations of (w - w0, a, b).
struct SurfaceSums {
  Eigen::Matrix3d H = Eigen::Matrix3d::Zero();
  Eigen::Vector3d g = Eigen::Vector3d::Zero();
};

SurfaceSums sums_around(const cv::Mat& depth, const Eigen::Vector2d& pixel, float w0,
                        const DepthPlaneOptions& options) {
  const int u = static_cast<int>(std::lround(pixel.x())), v = static_cast<int>(std::lround(pixel.y()));
  const int first = std::max(0, u - options.reach_px), last = std::min(depth.cols - 1, u + options.reach_px);
  const float most = static_cast<float>(options.tolerance) * w0;
  SurfaceSums sums;
  for (int y = std::max(0, v - options.reach_px); y <= std::min(depth.rows - 1, v + options.reach_px); ++y) {
    const float* row = depth.ptr<float>(y);
    const double dv = y - pixel.y();
    double n = 0, su = 0, suu = 0, sw = 0, suw = 0;
    for (int x = first; x <= last; ++x) {
      const float dw = 1 / row[x] - w0;
      if (!(std::abs(dw) <= most)) continue;  // unknown depths as well
      const double du = x - pixel.x();
      n += 1, su += du, suu += du * du, sw += dw, suw += du * dw;
    }
    Eigen::Matrix3d H;
    H << n, su, n * dv, su, suu, su * dv, n * dv, su * dv, n * dv * dv;
    sums.H += H;
    sums.g += Eigen::Vector3d(sw, suw, sw * dv);
  }
  return sums;
}

}  // namespace

std::optional<DepthPlane> depth_plane_at(const cv::Mat& depth, const Eigen::Vector2d& pixel,
                                         const Camera& camera, const DepthNoise& noise,
                                         const DepthLookupOptions& lookup, const DepthPlaneOptions& options) {
  const auto nearby = depth_at(depth, pixel, lookup);
  if (!nearby) return std::nullopt;
  const double z = *nearby, w0 = 1 / z;
  SurfaceSums sums = sums_around(depth, pixel, static_cast<float>(w0), options);
  const Eigen::Vector2d focal(std::abs(camera.fx), std::abs(camera.fy));
  // What is known of a slope without measuring, over what a pixel says of it.
  const Eigen::Vector2d known = noise.sigma(z) / z * focal / options.usual_slope;
  sums.H.diagonal().tail<2>() += options.noise_area_px * known.cwiseProduct(known);
  const Eigen::Matrix3d inverse = sums.H.inverse();
  const Eigen::Vector3d plane = inverse * sums.g;
  const double w = static_cast<float>(w0) + plane[0], share2 = options.noise_area_px * inverse(0, 0);
  if (!(w > 0) || !(share2 > 0)) return DepthPlane{z};
  return DepthPlane{1 / w, std::sqrt(std::min(1.0, share2)),
                    plane.tail<2>().cwiseProduct(Eigen::Vector2d(camera.fx, camera.fy))};
}

}  // namespace framewise
