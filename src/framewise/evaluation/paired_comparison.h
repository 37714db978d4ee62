// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "framewise/evaluation/bootstrap.h"

namespace framewise {

struct PairedOptions {
  BootstrapOptions bootstrap;  // of the interval; its seed serves the flips as well
  int flips = 9999;            // random ones; where there are fewer different ones all are taken
  double significance = 0.05;  // of all comparisons of a group together
  void check() const;          // throws std::invalid_argument naming the value
};

// Whether one method's errors are larger than another's on the same frames.
struct PairedDifference {
  double median = 0;                 // of the frames' differences
  std::optional<Interval> interval;  // of that median (bootstrap_interval); unset for fewer than 6 frames
  double p = 1;                      // of a median this far from 0 where the methods are equal; two-sided
  double p_holm = 1;                 // corrected for all comparisons of the group
  bool is_real = false;              // p_holm is below the significance
  std::size_t frames = 0;
  std::size_t block_length = 1;  // of the flips
};

// p by sign flips: were the methods equal, each difference could as well have the other sign. Successive
// frames that depend on each other are flipped together, in blocks twice as long as the differences remember
// (dependence_length), since a flip cuts what crosses a block's end; but in twelve blocks at least, so that p
// is too small where they remember more than a twentieth of the recording. p counts the observed sign as one
// of the flips (Phipson and Smyth, Permutation P-values Should Never Be Zero, SAGMB 2010); sign-flip tests:
// Fisher, The Design of Experiments, 1935. Throws std::invalid_argument for no differences and for one that
// is not finite.
PairedDifference paired_difference(std::span<const double> differences, const PairedOptions& options = {});

// p values corrected for their number, in the order given: the chance of one false finding or more among them
// stays below the level that is asked for, however they depend on each other.
//   Holm, A Simple Sequentially Rejective Multiple Test Procedure, Scandinavian J. of Statistics 1979.
std::vector<double> holm(std::span<const double> p);

// Each method against the one that is best.
struct BestComparison {
  std::size_t best = 0;
  std::vector<std::optional<PairedDifference>> differences;  // error - best's; unset for the best itself
};

// errors[m][i]: of method m at frame i, all of one length; scores[m]: what ranks them, least is best, of
// equals the first. The best is chosen by the same frames that judge it: a difference to it is real for the
// recording at hand, not a ranking of the method for all recordings. Throws std::invalid_argument for none
// and for lengths that differ.
BestComparison compare_with_best(std::span<const std::vector<double>> errors, std::span<const double> scores,
                                 const PairedOptions& options = {});

}  // namespace framewise
