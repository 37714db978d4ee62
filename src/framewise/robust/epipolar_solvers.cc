// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/robust/epipolar_solvers.h"

#include <array>
#include <type_traits>

#include "framewise/geometry/epipolar.h"
#include "framewise/robust/bearings.h"
#include "framewise/solvers/decompose_essential.h"
#include "framewise/solvers/essential_8pt.h"
#include "framewise/solvers/fundamental_7pt.h"
#include "framewise/solvers/relpose_5pt_nister.h"
#include "framewise/solvers/relpose_5pt_stewenius.h"
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

template <std::size_t N>
using Sample = std::array<Bearing, N>;

void eight_point(const Sample<8>& x1, const Sample<8>& x2, const Sink& sink) {
  if (const auto E = essential_8pt(x1, x2)) sink.add(*E);
}
void seven_point(const Sample<7>& x1, const Sample<7>& x2, const Sink& sink) {
  for (const Eigen::Matrix3d& F : fundamental_7pt(x1, x2)) sink.add(nearest_essential(F));
}
void nister(const Sample<5>& x1, const Sample<5>& x2, const Sink& sink) {
  for (const Eigen::Matrix3d& E : essential_5pt_nister(x1, x2)) sink.add(E);
}
void stewenius(const Sample<5>& x1, const Sample<5>& x2, const Sink& sink) {
  for (const Eigen::Matrix3d& E : essential_5pt_stewenius(x1, x2)) sink.add(E);
}
void kneip(const Sample<5>& x1, const Sample<5>& x2, const Sink& sink) {
  for (const Eigen::Matrix3d& R : relrot_5pt_kneip(x1, x2)) {
    if (const auto t = translation_npt(x1, x2, R)) sink.add(Pose{R, *t});
  }
}
void eigensolver(const Sample<10>& x1, const Sample<10>& x2, const Sink& sink) {
  if (const auto found = rotation_eigensolver(x1, x2)) sink.add(Pose{found->R, found->t});
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
  const auto with = [&]<std::size_t N>(const auto& solver, std::integral_constant<std::size_t, N>) {
    const Sample<N> a = gather<N>(x1, sample), b = gather<N>(x2, sample);
    solver(a, b, Sink{options.measure, a, b, models});
  };
  constexpr std::integral_constant<std::size_t, 2> two;
  constexpr std::integral_constant<std::size_t, 5> five;
  constexpr std::integral_constant<std::size_t, 7> seven;
  constexpr std::integral_constant<std::size_t, 8> eight;
  constexpr std::integral_constant<std::size_t, 10> ten;
  switch (options.solver) {
    case RelativePoseSolver::kEightPoint:
      return with(eight_point, eight);
    case RelativePoseSolver::kSevenPoint:
      return with(seven_point, seven);
    case RelativePoseSolver::kNister5pt:
      return with(nister, five);
    case RelativePoseSolver::kStewenius5pt:
      return with(stewenius, five);
    case RelativePoseSolver::kKneip5ptRotation:
      return with(kneip, five);
    case RelativePoseSolver::kEigensolver:
      return with(eigensolver, ten);
    case RelativePoseSolver::kTwoPoint:
      return with(
          [&](const Sample<2>& a, const Sample<2>& b, const Sink& sink) {
            const Eigen::Matrix3d& R = *options.rotation;
            if (const auto t = translation_2pt(a, b, R)) sink.add(Pose{R, *t});
          },
          two);
  }
}

}  // namespace framewise
