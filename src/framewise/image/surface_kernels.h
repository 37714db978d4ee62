// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace framewise {

// The loops under the flexion and normal images: one row of the result from three rows of depth.
// The instructions used are chosen when the program runs; the answer is the same to the bit with all of them.
// No OpenCV and no Eigen here: code compiled for newer processors must not leak into shared inline functions.
//
// With P the points of the pixels at distance n, the four differences of a pixel (u, v) are
//   d0 = P(u, v+n) - P(u, v-n)        d2 = P(u-n, v+n) - P(u+n, v-n)
//   d1 = P(u+n, v) - P(u-n, v)        d3 = P(u+n, v+n) - P(u-n, v-n)
// Every loop writes the columns n ... width - n - 1 of `out`; NaN where a depth it uses is NaN, and where a
// difference has no length.

// depth (times scale, where there is one) where it is a positive number, else `unknown`.
void clean_depths(const float* depth, const float* scale, int width, float unknown, float* out);

// Depths of the rows v - n, v, v + n. The answers are homogeneous in the depths, and replacing them all by
// their inverses only turns every difference round (1/a - 1/b ~ b - a, 1/a + 1/b ~ b + a): inverse depths are
// given with `below` and `above` exchanged and the step negative.
struct DepthRows {
  const float *above, *here, *below;
  int width, distance;
  bool inverse;
};

enum class SurfaceMeasure {
  kFlexion,            // |c0 . c1|, c0 = d0/|d0| x d1/|d1|, c1 = d2/|d2| x d3/|d3|
  kFlexionNormalised,  // |c0 . c1| / (|c0| |c1|)
  kNormal,             // max(0, light . c0 / |c0|), c0 towards the camera
};

struct Direction {
  float x, y, z;
};

// A point is depth (x, y, 1); g and h are what x and y grow by over n pixels, and X[u] = x / g of a column.
struct PlaneRays {
  const float* X;
  double y, g, h;
};
void measure_plane_row(const DepthRows& rows, const PlaneRays& rays, SurfaceMeasure measure, Direction light,
                       float* out);

// Rows of equal polar angle theta, columns even in azimuth: all columns of a row are alike. The light stands
// behind the camera on the pixel's ray, or has the components x and z that every column sees from axes turned
// to its azimuth.
struct SphereRays {
  double theta_above, theta_here, theta_below;
  double azimuth;  // over n pixels
  bool light_along_ray;
  const float* light_x;
  float light_y;
  const float* light_z;
};
void measure_sphere_row(const DepthRows& rows, const SphereRays& rays, SurfaceMeasure measure, float* out);

// Any camera: a point is depth (x[u], y[u], z[u]), a table of rays for each of the three rows. Depths are not
// inverse.
struct TableRays {
  const double *x, *y, *z;
};
void measure_table_row(const DepthRows& rows, const TableRays& above, const TableRays& here,
                       const TableRays& below, SurfaceMeasure measure, Direction light, float* out);

}  // namespace framewise
