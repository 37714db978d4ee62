// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>

#include "framewise/geometry/pose.h"
#include "framewise/robust/relative_pose.h"
#include "framewise/solvers/hypotheses.h"

namespace framewise {

// A hypothesis about two views: its essential matrix, and the pose where one is needed to judge it. Sampson's
// distance is the same for the four poses of E, so that none is chosen before the end.
struct EpipolarModel {
  Eigen::Matrix3d E = Eigen::Matrix3d::Zero();
  Pose pose;
};
using EpipolarModels = Hypotheses<EpipolarModel, 20>;

// How many correspondences a solver takes.
std::size_t epipolar_sample_size(RelativePoseSolver solver);

// The solver's answers for a sample of unit bearings, with the pose that `measure` needs: for kReprojection
// the one with most of the sample in front of both cameras, for kBearingEuclidean each rotation.
void solve_epipolar(const RelativePoseOptions& options, std::span<const Bearing> x1,
                    std::span<const Bearing> x2, std::span<const std::uint32_t> sample,
                    EpipolarModels& models);

}  // namespace framewise
