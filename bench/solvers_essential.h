// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "framewise/solvers/decompose_essential.h"
#include "framewise/solvers/essential_8pt.h"
#include "framewise/solvers/fundamental_7pt.h"
#include "framewise/solvers/relpose_5pt_nister.h"
#include "framewise/solvers/relpose_5pt_stewenius.h"
#include "solver_bench.h"

#ifdef FRAMEWISE_BENCH_POSELIB
#include <PoseLib/poselib.h>
#endif
#ifdef FRAMEWISE_BENCH_OPENGV
#include <opengv/relative_pose/CentralRelativeAdapter.hpp>
#include <opengv/relative_pose/methods.hpp>
#endif
#ifdef FRAMEWISE_BENCH_OPENCV
#include <opencv2/calib3d.hpp>
#endif

namespace framewise::bench {

template <std::size_t N>
struct BearingPairs {
  std::array<Bearing, N> x1, x2;
};

template <std::size_t N>
BearingPairs<N> pairs(const TwoViewProblem& problem) {
  BearingPairs<N> result;
  std::copy_n(problem.x1.begin(), N, result.x1.begin());
  std::copy_n(problem.x2.begin(), N, result.x2.begin());
  return result;
}

// Rotation error of the best of all motions of all matrices, or of all poses.
inline constexpr auto judge_matrices = [](const auto& matrices, const TwoViewProblem& problem) {
  double best = M_PI;
  for (const Eigen::Matrix3d& E : matrices) {
    if (!E.allFinite()) continue;
    for (const Pose& pose : decompose_essential(E)) {
      best = std::min(best, testing::rotation_error(pose.R, problem.cam2_from_cam1.R));
    }
  }
  return best;
};
inline constexpr auto judge_poses = [](const auto& poses, const TwoViewProblem& problem) {
  double best = M_PI;
  for (const auto& pose : poses) {
    best = std::min(best, testing::rotation_error(pose.R, problem.cam2_from_cam1.R));
  }
  return best;
};

inline void register_framewise_essential(Registry& registry) {
  registry.add(
      "5pt, matrices", "Framewise Nister", 5, pairs<5>,
      [](const auto& p) { return essential_5pt_nister(p.x1, p.x2); }, judge_matrices);
  registry.add(
      "5pt, matrices", "Framewise Stewenius", 5, pairs<5>,
      [](const auto& p) { return essential_5pt_stewenius(p.x1, p.x2); }, judge_matrices);
  registry.add(
      "5pt, poses", "Framewise Nister", 5, pairs<5>,
      [](const auto& p) { return relpose_5pt_nister(p.x1, p.x2); }, judge_poses);
  registry.add(
      "5pt, poses", "Framewise Stewenius", 5, pairs<5>,
      [](const auto& p) { return relpose_5pt_stewenius(p.x1, p.x2); }, judge_poses);
  registry.add(
      "7pt, matrices", "Framewise", 7, pairs<7>, [](const auto& p) { return fundamental_7pt(p.x1, p.x2); },
      judge_matrices);
  for (const std::size_t n : {8u, 100u}) {
    registry.add(
        "8pt N=" + std::to_string(n) + ", matrix", "Framewise", n,
        [](const TwoViewProblem& problem) { return problem; },
        [](const TwoViewProblem& p) { return std::array{essential_8pt(p.x1, p.x2).value()}; },
        judge_matrices);
  }
}

#ifdef FRAMEWISE_BENCH_POSELIB
inline void register_poselib_essential(Registry& registry) {
  const auto prepare = [](const TwoViewProblem& problem) { return problem; };
  registry.add(
      "5pt, matrices", "PoseLib", 5, prepare,
      [](const TwoViewProblem& p) {
        std::vector<Eigen::Matrix3d> E;
        poselib::relpose_5pt(p.x1, p.x2, &E);
        return E;
      },
      judge_matrices);
  registry.add(
      "5pt, poses", "PoseLib", 5, prepare,
      [](const TwoViewProblem& p) {
        poselib::CameraPoseVector poses;
        poselib::relpose_5pt(p.x1, p.x2, &poses);
        return poses;
      },
      [](const poselib::CameraPoseVector& poses, const TwoViewProblem& problem) {
        double best = M_PI;
        for (const auto& pose : poses) {
          best = std::min(best, testing::rotation_error(pose.R(), problem.cam2_from_cam1.R));
        }
        return best;
      });
  registry.add(
      "7pt, matrices", "PoseLib", 7, prepare,
      [](const TwoViewProblem& p) {
        std::vector<Eigen::Matrix3d> F;
        poselib::relpose_7pt(p.x1, p.x2, &F);
        return F;
      },
      judge_matrices);
  for (const std::size_t n : {8u, 100u}) {
    registry.add(
        "8pt N=" + std::to_string(n) + ", matrix", "PoseLib", n, prepare,
        [](const TwoViewProblem& p) {
          Eigen::Matrix3d E;
          poselib::essential_matrix_8pt(p.x1, p.x2, &E);
          return std::array{E};
        },
        judge_matrices);
  }
}
#endif

#ifdef FRAMEWISE_BENCH_OPENGV
struct OpenGvInput {
  opengv::bearingVectors_t f1, f2;
};
// OpenGV's matrices take view 2 to view 1: ours, transposed.
inline constexpr auto judge_opengv = [](const auto& matrices, const TwoViewProblem& problem) {
  std::vector<Eigen::Matrix3d> ours;
  for (const auto& E : matrices) {
    if (E.imag().norm() <= 1e-6 * E.norm()) ours.push_back(E.real().transpose());
  }
  return judge_matrices(ours, problem);
};
inline void register_opengv_essential(Registry& registry) {
  const auto prepare = [](const TwoViewProblem& problem) {
    return OpenGvInput{{problem.x1.begin(), problem.x1.end()}, {problem.x2.begin(), problem.x2.end()}};
  };
  const auto add = [&](const std::string& task, const std::string& who, std::size_t points, auto solve) {
    registry.add(
        task, who, points, prepare,
        [solve](const OpenGvInput& input) {
          opengv::relative_pose::CentralRelativeAdapter adapter(input.f1, input.f2);
          return solve(adapter);
        },
        judge_opengv);
  };
  namespace solvers = opengv::relative_pose;
  add("5pt, matrices", "OpenGV Nister", 5, [](auto& adapter) { return solvers::fivept_nister(adapter); });
  add("5pt, matrices", "OpenGV Stewenius", 5,
      [](auto& adapter) { return solvers::fivept_stewenius(adapter); });
  add("7pt, matrices", "OpenGV", 7, [](auto& adapter) { return solvers::sevenpt(adapter); });
  for (const std::size_t n : {8u, 100u}) {
    add("8pt N=" + std::to_string(n) + ", matrix", "OpenGV", n,
        [](auto& adapter) { return std::array{solvers::eightpt(adapter)}; });
  }
}
#endif

#ifdef FRAMEWISE_BENCH_OPENCV
struct OpenCvInput {
  std::vector<cv::Point2d> x1, x2;
};
inline std::vector<Eigen::Matrix3d> stacked_matrices(const cv::Mat& stacked) {
  std::vector<Eigen::Matrix3d> matrices(stacked.rows / 3);
  for (std::size_t m = 0; m < matrices.size(); ++m) {
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) matrices[m](i, j) = stacked.at<double>(static_cast<int>(3 * m) + i, j);
    }
  }
  return matrices;
}
inline void register_opencv_essential(Registry& registry) {
  const auto prepare = [](const TwoViewProblem& problem) {
    OpenCvInput input;
    for (const Bearing& x : problem.x1) input.x1.emplace_back(x.x() / x.z(), x.y() / x.z());
    for (const Bearing& x : problem.x2) input.x2.emplace_back(x.x() / x.z(), x.y() / x.z());
    return input;
  };
  registry.add(
      "5pt, matrices", "OpenCV", 5, prepare,
      [](const OpenCvInput& input) {
        return stacked_matrices(cv::findEssentialMat(input.x1, input.x2, 1.0, {0, 0}));
      },
      judge_matrices);
  registry.add(
      "7pt, matrices", "OpenCV", 7, prepare,
      [](const OpenCvInput& input) {
        return stacked_matrices(cv::findFundamentalMat(input.x1, input.x2, cv::FM_7POINT));
      },
      judge_matrices);
  for (const std::size_t n : {8u, 100u}) {
    registry.add(
        "8pt N=" + std::to_string(n) + ", matrix", "OpenCV", n, prepare,
        [](const OpenCvInput& input) {
          return stacked_matrices(cv::findFundamentalMat(input.x1, input.x2, cv::FM_8POINT));
        },
        judge_matrices);
  }
}
#endif

inline void register_essential(Registry& registry) {
  register_framewise_essential(registry);
#ifdef FRAMEWISE_BENCH_POSELIB
  register_poselib_essential(registry);
#endif
#ifdef FRAMEWISE_BENCH_OPENGV
  register_opengv_essential(registry);
#endif
#ifdef FRAMEWISE_BENCH_OPENCV
  register_opencv_essential(registry);
#endif
}

}  // namespace framewise::bench
