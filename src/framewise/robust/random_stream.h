// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>

namespace framewise {

// A stream of random numbers from one seed, the same on every platform and compiler.
//   SplitMix64: Steele, Lea, Flood, Fast Splittable Pseudorandom Number Generators, OOPSLA 2014.
class RandomStream {
 public:
  explicit RandomStream(std::uint64_t seed) : state_(seed) {}

  std::uint64_t next() {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }

  // Uniform in [0, size), size < 2^32. The multiplication favours no index by more than size / 2^32.
  std::uint32_t index(std::size_t size) {
    return static_cast<std::uint32_t>(((next() >> 32) * static_cast<std::uint64_t>(size)) >> 32);
  }

 private:
  std::uint64_t state_;
};

}  // namespace framewise
