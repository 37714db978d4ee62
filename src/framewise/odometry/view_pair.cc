// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/odometry/view_pair.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "framewise/geometry/so3.h"
#include "framewise/robust/sampler.h"

namespace framewise {
namespace {

constexpr double kNearPx = 3;           // a feature and a point that are the same corner
constexpr double kMostUncertain = 0.2;  // of depths that are worth asking
constexpr int kFewest = 10;             // as of length_by_depth

const KnownDepth* nearest_to(const Eigen::Vector2d& pixel, const std::vector<KnownDepth>& known) {
  const KnownDepth* nearest = nullptr;
  double least = kNearPx * kNearPx;
  for (const KnownDepth& depth : known)
    if (const double d2 = (depth.pixel - pixel).squaredNorm(); d2 < least) nearest = &depth, least = d2;
  return nearest;
}

// A length as one point has it, and what that is worth.
struct Vote {
  double log_length, weight;
};

double weighted_median(std::vector<Vote>& votes) {
  std::sort(votes.begin(), votes.end(),
            [](const Vote& a, const Vote& b) { return a.log_length < b.log_length; });
  double half = 0;
  for (const Vote& vote : votes) half += vote.weight / 2;
  for (const Vote& vote : votes)
    if ((half -= vote.weight) <= 0) return vote.log_length;
  return votes.back().log_length;
}

// A point of known depth, in camera 1 and in camera 2 but for the translation, and where camera 2 sees it.
struct TurnedPoint {
  Eigen::Vector3d X, turned, ray;
  double relative_sigma, max_error;

