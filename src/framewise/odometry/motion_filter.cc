// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/odometry/motion_filter.h"

#include <algorithm>
#include <cmath>

#include "framewise/geometry/so3.h"

namespace framewise {
namespace {

constexpr double kLag = 0.5;            // s
constexpr double kLeastHalfLife = 0.2;  // s: a hand that moves the camera changes its mind about as fast

}  // namespace

void MotionFilter::start(double time, const Pose& world_from_cam) {
  time_ = time;
  world_from_cam_ = measured_ = world_from_cam;
  rotation_ = {}, position_ = {};
  updates_ = 0;
  time_then_ = std::numeric_limits<double>::quiet_NaN();
}

Pose MotionFilter::predict(double time) const {
  const double dt = time - time_;
  return {world_from_cam_.R * so3_exp(rotation_.velocity * dt), world_from_cam_.t + position_.velocity * dt};
}

Pose MotionFilter::motion_during(double delay) const {
  const Pose world_from_later = {world_from_cam_.R * so3_exp(rotation_.velocity * delay),
                                 world_from_cam_.t + position_.velocity * delay};
  return world_from_later.inverse() * world_from_cam_;
}

Eigen::Vector3d MotionFilter::Axes::update(const Eigen::Vector3d& e, double noise, double dt, bool shrinks) {
  constexpr double kMemory = 0.1;     // of the newest innovation in their mean
  constexpr double kLeastGain = 0.1;  // however still the camera stood, it may begin to move
  const double square = e.squaredNorm() / 3;
  innovation = innovation < 0 ? square : (1 - kMemory) * innovation + kMemory * square;
  // A sudden start is not held back by how still it was before.
  constexpr double kSudden = 6;  // times the mean square: noise is seldom so large
  const double expected = square > kSudden * innovation ? square : innovation;
  const double alpha = shrinks && expected > 0 ? std::clamp(1 - noise / expected, kLeastGain, 1.0) : 1;
  taken = alpha;
  const double beta = 2 * (2 - alpha) - 4 * std::sqrt(1 - alpha);
  velocity += std::min(1.0, beta) * e / dt;
  return alpha * e;
}

void MotionFilter::Axes::take_rate(const Eigen::Vector3d& measured_rate, double dt) {
  constexpr double kMemory = 0.05;
  const Eigen::Vector3d newest = (measured_rate - rate) * dt;
  if (++rates > 2) change_products += kMemory * (newest.dot(change) / 3 - change_products);
  rate = measured_rate, change = newest;
}

double MotionFilter::Axes::shown_noise(double said) const {
  constexpr double kMost = 9;  // of what was said: steps seen at a few frames a second swing as well
  return std::clamp(-change_products / 4, said, kMost * said);
}

void MotionFilter::Axes::compare_with_then() {
  constexpr double kMemory = 0.2;  // of the newest pair
  const double square = (velocity.squaredNorm() + velocity_then.squaredNorm()) / 2;
  if (squares == 0) products = std::exp2(-kLag / kLeastHalfLife) * square, squares = square;
  products = (1 - kMemory) * products + velocity.dot(velocity_then);
  squares = (1 - kMemory) * squares + square;
}

double MotionFilter::Axes::share_kept(double seconds) const {
  const double least = std::exp2(-kLag / kLeastHalfLife);
  const double a_lag_later = squares > 0 ? std::clamp(products / squares, least, 1.0) : least;
  return std::pow(a_lag_later, seconds / kLag);
}

Pose MotionFilter::update(double time, const Pose& measured, const Matrix6d& covariance) {
  const double dt = std::max(1e-6, time - time_);
  const Pose predicted = predict(time);
  rotation_.take_rate(so3_log(measured_.R.transpose() * measured.R) / dt, dt);
  position_.take_rate((measured.t - measured_.t) / dt, dt);
  measured_ = measured;
  const double rotation_noise = rotation_.shown_noise(covariance.topLeftCorner<3, 3>().trace() / 3);
  const double position_noise = position_.shown_noise(covariance.bottomRightCorner<3, 3>().trace() / 3);
  const bool shrinks = shrinks_ && updates_++ > 2 && std::isfinite(rotation_noise + position_noise);
  const Eigen::Vector3d turned =
      rotation_.update(so3_log(predicted.R.transpose() * measured.R), rotation_noise, dt, shrinks);
  const Eigen::Vector3d moved = position_.update(measured.t - predicted.t, position_noise, dt, shrinks);
  draw_ = {rotation_.taken, position_.taken, rotation_.innovation, position_.innovation};
  time_ = time;
  world_from_cam_ = shrinks ? Pose{predicted.R * so3_exp(turned), predicted.t + moved} : measured;
  world_from_cam_.R = nearest_rotation(world_from_cam_.R);  // of thousands of products
  if (time - time_then_ < kLag) return world_from_cam_;
  for (Axes* axes : {&rotation_, &position_}) {
    if (std::isfinite(time_then_)) axes->compare_with_then();
    axes->velocity_then = axes->velocity;
  }
  time_then_ = time;
  return world_from_cam_;
}

Matrix6d MotionFilter::departure() const {
  const auto square = [](const Axes& axes) { return axes.innovation < 0 ? 1.0 : axes.innovation; };
  Vector6d squares;
  squares << Eigen::Vector3d::Constant(square(rotation_)), Eigen::Vector3d::Constant(square(position_));
  return squares.asDiagonal();
}

void MotionFilter::coast(double time) {
  world_from_cam_ = measured_ = predict(time);
  for (Axes* axes : {&rotation_, &position_}) {
    axes->velocity *= axes->share_kept(std::max(0.0, time - time_));
    axes->rates = 0;
  }
  time_then_ = std::numeric_limits<double>::quiet_NaN();
  time_ = time;
}

void MotionFilter::correct(const Pose& new_from_old) {
  world_from_cam_ = new_from_old * world_from_cam_;
  world_from_cam_.R = nearest_rotation(world_from_cam_.R);
  measured_ = new_from_old * measured_;
  for (Eigen::Vector3d* v : {&position_.rate, &position_.change}) *v = new_from_old.R * *v;
  position_.velocity = new_from_old.R * position_.velocity;
  position_.velocity_then = new_from_old.R * position_.velocity_then;
}

}  // namespace framewise
