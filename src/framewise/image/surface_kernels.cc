// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/image/surface_kernels.h"

#include <cmath>
#include <limits>

#include "framewise/image/chosen_at_run_time.h"

namespace framewise {
namespace {

template <typename T>
struct Vector {
  T x, y, z;
};

template <typename T>
FRAMEWISE_INLINE Vector<T> difference(const Vector<T>& a, const Vector<T>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <typename T>
FRAMEWISE_INLINE T dot(const Vector<T>& a, const Vector<T>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <typename T>
FRAMEWISE_INLINE Vector<T> cross(const Vector<T>& a, const Vector<T>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

template <typename T>
struct Differences {
  Vector<T> d0, d1, d2, d3;
};

// Roots of products of two squared lengths: those of all four would leave the range of floats.
template <SurfaceMeasure measure, typename T>
FRAMEWISE_INLINE float measured(const Differences<T>& d, const Vector<T>& light) {
  const Vector<T> c0 = cross(d.d0, d.d1);
  if constexpr (measure == SurfaceMeasure::kNormal) {
    const T cosine = dot(light, c0) / std::sqrt(dot(c0, c0));
    return static_cast<float>(cosine < T(0) ? T(0) : cosine);
  } else {
    const Vector<T> c1 = cross(d.d2, d.d3);
    T lengths;
    if constexpr (measure == SurfaceMeasure::kFlexion)
      lengths = std::sqrt(dot(d.d0, d.d0) * dot(d.d1, d.d1)) * std::sqrt(dot(d.d2, d.d2) * dot(d.d3, d.d3));
    else
      lengths = std::sqrt(dot(c0, c0)) * std::sqrt(dot(c1, c1));
    const T flexion = std::fabs(dot(c0, c1)) / lengths;
    return static_cast<float>(flexion > T(1) ? T(1) : flexion);
  }
}

struct Neighbours {
  const float *up, *down, *left, *right, *up_left, *up_right, *down_left, *down_right;
};

FRAMEWISE_INLINE Neighbours neighbours(const DepthRows& rows) {
  const float* up = rows.inverse ? rows.below : rows.above;
  const float* down = rows.inverse ? rows.above : rows.below;
  const int n = rows.inverse ? -rows.distance : rows.distance;
  return {up, down, rows.here - n, rows.here + n, up - n, up + n, down - n, down + n};
}

// Half of the planes' cost is the lengths, so both are written out. With D and S the difference and the sum
// of the two depths of a difference d, r = (x, y, 1), and (X, Y) = (x / g, y / h):
//   d0 = D0 r + S0 (0, h, 0)              d0 x d1 = g h (A / g, B / h, -C)
//   d1 = D1 r + S1 (g, 0, 0)                A = S0 D1,  B = D0 S1,  C = X A + Y B + S0 S1
//   d2 = D2 r + S2 (-g, h, 0)             d2 x d3 = g h (A' / g, B' / h, -C')
//   d3 = D3 r + S3 (g, h, 0)                A' = S2 D3 - D2 S3,  B' = S2 D3 + D2 S3,  C' = X A' + Y B' + 2 S2
//   S3 |d0|^2 = h^2 (D0 (D0 |r|^2 / h^2 + 2 Y S0) + S0^2), and the like.
// Nothing is lost to cancellation, as it would be in P - P.
struct PlaneConstants {
  float Y;
  float per_g2, per_h2;  // 1 / g^2, 1 / h^2
  float g2_h2;           // g^2 / h^2
  float y2_g2;           // (1 + y^2) / g^2
  float g2_k;            // g^2 / k, k = g^2 + h^2
  float along_y;         // 2 h y / k
  float area;            // |g h| / k
};

PlaneConstants plane_constants(double y, double g, double h) {
  const double k = g * g + h * h;
  PlaneConstants c;
  c.Y = static_cast<float>(y / h);
  c.per_g2 = static_cast<float>(1 / (g * g));
  c.per_h2 = static_cast<float>(1 / (h * h));
  c.g2_h2 = static_cast<float>(g * g / (h * h));
  c.y2_g2 = static_cast<float>((1 + y * y) / (g * g));
  c.g2_k = static_cast<float>(g * g / k);
  c.along_y = static_cast<float>(2 * h * y / k);
  c.area = static_cast<float>(std::fabs(g * h) / k);
  return c;
}

template <SurfaceMeasure measure>
FRAMEWISE_INLINE void plane_flexion_row(const DepthRows& rows, const PlaneConstants& c, const float* X_of,
                                        float* __restrict out) {
  const Neighbours z = neighbours(rows);
  const float* __restrict columns = X_of;
  const int end = rows.width - rows.distance;
#pragma GCC ivdep
  for (int u = rows.distance; u < end; ++u) {
    const float X = columns[u];
    const float D0 = z.down[u] - z.up[u], S0 = z.down[u] + z.up[u];
    const float D1 = z.right[u] - z.left[u], S1 = z.right[u] + z.left[u];
    const float D2 = z.down_left[u] - z.up_right[u], S2 = z.down_left[u] + z.up_right[u];
    const float D3 = z.down_right[u] - z.up_left[u], S3 = z.down_right[u] + z.up_left[u];

    const float A = S0 * D1, B = D0 * S1, C = X * A + c.Y * B + S0 * S1;
    const float p = S2 * D3, q = D2 * S3, S = S2 * S3;
    const float A1 = p - q, B1 = p + q, C1 = X * A1 + c.Y * B1 + (S + S);
    const float Ag = A * c.per_g2, Bh = B * c.per_h2;
    const float product = std::fabs(Ag * A1 + Bh * B1 + C * C1);
    float flexion;
    if constexpr (measure == SurfaceMeasure::kFlexionNormalised) {
      const float length0 = Ag * A + Bh * B + C * C;
      const float length1 = (A1 * c.per_g2) * A1 + (B1 * c.per_h2) * B1 + C1 * C1;
      flexion = product / (std::sqrt(length0) * std::sqrt(length1));
    } else {
      const float XX = X * X, X_k = X * c.g2_k, along_x = X_k + X_k;
      const float turn0 = D0 * c.Y + S0, turn1 = D1 * X + S1;
      const float length0 = (D0 * D0) * (XX * c.g2_h2 + c.per_h2) + turn0 * turn0;
      const float length1 = (D1 * D1) * c.y2_g2 + turn1 * turn1;
      const float r2_k = (XX + c.y2_g2) * c.g2_k;
      const float length2 = D2 * (D2 * r2_k + (c.along_y - along_x) * S2) + S2 * S2;
      const float length3 = D3 * (D3 * r2_k + (c.along_y + along_x) * S3) + S3 * S3;
      flexion = c.area * product / (std::sqrt(length0 * length1) * std::sqrt(length2 * length3));
    }
    out[u] = flexion > 1.0f ? 1.0f : flexion;
  }
}

// (A / g, B / h, -C) faces the camera even where g h is negative, in an image that is upside down.
FRAMEWISE_INLINE void plane_normal_row(const DepthRows& rows, const PlaneRays& rays, Direction towards,
                                       float* __restrict out) {
  const Neighbours z = neighbours(rows);
  const float* __restrict columns = rays.X;
  const float Y = static_cast<float>(rays.y / rays.h);
  const int end = rows.width - rows.distance;
  const float light_x = static_cast<float>(towards.x / rays.g);
  const float light_y = static_cast<float>(towards.y / rays.h);
  const float light_z = -towards.z;
  const float per_g2 = static_cast<float>(1 / (rays.g * rays.g));
  const float per_h2 = static_cast<float>(1 / (rays.h * rays.h));
#pragma GCC ivdep
  for (int u = rows.distance; u < end; ++u) {
    const float D0 = z.down[u] - z.up[u], S0 = z.down[u] + z.up[u];
    const float D1 = z.right[u] - z.left[u], S1 = z.right[u] + z.left[u];
    const float A = S0 * D1, B = D0 * S1, C = columns[u] * A + Y * B + S0 * S1;
    const float cosine =
        (light_x * A + light_y * B + light_z * C) / std::sqrt((A * per_g2) * A + (B * per_h2) * B + C * C);
    out[u] = cosine < 0.0f ? 0.0f : cosine;
  }
}

// Depths are first made distances from the vertical axis, rho = depth sin(theta); the ray is then
// (sin azimuth, -cot theta, cos azimuth), with the azimuth counted from the pixel's own column.
struct SphereRow {
  float scale_up, scale_here, scale_down;  // depth to rho; its inverse for inverse depths
  float y, h;                              // mean and half difference of the rays' y, rows above and below
  float y_here, sine, cosine;
  float towards_y, towards_z;  // against the pixel's ray
};

SphereRow sphere_row(const DepthRows& rows, const SphereRays& rays) {
  const double sines[] = {std::sin(rays.theta_above), std::sin(rays.theta_here), std::sin(rays.theta_below)};
  const double y_above = -std::cos(rays.theta_above) / sines[0];
  const double y_below = -std::cos(rays.theta_below) / sines[2];
  const auto scale = [&](int i) { return static_cast<float>(rows.inverse ? 1 / sines[2 - i] : sines[i]); };
  SphereRow row;
  row.scale_up = scale(0);
  row.scale_here = scale(1);
  row.scale_down = scale(2);
  row.y = static_cast<float>((y_below + y_above) / 2);
  row.h = static_cast<float>((y_below - y_above) / 2);
  row.y_here = static_cast<float>(-std::cos(rays.theta_here) / sines[1]);
  row.towards_y = static_cast<float>(std::cos(rays.theta_here));
  row.towards_z = static_cast<float>(-sines[1]);
  row.sine = static_cast<float>(std::sin(rays.azimuth));
  row.cosine = static_cast<float>(std::cos(rays.azimuth));
  return row;
}

template <SurfaceMeasure measure, typename Light>
FRAMEWISE_INLINE void sphere_columns(const DepthRows& rows, const SphereRow& row, const Light& light,
                                     float* __restrict out) {
  const Neighbours z = neighbours(rows);
  const float a = row.scale_up, c = row.scale_here, b = row.scale_down;
  const float y = row.y, h = row.h, s = row.sine, q = row.cosine;
  const int end = rows.width - rows.distance;
#pragma GCC ivdep
  for (int u = rows.distance; u < end; ++u) {
    const float up = a * z.up[u], down = b * z.down[u], left = c * z.left[u], right = c * z.right[u];
    const float up_left = a * z.up_left[u], up_right = a * z.up_right[u];
    const float down_left = b * z.down_left[u], down_right = b * z.down_right[u];
    const float D0 = down - up, S0 = down + up, D1 = right - left, S1 = right + left;
    const float D2 = down_left - up_right, S2 = down_left + up_right;
    const float D3 = down_right - up_left, S3 = down_right + up_left;
    const Differences<float> d{{0, D0 * y + S0 * h, D0},
                               {S1 * s, D1 * row.y_here, D1 * q},
                               {-(S2 * s), D2 * y + S2 * h, D2 * q},
                               {S3 * s, D3 * y + S3 * h, D3 * q}};
    out[u] = measured<measure>(d, light(u));
  }
}

template <SurfaceMeasure measure>
FRAMEWISE_INLINE void table_row(const DepthRows& rows, const TableRays& above, const TableRays& here,
                                const TableRays& below, Direction towards, float* __restrict out) {
  const Vector<double> light{towards.x, towards.y, towards.z};
  const int n = rows.distance, end = rows.width - n;
  const auto point = [](const float* depth, const TableRays& ray, int u) {
    const double z = depth[u];
    return Vector<double>{z * ray.x[u], z * ray.y[u], z * ray.z[u]};
  };
#pragma GCC ivdep
  for (int u = n; u < end; ++u) {
    const Differences<double> d{difference(point(rows.below, below, u), point(rows.above, above, u)),
                                difference(point(rows.here, here, u + n), point(rows.here, here, u - n)),
                                difference(point(rows.below, below, u - n), point(rows.above, above, u + n)),
                                difference(point(rows.below, below, u + n), point(rows.above, above, u - n))};
    out[u] = measured<measure>(d, light);
  }
}

// One door for each loop, so that the compiler makes its copies of each.
FRAMEWISE_CHOSEN_AT_RUN_TIME void plane_flexion(const DepthRows& rows, const PlaneConstants& constants,
                                                const float* X, float* out) {
  plane_flexion_row<SurfaceMeasure::kFlexion>(rows, constants, X, out);
}
FRAMEWISE_CHOSEN_AT_RUN_TIME void plane_flexion_normalised(const DepthRows& rows,
                                                           const PlaneConstants& constants, const float* X,
                                                           float* out) {
  plane_flexion_row<SurfaceMeasure::kFlexionNormalised>(rows, constants, X, out);
}
FRAMEWISE_CHOSEN_AT_RUN_TIME void plane_normal(const DepthRows& rows, const PlaneRays& rays, Direction light,
                                               float* out) {
  plane_normal_row(rows, rays, light, out);
}
FRAMEWISE_CHOSEN_AT_RUN_TIME void sphere_flexion(const DepthRows& rows, const SphereRow& row, float* out) {
  sphere_columns<SurfaceMeasure::kFlexion>(
      rows, row, [](int) { return Vector<float>{}; }, out);
}
FRAMEWISE_CHOSEN_AT_RUN_TIME void sphere_flexion_normalised(const DepthRows& rows, const SphereRow& row,
                                                            float* out) {
  sphere_columns<SurfaceMeasure::kFlexionNormalised>(
      rows, row, [](int) { return Vector<float>{}; }, out);
}
FRAMEWISE_CHOSEN_AT_RUN_TIME void sphere_normal(const DepthRows& rows, const SphereRow& row, float* out) {
  const Vector<float> light{0, row.towards_y, row.towards_z};
  sphere_columns<SurfaceMeasure::kNormal>(
      rows, row, [=](int) { return light; }, out);
}
FRAMEWISE_CHOSEN_AT_RUN_TIME void sphere_shaded(const DepthRows& rows, const SphereRow& row,
                                                const SphereRays& rays, float* out) {
  const float *x = rays.light_x, y = rays.light_y, *z = rays.light_z;
  sphere_columns<SurfaceMeasure::kNormal>(
      rows, row,
      [=](int u) {
        return Vector<float>{x[u], y, z[u]};
      },
      out);
}
FRAMEWISE_CHOSEN_AT_RUN_TIME void table_flexion(const DepthRows& rows, const TableRays& above,
                                                const TableRays& here, const TableRays& below, float* out) {
  table_row<SurfaceMeasure::kFlexion>(rows, above, here, below, {}, out);
}
FRAMEWISE_CHOSEN_AT_RUN_TIME void table_flexion_normalised(const DepthRows& rows, const TableRays& above,
                                                           const TableRays& here, const TableRays& below,
                                                           float* out) {
  table_row<SurfaceMeasure::kFlexionNormalised>(rows, above, here, below, {}, out);
}
FRAMEWISE_CHOSEN_AT_RUN_TIME void table_normal(const DepthRows& rows, const TableRays& above,
                                               const TableRays& here, const TableRays& below, Direction light,
                                               float* out) {
  table_row<SurfaceMeasure::kNormal>(rows, above, here, below, light, out);
}

}  // namespace

FRAMEWISE_CHOSEN_AT_RUN_TIME
void clean_depths(const float* depth, const float* scale, int width, float unknown, float* out) {
  constexpr float kFarthest = std::numeric_limits<float>::max();
  if (scale)
    for (int u = 0; u < width; ++u) {
      const float z = depth[u] * scale[u];
      out[u] = z > 0 && z <= kFarthest ? z : unknown;
    }
  else
    for (int u = 0; u < width; ++u) {
      const float z = depth[u];
      out[u] = z > 0 && z <= kFarthest ? z : unknown;
    }
}

void measure_plane_row(const DepthRows& rows, const PlaneRays& rays, SurfaceMeasure measure, Direction light,
                       float* out) {
  if (measure == SurfaceMeasure::kNormal) return plane_normal(rows, rays, light, out);
  const PlaneConstants constants = plane_constants(rays.y, rays.g, rays.h);
  if (measure == SurfaceMeasure::kFlexion) return plane_flexion(rows, constants, rays.X, out);
  plane_flexion_normalised(rows, constants, rays.X, out);
}

void measure_sphere_row(const DepthRows& rows, const SphereRays& rays, SurfaceMeasure measure, float* out) {
  const SphereRow row = sphere_row(rows, rays);
  if (measure == SurfaceMeasure::kFlexion) return sphere_flexion(rows, row, out);
  if (measure == SurfaceMeasure::kFlexionNormalised) return sphere_flexion_normalised(rows, row, out);
  if (rays.light_along_ray) return sphere_normal(rows, row, out);
  sphere_shaded(rows, row, rays, out);
}

void measure_table_row(const DepthRows& rows, const TableRays& above, const TableRays& here,
                       const TableRays& below, SurfaceMeasure measure, Direction light, float* out) {
  if (measure == SurfaceMeasure::kFlexion) return table_flexion(rows, above, here, below, out);
  if (measure == SurfaceMeasure::kFlexionNormalised)
    return table_flexion_normalised(rows, above, here, below, out);
  table_normal(rows, above, here, below, light, out);
}

}  // namespace framewise
