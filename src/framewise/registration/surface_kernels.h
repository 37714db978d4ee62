// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace framewise {

// The loops under surface_pyramid.h. The instructions used are chosen when the program runs; the answer is
// the same to the bit with all of them. No OpenCV and no Eigen here: code compiled for newer processors must
// not leak into shared inline functions.
//
// Images of inverse depth have a margin of unknown pixels (0) all round: kFitReach rows and columns, and
// kLanes columns more on the right. Rows of answers have kLanes - 1 columns more than pixels.

inline constexpr int kLanes = 8;     // numbers that are worked on together
inline constexpr int kFitReach = 4;  // the widest neighbourhood is (2 kFitReach + 1)^2 pixels

// One row of an image of half the size from two: the mean of those of the four pixels that are as near as the
// nearest of them, up to `tolerance` (a share of it).
void halve_rows(const float* above, const float* below, int width, float tolerance, float* out);

// The plane through a pixel's neighbourhood. An image's inverse depth of a plane is linear in the pixels,
//   w(u + du, v + dv) = w + a du + b dv,
// and a structured-light camera's noise in it is even, so that least squares over the neighbourhood are the
// likeliest plane. Pixels whose inverse depth differs by more than `tolerance` (a share) belong to other
// surfaces. rows: 2 reach + 1 rows, each at its first pixel. Inverse depth 0 where fewer than `least` pixels
// agree or where they do not span a plane.
struct FittedRow {
  float *inverse_depth, *slope_u, *slope_v;
  float* spread_u;  // variance of slope_u over that of a pixel's inverse depth
};
void fit_planes(const float* const* rows, int reach, int width, float tolerance, float least,
                const FittedRow& out);

// From the image's plane to the camera's: with ray = (x, y, 1), (A, B, C) . ray = w, A = a fx, B = b fy,
//   n = (A, B, C) / |(A, B, C)|,  distance = 1 / |(A, B, C)|.
// The precision is that of the difference of two frames' distances from the plane,
//   sigma^2 = 2 (sigma_z n . ray)^2 + 2 (sideways z)^2 (1 - (n . ray / |ray|)^2),
// sigma_z the depth noise at z, `sideways` the noise of a depth edge's place (pixels over focal length).
struct PlaneModel {
  float fx, fy, cx, y;
  float noise_floor, noise_growth, noise_nearest;
  float sideways;
  float least_cosine;  // of the angle between normal and ray: flatter views count for nothing
};
struct PlaneRow {
  float *inverse_depth, *nx, *ny, *nz, *distance, *precision;
  float* feigned;  // (precision x standard deviation of a component of n)^2
};
void convert_planes(const FittedRow& fitted, const PlaneModel& model, int width, const PlaneRow& out);

}  // namespace framewise
