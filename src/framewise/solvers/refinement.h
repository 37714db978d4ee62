// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <limits>

#include "framewise/geometry/image_surface.h"
#include "framewise/geometry/pose.h"
#include "framewise/solvers/robust_loss.h"

namespace framewise {

// How a pose is refined: Levenberg-Marquardt on all points, each weighed by its own noise.
struct RefineOptions {
  double sigma = 1e-3;  // noise of an image measurement: pixels over focal length, or rad on the sphere
  ImageSurface surface = ImageSurface::kPlane;
  RobustLoss loss;
  int max_iterations = 25;
  // Done when a step promises to lower the cost by less than this (the cost is in squared sigmas): the
  // default moves the pose by a thousandth of its standard deviation. That last step is still taken.
  double tolerance = 1e-6;

  // Throws std::invalid_argument naming the field that makes no sense.
  void check() const;
};

struct Refinement {
  Pose pose;
  // Of the tangent vector (rotation, translation) of the pose, R exp(rotation) and t + translation: the
  // inverse of the Gauss-Newton information under the noise given, each point weighed by its loss. NaN where
  // the points leave a direction free.
  Matrix6d covariance = Matrix6d::Constant(std::numeric_limits<double>::quiet_NaN());
  double cost =
      0;  // sum of rho(squared residual in sigmas): about (residuals - degrees of freedom) if all fit
  int iterations = 0;      // steps tried
  bool converged = false;  // false: max_iterations came first, or no step lowers the cost
};

}  // namespace framewise
