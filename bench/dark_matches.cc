// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
//
// How often matches between neighbouring depth images are right: those within 3 pixels of where the depth of
// their first pixel and the motion put them, of all whose first pixel has depth. For every input made of
// depth, every feature, brute force and windowed. The motion is the true one, and the same after the two
// surfaces were aligned from there: motion capture is off by several pixels between neighbours of a fast
// turn.
//   bench_dark_matches RECORDING [every how many-th pair, default 3]
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string>
#include <vector>

#include "framewise/geometry/trajectory.h"
#include "framewise/io/dataset.h"
#include "framewise/odometry/correspond.h"
#include "framewise/registration/align_surfaces.h"
#include "framewise/registration/surface_pyramid.h"

namespace {

using namespace framewise;

constexpr double kRightPx = 3;

// Two neighbouring frames and the motion between their depth images.
struct Pair {
  Frame frame1, frame2;
  Pose true_motion, aligned_motion;  // cam2_from_cam1
};

// The truth where the depth image was taken, which is not when colour was: a fast turn moves by 10 pixels in
// between.
std::optional<Pose> true_pose(const Dataset& dataset, std::size_t i) {
  return pose_at(dataset.truth, dataset.frames[i].time + dataset.frames[i].depth_delay, 0.1);
}

std::vector<Pair> pairs_of(const Dataset& dataset, std::size_t every) {
  SurfaceMaker surface_of(dataset.calibration.camera, {});
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i + 1 < dataset.frames.size(); i += every) {
    const auto world_from_cam1 = true_pose(dataset, i), world_from_cam2 = true_pose(dataset, i + 1);
    if (!world_from_cam1 || !world_from_cam2) continue;
    Pair pair{load_frame(dataset, i),
              load_frame(dataset, i + 1),
              world_from_cam2->inverse() * *world_from_cam1,
              {}};
    const SurfacePyramid surface1 = surface_of(pair.frame1.depth), surface2 = surface_of(pair.frame2.depth);
    const auto aligned = align_surfaces(surface1, surface2, pair.true_motion, {});
    if (!aligned) continue;
    pair.aligned_motion = aligned->cam2_from_cam1;
    pairs.push_back(std::move(pair));
  }
  return pairs;
}

struct Count {
  long judged = 0, right = 0, right_aligned = 0, matches = 0;

  void add(const Correspondences& shared, const Pair& pair, const Camera& camera) {
    matches += static_cast<long>(shared.x1.size());
    for (std::size_t k = 0; k < shared.x1.size(); ++k) {
      if (!(shared.z1[k] > 0)) continue;
      ++judged;
      const Eigen::Vector3d x_in_cam1 = shared.z1[k] / shared.x1[k].z() * shared.x1[k];
      const auto is_right = [&](const Pose& cam2_from_cam1) {
        const auto there = camera.project(cam2_from_cam1 * x_in_cam1);
        return there && (*there - shared.pixels2[k]).norm() < kRightPx;
      };
      right += is_right(pair.true_motion);
      right_aligned += is_right(pair.aligned_motion);
    }
  }
};

void print_row(const std::vector<Pair>& pairs, const Camera& camera, const std::string& input,
               const std::string& feature) {
  OdometryOptions options;
  options.input = input;
  options.features.detector = options.features.descriptor = feature;
  Count brute_force, windowed;
  for (const Pair& pair : pairs) {
    const Observation first = observe(pair.frame1, camera, options);
    const Observation second = observe(pair.frame2, camera, options);
    options.matcher = "brute-force";
    brute_force.add(correspond(first, second, camera, options), pair, camera);
    options.matcher = "windowed";
    windowed.add(correspond(first, second, camera, options), pair, camera);
  }
  std::printf("| %s | %s |", input.c_str(), feature.c_str());
  for (const Count& count : {brute_force, windowed})
    std::printf(" %.0f, %.0f of %ld |", 100.0 * count.right / std::max(1L, count.judged),
                100.0 * count.right_aligned / std::max(1L, count.judged),
                count.matches / std::max(1L, static_cast<long>(pairs.size())));
  std::printf("\n");
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2 || argc > 3) {
    std::fprintf(stderr, "usage: bench_dark_matches RECORDING [every how many-th pair]\n");
    return 2;
  }
  const Dataset dataset = open_dataset(argv[1], {});
  const auto pairs = pairs_of(dataset, argc == 3 ? std::max(1, std::atoi(argv[2])) : 3);
  std::printf(
      "%s, %zu pairs\n\n| input | feature | brute force: %%, %% aligned, of so many a pair | windowed |\n",
      dataset.name.c_str(), pairs.size());
  std::printf("|---|---|---|---|\n");
  for (const char* input : {"depth-raw", "depth", "flexion-published", "flexion", "normal"})
    for (const char* feature : {"sift", "akaze", "orb"})
      print_row(pairs, dataset.calibration.camera, input, feature);
}
