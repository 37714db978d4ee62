// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/registration/align_surfaces.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "framewise/geometry/linear_algebra.h"
#include "framewise/geometry/so3.h"
#include "framewise/registration/alignment_kernels.h"
#include "framewise/registration/option_check.h"

namespace framewise {
namespace {

SurfaceView view(const Surface& surface) {
  const SurfaceGrid& grid = surface.grid;
  return {grid.width,
          grid.height,
          grid.fx,
          grid.fy,
          grid.cx,
          grid.cy,
          surface.inverse_depth.data(),
          surface.nx.data(),
          surface.ny.data(),
          surface.nz.data(),
          surface.distance.data(),
          surface.precision.data()};
}

MotionView view(const Pose& pose) {
  MotionView motion{};
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) motion.R[3 * i + j] = static_cast<float>(pose.R(i, j));
    motion.t[i] = static_cast<float>(pose.t[i]);
  }
  return motion;
}

PullLoss pull_loss(Loss loss) {
  switch (loss) {
    case Loss::kHuber:
      return PullLoss::kHuber;
    case Loss::kCauchy:
      return PullLoss::kCauchy;
    case Loss::kTruncated:
      return PullLoss::kTruncated;
    case Loss::kTukey:
      return PullLoss::kTukey;
    default:
      return PullLoss::kTrivial;
  }
}

// Normal equations H step = -b of the motion exp(omega) x + tau.
struct NormalEquations {
  Matrix6d H = Matrix6d::Zero();
  Vector6d b = Vector6d::Zero();
  double partners = 0, inliers = 0, weight = 0, squares = 0;
};

NormalEquations pull(const Surface& reference, const Surface& current, const Pose& cam1_from_cam2,
                     const PullOptions& options, int row_step, std::vector<float>& scratch) {
  PullSums sums{};
  const SurfaceView reference_view = view(reference), current_view = view(current);
  const MotionView motion = view(cam1_from_cam2);
  for (int v = 0; v < current.grid.height; v += row_step)
    add_pull_of_row(reference_view, current_view, v, motion, options, scratch.data(), sums);
  NormalEquations equations;
  const double* product = sums.products;
  for (int i = 0; i < 6; ++i) {
    for (int j = i; j < 6; ++j) equations.H(i, j) = equations.H(j, i) = *product++;
    equations.b[i] = *product++;
  }
  equations.partners = sums.partners, equations.inliers = sums.inliers;
  equations.weight = sums.weight, equations.squares = sums.squares;
  return equations;
}

// Motions in coordinates in which all six move the surface about alike, by their length: a rotation about its
// centre times its radius, and the centre's translation.
struct SceneCoordinates {
  SceneCoordinates(const Surface& surface)
      : centre(surface.centre), radius(std::max(surface.radius, 1e-3)) {
    motion.setIdentity();
    motion.topLeftCorner<3, 3>() /= radius;
    motion.bottomLeftCorner<3, 3>() = skew(centre) / radius;  // tau = tau_centre - omega x centre
  }

  Eigen::Vector3d centre;
  double radius;
  Matrix6d motion;  // (omega, tau) = motion * coordinates
};

// The step, and the directions along which none is taken.
struct Step {
  Vector6d motion = Vector6d::Zero();  // (omega, tau)
  std::vector<Vector6d> free;          // in scene coordinates
  Matrix6d inverse = Matrix6d::Zero();  // of the information, without the free directions
};

Step solve(const NormalEquations& equations, const SceneCoordinates& scene, double least_information) {
  const auto eigen = symmetric_eigen(Matrix6d(scene.motion.transpose() * equations.H * scene.motion));
  const Vector6d b = scene.motion.transpose() * equations.b;
  Step step;
  Vector6d coordinates = Vector6d::Zero();
  Matrix6d inverse = Matrix6d::Zero();
  for (int i = 0; i < 6; ++i) {
    const Vector6d direction = eigen.vectors.col(i);
    if (!(eigen.values[i] > least_information)) {
      step.free.push_back(direction);
      continue;
    }
    coordinates -= direction * (direction.dot(b) / eigen.values[i]);
    inverse += direction * direction.transpose() / eigen.values[i];
  }
  step.motion = scene.motion * coordinates;
  step.inverse = scene.motion * inverse * scene.motion.transpose();
  return step;
}

Pose moved(const Pose& cam1_from_cam2, const Vector6d& motion) {
  return Pose{so3_exp(motion.head<3>()), motion.tail<3>()} * cam1_from_cam2;
}

// From the covariance of the motion of cam1_from_cam2, exp(omega) x + tau, to that of its inverse's tangent
// vector: rotation = -omega, translation = -R tau.
Matrix6d covariance_of_inverse(const Matrix6d& S, const Pose& cam2_from_cam1) {
  Matrix6d J = Matrix6d::Zero();
  J.topLeftCorner<3, 3>() = -Eigen::Matrix3d::Identity();
  J.bottomRightCorner<3, 3>() = -cam2_from_cam1.R;
  return J * S * J.transpose();
}

