// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

namespace framewise {

// Numbers of many points, one column for each number, so that several points fill one SIMD register.
// Rows are filled up with zeros to a multiple of kLanes. Memory is kept from one fill to the next.
// No Eigen here: the kernels that read it are compiled for several instruction sets.
class PointColumns {
 public:
  static constexpr std::size_t kLanes = 4;

  // All zero, `rows` by `width`; column 0 is 1 for each row that holds a point.
  void reset(std::size_t rows, std::size_t width) {
    rows_ = rows;
    padded_ = (rows + kLanes - 1) / kLanes * kLanes;
    values_.assign(padded_ * width, 0.0);
    for (std::size_t i = 0; i < rows; ++i) values_[i] = 1;
  }
  std::size_t rows() const { return rows_; }
  std::size_t padded_rows() const { return padded_; }
  double* column(std::size_t i) { return values_.data() + i * padded_; }
  const double* column(std::size_t i) const { return values_.data() + i * padded_; }
  void set3(std::size_t row, std::size_t first_column, double a, double b, double c) {
    column(first_column)[row] = a;
    column(first_column + 1)[row] = b;
    column(first_column + 2)[row] = c;
  }

 private:
  std::size_t rows_ = 0, padded_ = 0;
  std::vector<double> values_;
};

}  // namespace framewise
