// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/odometry/pose_errors.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <tuple>

#include "framewise/geometry/so3.h"

namespace framewise {
namespace {

using Matrix63 = Eigen::Matrix<double, 6, 3>;
using Matrix36 = Eigen::Matrix<double, 3, 6>;

bool before(const PointRef& a, const PointRef& b) {
  return std::tie(a.keyframe, a.point) < std::tie(b.keyframe, b.point);
}

// Of measurements of which the third may be missing.
Eigen::Matrix3d information(const Eigen::Matrix3d& covariance, bool has_depth) {
  if (has_depth) return covariance.inverse();
  Eigen::Matrix3d W = Eigen::Matrix3d::Zero();
  W.topLeftCorner<2, 2>() = covariance.topLeftCorner<2, 2>().inverse();
  return W;
}

Matrix6d symmetric(const Matrix6d& A) { return 0.5 * (A + A.transpose()); }

// Of what is a covariance but for rounding and for what is left out to first order.
Matrix6d positive_part(const Matrix6d& A) {
  const Eigen::SelfAdjointEigenSolver<Matrix6d> eigen(symmetric(A));
  return eigen.eigenvectors() * eigen.eigenvalues().cwiseMax(0).asDiagonal() *
         eigen.eigenvectors().transpose();
}

// d xi / d (rotation in the camera's axes, position in the world's).
Matrix6d xi_by_camera(const Pose& world_from_cam) {
  Matrix6d J = Matrix6d::Zero();
  J.topLeftCorner<3, 3>() = world_from_cam.R;
  J.bottomLeftCorner<3, 3>() = skew(world_from_cam.t) * world_from_cam.R;
  J.bottomRightCorner<3, 3>().setIdentity();
  return J;
}

// d (ray, depth of the point) / d xi of the camera.
Matrix36 measured_by_camera(const PlacedBy& point, const Pose& world_from_cam) {
  const Eigen::Matrix3d M = measured_by_position(point), cam_from_world = world_from_cam.R.transpose();
  Matrix36 J;
  J << M * cam_from_world * skew(world_from_cam * point.x_in_cam), -M * cam_from_world;
  return J;
}

// The covariance of a camera as its residuals show it one by one: where those of the points that say most are
// larger or smaller than the others. gains: JtW of each; inverse: of their information.
//   MacKinnon, White, Some heteroskedasticity-consistent covariance matrix estimators with improved finite
//   sample properties, Journal of Econometrics 1985 (HC3).
template <class Gains>
Matrix6d shown_by_residuals(const std::vector<PlacedBy>& points, const Gains& gains, const Matrix6d& inverse,
                            const Pose& world_from_cam) {
  Matrix6d sum = Matrix6d::Zero();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Matrix63& JtW = gains[i].by_error;
    Eigen::Vector3d residual = gains[i].residual;
    if (!(points[i].z_sigma > 0)) residual.z() = 0;
    const Eigen::Matrix3d leverage = measured_by_camera(points[i], world_from_cam) * inverse * JtW;
    const Vector6d pull = JtW * (Eigen::Matrix3d::Identity() - leverage).inverse() * residual;
    sum += pull * pull.transpose();
  }
  return symmetric(inverse * sum * inverse.transpose());
}

// A with A C A' = another covariance.
Matrix6d between(const Matrix6d& C, const Matrix6d& other) {
  const Eigen::LLT<Matrix6d> from(C), to(other);
  if (from.info() != Eigen::Success || to.info() != Eigen::Success) return Matrix6d::Identity();
  const Matrix6d L = to.matrixL();
  return L * Matrix6d(from.matrixL()).inverse();
}

}  // namespace

void PoseErrors::start(int first_id, int count) {
  *this = {};
  first_id_ = first_id;
  keyframes_.setZero(6 * count, 6 * count);
  last_.with_keyframes.setZero(6, 6 * count);
}

std::vector<const PoseErrors::Gain*> PoseErrors::gains_before(const std::vector<PlacedBy>& points) const {
  std::vector<const Gain*> gains;
  auto gain = last_.gains.begin();
  for (const PlacedBy& point : points) {
    while (gain != last_.gains.end() && before(gain->ref, point.ref)) ++gain;
    const bool is_shared = gain != last_.gains.end() && !before(point.ref, gain->ref);
    gains.push_back(is_shared ? &*gain : nullptr);
  }
  return gains;
}

