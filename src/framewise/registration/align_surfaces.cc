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
  SceneCoordinates(const Surface& surface) : centre(surface.centre), radius(std::max(surface.radius, 1e-3)) {
    motion.setIdentity();
    motion.topLeftCorner<3, 3>() /= radius;
    motion.bottomLeftCorner<3, 3>() = skew(centre) / radius;  // tau = tau_centre - omega x centre
  }

  Eigen::Vector3d centre;
  double radius;
  Matrix6d motion;  // (omega, tau) = motion * coordinates
};

using Directions = std::vector<Vector6d>;  // orthonormal, in scene coordinates

// What the normal equations say in scene coordinates, apart from directions that are locked.
struct Spectrum {
  SymmetricEigen<6> eigen;
  double rounding;  // of the eigenvalues: what is not above it is 0
};

Spectrum spectrum(const Matrix6d& H, const SceneCoordinates& scene, const Directions& locked) {
  Matrix6d open = Matrix6d::Identity();
  for (const Vector6d& direction : locked) open -= direction * direction.transpose();
  Spectrum result;
  result.eigen = symmetric_eigen(Matrix6d(open * scene.motion.transpose() * H * scene.motion * open));
  result.rounding = 1e-7 * std::max(result.eigen.values[5], 1e-300);
  return result;
}

// H^-1 without the locked directions.
Matrix6d inverse_of(const Matrix6d& H, const SceneCoordinates& scene, const Directions& locked) {
  const auto [eigen, rounding] = spectrum(H, scene, locked);
  Matrix6d inverse = Matrix6d::Zero();
  for (int i = 0; i < 6; ++i)
    if (eigen.values[i] > rounding)
      inverse += eigen.vectors.col(i) * eigen.vectors.col(i).transpose() / eigen.values[i];
  return scene.motion * inverse * scene.motion.transpose();
}

// Directions whose information is not more than what noise in the normals would feign.
Directions free_directions(const NormalEquations& equations, const Surface& reference,
                           const SceneCoordinates& scene, double least_information) {
  const auto [eigen, rounding] = spectrum(equations.H, scene, {});
  const double feigned = least_information * equations.weight * reference.feigned_information;
  Directions directions;
  for (int i = 0; i < 6; ++i)
    if (!(eigen.values[i] > std::max(feigned, rounding))) directions.push_back(eigen.vectors.col(i));
  return directions;
}

Pose moved(const Pose& cam1_from_cam2, const Vector6d& motion) {
  const Pose product = Pose{so3_exp(motion.head<3>()), motion.tail<3>()} * cam1_from_cam2;
  // Products of products round a rotation away from orthogonality unless it is renewed.
  return Pose::from_quaternion(product.quaternion(), product.t);
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
  const double pixels =
      (motion.head<3>().norm() + motion.tail<3>().norm() / std::max(radius, 1e-3)) * grid.fx;
  return pixels < 0.01;
}

// The pose, and the normal equations at the last step of the finest level.
struct Aligned {
  Pose cam1_from_cam2;
  NormalEquations equations;
  int iterations = 0;
};

SurfaceAlignment answer(const Aligned& aligned, const Directions& free, const SceneCoordinates& scene,
                        const Surface& current, const AlignmentOptions& options) {
  const NormalEquations& equations = aligned.equations;
  const double rows = 1 + options.skipped_rows;
  SurfaceAlignment alignment;
  alignment.cam2_from_cam1 = aligned.cam1_from_cam2.inverse();
  alignment.information = equations.H;
  alignment.overlap = equations.inliers * rows / static_cast<double>(std::max<std::size_t>(current.known, 1));
  alignment.rms = std::sqrt(equations.squares / std::max(equations.inliers, 1.0));
  alignment.iterations = aligned.iterations;
  for (const Vector6d& direction : free)
    alignment.free_directions.push_back(free_direction(direction, scene));
  if (free.empty())
    alignment.covariance =
        options.noise_area_px / rows *
        covariance_of_inverse(inverse_of(equations.H, scene, {}), alignment.cam2_from_cam1);
  return alignment;
}

class Alignment {
 public:
  Alignment(const SurfacePyramid& reference, const SurfacePyramid& current, const AlignmentOptions& options)
      : reference_(reference),
        current_(current),
        options_(options),
        scene_(reference[0]),
        scratch_(pull_scratch(std::max(reference[0].grid.width, current[0].grid.width))) {}

  const SceneCoordinates& scene() const { return scene_; }

  // What the reference alone leaves free, whatever is aligned with it.
  Directions free_directions_of_reference() {
    constexpr int kRowStep = 4;
    const auto equations =
        pull(reference_[0], reference_[0], Pose(), level_of(options_, 0).pull, kRowStep, scratch_);
    return free_directions(equations, reference_[0], scene_, options_.least_information);
  }

  std::optional<Aligned> align(const Pose& guess, const Directions& locked) {
    Aligned aligned{guess, {}, 0};
    for (std::size_t k = std::min(reference_.size(), current_.size()); k-- > 0;)
      if (!align_level(k, locked, aligned)) return std::nullopt;
    return aligned;
  }

 private:
  bool align_level(std::size_t k, const Directions& locked, Aligned& aligned) {
    const Level level = level_of(options_, k);
    const double least = options_.least_inliers * std::pow(0.25, k) / level.row_step;
    for (int i = 0; i < level.most_iterations; ++i) {
      NormalEquations equations =
          pull(reference_[k], current_[k], aligned.cam1_from_cam2, level.pull, level.row_step, scratch_);
      // Coarse pixels may be too wide for the slopes of a scene; the finest level decides.
      if (equations.inliers < least) return k > 0;
      const Vector6d motion = -inverse_of(equations.H, scene_, locked) * equations.b;
      aligned.cam1_from_cam2 = moved(aligned.cam1_from_cam2, motion);
      aligned.equations = equations;
      ++aligned.iterations;
      if (is_done(motion, scene_.radius, reference_[k].grid)) break;
    }
    return true;
  }

  const SurfacePyramid& reference_;
  const SurfacePyramid& current_;
  const AlignmentOptions& options_;
  SceneCoordinates scene_;
  std::vector<float> scratch_;
};

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
  Alignment alignment(reference, current, options);
  const SceneCoordinates& scene = alignment.scene();
  const Pose guess = cam2_from_cam1_guess.inverse();
  Directions free = alignment.free_directions_of_reference();
  auto aligned = alignment.align(guess, free);
  if (!aligned) return std::nullopt;
  // What the two have in common may leave more free.
  const Directions common =
      free_directions(aligned->equations, reference[0], scene, options.least_information);
  if (common.size() > free.size()) {
    free = common;
    aligned = alignment.align(guess, free);
    if (!aligned) return std::nullopt;
  }
  return answer(*aligned, free, scene, current[0], options);
}

double fitting_pixels(const SurfacePyramid& reference, const SurfacePyramid& current,
                      const Pose& cam2_from_cam1, const AlignmentOptions& options) {
  if (reference.empty() || current.empty()) return 0;
  const std::size_t k = std::min<std::size_t>({1, reference.size() - 1, current.size() - 1});
  std::vector<float> scratch(pull_scratch(current[k].grid.width));
  return pull(reference[k], current[k], cam2_from_cam1.inverse(), level_of(options, k).pull, 2, scratch)
      .weight;
}

}  // namespace framewise
