// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "framewise/solvers/five_point_kernel.h"

namespace framewise::five_point::FRAMEWISE_ISA {

// A root z / w of a polynomial, max(|z|, |w|) = 1: roots at infinity are ordinary ones.
struct ProjectiveRoot {
  double z, w;
};

// The real roots of sum p[k] z^k w^(N - k), to about 1e-8: all that lie apart, and of two that nearly meet
// (or just missed each other in rounding) their common place. Both halves of the line, |z| <= w and |w| <= z,
// are cut into cells; by the theorem of Budan and Fourier a cell holds at most as many roots as its ends
// differ in the sign changes of p and all its derivatives, and as many modulo 2. Cells that may hold several
// are cut again.
template <int N>
class RealRoots {
 public:
  static constexpr int kMost = N + 2;

  FRAMEWISE_INLINE explicit RealRoots(const double (&p)[N + 1]) {
    for (int k = 0; k <= N; ++k) {
      half_[0][k] = p[k];
      half_[1][k] = p[N - k];
    }
    for (int half = 0; half < 2; ++half) search(half);
    refine();
  }

  FRAMEWISE_INLINE int size() const { return size_; }
  FRAMEWISE_INLINE ProjectiveRoot operator[](int i) const {
    return in_half_[i] == 0 ? ProjectiveRoot{x_[i], 1} : ProjectiveRoot{1, x_[i]};
  }

 private:
  static constexpr int kPoints = 16, kCells = kPoints - 1;
  static constexpr double kWidth = 2.0 / kCells;
  static constexpr double kNearlyMeet = 1e-5;
  static constexpr int kLanes = (kMost + 3) / 4 * 4, kWaiting = 24;

  // Taylor coefficients p^(k) / k! at four places.
  struct Jets {
    V4 c[N + 1];
  };
  FRAMEWISE_INLINE Jets jets(int half, const V4& x) const {
    Jets j;
    for (int k = 0; k <= N; ++k) j.c[k] = V4{} + half_[half][k];
#pragma GCC unroll 16
    for (int i = 0; i < N; ++i) {
#pragma GCC unroll 16
      for (int k = N - 1; k >= i; --k) j.c[k] += x * j.c[k + 1];
    }
    return j;
  }
  FRAMEWISE_INLINE static I4 sign_changes(const Jets& j) {
    I4 count{};
#pragma GCC unroll 16
    for (int k = 0; k < N; ++k) count -= (I4)(j.c[k] < 0) ^ (I4)(j.c[k + 1] < 0);
    return count;
  }
  // Within reach of each place: no root at all (-1 in the lane), no second root.
  FRAMEWISE_INLINE static void bounds(const Jets& j, double reach, I4& no_root, I4& no_second) {
    const auto magnitude = [](const V4& x) { return x < 0 ? -x : x; };
    V4 others = magnitude(j.c[N]), slopes = N * magnitude(j.c[N]);
#pragma GCC unroll 16
    for (int k = N - 1; k >= 2; --k) {
      others = others * reach + magnitude(j.c[k]);
      slopes = slopes * reach + k * magnitude(j.c[k]);
    }
    others = (others * reach + magnitude(j.c[1])) * reach;
    no_root = magnitude(j.c[0]) > others;
    no_second = magnitude(j.c[1]) > slopes * reach;
  }

  struct End {
    double x, f;
    std::int64_t changes;
  };

  FRAMEWISE_INLINE void search(int half) {
    End ends[kPoints];
#pragma GCC unroll 1
    for (int v = 0; v < kPoints; v += 4) {
      const double first = -1 + kWidth * v;
      store(half, V4{first, first + kWidth, first + 2 * kWidth, first + 3 * kWidth}, ends + v);
    }
#pragma GCC unroll 1
    for (int k = 0; k < kCells; ++k) {
      const std::int64_t most = ends[k].changes - ends[k + 1].changes;
      if (most == 1) add(half, ends[k], ends[k + 1]);
      if (most > 1) split(half, ends[k], ends[k + 1]);
    }
  }

  FRAMEWISE_INLINE Jets store(int half, const V4& x, End* ends) const {
    const Jets j = jets(half, x);
    const I4 changes = sign_changes(j);
    for (int lane = 0; lane < 4; ++lane) ends[lane] = {x[lane], j.c[0][lane], changes[lane]};
    return j;
  }

