// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Alignment and refinement against peers: lower-quartile microseconds of one call, rivals interleaved.
//   build/release/bench/bench_refine
#include <Eigen/Geometry>
#include <string>

#include "framewise/geometry/alignment.h"
#include "framewise/geometry/depth_noise.h"
#include "framewise/solvers/problems_for_tests.h"
#include "framewise/solvers/refine_absolute_pose.h"
#include "framewise/solvers/refine_input.h"
#include "framewise/solvers/refine_registration.h"
#include "framewise/solvers/refine_relative_pose.h"
#include "framewise/solvers/refine_rgbd_pair.h"
#include "framewise/solvers/refinement_for_tests.h"
#include "interleaved.h"

#ifdef FRAMEWISE_BENCH_OPENGV
#include <opengv/point_cloud/PointCloudAdapter.hpp>
#include <opengv/point_cloud/methods.hpp>
#endif

#ifdef FRAMEWISE_BENCH_POSELIB
#include <PoseLib/robust/bundle.h>
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

constexpr double kSigma = 1.0 / 525;

// One noisy pair of views and a start near its truth.
struct RefineProblem {
  Pose truth, initial;
  Points x1, x2, X1, X2, X1_exact;
  std::vector<double> z1, z2;
  std::vector<Eigen::Matrix3d> S1, S2;
};

RefineProblem make_refine_problem(testing::Scene scene, std::size_t size, testing::Random& random) {
  const testing::TwoViewProblem p = testing::make_problem(scene, size, random);
  RefineProblem r;
  r.truth = p.cam2_from_cam1;
  r.initial = testing::perturbed(r.truth, 0.005, 0.01 * r.truth.t.norm(), random);
  r.x1 = testing::noisy_rays(p.x1, ImageSurface::kPlane, kSigma, random);
  r.x2 = testing::noisy_rays(p.x2, ImageSurface::kPlane, kSigma, random);
  r.X1_exact = p.X1;
  const DepthNoise noise;
  for (std::size_t i = 0; i < size; ++i) {
    r.z1.push_back(p.X1[i].z() + noise.sigma(p.X1[i].z()) * random.normal());
    r.z2.push_back(p.X2[i].z() + noise.sigma(p.X2[i].z()) * random.normal());
    r.X1.push_back(point_at_depth(r.x1[i], r.z1[i]));
    r.X2.push_back(point_at_depth(r.x2[i], r.z2[i]));
    r.S1.push_back(point_covariance(r.x1[i], r.z1[i], kSigma, noise.sigma(r.z1[i])));
    r.S2.push_back(point_covariance(r.x2[i], r.z2[i], kSigma, noise.sigma(r.z2[i])));
  }
  return r;
}

// Mean error over the problems of one rival, so that speed is not bought with precision.
template <typename Refine>
void print_errors(const char* name, const std::vector<RefineProblem>& problems, const Refine& refine) {
  double rotation = 0, direction = 0, iterations = 0;
  for (std::size_t i = 0; i < problems.size(); ++i) {
    const auto [pose, steps] = refine(i);
    rotation += testing::rotation_error(pose.R, problems[i].truth.R);
    direction += testing::direction_error(pose.t, problems[i].truth.t);
    iterations += steps;
  }
  const double n = static_cast<double>(problems.size()), deg = 180 / M_PI;
  std::printf("  %-44s rotation %.4f deg, direction %.3f deg, %.1f iterations\n", name, rotation / n * deg,
              direction / n * deg, iterations / n);
}

#ifdef FRAMEWISE_BENCH_POSELIB
struct PoseLibInput {
  std::vector<poselib::Point2D> x1, x2;
  std::vector<poselib::Point3D> X1;
  poselib::CameraPose initial;
};

PoseLibInput for_poselib(const RefineProblem& p) {
  PoseLibInput in;
  for (std::size_t i = 0; i < p.x1.size(); ++i) {
    in.x1.push_back(p.x1[i].hnormalized());
    in.x2.push_back(p.x2[i].hnormalized());
    in.X1.push_back(p.X1_exact[i]);
  }
  in.initial = poselib::CameraPose(p.initial.R, p.initial.t);
  return in;
}

Pose pose_of(const poselib::CameraPose& pose) { return {pose.R(), pose.t}; }
#endif

