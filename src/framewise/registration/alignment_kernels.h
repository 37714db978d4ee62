// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace framewise {

// The loops under align_surfaces.h: one row of the current surface against the reference's planes. The
// instructions used are chosen when the program runs; the answer is the same to the bit with all of them. No
// OpenCV and no Eigen here: code compiled for newer processors must not leak into shared inline functions.

// Columns of a Surface.
struct SurfaceView {
  int width, height;
  float fx, fy, cx, cy;
  const float *inverse_depth, *nx, *ny, *nz, *distance, *precision;
};

// x_in_reference = R x + t; R row by row.
struct MotionView {
  float R[9], t[3];
};

enum class PullLoss { kTrivial, kHuber, kCauchy, kTruncated, kTukey };

struct PullOptions {
  PullLoss loss;
  float threshold;      // of the loss, in standard deviations
  float widening;       // residuals are divided by this first: a coarse level is less exact
  float depth_gate;     // points whose depths differ by more (a share) do not belong together
  float normal_cosine;  // normals whose cosine is less do not either
};

inline constexpr int kPullColumns = 7;  // six derivatives and the residual
inline constexpr int kPullProducts = kPullColumns * (kPullColumns + 1) / 2;

// Sums over the pixels that found a partner.
struct PullSums {
  double products[kPullProducts];  // of columns i <= j, row by row, weighed
  double partners;                 // how many
  double inliers;                  // of those, within the threshold
  double weight;                   // sum of the loss's weights
  double squares;                  // sum of the inliers' squared residuals
};

// Numbers of scratch space for rows of a width.
constexpr int pull_scratch(int width) { return (kPullColumns + 12) * (width + 16); }

// Row v of the current surface, its pixels carried into the reference's image, where each meets the plane of
// the pixel it falls on (projective association):
//   q = R x + t,  r = s (n . q - distance),  dr = s ((q x n) . omega + n . tau)
// for the motion exp(omega) q + tau; s the plane's precision. Adds to `sums` the weighed products of the
// columns (q x n, n, r) s.
//   Chen, Medioni, Object modelling by registration of multiple range images, IVC 1992;
//   Blais, Levine, Registering multiview range data to create 3D computer objects, PAMI 1995.
void add_pull_of_row(const SurfaceView& reference, const SurfaceView& current, int v,
                     const MotionView& motion, const PullOptions& options, float* scratch, PullSums& sums);

}  // namespace framewise
