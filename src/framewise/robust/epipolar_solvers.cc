// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/robust/epipolar_solvers.h"

#include "framewise/geometry/epipolar.h"
#include "framewise/robust/bearings.h"
#include "framewise/solvers/decompose_essential.h"
#include "framewise/solvers/essential_8pt.h"
#include "framewise/solvers/relrot_5pt_kneip.h"
#include "framewise/solvers/rotation_eigensolver.h"
#include "framewise/solvers/translation_2pt.h"
#include "framewise/solvers/translation_npt.h"

namespace framewise {
namespace {

struct Sink {
  InlierMeasure measure;
  std::span<const Bearing> x1, x2;
  EpipolarModels& models;

  void add(const EpipolarModel& model) const {
    if (models.size() < EpipolarModels::capacity()) models.push_back(model);
  }
  void add(const Pose& pose) const { add(EpipolarModel{essential_from_pose(pose), pose}); }
  void add(const Eigen::Matrix3d& E) const {
    switch (measure) {
      case InlierMeasure::kSampson:
        return add(EpipolarModel{E, {}});
      case InlierMeasure::kReprojection:
        if (const auto vote = choose_by_cheirality(E, x1, x2)) add(EpipolarModel{E, vote->cam2_from_cam1});
        return;
      case InlierMeasure::kBearingEuclidean: {
        const auto poses = decompose_essential(E);
        add(EpipolarModel{E, poses[0]});
        add(EpipolarModel{E, poses[2]});
        return;
      }
    }
  }
};

template <std::size_t N, typename Solve>
void with_sample(const RelativePoseOptions& options, std::span<const Bearing> x1, std::span<const Bearing> x2,
                 std::span<const std::uint32_t> sample, EpipolarModels& models, const Solve& solve) {
  const auto a = gather<N>(x1, sample), b = gather<N>(x2, sample);
  solve(a, b, Sink{options.measure, a, b, models});
}

}  // namespace

std::size_t epipolar_sample_size(RelativePoseSolver solver) {
  switch (solver) {
    case RelativePoseSolver::kEightPoint:
      return 8;
    case RelativePoseSolver::kSevenPoint:
      return 7;
    case RelativePoseSolver::kEigensolver:
      return 10;
    case RelativePoseSolver::kTwoPoint:
      return 2;
    case RelativePoseSolver::kNister5pt:
    case RelativePoseSolver::kStewenius5pt:
    case RelativePoseSolver::kKneip5ptRotation:
      break;
  }
  return 5;
}

void solve_epipolar(const RelativePoseOptions& options, std::span<const Bearing> x1,
                    std::span<const Bearing> x2, std::span<const std::uint32_t> sample,
                    EpipolarModels& models) {
  switch (options.solver) {
    case RelativePoseSolver::kSevenPoint:
    case RelativePoseSolver::kEightPoint:
      return with_sample<8>(options, x1, x2, sample, models,
                            [](const auto& a, const auto& b, const Sink& sink) {
                              if (const auto E = essential_8pt(a, b)) sink.add(*E);
                            });
    case RelativePoseSolver::kNister5pt:
    case RelativePoseSolver::kStewenius5pt:
    case RelativePoseSolver::kEigensolver:
      return with_sample<10>(options, x1, x2, sample, models,
                             [](const auto& a, const auto& b, const Sink& sink) {
                               if (const auto found = rotation_eigensolver(a, b))
                                 sink.add(Pose{found->R, found->t});
                             });
    case RelativePoseSolver::kKneip5ptRotation:
      return with_sample<5>(options, x1, x2, sample, models,
                            [](const auto& a, const auto& b, const Sink& sink) {
                              for (const Eigen::Matrix3d& R : relrot_5pt_kneip(a, b)) {
                                if (const auto t = translation_npt(a, b, R)) sink.add(Pose{R, *t});
                              }
                            });
    case RelativePoseSolver::kTwoPoint:
      return with_sample<2>(options, x1, x2, sample, models,
                            [&](const auto& a, const auto& b, const Sink& sink) {
                              if (const auto t = translation_2pt(a, b, *options.rotation)) {
                                sink.add(Pose{*options.rotation, *t});
                              }
                            });
  }
}

}  // namespace framewise