void race_refinement(testing::Scene scene, std::size_t size) {
  testing::Random random(size);
  std::vector<RefineProblem> problems;
  for (std::size_t k = 0; k < kProblems; ++k) problems.push_back(make_refine_problem(scene, size, random));
  const auto relative = [&](std::size_t i, EpipolarResidual residual) {
    RefineOptions options;
    options.sigma = kSigma;
    return refine_relative_pose(problems[i].initial, problems[i].x1, problems[i].x2, options, residual);
  };
  const auto absolute = [&](std::size_t i) {
    RefineOptions options;
    options.sigma = kSigma;
    return refine_absolute_pose(problems[i].initial, problems[i].X1_exact, problems[i].x2, options);
  };
  const auto registration = [&](std::size_t i) {
    const RefineProblem& p = problems[i];
    return refine_registration(p.initial, p.X1, p.S1, p.X2, p.S2);
  };
  const auto rgbd = [&](std::size_t i) {
    const RefineProblem& p = problems[i];
    RefineOptions options;
    options.sigma = kSigma;
    return refine_rgbd_pair(p.initial, p.x1, p.z1, p.x2, p.z2, {}, options);
  };
  const auto sampson = [&](std::size_t i) { return relative(i, EpipolarResidual::kSampson); };
  const auto reprojection = [&](std::size_t i) { return relative(i, EpipolarResidual::kReprojection); };
  std::vector<Rival> rivals = {
      {"relative pose, Sampson", [&](std::size_t i) { return sampson(i).cost; }},
      {"relative pose, reprojection", [&](std::size_t i) { return reprojection(i).cost; }},
      {"absolute pose", [&](std::size_t i) { return absolute(i).cost; }},
      {"registration", [&](std::size_t i) { return registration(i).cost; }},
      {"RGB-D pair", [&](std::size_t i) { return rgbd(i).cost; }}};
#ifdef FRAMEWISE_BENCH_POSELIB
  std::vector<PoseLibInput> inputs;
  for (const auto& p : problems) inputs.push_back(for_poselib(p));
  poselib::BundleOptions bundle;
  bundle.loss_type = poselib::BundleOptions::LossType::TRIVIAL;
  poselib::BundleStats stats;
  const auto poselib_relative = [&](std::size_t i) {
    poselib::CameraPose pose = inputs[i].initial;
    stats = poselib::refine_relpose(inputs[i].x1, inputs[i].x2, &pose, bundle);
    return pose_of(pose);
  };
  const auto poselib_absolute = [&](std::size_t i) {
    poselib::CameraPose pose = inputs[i].initial;
    stats = poselib::bundle_adjust(inputs[i].x2, inputs[i].X1, &pose, bundle);
    return pose_of(pose);
  };
  rivals.push_back(
      {"PoseLib refine_relpose (Sampson)", [&](std::size_t i) { return poselib_relative(i).t.x(); }});
  rivals.push_back(
      {"PoseLib bundle_adjust (absolute)", [&](std::size_t i) { return poselib_absolute(i).t.x(); }});
#endif
  print_race("refinement, " + testing::name(scene) + ", N = " + std::to_string(size), rivals, kProblems,
             100000 / (100 + size * kProblems));
  const auto outcome = [](const Refinement& r) { return std::pair<Pose, int>(r.pose, r.iterations); };
  print_errors("relative pose, Sampson", problems, [&](std::size_t i) { return outcome(sampson(i)); });
  print_errors("relative pose, reprojection", problems,
               [&](std::size_t i) { return outcome(reprojection(i)); });
  print_errors("absolute pose", problems, [&](std::size_t i) { return outcome(absolute(i)); });
  print_errors("registration", problems, [&](std::size_t i) { return outcome(registration(i)); });
  print_errors("RGB-D pair", problems, [&](std::size_t i) { return outcome(rgbd(i)); });
#ifdef FRAMEWISE_BENCH_POSELIB
  const auto with_steps = [&](const Pose& pose) {
    return std::pair<Pose, int>(pose, static_cast<int>(stats.iterations));
  };
  print_errors("PoseLib refine_relpose", problems,
               [&](std::size_t i) { return with_steps(poselib_relative(i)); });
  print_errors("PoseLib bundle_adjust", problems,
               [&](std::size_t i) { return with_steps(poselib_absolute(i)); });
#endif
}

}  // namespace
}  // namespace framewise::bench

int main() {
  using framewise::testing::Scene;
  for (const std::size_t size : {3, 100, 1000}) framewise::bench::race_alignment(size);
  for (const Scene scene : {Scene::kRandom, Scene::kOdometry})
    for (const std::size_t size : {50, 200, 1000}) framewise::bench::race_refinement(scene, size);
}
