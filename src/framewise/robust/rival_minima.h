// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "framewise/robust/consensus.h"

namespace framewise {

// The best of the minima that a consensus has around it, and whether another fits about as well.
struct Settled {
  Consensus consensus;
  bool ambiguous = false;
};

// Small motions and planes have several motions that fit all points. Descends from the two motions of the
// plane nearest to the members and from the best rotation with each principal direction of translation, and
// takes what fits best among those with the points in front of both cameras. Ambiguous: a motion more than 10
// deg away fits as well. The two are not nested, so that the difference of their costs over n points has a
// standard deviation near 2 sqrt(n) when both are right, and three times that is the limit.
Settled settle_minimum(const TwoViews& views, const Consensus& consensus, double max_error);

}  // namespace framewise