ResidualChanges PoseErrors::changes_since_last(const std::vector<PlacedBy>& points,
                                               const std::vector<const Gain*>& earlier) {
  constexpr double kEnough = 20;
  double ray = 0, rays = 0, z = 0, zs = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const PlacedBy& point = points[i];
    if (!earlier[i]) continue;
    const Eigen::Vector2d change = point.ray_residual - earlier[i]->residual.head<2>();
    ray += (point.ray_noise.whitening() * change).squaredNorm() / 4;
    ++rays;
    if (!(point.z_sigma > 0) || !earlier[i]->by_error.col(2).any()) continue;
    z += std::pow((point.z_residual - earlier[i]->residual.z()) / point.z_sigma, 2) / 2;
    ++zs;
  }
  ResidualChanges changes;
  if (rays >= kEnough) changes.ray = ray / rays;
  if (zs >= kEnough) changes.z = z / zs;
  return changes;
}

void PoseErrors::placed(const Pose& world_from_cam, const std::vector<PlacedBy>& points) {
  const std::vector<const Gain*> earlier = gains_before(points);
  const ResidualChanges changes = changes_since_last(points, earlier);
  const auto [ray_tails, z_tails] = residual_tails(points);
  const Likeness alike = likeness_of_neighbours(points);
  const auto count = static_cast<int>(keyframes_.rows() / 6);

  Matrix6d H = Matrix6d::Zero(), noise = Matrix6d::Zero(), repeated = Matrix6d::Zero();
  std::vector<Matrix6d> by_host(count, Matrix6d::Zero());
  std::vector<Gain> gains;
  for (const PlacedBy& point : points) {
    const Eigen::Matrix3d M = measured_by_position(point);
    const Matrix36 J = measured_by_camera(point, world_from_cam);
    const double z = point.z_sigma * point.z_sigma;
    const auto noise_of = [&](double ray_share, double z_share) {
      Eigen::Matrix3d C = Eigen::Matrix3d::Zero();
      C.topLeftCorner<2, 2>() = ray_share * point.ray_noise.covariance();
      C(2, 2) = z_share * z;
      return C;
    };
    const Eigen::Matrix3d shown = noise_of(1, 1);
    const Eigen::Matrix3d S = M * point.S * M.transpose();
    const Matrix63 JtW = J.transpose() * information(shown + S, z > 0);
    H += JtW * J;
    const int host = point.ref.keyframe - first_id_;
    if (host >= 0 && host < count) by_host[host] += JtW * J;
    const double new_ray = std::min(changes.ray, ray_tails), new_z = std::min(changes.z, z_tails);
    const Eigen::Matrix3d own = noise_of(alike.ray * new_ray, alike.z * new_z);
    const Eigen::Matrix3d again =
        alike.z * S + noise_of(alike.ray * (ray_tails - new_ray), alike.z * (z_tails - new_z));
    noise += JtW * own * JtW.transpose();
    repeated += JtW * again * JtW.transpose();
    gains.push_back(
        {point.ref, JtW, again, {point.ray_residual.x(), point.ray_residual.y(), point.z_residual}});
  }
  const Eigen::FullPivLU<Matrix6d> lu(H);
  if (points.size() < 3 || !lu.isInvertible()) return moved(world_from_cam, Matrix6d::Identity());
  const Matrix6d inverse = lu.inverse();
  noise = inverse * noise * inverse.transpose();
  repeated = inverse * repeated * inverse.transpose();
  const Matrix6d shown = shown_by_residuals(points, gains, inverse, world_from_cam);
  const Matrix6d A = between(noise + repeated, shown);
  noise = A * noise * A.transpose();
  repeated = A * repeated * A.transpose();

  CameraErrors now;
  now.with_keyframes.setZero(6, keyframes_.cols());
  Matrix6d with_last = Matrix6d::Zero();
  for (int i = 0; i < count; ++i) {
    by_host[i] = inverse * by_host[i];
    now.with_keyframes += by_host[i] * keyframes_.middleRows(6 * i, 6);
    with_last += by_host[i] * last_.with_keyframes.middleCols(6 * i, 6).transpose();
  }
  now.covariance = noise + repeated;
  for (int i = 0; i < count; ++i)
    now.covariance += now.with_keyframes.middleCols(6 * i, 6) * by_host[i].transpose();

  Matrix6d by_points = Matrix6d::Zero();  // what both cameras have of the same points' errors
  for (std::size_t i = 0; i < gains.size(); ++i) {
    gains[i].by_error = A * inverse * gains[i].by_error;
    if (!earlier[i]) continue;
    const Eigen::Matrix3d& both =
        gains[i].repeated.trace() < earlier[i]->repeated.trace() ? gains[i].repeated : earlier[i]->repeated;
    by_points += gains[i].by_error * both * earlier[i]->by_error.transpose();
  }
  if (last_.is_keyframe) {
    const Matrix6d share = by_host[count - 1] * by_points.transpose();
    now.covariance += share + share.transpose();
    now.with_keyframes.rightCols<6>() += by_points;
  }
  with_last += by_points;
  now.covariance = symmetric(now.covariance);
  now.gains = std::move(gains);
  difference_ =
      noise + positive_part(now.covariance + last_.covariance - with_last - with_last.transpose() - noise);
  last_with_earlier_ = with_last;
  earlier_ = std::move(last_);
  last_ = std::move(now);
}