  bool agrees(const Eigen::Vector3d& t) const {
    const Eigen::Vector3d x = turned + t;
    return x.z() > 0 && (x.head<2>() / x.z() - ray.head<2>()).norm() < max_error + spread(t);
  }
  // How far off its image is where its depth is by a sigma.
  double spread(const Eigen::Vector3d& t) const { return relative_sigma * t.norm() / turned.z(); }
  // Of (turned + t), 0 where the ray is.
  Eigen::Matrix<double, 2, 3> rows(const Eigen::Vector3d& t) const {
    Eigen::Matrix<double, 2, 3> A;
    A << 1, 0, -ray.x(), 0, 1, -ray.y();
    return A / std::max(0.1 * turned.z(), turned.z() + t.z());
  }
  double weight(const Eigen::Vector3d& t) const {
    constexpr double kSigma = 0.5;  // of max_error
    return 1 / (std::pow(kSigma * max_error, 2) + std::pow(spread(t), 2));
  }
};

// The translation that fits best; its own depths and noise depend on it a little.
std::optional<Eigen::Vector3d> solve(std::span<const TurnedPoint> points) {
  Eigen::Vector3d t = Eigen::Vector3d::Zero();
  for (int round = 0; round < 3; ++round) {
    Eigen::Matrix3d N = Eigen::Matrix3d::Zero();
    Eigen::Vector3d b = Eigen::Vector3d::Zero();
    for (const TurnedPoint& point : points) {
      const Eigen::Matrix<double, 2, 3> A = point.rows(t);
      N += point.weight(t) * A.transpose() * A;
      b -= point.weight(t) * A.transpose() * (A * point.turned);
    }
    const Eigen::LDLT<Eigen::Matrix3d> factors(N);
    if (factors.info() != Eigen::Success || factors.rcond() < 1e-9) return std::nullopt;
    t = factors.solve(b);
  }
  return t;
}

double median_z(std::vector<KnownDepth> known) {
  if (known.empty()) return 0;
  const auto middle = known.begin() + static_cast<std::ptrdiff_t>(known.size() / 2);
  std::nth_element(known.begin(), middle, known.end(),
                   [](const KnownDepth& a, const KnownDepth& b) { return a.z < b.z; });
  return middle->z;
}

}  // namespace

std::vector<KnownDepth> known_depths(const LocalMap& map, const std::vector<int>& keyframes,
                                     const Pose& world_from_cam, const Camera& camera) {
  std::vector<KnownDepth> known;
  for (const VisiblePoint& visible : points_in_view(map, keyframes, world_from_cam, camera, {})) {
    const MapPoint& point = map.point(visible.ref);
    const double relative_sigma = std::sqrt(point.variance) / point.inverse_z;
    if (relative_sigma < kMostUncertain)
      known.push_back({visible.pixel, visible.x_in_cam.z(), relative_sigma});
  }
  return known;
}

std::vector<KnownDepth> known_depths(const MapFrame& frame, const Camera& camera,
                                     const OdometryOptions& options) {
  std::vector<KnownDepth> known;
  for (std::size_t i = 0; i < frame.rays.size(); ++i)
    if (const auto plane = depth_along(frame, frame.rays[i], {}, camera, options))
      known.push_back({frame.pixel(static_cast<int>(i)), plane->z,
                       plane->noise_share * options.depth_noise.sigma(plane->z) / plane->z});
  return known;
}

std::optional<MotionLength> length_by_known(const TwoViewStart& two_views, const MapFrame& frame1,
                                            const std::vector<KnownDepth>& known) {
  std::vector<Vote> votes;
  for (const MapPoint& point : two_views.points) {
    const KnownDepth* depth = nearest_to(frame1.pixel(point.feature), known);
    if (!depth) continue;
    constexpr double kLeastSigma = 0.03;  // of one point, whose neighbour this may be
    const double sigma = std::hypot(std::sqrt(point.variance) / point.inverse_z, depth->relative_sigma);
    if (sigma > kMostUncertain) continue;
    const double worth = std::max(kLeastSigma, sigma);
    votes.push_back({std::log(depth->z * point.inverse_z), 1 / (worth * worth)});
  }
  if (static_cast<int>(votes.size()) < kFewest) return std::nullopt;
  const double middle = weighted_median(votes);
  constexpr double kAgreeing = 0.2;
  double information = 0, squares = 0;
  int agreeing = 0;
  for (const Vote& vote : votes) {
    const double off = vote.log_length - middle;
    if (std::abs(off) > kAgreeing) continue;
    ++agreeing, information += vote.weight, squares += vote.weight * off * off;
  }
  if (agreeing < kFewest || 2 * agreeing < static_cast<int>(votes.size())) return std::nullopt;
  const double noise = std::max(1.0, squares / agreeing);
  return MotionLength{std::exp(middle), std::sqrt(noise / information)};
}

std::optional<KnownTranslation> translation_by_known(const TwoViewStart& two_views, const MapFrame& frame1,
                                                     const std::vector<KnownDepth>& known,
                                                     const Camera& camera, std::uint64_t seed) {
  const double focal = std::abs(camera.fx), max_error = TwoViewOptions().max_error_px / focal;
  const Eigen::Matrix3d& R = two_views.cam2_from_cam1.R;
  std::vector<TurnedPoint> points;
  for (const FeaturePair& pair : two_views.agreeing) {
    const KnownDepth* depth = nearest_to(frame1.pixel(pair.feature1), known);
    if (!depth || depth->relative_sigma > kMostUncertain) continue;
    const Eigen::Vector3d X = point_at_depth(frame1.rays[pair.feature1], depth->z);
    points.push_back({X, R * X, pair.ray2, depth->relative_sigma, max_error});
  }
  const int count = static_cast<int>(points.size());
  if (count < kFewest) return std::nullopt;
  constexpr int kTries = 100;
  RandomStream random(seed);
  std::array<std::uint32_t, 2> sample{};
  Eigen::Vector3d best = Eigen::Vector3d::Zero();
  int most = 0;
  for (int i = 0; i < kTries; ++i) {
    draw_distinct(points.size(), sample, random);
    const auto t = solve(std::array{points[sample[0]], points[sample[1]]});
    if (!t) continue;
    const auto agreeing = std::count_if(points.begin(), points.end(),
                                        [&](const TurnedPoint& point) { return point.agrees(*t); });
    if (agreeing > most) most = static_cast<int>(agreeing), best = *t;
  }
  if (most < kFewest || 2 * most < count) return std::nullopt;
  std::erase_if(points, [&](const TurnedPoint& point) { return !point.agrees(best); });
  const auto t = solve(points);
  if (!t) return std::nullopt;
  Eigen::Matrix3d N = Eigen::Matrix3d::Zero(), M = Eigen::Matrix3d::Zero();
  double squares = 0;
  for (const TurnedPoint& point : points) {
    const Eigen::Matrix<double, 2, 3> A = point.rows(*t);
    const double weight = point.weight(*t);
    N += weight * A.transpose() * A;
    M += weight * A.transpose() * A * R * skew(point.X);
    squares += weight * (A * (point.turned + *t)).squaredNorm();
  }
  const double noise = std::max(1.0, squares / (2 * most - 3));
  return KnownTranslation{*t, noise * N.inverse(), N.inverse() * M};
}

std::optional<ViewPose> pose_from_views(FrameView& first, FrameView& second, const Pose& prior,
                                        const std::vector<KnownDepth>& known, const Camera& camera,
                                        const RansacOptions& ransac) {
  if (first.empty() || second.empty()) return std::nullopt;
  TwoViewOptions options;
  options.ransac = ransac;
  options.farthest = 2;          // anywhere
  options.min_parallax_deg = 0;  // few known depths are enough
  options.min_points = kFewest;
  const MapFrame &frame1 = first.described(camera), &frame2 = second.described(camera);
  const TwoViewStart two_views = start_from_two_views(frame1, frame2, camera, options);
  if (two_views.kind == TwoViewStart::Kind::kUnrelated) return std::nullopt;
  ViewPose found;
  found.pose.num_inliers = two_views.inliers;
  found.pose.inliers.assign(two_views.pairs, 1);
  found.pose.cam_from_reference = two_views.cam2_from_cam1;
  found.is_far = two_views.support != EstimateKind::kFull;
  Matrix6d& C = found.pose.covariance = two_views.covariance;
  Eigen::Vector3d& t = found.pose.cam_from_reference.t;
  MotionLength length{prior.t.norm(), 1};
  const auto by_known = two_views.kind == TwoViewStart::Kind::kTriangulated
                            ? length_by_known(two_views, frame1, known)
                            : std::nullopt;
  const auto translation =
      by_known ? std::nullopt : translation_by_known(two_views, frame1, known, camera, ransac.seed);
  if (translation) {
    const Eigen::Matrix3d C_R = C.topLeftCorner<3, 3>(), by_rotation = translation->by_rotation;
    t = translation->t;
    C.topRightCorner<3, 3>() = C_R * by_rotation.transpose();
    C.bottomLeftCorner<3, 3>() = by_rotation * C_R;
    C.bottomRightCorner<3, 3>() = translation->covariance + by_rotation * C_R * by_rotation.transpose();
  } else if (two_views.support == EstimateKind::kRotationOnly) {
    t.setZero();
    length.value = 0;
    C.rightCols<3>().setZero(), C.bottomRows<3>().setZero();
    const double sigma = 2 * options.max_error_px / std::abs(camera.fx) * median_z(known);
    C.bottomRightCorner<3, 3>() = sigma * sigma * Eigen::Matrix3d::Identity();
    found.is_guess = known.empty();
  } else if (two_views.kind == TwoViewStart::Kind::kTriangulated) {
    found.is_guess = !by_known;
    if (by_known) length = *by_known;
    t *= length.value;
    C.rightCols<3>() *= length.value, C.bottomRows<3>() *= length.value;
    C.bottomRightCorner<3, 3>() += std::pow(length.relative_sigma, 2) * t * t.transpose();
  } else {
    found.is_guess = true;
    t = two_views.cam2_from_cam1.R * prior.R.transpose() * prior.t;
  }
  if (!found.is_guess && !C.allFinite()) return std::nullopt;
  return found;
}

}  // namespace framewise