FreeDirection free_direction(const Vector6d& coordinates, const SceneCoordinates& scene) {
  return {coordinates.head<3>() / scene.radius, coordinates.tail<3>(), scene.centre};
}

struct Level {
  PullOptions pull;
  int most_iterations, row_step;
};

Level level_of(const AlignmentOptions& options, std::size_t k) {
  Level level;
  level.pull = {pull_loss(options.loss.kind), static_cast<float>(options.loss.threshold),
                static_cast<float>(std::pow(options.widening, k)), static_cast<float>(options.depth_gate),
                static_cast<float>(options.normal_gate)};
  level.most_iterations = options.iterations[std::min(k, options.iterations.size() - 1)];
  level.row_step = k == 0 ? 1 + options.skipped_rows : 1;
  return level;
}

bool is_done(const Vector6d& motion, double radius, const SurfaceGrid& grid) {
  const double pixels = (motion.head<3>().norm() + motion.tail<3>().norm() / std::max(radius, 1e-3)) * grid.fx;
  return pixels < 0.01;
}

}  // namespace

void AlignmentOptions::check() const {
  for (const int count : iterations)
    check_option(count >= 0 && count <= 1000, "iterations", count, "0 to 1000");
  check_option(skipped_rows >= 0, "skipped_rows", skipped_rows, "0 or more");
  check_option(loss.threshold > 0, "loss.threshold", loss.threshold, "more than 0");
  check_option(widening >= 1 && widening <= 10, "widening", widening, "1 to 10");
  check_option(depth_gate > 0, "depth_gate", depth_gate, "more than 0");
  check_option(normal_gate >= -1 && normal_gate < 1, "normal_gate", normal_gate, "-1 or more, below 1");
  check_option(noise_area_px > 0, "noise_area_px", noise_area_px, "more than 0");
  check_option(least_information >= 0, "least_information", least_information, "0 or more");
  check_option(least_inliers >= 6, "least_inliers", least_inliers, "at least 6");
}

std::string name_of(const FreeDirection& direction) {
  const bool translation = direction.is_translation();
  const Eigen::Vector3d axis = (translation ? direction.translation : direction.rotation).normalized();
  char text[96];
  std::snprintf(text, sizeof text, "%s (%.2f, %.2f, %.2f)",
                translation ? "translation along" : "rotation about", axis.x(), axis.y(), axis.z());
  return text;
}

std::optional<SurfaceAlignment> align_surfaces(const SurfacePyramid& reference, const SurfacePyramid& current,
                                               const Pose& cam2_from_cam1_guess,
                                               const AlignmentOptions& options) {
  options.check();
  if (reference.empty() || current.empty()) return std::nullopt;
  std::vector<float> scratch(pull_scratch(current[0].grid.width));
  Pose cam1_from_cam2 = cam2_from_cam1_guess.inverse();
  SurfaceAlignment alignment;
  for (std::size_t k = std::min(reference.size(), current.size()); k-- > 0;) {
    const Level level = level_of(options, k);
    const SceneCoordinates scene(reference[k]);
    const double pixel_share = std::pow(0.25, k) / level.row_step;
    Step step;
    NormalEquations equations;
    for (int i = 0; i < std::max(level.most_iterations, k == 0 ? 1 : 0); ++i) {
      equations = pull(reference[k], current[k], cam1_from_cam2, level.pull, level.row_step, scratch);
      if (equations.inliers < options.least_inliers * pixel_share) return std::nullopt;
      step = solve(equations, scene,
                   options.least_information * equations.weight * reference[k].feigned_information /
                       (level.pull.widening * level.pull.widening));
      cam1_from_cam2 = moved(cam1_from_cam2, step.motion);
      ++alignment.iterations;
      if (is_done(step.motion, scene.radius, reference[k].grid)) break;
    }
    if (k > 0) continue;
    const double known = static_cast<double>(std::max<std::size_t>(current[0].known, 1)) / level.row_step;
    alignment.overlap = equations.inliers / known;
    alignment.rms = std::sqrt(equations.squares / std::max(equations.inliers, 1.0));
    alignment.information = equations.H;
    for (const Vector6d& direction : step.free)
      alignment.free_directions.push_back(free_direction(direction, scene));
    alignment.cam2_from_cam1 = cam1_from_cam2.inverse();
    if (step.free.empty())
      alignment.covariance = options.noise_area_px *
                             covariance_of_inverse(step.inverse, alignment.cam2_from_cam1);
  }
  alignment.cam2_from_cam1 = cam1_from_cam2.inverse();
  return alignment;
}

}  // namespace framewise