// xi = A xi_placed + (1 - A) xi_earlier + lag.
void PoseErrors::drawn_to_prior(const Pose& world_from_cam, const PriorDraw& draw) {
  if (last_.gains.empty() || (draw.rotation >= 1 && draw.position >= 1)) return;
  const Matrix6d to_xi = xi_by_camera(world_from_cam);
  Matrix6d from_xi = Matrix6d::Identity();
  from_xi.topLeftCorner<3, 3>() = world_from_cam.R.transpose();
  from_xi.bottomLeftCorner<3, 3>() = -skew(world_from_cam.t);
  const Matrix6d placed = from_xi * difference_ * from_xi.transpose();
  Vector6d taken, lag;
  const auto left_of = [](double alpha, double innovation, double noise) {
    return (1 - alpha) * (1 - alpha) * std::max(0.0, innovation - noise);
  };
  taken << Eigen::Vector3d::Constant(draw.rotation), Eigen::Vector3d::Constant(draw.position);
  lag << Eigen::Vector3d::Constant(
      left_of(draw.rotation, draw.rotation_innovation, placed.topLeftCorner<3, 3>().trace() / 3)),
      Eigen::Vector3d::Constant(
          left_of(draw.position, draw.position_innovation, placed.bottomRightCorner<3, 3>().trace() / 3));
  const Matrix6d A = to_xi * taken.asDiagonal() * from_xi, rest = Matrix6d::Identity() - A;
  const Matrix6d late = to_xi * lag.asDiagonal() * to_xi.transpose();
  const Matrix6d cross = A * last_with_earlier_ * rest.transpose();
  last_.covariance = symmetric(A * last_.covariance * A.transpose() + cross + cross.transpose() +
                               rest * earlier_.covariance * rest.transpose() + late);
  last_.with_keyframes = A * last_.with_keyframes + rest * earlier_.with_keyframes;
  for (Gain& gain : last_.gains) gain.by_error = A * gain.by_error;
  difference_ = symmetric(A * difference_ * A.transpose() + late);
}

void PoseErrors::moved(const Pose& world_from_cam, const Matrix6d& covariance) {
  const Matrix6d J = xi_by_camera(world_from_cam);
  difference_ = symmetric(J * covariance * J.transpose());
  last_.covariance += difference_;
  last_.gains.clear();
  last_.is_keyframe = false;
}

void PoseErrors::corrected(const Pose& new_from_old) {
  Vector6d moved;
  moved << so3_log(new_from_old.R), new_from_old.t;
  difference_ += moved * moved.transpose();
}

void PoseErrors::become_keyframe(int first_id) {
  const Eigen::Index n = keyframes_.rows();
  Eigen::MatrixXd grown(n + 6, n + 6);
  grown.topLeftCorner(n, n) = keyframes_;
  grown.bottomLeftCorner(6, n) = last_.with_keyframes;
  grown.topRightCorner(n, 6) = last_.with_keyframes.transpose();
  grown.bottomRightCorner<6, 6>() = last_.covariance;
  keyframes_ = std::move(grown);
  last_.with_keyframes.conservativeResize(6, n + 6);
  last_.with_keyframes.rightCols<6>() = last_.covariance;
  last_.is_keyframe = true;
  if (first_id == first_id_) return;
  const Eigen::Index kept = keyframes_.rows() - 6 * (first_id - first_id_);
  keyframes_ = Eigen::MatrixXd(keyframes_.bottomRightCorner(kept, kept));
  last_.with_keyframes = Eigen::Matrix<double, 6, Eigen::Dynamic>(last_.with_keyframes.rightCols(kept));
  first_id_ = first_id;
}

// world_from_cam2^-1 exp(xi1 - xi2) world_from_cam1 = cam2_from_cam1 exp(Ad(cam1_from_world) (xi1 - xi2)).
Matrix6d PoseErrors::step_covariance(const Pose& world_from_cam1, const Pose& world_from_cam2) const {
  const Eigen::Matrix3d cam1_from_world = world_from_cam1.R.transpose();
  const Eigen::Matrix3d cam2_from_world = world_from_cam2.R.transpose();
  Matrix6d J = Matrix6d::Zero();
  J.topLeftCorner<3, 3>() = cam1_from_world;
  J.bottomLeftCorner<3, 3>() = -cam2_from_world * skew(world_from_cam1.t);
  J.bottomRightCorner<3, 3>() = cam2_from_world;
  return symmetric(J * difference_ * J.transpose());
}

}  // namespace framewise
