// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Solvers with few unknowns against their peers: time of a call (us, median of repeats) and failures, that is
// problems whose best solution is worse than 1e-4 rad, on noise-free seeded problems of two motion kinds.
//   bench_minimal [problems = 100000] [name filter]
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>
#include <string_view>
#include <vector>

#include "framewise/solvers/abspose_p3p.h"
#include "framewise/solvers/problems_for_tests.h"
#include "framewise/solvers/relpose_upright_3pt.h"
#include "framewise/solvers/relrot_5pt_kneip.h"
#include "framewise/solvers/rotation_2pt.h"
#include "framewise/solvers/rotation_eigensolver.h"
#include "framewise/solvers/rotation_npt.h"
#include "framewise/solvers/translation_2pt.h"
#include "framewise/solvers/translation_npt.h"

#ifdef FRAMEWISE_BENCH_OPENGV
#include <opengv/relative_pose/CentralRelativeAdapter.hpp>
#include <opengv/relative_pose/methods.hpp>
#endif
#ifdef FRAMEWISE_BENCH_POSELIB
#include <PoseLib/poselib.h>
#endif
#ifdef FRAMEWISE_BENCH_OPENCV
#include <opencv2/calib3d.hpp>
#endif

namespace {

using framewise::Bearing;
using framewise::Pose;
using framewise::testing::direction_error;
using framewise::testing::make_problem;
using framewise::testing::Random;
using framewise::testing::rotation_error;
using framewise::testing::Scene;

struct Problem {
  Pose truth;
  std::vector<Eigen::Vector3d> x1, x2, X1;
#ifdef FRAMEWISE_BENCH_OPENGV
  opengv::bearingVectors_t f1, f2;
#endif
};

std::vector<Problem> problems(Scene scene, std::size_t points, std::size_t count) {
  Random random(1 + static_cast<int>(scene));
  std::vector<Problem> all(count);
  for (Problem& problem : all) {
    auto p = make_problem(scene, points, random);
    problem.truth = p.cam2_from_cam1;
    problem.x1 = p.x1, problem.x2 = p.x2, problem.X1 = p.X1;
#ifdef FRAMEWISE_BENCH_OPENGV
    problem.f1.assign(p.x1.begin(), p.x1.end()), problem.f2.assign(p.x2.begin(), p.x2.end());
#endif
  }
  return all;
}

template <std::size_t N>
const std::array<Eigen::Vector3d, N>& first(const std::vector<Eigen::Vector3d>& x) {
  return *reinterpret_cast<const std::array<Eigen::Vector3d, N>*>(x.data());
}

std::size_t g_count = 100000;
std::string_view g_filter;
volatile double g_sink;

// Processor time of this thread: other programs on the machine count less than in wall time.
double thread_microseconds() {
  timespec t;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return 1e6 * static_cast<double>(t.tv_sec) + 1e-3 * static_cast<double>(t.tv_nsec);
}

// Prints time and failures of solve(problem), judged by error(solution, problem) (rad).
template <typename Solve, typename Error>
void row(const std::string& name, const char* kind, const std::vector<Problem>& all, Solve solve,
         Error error) {
  if (name.find(g_filter) == std::string::npos) return;
  std::size_t failures = 0;
  double worst = 0;
  for (const Problem& problem : all) {
    const double e = error(solve(problem), problem);
    failures += !(e < 1e-4);
    if (e < 1e-4) worst = std::max(worst, e);
  }
  const std::size_t batch = std::min<std::size_t>(all.size(), 2000);
  std::vector<double> times;
  for (int repeat = 0; repeat < 11; ++repeat) {
    const double start = thread_microseconds();
    for (std::size_t i = 0; i < batch; ++i) {
      auto solution = solve(all[i]);
      g_sink = *reinterpret_cast<const char*>(&solution);
    }
    times.push_back((thread_microseconds() - start) / batch);
  }
  std::sort(times.begin(), times.end());
  std::printf("%-34s %-10s %9.3f us (min %9.3f)  failures %7zu of %zu (%.3f %%)  worst success %.1e\n",
              name.c_str(), kind, times[times.size() / 2], times[0], failures, all.size(),
              100.0 * failures / all.size(), worst);
  std::fflush(stdout);
}

const auto translation_judge = [](const auto& t, const Problem& p) {
  return t ? direction_error(*t, p.truth.t) : M_PI;
};
const auto rotation_judge = [](const auto& R, const Problem& p) {
  return R ? rotation_error(*R, p.truth.R) : M_PI;
};
// Rotation and, relative to the point distances (about 5 m), translation.
const auto absolute_judge = [](const auto& poses, const Problem& p) {
  double best = M_PI;
  for (const auto& pose : poses)
    best = std::min(best, std::max(rotation_error(pose.R, p.truth.R), (pose.t - p.truth.t).norm() / 5));
  return best;
};

void translation(Scene scene, const char* kind) {
  for (const std::size_t n : {2, 10, 100}) {
    const auto all = problems(scene, n, n == 2 ? g_count : g_count / 10);
    if (n == 2) {
      row(
          "translation_2pt", kind, all,
          [](const Problem& p) {
            return framewise::translation_2pt(first<2>(p.x1), first<2>(p.x2), p.truth.R);
          },
          translation_judge);
#ifdef FRAMEWISE_BENCH_OPENGV
      row(
          "opengv twopt", kind, all,
          [](const Problem& p) {
            // OpenGV's R12 is cam1_from_cam2, and its answer the position of camera 2 in camera 1.
            opengv::relative_pose::CentralRelativeAdapter adapter(p.f1, p.f2, p.truth.R.transpose());
            const opengv::translation_t c = opengv::relative_pose::twopt(adapter, true);
            return std::optional<Eigen::Vector3d>(-(p.truth.R * c));
          },
          translation_judge);
#endif
    }
    row(
        "translation_npt " + std::to_string(n), kind, all,
        [](const Problem& p) { return framewise::translation_npt(p.x1, p.x2, p.truth.R); },
        translation_judge);
  }
}

void rotation() {
  const char* kind = "pure";
  for (const std::size_t n : {2, 10, 100, 1000}) {
    const auto all = problems(Scene::kPureRotation, n, n == 2 ? g_count : n == 1000 ? 1000 : g_count / 10);
    if (n == 2) {
      row(
          "rotation_2pt", kind, all,
          [](const Problem& p) { return framewise::rotation_2pt(first<2>(p.x1), first<2>(p.x2)); },
          rotation_judge);
#ifdef FRAMEWISE_BENCH_OPENGV
      row(
          "opengv twopt_rotationOnly", kind, all,
          [](const Problem& p) {
            opengv::relative_pose::CentralRelativeAdapter adapter(p.f1, p.f2);
            return std::optional<Eigen::Matrix3d>(
                opengv::relative_pose::twopt_rotationOnly(adapter).transpose());
          },
          rotation_judge);
#endif
    }
    row(
        "rotation_npt " + std::to_string(n), kind, all,
        [](const Problem& p) { return framewise::rotation_npt(p.x1, p.x2); }, rotation_judge);
#ifdef FRAMEWISE_BENCH_OPENGV
    row(
        "opengv rotationOnly " + std::to_string(n), kind, all,
        [](const Problem& p) {
          opengv::relative_pose::CentralRelativeAdapter adapter(p.f1, p.f2);
          return std::optional<Eigen::Matrix3d>(opengv::relative_pose::rotationOnly(adapter).transpose());
        },
        rotation_judge);
#endif
  }
}

void p3p(Scene scene, const char* kind) {
  const auto all = problems(scene, 3, g_count);
  row(
      "abspose_p3p", kind, all,
      [](const Problem& p) { return framewise::abspose_p3p(first<3>(p.x2), first<3>(p.X1)); },
      absolute_judge);
#ifdef FRAMEWISE_BENCH_POSELIB
  row(
      "poselib p3p", kind, all,
      [](const Problem& p) {
        thread_local std::vector<poselib::CameraPose> poses;
        poselib::p3p(p.x2, p.X1, &poses);
        return &poses;
      },
      [](const auto* poses, const Problem& p) {
        std::vector<Pose> converted;
        for (const auto& pose : *poses) converted.push_back({pose.R(), pose.t});
        return absolute_judge(converted, p);
      });
#endif
#ifdef FRAMEWISE_BENCH_OPENCV
  const std::vector<Problem> some(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(all.size() / 10));
  for (const auto& [name, flag] :
       {std::pair{"opencv solveP3P P3P", cv::SOLVEPNP_P3P}, {"opencv solveP3P AP3P", cv::SOLVEPNP_AP3P}})
    row(
        name, kind, some,
        [flag = flag](const Problem& p) {
          cv::Point3d X[3];
          cv::Point2d x[3];
          for (int i = 0; i < 3; ++i)
            X[i] = {p.X1[i][0], p.X1[i][1], p.X1[i][2]},
            x[i] = {p.x2[i][0] / p.x2[i][2], p.x2[i][1] / p.x2[i][2]};
          std::vector<cv::Mat> r, t;
          cv::solveP3P(cv::Mat(3, 1, CV_64FC3, X), cv::Mat(3, 1, CV_64FC2, x), cv::Mat::eye(3, 3, CV_64F),
                       cv::noArray(), r, t, flag);
          std::vector<Pose> poses;
          for (std::size_t i = 0; i < r.size(); ++i) {
            const double* phi = r[i].ptr<double>();
            const double* c = t[i].ptr<double>();
            poses.push_back({framewise::so3_exp({phi[0], phi[1], phi[2]}), {c[0], c[1], c[2]}});
          }
          return poses;
        },
        absolute_judge);
#endif
}

// Five bearings, rotations only.
void kneip(Scene scene, const char* kind) {
  const auto judge = [](const auto& rotations, const Problem& p) {
    double best = M_PI;
    for (const Eigen::Matrix3d& R : rotations) best = std::min(best, rotation_error(R, p.truth.R));
    return best;
  };
  const auto all = problems(scene, 5, g_count);
  row(
      "relrot_5pt_kneip", kind, all,
      [](const Problem& p) { return framewise::relrot_5pt_kneip(first<5>(p.x1), first<5>(p.x2)); }, judge);
#ifdef FRAMEWISE_BENCH_OPENGV
  const std::vector<Problem> some(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(all.size() / 10));
  row(
      "opengv fivept_kneip", kind, some,
      [](const Problem& p) {
        opengv::relative_pose::CentralRelativeAdapter adapter(p.f1, p.f2);
        std::vector<Eigen::Matrix3d> rotations;
        for (const auto& R : opengv::relative_pose::fivept_kneip(adapter, {0, 1, 2, 3, 4}))
          rotations.push_back(R.transpose());
        return rotations;
      },
      judge);
#endif
}

// Both start from the identity.
void eigensolver(Scene scene, const char* kind) {
  for (const std::size_t n : {10, 100}) {
    const auto judge = [](const auto& R, const Problem& p) {
      return R ? rotation_error(*R, p.truth.R) : M_PI;
    };
    const auto all = problems(scene, n, g_count / (n / 10));
    row(
        "rotation_eigensolver " + std::to_string(n), kind, all,
        [](const Problem& p) -> std::optional<Eigen::Matrix3d> {
          const auto s =
              framewise::rotation_eigensolver(p.x1, p.x2, Eigen::Matrix3d(Eigen::Matrix3d::Identity()));
          return s ? std::optional(s->R) : std::nullopt;
        },
        judge);
#ifdef FRAMEWISE_BENCH_OPENGV
    const std::vector<Problem> some(
        all.begin(), all.begin() + static_cast<std::ptrdiff_t>(std::min<std::size_t>(all.size(), 10000)));
    row(
        "opengv eigensolver " + std::to_string(n), kind, some,
        [](const Problem& p) {
          opengv::relative_pose::CentralRelativeAdapter adapter(p.f1, p.f2, opengv::rotation_t::Identity());
          return std::optional<Eigen::Matrix3d>(opengv::relative_pose::eigensolver(adapter).transpose());
        },
        judge);
#endif
  }
}

// The cameras' y axes turned onto gravity (its direction in camera 1: within 60 degrees of down).
void upright(Scene scene, const char* kind) {
  auto all = problems(scene, 3, g_count);
  Random random(9);
  for (Problem& p : all) {
    const Bearing gravity1 = (Bearing::UnitY() + 0.8 * random.direction()).normalized();
    const auto level = [](const Bearing& gravity) {
      return Eigen::Quaterniond::FromTwoVectors(gravity, Bearing::UnitY()).toRotationMatrix();
    };
    const Eigen::Matrix3d level1 = level(gravity1), level2 = level(p.truth.R * gravity1);
    for (int i = 0; i < 3; ++i) p.x1[i] = level1 * p.x1[i], p.x2[i] = level2 * p.x2[i];
    p.truth = {level2 * p.truth.R * level1.transpose(), level2 * p.truth.t};
  }
  const auto judge = [](const auto& poses, const Problem& p) {
    double best = M_PI;
    for (const auto& pose : poses)
      best = std::min(best, std::max(rotation_error(pose.R, p.truth.R), direction_error(pose.t, p.truth.t)));
    return best;
  };
  row(
      "relpose_upright_3pt", kind, all,
      [](const Problem& p) { return framewise::relpose_upright_3pt(first<3>(p.x1), first<3>(p.x2)); }, judge);
#ifdef FRAMEWISE_BENCH_POSELIB
  row(
      "poselib relpose_upright_3pt", kind, all,
      [](const Problem& p) {
        thread_local std::vector<poselib::CameraPose> poses;
        poses.clear();
        poselib::relpose_upright_3pt(p.x1, p.x2, &poses);
        return &poses;
      },
      [&](const auto* poses, const Problem& p) {
        std::vector<Pose> converted;
        for (const auto& pose : *poses) converted.push_back({pose.R(), pose.t});
        return judge(converted, p);
      });
#endif
}

}  // namespace

int main(int argc, char** argv) {
  if (argc > 1) g_count = std::strtoull(argv[1], nullptr, 10);
  if (argc > 2) g_filter = argv[2];
  const std::pair<Scene, const char*> kinds[] = {{Scene::kRandom, "wide"}, {Scene::kOdometry, "odometry"}};
  for (const auto& [scene, kind] : kinds) translation(scene, kind);
  rotation();
  for (const auto& [scene, kind] : kinds) p3p(scene, kind);
  for (const auto& [scene, kind] : kinds) upright(scene, kind);
  for (const auto& [scene, kind] : kinds) kneip(scene, kind);
  for (const auto& [scene, kind] : kinds) eigensolver(scene, kind);
}
