// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace framewise {

// One line of a table in text, its fields still text, with its place in the file.
struct NumberRow {
  std::size_t line = 0;  // from 1
  std::vector<std::string_view> fields;
  bool commas = false;  // separated by commas
};

// The lines of a text file that say something. '#' begins a comment; blanks, tabs, commas, semicolons, and
// line ends of any system separate.
class NumberRows {
 public:
  // Throws InputError, which says that `expected` was, where there is no such file or it cannot be read.
  NumberRows(const std::filesystem::path& path, const std::string& expected);
  NumberRows(const NumberRows&) = delete;  // the rows point into the text
  NumberRows& operator=(const NumberRows&) = delete;

  const std::filesystem::path& path() const { return path_; }
  std::size_t size() const { return rows_.size(); }
  bool empty() const { return rows_.empty(); }
  const NumberRow& operator[](std::size_t i) const { return rows_[i]; }
  auto begin() const { return rows_.begin(); }
  auto end() const { return rows_.end(); }

  // The number in a column of a row. Throws InputError that names the file, the line and `name` where it is
  // no number or not finite.
  double number(const NumberRow& row, std::size_t column, const std::string& name) const;

  // Throws InputError where a row has not the columns it should: "columns: found 3, expected ...".
  void expect_columns(const NumberRow& row, bool right, const std::string& expected) const;

 private:
  std::filesystem::path path_;
  std::string text_;
  std::vector<NumberRow> rows_;
};

// A number in as few digits as bring it back exactly.
std::string shortest_text(double value);

}  // namespace framewise
