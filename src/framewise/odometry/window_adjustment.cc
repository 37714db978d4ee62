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
  double lens = 0;  // correction of k1
};

// A view's residuals in standard deviations, with their derivatives by the host's pose, the viewer's and the
// inverse depth. Without depth the third is zero.
struct ViewTerms {
  Eigen::Vector3d r = Eigen::Vector3d::Zero();
  Jacobian J_host, J_viewer;
  Eigen::Vector3d J_inverse_z, J_lens;
  bool is_in_front = false;
};

// Of a ray on the plane z = 1, by k1.
Eigen::Vector3d ray_by_lens(const Eigen::Vector3d& ray) {
  const double r2 = ray.head<2>().squaredNorm();
  return {-r2 * ray.x(), -r2 * ray.y(), 0};
}

ViewTerms view_terms(const MapPoint& point, double inverse_z, double lens, const PointView& view,
                     const Pose& host, const Pose& viewer, const DepthNoise& noise) {
  ViewTerms terms;
  const Eigen::Vector3d host_by_lens = ray_by_lens(point.ray), seen_by_lens = ray_by_lens(view.ray);
  const Eigen::Vector3d X_host = (point.ray + lens * host_by_lens) / inverse_z;
  const Eigen::Vector3d seen = view.ray + lens * seen_by_lens;
  const Eigen::Matrix3d viewer_from_world = viewer.R.transpose();
  const Eigen::Vector3d X = viewer_from_world * (host * X_host - viewer.t);
  terms.is_in_front = X.z() > 1e-3;
  if (!terms.is_in_front) return terms;
  const double iz = 1 / X.z();
  Eigen::Matrix3d W = Eigen::Matrix3d::Identity();
  W.topLeftCorner<2, 2>() = view.noise.whitening();
  const bool has_depth = view.z > 0;
  const double depth_weight = has_depth ? 1 / noise.sigma(view.z) : 0;
  terms.r << X.x() * iz - seen.x(), X.y() * iz - seen.y(), has_depth ? depth_weight * (X.z() - view.z) : 0;
  terms.r = (W * terms.r).eval();
  Eigen::Matrix3d P;
  P << iz, 0, -X.x() * iz * iz, 0, iz, -X.y() * iz * iz, 0, 0, depth_weight;
  P = (W * P).eval();
  const Eigen::Matrix3d viewer_from_host = viewer_from_world * host.R;
  terms.J_host << -P * viewer_from_host * skew(X_host), P * viewer_from_world;
  terms.J_viewer << P * skew(X), -P * viewer_from_world;
  terms.J_inverse_z = -P * viewer_from_host * X_host / inverse_z;
  terms.J_lens = P * viewer_from_host * host_by_lens / inverse_z - W * seen_by_lens;
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
    if (has_lens()) summary.lens_correction = state_.lens, summary.lens_information = lens_information();
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

  bool has_lens() const { return options_.lens_information >= 0; }
  int index_of(const PointView& view) const { return index_of_.at(view.keyframe); }

  double cost_of(const WindowState& state) const {
    double cost = 0;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const MapPoint& point = map_.point(points_[i].ref);
      for (const int v : points_[i].views) {
        const PointView& view = point.views[v];
        const ViewTerms terms =
            view_terms(point, state.inverse_z[i], state.lens, view, state.poses[points_[i].host],
                       state.poses[index_of(view)], options_.depth_noise);
        cost += terms.is_in_front ? robust_.price(terms.r.squaredNorm()) : robust_.price(1e6);
      }
      const double d = state.inverse_z[i] - point.measured;
      cost += robust_.price(d * d * point.information);
    }
    if (has_lens()) cost += options_.lens_information * state.lens * state.lens;
    return cost;
  }

  // What a point's own number has to do with the rest.
  struct Elimination {
    double h = 0, g = 0, of_lens = 0;
    std::vector<std::pair<int, Vector6d>> of_poses;
  };

  // Of the moving poses and then the lens, the points' own numbers eliminated one by one.
  struct NormalEquations {
    Eigen::MatrixXd H;
    Eigen::VectorXd g;
    std::vector<Elimination> eliminated;

    NormalEquations(int size, std::size_t points)
        : H(Eigen::MatrixXd::Zero(size, size)), g(Eigen::VectorXd::Zero(size)), eliminated(points) {}
  };

  int size() const { return 6 * moving_ + has_lens(); }

  void add_view(const WindowPoint& window_point, std::size_t index, int v, NormalEquations& n) const {
    const MapPoint& point = map_.point(window_point.ref);
    const PointView& view = point.views[v];
    Elimination& own = n.eliminated[index];
    const int host = window_point.host, viewer = index_of(view);
    const ViewTerms t = view_terms(point, state_.inverse_z[index], state_.lens, view, state_.poses[host],
                                   state_.poses[viewer], options_.depth_noise);
    if (!t.is_in_front) return;
    const double w = robust_.weight(t.r.squaredNorm());
    own.h += w * t.J_inverse_z.squaredNorm();
    own.g += w * t.J_inverse_z.dot(t.r);
    const int lens = 6 * moving_;
    const auto add_pose = [&](int pose, const Jacobian& J) {
      n.H.block<6, 6>(6 * pose, 6 * pose) += w * J.transpose() * J;
      n.g.segment<6>(6 * pose) += w * J.transpose() * t.r;
      const Vector6d h = w * J.transpose() * t.J_inverse_z;
      const auto known = std::find_if(own.of_poses.begin(), own.of_poses.end(),
                                      [&](const auto& of_pose) { return of_pose.first == pose; });
      if (known == own.of_poses.end()) {
        own.of_poses.emplace_back(pose, h);
      } else {
        known->second += h;
      }
      if (has_lens()) n.H.block<6, 1>(6 * pose, lens) += w * J.transpose() * t.J_lens;
    };
    if (host < moving_) add_pose(host, t.J_host);
    if (viewer < moving_) add_pose(viewer, t.J_viewer);
    if (host < moving_ && viewer < moving_) {
      const Matrix6d cross = w * t.J_host.transpose() * t.J_viewer;
      n.H.block<6, 6>(6 * host, 6 * viewer) += cross;
      n.H.block<6, 6>(6 * viewer, 6 * host) += cross.transpose();
    }
    if (!has_lens()) return;
    n.H(lens, lens) += w * t.J_lens.squaredNorm();
    n.g[lens] += w * t.J_lens.dot(t.r);
    own.of_lens += w * t.J_lens.dot(t.J_inverse_z);
  }

  void eliminate(Elimination& own, double damping, NormalEquations& n) const {
    own.h = std::max(own.h, 1e-12) * (1 + damping);
    const int lens = 6 * moving_;
    for (const auto& [a, ha] : own.of_poses) {
      n.g.segment<6>(6 * a) -= ha * (own.g / own.h);
      for (const auto& [b, hb] : own.of_poses) n.H.block<6, 6>(6 * a, 6 * b) -= ha * hb.transpose() / own.h;
      if (has_lens()) n.H.block<6, 1>(6 * a, lens) -= ha * (own.of_lens / own.h);
    }
    if (!has_lens()) return;
    n.H(lens, lens) -= own.of_lens * own.of_lens / own.h;
    n.g[lens] -= own.of_lens * own.g / own.h;
  }

  NormalEquations normal_equations(double damping) const {
    NormalEquations n(size(), points_.size());
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const MapPoint& point = map_.point(points_[i].ref);
      const double d = state_.inverse_z[i] - point.measured;
      const double prior = point.information * robust_.weight(d * d * point.information);
      n.eliminated[i].h = prior, n.eliminated[i].g = prior * d;
      for (const int v : points_[i].views) add_view(points_[i], i, v, n);
      eliminate(n.eliminated[i], damping, n);
    }
    if (has_lens()) {
      const int lens = 6 * moving_;
      n.H(lens, lens) += options_.lens_information;
      n.g[lens] += options_.lens_information * state_.lens;
      n.H.row(lens) = n.H.col(lens).transpose();
    }
    n.H.diagonal().array() *= 1 + damping;
    n.H.diagonal().array() += 1e-9;
    return n;
  }

  // With the poses free to follow.
  double lens_information() const {
    const NormalEquations n = normal_equations(0);
    const Eigen::VectorXd column = n.H.ldlt().solve(Eigen::VectorXd::Unit(size(), size() - 1));
    return column[size() - 1] > 0 ? 1 / column[size() - 1] : 0;
  }

  // One Levenberg-Marquardt step.
  WindowState stepped(double damping, double& promised) const {
    const NormalEquations n = normal_equations(damping);
    const Eigen::VectorXd step = n.H.ldlt().solve(-n.g);
    WindowState next = state_;
    promised = -n.g.dot(step);
    for (int k = 0; k < moving_; ++k) {
      next.poses[k].R = nearest_rotation(state_.poses[k].R * so3_exp(step.segment<3>(6 * k)));
      next.poses[k].t += step.segment<3>(6 * k + 3);
    }
    const double lens_step = has_lens() ? step[6 * moving_] : 0;
    next.lens += lens_step;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const Elimination& own = n.eliminated[i];
      double pull = own.g + own.of_lens * lens_step;
      for (const auto& [pose, h] : own.of_poses) pull += h.dot(step.segment<6>(6 * pose));
      const double moved = state_.inverse_z[i] - pull / own.h;
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
          const ViewTerms terms =
              view_terms(point, point.inverse_z, state_.lens, view, state_.poses[points_[i].host],
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
