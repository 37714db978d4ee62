// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cassert>
#include <cstddef>

namespace framewise {

// What a minimal solver returns: none to N solutions, kept in place (no heap). Empty means "no solution".
template <typename T, std::size_t N>
class Hypotheses {
 public:
  static constexpr std::size_t capacity() { return N; }

  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  void clear() { size_ = 0; }
  void push_back(const T& value) {
    assert(size_ < N);
    values_[size_++] = value;
  }

  T& operator[](std::size_t i) { return values_[i]; }
  const T& operator[](std::size_t i) const { return values_[i]; }
  T* begin() { return values_.data(); }
  T* end() { return values_.data() + size_; }
  const T* begin() const { return values_.data(); }
  const T* end() const { return values_.data() + size_; }

 private:
  std::array<T, N> values_;
  std::size_t size_ = 0;
};

}  // namespace framewise
