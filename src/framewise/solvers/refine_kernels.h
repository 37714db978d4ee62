// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "framewise/solvers/point_columns.h"
#include "framewise/solvers/robust_loss.h"

// The inner loops of refinement: what all points together say about a pose cam2_from_cam1. Compiled for AVX2
// and for any x86-64, chosen when the program runs; the same bits either way (no fused multiply-add). No
// Eigen here: templates compiled under two instruction sets in one program break the one-definition rule.
namespace framewise {

// Gauss-Newton sums over the points, each weighed by its loss, with respect to (W, t): R becomes exp(W) R.
// The derivative of the price is 2 g exactly, H its Gauss-Newton second derivative.
struct NormalSums {
  double H[21] = {};  // upper triangle, row by row
  double g[6] = {};
  double cost = 0;  // sum of prices

  NormalSums& operator+=(const NormalSums& other);
};

struct KernelPose {
  double R[9];  // row-major
  double t[3];
};

// Each takes columns 1.. as listed (column 0 says which rows hold a point) and the loss.

// Sampson residual over sigma. Columns x1 (3), x2 (3) on the plane z = 1, or of unit length.
NormalSums sum_sampson_plane(const PointColumns&, const KernelPose&, double sigma, const RobustLoss&);
NormalSums sum_sampson_sphere(const PointColumns&, const KernelPose&, double sigma, const RobustLoss&);

// Distance to the nearest pair whose rays meet, over sigma (geometry/triangulation.h): two-view bundle
// adjustment with every point at its best place. Same columns; |t| = 1.
NormalSums sum_reprojection_plane(const PointColumns&, const KernelPose&, double sigma, const RobustLoss&);
NormalSums sum_reprojection_sphere(const PointColumns&, const KernelPose&, double sigma, const RobustLoss&);

// Projection of R X1 + t against x2, over sigma; on the sphere the chord. Columns X1 (3), x2 (3).
// A point behind the plane's camera pulls nowhere and pays like one 1e6 sigma away.
NormalSums sum_projection_plane(const PointColumns&, const KernelPose&, double sigma, const RobustLoss&);
NormalSums sum_projection_sphere(const PointColumns&, const KernelPose&, double sigma, const RobustLoss&);

// R X1 + t against X2, both uncertain. Columns X1 (3), S1 (6: xx xy xz yy yz zz), X2 (3), S2 (6).
NormalSums sum_registration(const PointColumns&, const KernelPose&, const RobustLoss&);

// X1 with covariance S1 against the ray x2 in camera 2 with noise sigma on the plane, and the other way
// about. Columns X1 (3), S1 (6), x2 (3); X2 (3), S2 (6), x1 (3).
NormalSums sum_point1_on_ray2(const PointColumns&, const KernelPose&, double sigma, const RobustLoss&);
NormalSums sum_point2_on_ray1(const PointColumns&, const KernelPose&, double sigma, const RobustLoss&);

}  // namespace framewise
