// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace framewise {

// A file of values separated by commas whose first line names the columns (RFC 4180: a value in double quotes
// may hold commas, line ends and doubled quotes; line ends of any system).
class CsvTable {
 public:
  // Throws InputError where there is no file, no line, a line that has not as many values as there are
  // columns, a column named twice, or a quote that does not end.
  explicit CsvTable(const std::filesystem::path& path);

  std::size_t num_rows() const { return rows_.size(); }

  // Empty where the table has no such column.
  std::optional<std::size_t> find(const std::string& name) const;

  // Throws InputError where the table has no such column.
  std::size_t column(const std::string& name) const;

  const std::string& text(std::size_t row, std::size_t column) const { return rows_[row].values[column]; }

  // Empty where the value is. Throws InputError where it is not a finite number.
  std::optional<double> number(std::size_t row, std::size_t column) const;

 private:
  struct Row {
    std::size_t line;  // in the file, from 1
    std::vector<std::string> values;
  };
  std::filesystem::path path_;
  std::vector<std::string> columns_;
  std::vector<Row> rows_;
};

}  // namespace framewise