  // Cuts an interval that may hold several roots in five, until each part holds one, or none, or is so short
  // that its roots nearly meet.
  FRAMEWISE_INLINE void split(int half, const End& from, const End& to) {
    struct Interval {
      End left, right;
    } waiting[kWaiting];
    int count = 0;
    waiting[count++] = {from, to};
    while (count > 0) {
      const Interval whole = waiting[--count];
      const double width = (whole.right.x - whole.left.x) / 5;
      const double x = whole.left.x;
      End ends[6];
      const Jets j = store(half, V4{x + width, x + 2 * width, x + 3 * width, x + 4 * width}, ends + 1);
      ends[0] = whole.left;
      ends[5] = whole.right;
      I4 no_root, no_second;  // in the cell to the left of the place and in that to its right
      bounds(j, width, no_root, no_second);
      for (int k = 0; k < 5; ++k) {
        const std::int64_t most = ends[k].changes - ends[k + 1].changes;
        const bool crosses = (ends[k].f < 0) != (ends[k + 1].f < 0);
        const int by_left = k - 1, by_right = k;
        const bool none = (k > 0 && no_root[by_left & 3]) || (k < 4 && no_root[by_right & 3]);
        const bool single = (k > 0 && no_second[by_left & 3]) || (k < 4 && no_second[by_right & 3]);
        if (most <= 0 || none) continue;
        if (crosses && (most == 1 || single)) {
          add(half, ends[k], ends[k + 1]);
        } else if (crosses || !single) {
          if (width > kNearlyMeet && count < kWaiting) {
            waiting[count++] = {ends[k], ends[k + 1]};
          } else {
            add(half, ends[k], ends[k + 1]);
          }
        }
      }
    }
  }

  FRAMEWISE_INLINE void add(int half, const End& lo, const End& hi) {
    if (size_ == kMost) return;
    for (int k = 0; k <= N; ++k) coefficient_[k][size_] = half_[half][k];
    in_half_[size_] = half;
    lo_[size_] = lo.x;
    hi_[size_] = hi.x;
    sign_[size_] = lo.f < 0 ? -1 : 1;
    const bool crosses = (lo.f < 0) != (hi.f < 0);
    x_[size_] = lo.x + (hi.x - lo.x) * (crosses ? lo.f / (lo.f - hi.f) : 0.5);
    ++size_;
  }

  // Newton's method on all brackets at once; where it leaves its bracket, the middle.
  FRAMEWISE_INLINE void refine() {
#pragma GCC unroll 1
    for (int v = 0; v < size_; v += 4) {
      V4 &x = *reinterpret_cast<V4*>(x_ + v), lo = *reinterpret_cast<V4*>(lo_ + v),
         hi = *reinterpret_cast<V4*>(hi_ + v), sign = *reinterpret_cast<V4*>(sign_ + v);
#pragma GCC unroll 1
      for (int step = 0; step < 12; ++step) {
        V4 f = *reinterpret_cast<const V4*>(coefficient_[N] + v), slope{};
#pragma GCC unroll 16
        for (int k = N - 1; k >= 0; --k) {
          slope = slope * x + f;
          f = f * x + *reinterpret_cast<const V4*>(coefficient_[k] + v);
        }
        const I4 left = f * sign > 0;  // the root lies to the right of x
        lo = left ? x : lo;
        hi = left ? hi : x;
        const V4 newton = x - f / slope, middle = 0.5 * (lo + hi);
        const V4 next = ((newton >= lo) & (newton <= hi)) ? newton : middle;
        const V4 change = next - x;
        x = next;
        const I4 far = (change > 1e-5) | (change < -1e-5);  // one more step would give 1e-10
        if ((far[0] | far[1] | far[2] | far[3]) == 0) break;
      }
    }
  }

  double half_[2][N + 1];
  alignas(32) double coefficient_[N + 1][kLanes] = {};
  alignas(32) double x_[kLanes] = {}, lo_[kLanes] = {}, hi_[kLanes] = {}, sign_[kLanes] = {};
  int in_half_[kLanes];
  int size_ = 0;
};

}  // namespace framewise::five_point::FRAMEWISE_ISA
