// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/solvers/refine_kernels.h"

#include <cmath>
#include <cstddef>

#define INLINE inline __attribute__((always_inline))

namespace framewise {
namespace {

namespace portable {
// clang-format off
#include "framewise/solvers/refine_lanes.inc"
#include "framewise/solvers/refine_kernels_epipolar.inc"
#include "framewise/solvers/refine_kernels_points.inc"
// clang-format on
}  // namespace portable

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define FRAMEWISE_HAS_AVX2_KERNELS
#pragma GCC push_options
#pragma GCC target("avx2")
namespace avx2 {
// clang-format off
#include "framewise/solvers/refine_lanes.inc"
#include "framewise/solvers/refine_kernels_epipolar.inc"
#include "framewise/solvers/refine_kernels_points.inc"
// clang-format on
}  // namespace avx2
#pragma GCC pop_options
#endif

// a x b
void cross(const double* a, const double* b, double* c) {
  c[0] = a[1] * b[2] - a[2] * b[1];
  c[1] = a[2] * b[0] - a[0] * b[2];
  c[2] = a[0] * b[1] - a[1] * b[0];
}

// Two unit vectors across t, |t| = 1, in B.
void tangent(const double* t, double* B) {
  int axis = 0;
  for (int k = 1; k < 3; ++k)
    if (std::abs(t[k]) < std::abs(t[axis])) axis = k;
  double unit[3] = {0, 0, 0};
  unit[axis] = 1;
  cross(t, unit, B);
  const double length = std::sqrt(B[0] * B[0] + B[1] * B[1] + B[2] * B[2]);
  for (int k = 0; k < 3; ++k) B[k] /= length;
  cross(t, B, B + 3);
}

// E = [t]x R, row-major.
void essential(const KernelPose& pose, double* E) {
  for (int column = 0; column < 3; ++column) {
    const double r[3] = {pose.R[column], pose.R[3 + column], pose.R[6 + column]};
    double e[3];
    cross(pose.t, r, e);
    for (int k = 0; k < 3; ++k) E[3 * k + column] = e[k];
  }
}

// Calls the widest build of the kernels that this machine can run.
#ifdef FRAMEWISE_HAS_AVX2_KERNELS
#define FRAMEWISE_SUM(KERNEL, ...)                                                                           \
  if (__builtin_cpu_supports("avx2")) return avx2::sum_over(avx2::KERNEL{__VA_ARGS__}, columns, pose, loss); \
  return portable::sum_over(portable::KERNEL{__VA_ARGS__}, columns, pose, loss)
#else
#define FRAMEWISE_SUM(KERNEL, ...) \
  return portable::sum_over(portable::KERNEL{__VA_ARGS__}, columns, pose, loss)
#endif

double inverse_square(double sigma) { return 1 / (sigma * sigma); }

}  // namespace

NormalSums& NormalSums::operator+=(const NormalSums& other) {
  for (int n = 0; n < 21; ++n) H[n] += other.H[n];
  for (int n = 0; n < 6; ++n) g[n] += other.g[n];
  cost += other.cost;
  return *this;
}

NormalSums sum_sampson_plane(const PointColumns& columns, const KernelPose& pose, double sigma,
                             const RobustLoss& loss) {
  const double scale = inverse_square(sigma);
  FRAMEWISE_SUM(Sampson<true>, scale);
}

NormalSums sum_sampson_sphere(const PointColumns& columns, const KernelPose& pose, double sigma,
                              const RobustLoss& loss) {
  const double scale = inverse_square(sigma);
  FRAMEWISE_SUM(Sampson<false>, scale);
}

NormalSums sum_reprojection_plane(const PointColumns& columns, const KernelPose& pose, double sigma,
                                  const RobustLoss& loss) {
  const double scale = inverse_square(sigma);
  double E[9];
  essential(pose, E);
  FRAMEWISE_SUM(ReprojectionPlane, scale, E);
}

NormalSums sum_reprojection_sphere(const PointColumns& columns, const KernelPose& pose, double sigma,
                                   const RobustLoss& loss) {
  const double scale = inverse_square(sigma);
  double B[6];
  tangent(pose.t, B);
  FRAMEWISE_SUM(ReprojectionSphere, scale, B);
}

NormalSums sum_projection_plane(const PointColumns& columns, const KernelPose& pose, double sigma,
                                const RobustLoss& loss) {
  const double scale = inverse_square(sigma);
  FRAMEWISE_SUM(ProjectionPlane, scale);
}

NormalSums sum_projection_sphere(const PointColumns& columns, const KernelPose& pose, double sigma,
                                 const RobustLoss& loss) {
  const double scale = inverse_square(sigma);
  FRAMEWISE_SUM(ProjectionSphere, scale);
}

NormalSums sum_registration(const PointColumns& columns, const KernelPose& pose, const RobustLoss& loss) {
  FRAMEWISE_SUM(Registration);
}

NormalSums sum_point1_on_ray2(const PointColumns& columns, const KernelPose& pose, double sigma,
                              const RobustLoss& loss) {
  const double variance = sigma * sigma;
  FRAMEWISE_SUM(Point1OnRay2, variance);
}

NormalSums sum_point2_on_ray1(const PointColumns& columns, const KernelPose& pose, double sigma,
                              const RobustLoss& loss) {
  const double variance = sigma * sigma;
  FRAMEWISE_SUM(Point2OnRay1, variance);
}

}  // namespace framewise
