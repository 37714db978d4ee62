// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "framewise/evaluation/pose_convention.h"
#include "framewise/image/edge_alignment.h"
#include "framewise/io/dataset.h"

namespace framewise::apps {

// What the depth of some frames, spread evenly over a recording, amounts to.
struct DepthSummary {
  static constexpr std::array<double, 7> kShares = {0.01, 0.05, 0.25, 0.5, 0.75, 0.95, 0.99};

  std::size_t images = 0;
  double unknown = 0;                              // share of the pixels
  std::array<double, kShares.size()> quantiles{};  // m, at kShares; NaN where nothing is known

  double median() const { return quantiles[3]; }
};

struct ImageEvidence {
  int width = 0, height = 0;  // as decoded; of depth where there is no colour
  std::optional<DepthSummary> depth;
  std::optional<EdgeFit> edges;         // where frames have colour and depth with edges
  std::vector<ObservedMotion> motions;  // between frames whose truth is known
  // Of those with depth: how far the step goes by depth along the true one, over how long that is.
  std::vector<double> length_ratios;
};

// Decodes some tens of frames, however long the recording is. Throws InputError where one cannot be read.
ImageEvidence sample_images(const Dataset& dataset, double max_truth_gap, std::uint64_t seed);

}  // namespace framewise::apps
