// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstring>

#include "framewise/image/chosen_at_run_time.h"

// Eight numbers that are worked on together, whatever the processor's registers hold: so every instruction
// set adds in the same order. For files compiled for several instruction sets only.
namespace framewise {

typedef float Floats __attribute__((vector_size(32)));
typedef int Ints __attribute__((vector_size(32)));

FRAMEWISE_INLINE Floats load(const float* from) {
  Floats lanes;
  std::memcpy(&lanes, from, sizeof lanes);
  return lanes;
}

FRAMEWISE_INLINE Ints load(const int* from) {
  Ints lanes;
  std::memcpy(&lanes, from, sizeof lanes);
  return lanes;
}

template <typename Lanes, typename T>
FRAMEWISE_INLINE void store(const Lanes& lanes, T* to) {
  std::memcpy(to, &lanes, sizeof lanes);
}

// x where the mask is set, else 0.
FRAMEWISE_INLINE Floats where(const Ints& mask, const Floats& x) { return (Floats)(mask & (Ints)x); }

FRAMEWISE_INLINE Floats square_root(const Floats& x) {
  Floats root;
  for (int k = 0; k < 8; ++k) root[k] = __builtin_sqrtf(x[k]);
  return root;
}

FRAMEWISE_INLINE Floats all(float x) { return Floats{} + x; }

FRAMEWISE_INLINE Floats least_of(const Floats& a, const Floats& b) { return a < b ? a : b; }
FRAMEWISE_INLINE Floats most_of(const Floats& a, const Floats& b) { return a > b ? a : b; }

FRAMEWISE_INLINE Floats counting_from(int first) {
  return Floats{0, 1, 2, 3, 4, 5, 6, 7} + static_cast<float>(first);
}

}  // namespace framewise
