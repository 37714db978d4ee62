// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "framewise/evaluation/association.h"
#include "framewise/geometry/alignment.h"

namespace framewise {

// How the estimate's world is brought onto the reference's before they are compared.
//   none:   not at all
//   se3:    rotation and translation, least squares over the positions (Umeyama, PAMI 1991)
//   sim3:   the same with a scale
//   scale:  the scale of sim3 alone, about the estimate's origin (evo's -s)
//   yaw:    translation and rotation about the world's z axis: for estimates that know gravity (z up)
//   origin: the first matched pose onto the reference's
enum class Alignment { kNone, kSe3, kSim3, kScale, kYaw, kOrigin };

// reference_from_estimate over the first `count` matched poses (0: all).
// A path that leaves the rotation free (a straight line, a camera that stood still) takes it from the
// orientations. Throws std::invalid_argument where sim3 or scale meet an estimate that never moved.
Similarity align(const TrajectoryPair& matched, Alignment alignment, std::size_t count = 0);

// Positions scaled, turned and moved; orientations turned.
Trajectory transformed(const Similarity& b_from_a, const Trajectory& in_a);

}  // namespace framewise
