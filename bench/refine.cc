// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Alignment and refinement against peers: lower-quartile microseconds of one call, rivals interleaved.
//   build/release/bench/bench_refine
#include <Eigen/Geometry>
#include <string>

#include "framewise/geometry/alignment.h"
#include "framewise/solvers/problems_for_tests.h"
#include "interleaved.h"

#ifdef FRAMEWISE_BENCH_OPENGV
#include <opengv/point_cloud/PointCloudAdapter.hpp>
#include <opengv/point_cloud/methods.hpp>
#endif

namespace framewise::bench {
namespace {

using Points = std::vector<Eigen::Vector3d>;
constexpr std::size_t kProblems = 32;

void race_alignment(std::size_t size) {
  testing::Random random(size);
  std::vector<Points> X1(kProblems), X2(kProblems);
  std::vector<Eigen::Matrix3Xd> M1(kProblems), M2(kProblems);
  for (std::size_t k = 0; k < kProblems; ++k) {
    const Pose pose{so3_exp(random.uniform(0, M_PI) * random.direction()), random.normal3()};
    M1[k].resize(3, size), M2[k].resize(3, size);
    for (std::size_t i = 0; i < size; ++i) {
      X1[k].push_back(random.normal3());
      X2[k].push_back(pose * X1[k].back() + 0.01 * random.normal3());
      M1[k].col(i) = X1[k].back(), M2[k].col(i) = X2[k].back();
    }
  }
  std::vector<Rival> rivals = {
      {"framewise kabsch", [&](std::size_t i) { return kabsch(X1[i], X2[i])->t.x(); }},
      {"framewise umeyama", [&](std::size_t i) { return umeyama(X1[i], X2[i])->scale; }},
      {"Eigen::umeyama, no scale", [&](std::size_t i) { return Eigen::umeyama(M1[i], M2[i], false)(0, 3); }},
      {"Eigen::umeyama, scale", [&](std::size_t i) { return Eigen::umeyama(M1[i], M2[i], true)(0, 3); }}};
#ifdef FRAMEWISE_BENCH_OPENGV
  std::vector<opengv::points_t> P1, P2;
  for (std::size_t k = 0; k < kProblems; ++k)
    P1.emplace_back(X1[k].begin(), X1[k].end()), P2.emplace_back(X2[k].begin(), X2[k].end());
  rivals.push_back({"OpenGV threept_arun", [&](std::size_t i) {
                      opengv::point_cloud::PointCloudAdapter adapter(P1[i], P2[i]);
                      return opengv::point_cloud::threept_arun(adapter)(0, 3);
                    }});
#endif
  print_race("alignment of point clouds, N = " + std::to_string(size), rivals, kProblems,
             3000 / (1 + size / 30));
}

}  // namespace
}  // namespace framewise::bench

int main() {
  for (const std::size_t size : {3, 100, 1000}) framewise::bench::race_alignment(size);
}
