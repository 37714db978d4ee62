// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What judging a hypothesis costs for each correspondence, in full, without giving up early.
//   build/release/bench/bench_scoring [correspondences, default 2000]
#include "framewise/robust/scoring.h"

#include <cstdio>
#include <cstdlib>

#include "framewise/geometry/epipolar.h"
#include "interleaved.h"
#include "robust_problems.h"

#ifdef FRAMEWISE_BENCH_POSELIB
#include <PoseLib/robust/utils.h>
#endif

namespace framewise::bench {
namespace {

using RowMajor = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

Columns columns_of(const RobustProblem& p, std::size_t width) {
  Columns columns(p.x1.size(), width, 1);
  for (std::size_t i = 0; i < p.x1.size(); ++i) {
    const Eigen::Vector2d a = p.x1[i].hnormalized(), b = p.x2[i].hnormalized();
    const double plane[] = {a.x(), a.y(), b.x(), b.y()};
    const double rays[] = {p.x1[i].x(), p.x1[i].y(), p.x1[i].z(), p.x2[i].x(), p.x2[i].y(), p.x2[i].z()};
    for (std::size_t k = 0; k < width; ++k) columns.set(i, k, width == 4 ? plane[k] : rays[k]);
  }
  return columns;
}

void race(std::size_t size) {
  testing::Random random(1);
  const RobustProblem p = make_robust_problem({testing::Scene::kRandom, size, 0.5, 1.0}, random);
  const Columns plane = columns_of(p, 4), rays = columns_of(p, 6);
  const RowMajor E = essential_from_pose(p.cam2_from_cam1), R = p.cam2_from_cam1.R;
  const Eigen::Vector3d t = p.cam2_from_cam1.t;

  std::vector<Rival> rivals;
  const auto add = [&](const char* name, Scoring scoring, auto score) {
    Judge judge;
    judge.max_error = 2.0 / kFocal;
    judge.scoring = scoring;
    rivals.push_back({name, [judge, score](std::size_t) { return score(judge).cost; }});
  };
  const auto sampson = [&](const Judge& j) { return score_sampson_plane(plane, E.data(), j); };
  add("Sampson, image plane, MSAC", Scoring::kMsac, sampson);
  add("Sampson, image plane, inlier count", Scoring::kInlierCount, sampson);
  add("Sampson, image plane, marginalised", Scoring::kMarginalised, sampson);
  add("Sampson, sphere, MSAC", Scoring::kMsac,
      [&](const Judge& j) { return score_sampson_sphere(rays, E.data(), j); });
  add("reprojection of the midpoint, MSAC", Scoring::kMsac,
      [&](const Judge& j) { return score_triangulated(rays, R.data(), t.data(), j); });
  add("distance of points, MSAC", Scoring::kMsac,
      [&](const Judge& j) { return score_distance(rays, R.data(), t.data(), j); });
#ifdef FRAMEWISE_BENCH_POSELIB
  std::vector<poselib::Point2D> a, b;
  for (std::size_t i = 0; i < size; ++i) {
    a.push_back(p.x1[i].hnormalized());
    b.push_back(p.x2[i].hnormalized());
  }
  const Eigen::Quaterniond q(p.cam2_from_cam1.R);
  const poselib::CameraPose pose(Eigen::Vector4d(q.w(), q.x(), q.y(), q.z()), t);
  rivals.push_back({"PoseLib Sampson MSAC", [&](std::size_t) {
                      std::size_t inliers = 0;
                      const double limit = 4.0 / (kFocal * kFocal);
                      return poselib::compute_sampson_msac_score(pose, a, b, limit, &inliers);
                    }});
#endif
  std::printf("%zu correspondences\n", size);
  const std::vector<double> us = lower_quartile_us(rivals, 200, 40);
  for (std::size_t k = 0; k < rivals.size(); ++k)
    std::printf("  %-40s %7.3f ns a point\n", rivals[k].name.c_str(), 1000 * us[k] / size);
}

}  // namespace
}  // namespace framewise::bench

int main(int argc, char** argv) {
  framewise::bench::race(argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 2000);
}
