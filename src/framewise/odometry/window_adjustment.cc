// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/odometry/window_adjustment.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <map>

#include "framewise/geometry/so3.h"

namespace framewise {
namespace {

using Jacobian = Eigen::Matrix<double, 3, 6>;

constexpr double kMaxSquare = 16;  // of a view that agrees, in squared standard deviations

// A point that has a part in the adjustment.
struct WindowPoint {
  PointRef ref;
  int host;                // index of its pose
  double inverse_z;        // as adjusted
  std::vector<int> views;  // of the point's, those from keyframes in the adjustment
};

// What poses and points are moved from.
struct WindowState {
  std::vector<Pose> poses;  // world_from_cam of the moving keyframes, then of the still ones
  std::vector<double> inverse_z;
};

// A view's residuals in standard deviations, with their derivatives by the host's pose, the viewer's and the
// inverse depth. Without depth the third is zero.
struct ViewTerms {
  Eigen::Vector3d r = Eigen::Vector3d::Zero();
  Jacobian J_host, J_viewer;
  Eigen::Vector3d J_inverse_z;
  bool is_in_front = false;
};

ViewTerms view_terms(const MapPoint& point, double inverse_z, const PointView& view, const Pose& host,
                     const Pose& viewer, const DepthNoise& noise) {
  ViewTerms terms;
  const Eigen::Vector3d X_host = point.ray / inverse_z;
  const Eigen::Matrix3d viewer_from_world = viewer.R.transpose();
  const Eigen::Vector3d X = viewer_from_world * (host * X_host - viewer.t);
  terms.is_in_front = X.z() > 1e-3;
  if (!terms.is_in_front) return terms;
  const double iz = 1 / X.z(), weight = 1 / view.sigma;
  const bool has_depth = view.z > 0;
  const double depth_weight = has_depth ? 1 / noise.sigma(view.z) : 0;
  terms.r << weight * (X.x() * iz - view.ray.x()), weight * (X.y() * iz - view.ray.y()),
      has_depth ? depth_weight * (X.z() - view.z) : 0;
  Eigen::Matrix3d P;
  P << weight * iz, 0, -weight * X.x() * iz * iz, 0, weight * iz, -weight * X.y() * iz * iz, 0, 0,
      depth_weight;
  const Eigen::Matrix3d viewer_from_host = viewer_from_world * host.R;
  terms.J_host << -P * viewer_from_host * skew(X_host), P * viewer_from_world;
  terms.J_viewer << P * skew(X), -P * viewer_from_world;
  terms.J_inverse_z = -P * viewer_from_host * X_host / inverse_z;
  return terms;
}

// Cauchy's loss.
struct Robust {
  double t2;
  double price(double q) const { return t2 * std::log1p(q / t2); }
  double weight(double q) const { return 1 / (1 + q / t2); }
};

class Window {
 public:
  Window(LocalMap& map, const std::vector<int>& moving, const std::vector<int>& still,
         const WindowOptions& options)
      : map_(map),
        options_(options),
        robust_{options.loss_threshold * options.loss_threshold},
        moving_(static_cast<int>(moving.size())) {
    for (const auto* ids : {&moving, &still})
      for (const int id : *ids) {
        index_of_[id] = static_cast<int>(ids_.size());
        ids_.push_back(id);
        state_.poses.push_back(map.at(id).world_from_cam);
      }
    for (const int id : ids_) collect_points(id);
  }

  WindowSummary adjust() {
    WindowSummary summary;
    for (const WindowPoint& point : points_) summary.views += static_cast<int>(point.views.size());
    if (moving_ == 0 || points_.empty()) return summary;
    double cost = summary.first_cost = cost_of(state_), damping = 1e-4;
    while (summary.iterations < options_.max_iterations && damping < 1e6) {
      ++summary.iterations;
      double promised = 0;
      const WindowState next = stepped(damping, promised);
      const double next_cost = cost_of(next);
      if (next_cost < cost) {
        state_ = next;
        cost = next_cost;
        damping = std::max(1e-6, 0.1 * damping);
        if (promised < options_.tolerance * cost) break;
      } else {
        damping *= 20;
      }
    }
    summary.cost = cost;
    store();
    return summary;
  }

 private:
  void collect_points(int id) {
    const Keyframe& host = map_.at(id);
    for (int i = 0; i < static_cast<int>(host.points.size()); ++i) {
      WindowPoint point{{id, i}, index_of_[id], host.points[i].inverse_z, {}};
      for (int v = 0; v < static_cast<int>(host.points[i].views.size()); ++v)
        if (index_of_.contains(host.points[i].views[v].keyframe)) point.views.push_back(v);
      if (point.views.empty() || host.points[i].is_given_up) continue;
      state_.inverse_z.push_back(point.inverse_z);
      points_.push_back(std::move(point));
    }
  }

  int index_of(const PointView& view) const { return index_of_.at(view.keyframe); }

  double cost_of(const WindowState& state) const {
    double cost = 0;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const MapPoint& point = map_.point(points_[i].ref);
      for (const int v : points_[i].views) {
        const PointView& view = point.views[v];
        const ViewTerms terms = view_terms(point, state.inverse_z[i], view, state.poses[points_[i].host],
                                           state.poses[index_of(view)], options_.depth_noise);
        cost += terms.is_in_front ? robust_.price(terms.r.squaredNorm()) : robust_.price(1e6);
      }
      const double d = state.inverse_z[i] - point.measured;
      cost += robust_.price(d * d * point.information);
    }
    return cost;
  }

