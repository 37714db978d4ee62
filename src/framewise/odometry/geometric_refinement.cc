// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/odometry/geometric_refinement.h"

#include <limits>

#include "framewise/geometry/so3.h"
#include "framewise/image/densify.h"

namespace framewise {
namespace {

// Fewer pixels of the finest level with a plane (of all) are no view of anything.
constexpr double kLeastKnown = 0.02;
// An alignment that explains less of the frame has found another surface.
constexpr double kLeastOverlap = 0.3;
// A depth image of which less is known (and more than nothing) is a scanner's points.
constexpr double kSparse = 0.2;
// Features of one frame share errors, of depth that is rounded and of noise in their patches, that their
// covariance takes for independent: their variances are believed to be so many times what it says.
constexpr double kSharedErrors = 4;
// A motion is continued over no more frames than this.
constexpr double kMostContinued = 3;

SurfaceOptions surface_options(const OdometryOptions& options) {
  SurfaceOptions surface;
  surface.noise = options.depth_noise;
  return surface;
}

bool is_sparse(const cv::Mat& depth) {
  const double known = cv::countNonZero(depth > 0) / static_cast<double>(depth.total());
  return known > 0 && known < kSparse;
}

bool shows_enough(const SurfacePyramid& surface) {
  return !surface.empty() &&
         static_cast<double>(surface[0].known) > kLeastKnown * static_cast<double>(surface[0].grid.size());
}

Pose renewed(const Pose& pose) { return Pose::from_quaternion(pose.quaternion(), pose.t); }

}  // namespace

GeometricRefinement::GeometricRefinement(const Camera& camera, const OdometryOptions& options)
    : uses_model_(options.uses_surface_model()),
      maker_(camera, surface_options(options)),
      model_(maker_, alignment_, {}) {}

SurfacePyramid GeometricRefinement::surface(const cv::Mat& depth) const {
  if (depth.empty()) return {};
  return maker_(is_sparse(depth) ? densify(depth, {}).depth : depth);
}

const Pose& GeometricRefinement::world_from_base() const {
  return uses_model_ ? model_.world_from_keyframe() : world_from_reference_;
}

PoseEstimate GeometricRefinement::reference_from_base() const {
  return {world_from_reference_.inverse() * world_from_base(), reference_covariance_};
}

Pose GeometricRefinement::predicted(double time) const {
  if (!(motion_time_ > 0)) return world_from_reference_;
  const double share = std::min((time - reference_time_) / motion_time_, kMostContinued);
  return world_from_reference_ * Pose{so3_exp(share * so3_log(motion_.R)), share * motion_.t};
}

Pose GeometricRefinement::guess(const SurfacePyramid& surface, const Pose& prediction,
                                const std::optional<Pose>& by_features) const {
  if (!by_features) return prediction;
  const auto fit = [&](const Pose& world_from_cam) {
    return fitting_pixels(*reference_, surface, world_from_cam.inverse() * world_from_reference_, alignment_);
  };
  return fit(*by_features) > fit(prediction) ? *by_features : prediction;
}

std::optional<GeometricRefinement::Found> GeometricRefinement::align(const SurfacePyramid& surface,
                                                                     const Pose& world_from_cam_guess) const {
  auto alignment = uses_model_
                       ? model_.align(surface, world_from_cam_guess)
                       : align_surfaces(*reference_, surface,
                                        world_from_cam_guess.inverse() * world_from_base(), alignment_);
  if (!alignment || alignment->overlap < kLeastOverlap || alignment->free_directions.size() == 6)
    return std::nullopt;
  return Found{*alignment,
               {alignment->cam2_from_cam1, alignment->covariance},
               renewed(world_from_base() * alignment->cam2_from_cam1.inverse())};
}

std::optional<GeometricRefinement::Found> GeometricRefinement::find(const SurfacePyramid& surface,
                                                                    const Pose& prediction,
                                                                    const std::optional<Pose>& by_features,
                                                                    bool in_color) const {
  const auto found = align(surface, guess(surface, prediction, by_features));
  if (!found || found->alignment.free_directions.empty() || !by_features) return found;
  // The guess stays along what is free: it must be one that knows of it.
  return align(surface, in_color ? *by_features : prediction);
}

GeometricRefinement::Found GeometricRefinement::weighed(const Found& found, const Step& from_features) const {
  const auto both = fused(found.cam_from_base,
                          chained({from_features.cam2_from_cam1, kSharedErrors * from_features.covariance},
                                  reference_from_base()));
  if (!both) return found;
  return {found.alignment, *both, renewed(world_from_base() * both->cam2_from_cam1.inverse())};
}

void GeometricRefinement::refer_to(double time, std::shared_ptr<const SurfacePyramid> surface,
                                   const Pose& world_from_cam, const Matrix6d& covariance, double overlap) {
  if (reference_) {
    motion_ = world_from_reference_.inverse() * world_from_cam;
    motion_time_ = time - reference_time_;
  }
  const std::size_t keyframes = model_.keyframes();
  if (uses_model_ && model_.is_started())
    model_.add(*surface, world_from_cam, overlap);
  else if (uses_model_)
    model_.start(*surface, world_from_cam);
  reference_ = std::move(surface);
  world_from_reference_ = world_from_cam;
  const bool is_base = !uses_model_ || model_.keyframes() != keyframes;
  reference_covariance_ = is_base ? Matrix6d::Zero() : covariance;
  reference_time_ = time;
  newest_is_reference_ = true;
}

Step GeometricRefinement::refine(double time, std::shared_ptr<const SurfacePyramid> surface,
                                 const Step& from_features, bool in_color) {
  Step step = from_features;
  const bool sees = shows_enough(*surface);
  if (!reference_) {
    if (sees)
      refer_to(time, std::move(surface), Pose(), Matrix6d::Zero(), 1);
    else if (!is_measured(step.status))
      step.status = Status::kNoDepth;
    return step;
  }
  std::optional<Pose> by_features;
  if (newest_is_reference_ && is_measured(from_features.status))
    by_features = world_from_reference_ * from_features.cam2_from_cam1.inverse();
  auto found = sees ? find(*surface, predicted(time), by_features, in_color) : std::nullopt;
  if (!found && !by_features) {
    newest_is_reference_ = false;
    step = Step();
    step.matches = from_features.matches;
    step.status = sees ? Status::kLost : Status::kNoDepth;
    return step;
  }
  if (found && in_color && by_features) found = weighed(*found, from_features);
  const Pose world_from_cam = found ? found->world_from_cam : *by_features;
  if (found) {
    step.status = found->alignment.free_directions.empty() ? Status::kOk : Status::kLowParallax;
    step.cam2_from_cam1 = renewed(world_from_cam.inverse() * world_from_reference_);
    step.covariance = between(found->cam_from_base, reference_from_base()).covariance;
    for (const FreeDirection& direction : found->alignment.free_directions)
      step.free_directions.push_back(name_of(direction));
    step.overlap = found->alignment.overlap;
  }
  // Where nothing was found the features' step is followed, and what it is worth is not known.
  if (sees)
    refer_to(time, std::move(surface), world_from_cam,
             found ? found->cam_from_base.covariance
                   : Matrix6d::Constant(std::numeric_limits<double>::quiet_NaN()),
             found ? found->alignment.overlap : 0);
  newest_is_reference_ = sees;
  return step;
}

}  // namespace framewise
