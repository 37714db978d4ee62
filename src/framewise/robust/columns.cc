// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <numeric>
#include <utility>

#include "framewise/robust/random_stream.h"
#include "framewise/robust/scoring.h"

namespace framewise {

Columns::Columns(std::size_t rows, std::size_t width, std::uint64_t seed)
    : padded_((rows + kLanes - 1) / kLanes * kLanes),
      order_(rows),
      values_(padded_ * width, std::numeric_limits<float>::quiet_NaN()) {
  std::iota(order_.begin(), order_.end(), 0u);
  RandomStream random(seed);
  for (std::size_t i = rows; i > 1; --i) std::swap(order_[i - 1], order_[random.index(i)]);
}

}  // namespace framewise