  // One Levenberg-Marquardt step: the points' own numbers are eliminated one by one.
  WindowState stepped(double damping, double& promised) const {
    const int size = 6 * moving_;
    Eigen::MatrixXd H = Eigen::MatrixXd::Zero(size, size);
    Eigen::VectorXd g = Eigen::VectorXd::Zero(size);
    struct Elimination {
      double h = 0, g = 0;
      std::vector<std::pair<int, Vector6d>> of_poses;
    };
    std::vector<Elimination> eliminated(points_.size());
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const WindowPoint& window_point = points_[i];
      const MapPoint& point = map_.point(window_point.ref);
      Elimination& own = eliminated[i];
      const auto add_to = [&](int pose, const Vector6d& h) {
        for (auto& [known, sum] : own.of_poses)
          if (known == pose) return void(sum += h);
        own.of_poses.emplace_back(pose, h);
      };
      const double d = state_.inverse_z[i] - point.measured;
      const double prior = point.information * robust_.weight(d * d * point.information);
      own.h = prior, own.g = prior * d;
      for (const int v : window_point.views) {
        const PointView& view = point.views[v];
        const int host = window_point.host, viewer = index_of(view);
        const ViewTerms t = view_terms(point, state_.inverse_z[i], view, state_.poses[host],
                                       state_.poses[viewer], options_.depth_noise);
        if (!t.is_in_front) continue;
        const double w = robust_.weight(t.r.squaredNorm());
        own.h += w * t.J_inverse_z.squaredNorm();
        own.g += w * t.J_inverse_z.dot(t.r);
        const bool host_moves = host < moving_, viewer_moves = viewer < moving_;
        if (host_moves) {
          H.block<6, 6>(6 * host, 6 * host) += w * t.J_host.transpose() * t.J_host;
          g.segment<6>(6 * host) += w * t.J_host.transpose() * t.r;
          add_to(host, w * t.J_host.transpose() * t.J_inverse_z);
        }
        if (viewer_moves) {
          H.block<6, 6>(6 * viewer, 6 * viewer) += w * t.J_viewer.transpose() * t.J_viewer;
          g.segment<6>(6 * viewer) += w * t.J_viewer.transpose() * t.r;
          add_to(viewer, w * t.J_viewer.transpose() * t.J_inverse_z);
        }
        if (host_moves && viewer_moves) {
          const Matrix6d cross = w * t.J_host.transpose() * t.J_viewer;
          H.block<6, 6>(6 * host, 6 * viewer) += cross;
          H.block<6, 6>(6 * viewer, 6 * host) += cross.transpose();
        }
      }
      own.h = std::max(own.h, 1e-12) * (1 + damping);
      for (const auto& [a, ha] : own.of_poses) {
        g.segment<6>(6 * a) -= ha * (own.g / own.h);
        for (const auto& [b, hb] : own.of_poses) H.block<6, 6>(6 * a, 6 * b) -= ha * hb.transpose() / own.h;
      }
    }
    H.diagonal().array() *= 1 + damping;
    H.diagonal().array() += 1e-9;
    const Eigen::VectorXd step = H.ldlt().solve(-g);

    WindowState next = state_;
    promised = -g.dot(step);
    for (int k = 0; k < moving_; ++k) {
      next.poses[k].R = nearest_rotation(state_.poses[k].R * so3_exp(step.segment<3>(6 * k)));
      next.poses[k].t += step.segment<3>(6 * k + 3);
    }
    for (std::size_t i = 0; i < points_.size(); ++i) {
      double pull = eliminated[i].g;
      for (const auto& [pose, h] : eliminated[i].of_poses) pull += h.dot(step.segment<6>(6 * pose));
      const double moved = state_.inverse_z[i] - pull / eliminated[i].h;
      next.inverse_z[i] = std::clamp(moved, 0.3 * state_.inverse_z[i], 3 * state_.inverse_z[i]);
    }
    return next;
  }

  // Into the map; a point's variance becomes what the poses as they are leave of it.
  void store() {
    for (int k = 0; k < moving_; ++k) map_.at(ids_[k]).world_from_cam = state_.poses[k];
    for (std::size_t i = 0; i < points_.size(); ++i) {
      MapPoint& point = map_.point(points_[i].ref);
      point.inverse_z = state_.inverse_z[i];
      double information = point.information;
      std::vector<PointView> kept;
      std::size_t next = 0;
      for (int v = 0; v < static_cast<int>(point.views.size()); ++v) {
        const PointView& view = point.views[v];
        const bool has_part = next < points_[i].views.size() && points_[i].views[next] == v;
        next += has_part;
        if (has_part) {
          const ViewTerms terms = view_terms(point, point.inverse_z, view, state_.poses[points_[i].host],
                                             state_.poses[index_of(view)], options_.depth_noise);
          if (!terms.is_in_front || terms.r.head<2>().squaredNorm() > kMaxSquare) continue;
          information += terms.J_inverse_z.squaredNorm();
        }
        kept.push_back(view);
      }
      point.is_given_up = kept.empty() && !point.views.empty() && point.measured <= 0;
      point.views = std::move(kept);
      if (information > 0) point.variance = 1 / information;
    }
  }

  LocalMap& map_;
  WindowOptions options_;
  Robust robust_;
  int moving_;
  std::vector<int> ids_;
  std::map<int, int> index_of_;
  std::vector<WindowPoint> points_;
  WindowState state_;
};

}  // namespace

WindowSummary adjust_window(LocalMap& map, const std::vector<int>& moving, const std::vector<int>& still,
                            const WindowOptions& options) {
  return Window(map, moving, still, options).adjust();
}

}  // namespace framewise
