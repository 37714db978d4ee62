// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/io/csv_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <iterator>

#include "framewise/io/input_error.h"

namespace framewise {
namespace {

// Takes a file's text apart, record by record.
class CsvText {
 public:
  CsvText(const std::filesystem::path& path, std::string text) : path_(path), text_(std::move(text)) {}

  bool at_end() const { return at_ >= text_.size(); }
  std::size_t line() const { return line_; }

  std::vector<std::string> record() {
    std::vector<std::string> values{value()};
    while (take(',')) values.push_back(value());
    take('\r');
    if (!at_end() && !take('\n') && text_[at_ - 1] != '\r')
      throw InputError(path_, line_, "", "text after a value in quotes", "a comma or the end of the line");
    ++line_;
    return values;
  }

 private:
  bool take(char expected) {
    if (at_end() || text_[at_] != expected) return false;
    ++at_;
    return true;
  }

  std::string value() {
    if (take('"')) return quoted_value();
    const std::size_t end = std::min(text_.find_first_of(",\r\n", at_), text_.size());
    std::string plain = text_.substr(at_, end - at_);
    at_ = end;
    return plain;
  }

  std::string quoted_value() {
    const std::size_t begins = line_;
    std::string value;
    for (;;) {
      if (at_end()) throw InputError(path_, begins, "", "a quote that does not end", "a closing quote");
      const char c = text_[at_++];
      if (c == '"' && !take('"')) return value;
      line_ += c == '\n';
      value += c;
    }
  }

  const std::filesystem::path& path_;
  std::string text_;
  std::size_t at_ = 0, line_ = 1;
};

std::string text_of_file(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file || std::filesystem::is_directory(path))
    throw InputError(path, 0, "", "no file", "a table of values separated by commas");
  std::string text(std::istreambuf_iterator<char>(file), {});
  return text.starts_with("\xEF\xBB\xBF") ? text.substr(3) : text;  // a byte order mark
}

bool is_blank(const std::vector<std::string>& values) { return values.size() == 1 && values[0].empty(); }

}  // namespace

CsvTable::CsvTable(const std::filesystem::path& path) : path_(path) {
  CsvText text(path_, text_of_file(path));
  while (!text.at_end()) {
    const std::size_t line = text.line();
    std::vector<std::string> values = text.record();
    if (is_blank(values)) continue;
    if (columns_.empty()) {
      columns_ = std::move(values);
      continue;
    }
    if (values.size() != columns_.size())
      throw InputError(path_, line, "", fmt::format("{} values", values.size()),
                       fmt::format("{}, as there are columns", columns_.size()));
    rows_.push_back({line, std::move(values)});
  }
  if (columns_.empty()) throw InputError(path_, 0, "", "an empty file", "a line that names the columns");
  for (const std::string& name : columns_)
    if (std::count(columns_.begin(), columns_.end(), name) > 1)
      throw InputError(path_, 1, name, "a column of this name twice", "names that differ");
}

std::optional<std::size_t> CsvTable::find(const std::string& name) const {
  const auto found = std::find(columns_.begin(), columns_.end(), name);
  if (found == columns_.end()) return std::nullopt;
  return static_cast<std::size_t>(found - columns_.begin());
}

std::size_t CsvTable::column(const std::string& name) const {
  const auto found = find(name);
  if (!found)
    throw InputError(path_, 1, name, "no such column", fmt::format("one among {}", fmt::join(columns_, ",")));
  return *found;
}

std::optional<double> CsvTable::number(std::size_t row, std::size_t column) const {
  const std::string& text = rows_[row].values[column];
  if (text.empty()) return std::nullopt;
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
    throw InputError(path_, rows_[row].line, columns_[column], "'" + text + "'", "a number");
  return value;
}

}  // namespace framewise
