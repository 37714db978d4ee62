// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/io/number_rows.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fstream>
#include <iterator>

#include "framewise/io/input_error.h"

namespace framewise {
namespace {

std::vector<std::string_view> fields_of(std::string_view line) {
  constexpr std::string_view separators = " \t,;\v\f";
  std::vector<std::string_view> fields;
  for (std::size_t begin = line.find_first_not_of(separators); begin != std::string_view::npos;) {
    const std::size_t end = std::min(line.find_first_of(separators, begin), line.size());
    fields.push_back(line.substr(begin, end - begin));
    begin = line.find_first_not_of(separators, end);
  }
  return fields;
}

std::string read_text_of(const std::filesystem::path& path, const std::string& expected) {
  if (std::filesystem::is_directory(path)) throw InputError(path, 0, "", "a folder", "a file");
  std::ifstream file(path, std::ios::binary);
  if (!file) throw InputError(path, 0, "", "no such file, or none that can be read", expected);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::vector<NumberRow> rows_of(std::string_view text) {
  if (text.substr(0, 3) == "\xEF\xBB\xBF") text.remove_prefix(3);  // byte order mark of some editors
  std::vector<NumberRow> rows;
  for (std::size_t begin = 0, line = 1; begin < text.size(); ++line) {
    const std::size_t end = std::min(text.find_first_of("\r\n", begin), text.size());
    std::string_view content = text.substr(begin, end - begin);
    content = content.substr(0, content.find('#'));
    auto fields = fields_of(content);
    if (!fields.empty())
      rows.push_back({line, std::move(fields), content.find(',') != std::string_view::npos});
    begin = text.substr(end, 2) == "\r\n" ? end + 2 : end + 1;
  }
  return rows;
}

std::string quoted(std::string_view text) { return "'" + std::string(text.substr(0, 40)) + "'"; }

}  // namespace

NumberRows::NumberRows(const std::filesystem::path& path, const std::string& expected)
    : path_(path), text_(read_text_of(path, expected)), rows_(rows_of(text_)) {}

double NumberRows::number(const NumberRow& row, std::size_t column, const std::string& name) const {
  std::string_view field = row.fields[column];
  if (field.size() > 1 && field[0] == '+') field.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
  if (error != std::errc() || end != field.data() + field.size())
    throw InputError(path_, row.line, name, quoted(row.fields[column]), "a number");
  if (!std::isfinite(value))
    throw InputError(path_, row.line, name, quoted(row.fields[column]), "a finite number");
  return value;
}

void NumberRows::expect_columns(const NumberRow& row, bool right, const std::string& expected) const {
  if (!right) throw InputError(path_, row.line, "columns", std::to_string(row.fields.size()), expected);
}

std::string shortest_text(double value) {
  std::array<char, 400> text;
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
}

}  // namespace framewise
