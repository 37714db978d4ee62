// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "framewise/registration/align_surfaces.h"
#include "framewise/registration/surface_pyramid.h"

namespace framewise {

struct SurfaceModelOptions {
  double least_overlap = 0.75;  // of a frame with the model; with less the frame begins a new one
  double most_turn_deg = 5;     // from the model's view, likewise
  double most_distance = 0.05;  // m a metre of depth, likewise
  double most_weight = 30;      // frames that a pixel remembers
  // Of those, at most, that a new model takes over from the old one. A real camera's depth errs by its place
  // in the image, so that what is handed on does not average out: 0.
  double inherited_weight = 0;
  double agreement = 0.03;  // a depth that differs by more (a share) is another surface
  int refit_every = 2;      // frames between two fits of the model's planes

  // Throws std::invalid_argument that names the value.
  void check() const;
};

// A surface seen from a keyframe, ever better known: every frame that is aligned with it adds its depths to
// the keyframe's pixels, along their rays, as a running mean.
//   Newcombe et al., KinectFusion: Real-time dense surface mapping and tracking, ISMAR 2011, Eq. (11)-(13),
//   on the image of a keyframe in place of a volume.
// When the view has moved on, the newest frame begins a new model, which takes over what the old one knows.
class SurfaceModel {
 public:
  // Throws std::invalid_argument for wrong options. The maker must outlive the model.
  SurfaceModel(const SurfaceMaker& maker, const AlignmentOptions& alignment,
               const SurfaceModelOptions& options);

  // The first frame; the world is its camera.
  void start(const SurfacePyramid& frame, const Pose& world_from_cam);
  bool is_started() const { return !surface_.empty(); }

  // Aligns a frame near a guess. In the answer camera 1 is the keyframe's.
  std::optional<SurfaceAlignment> align(const SurfacePyramid& frame, const Pose& world_from_cam_guess) const;

  // Adds an aligned frame; overlap as the alignment found it.
  void add(const SurfacePyramid& frame, const Pose& world_from_cam, double overlap);

  const Pose& world_from_keyframe() const { return world_from_keyframe_; }
  std::size_t keyframes() const { return keyframes_; }

 private:
  bool has_moved_on(const Pose& keyframe_from_cam, double overlap) const;
  void fuse(const Surface& frame, const Pose& keyframe_from_cam, const std::vector<float>* weights);

  const SurfaceMaker* maker_;
  AlignmentOptions alignment_;
  SurfaceModelOptions options_;
  SurfacePyramid surface_;
  std::vector<float> inverse_depth_, weight_;  // of the keyframe's pixels
  Pose world_from_keyframe_;
  std::size_t keyframes_ = 0;
  int frames_since_fit_ = 0;
};

}  // namespace framewise
