// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/io/file_names.h"

#include <algorithm>
#include <charconv>

namespace framewise {
namespace {

namespace fs = std::filesystem;

bool is_digit(char c) { return c >= '0' && c <= '9'; }

// The run of digits at the front, taken away from the text.
std::string_view take_digits(std::string_view& text) {
  std::size_t end = 0;
  while (end < text.size() && is_digit(text[end])) ++end;
  const std::string_view digits = text.substr(0, end);
  text.remove_prefix(end);
  return digits;
}

std::string_view without_zeros(std::string_view digits) {
  return digits.substr(std::min(digits.find_first_not_of('0'), digits.size()));
}

// -1, 0 or 1 by the numbers' size, of any length.
int compare_numbers(std::string_view a, std::string_view b) {
  const std::string_view x = without_zeros(a), y = without_zeros(b);
  if (x.size() != y.size()) return x.size() < y.size() ? -1 : 1;
  const int order = x.compare(y);
  return order < 0 ? -1 : order > 0 ? 1 : 0;
}

}  // namespace

bool natural_less(std::string_view a, std::string_view b) {
  const std::string_view whole_a = a, whole_b = b;
  while (!a.empty() && !b.empty()) {
    if (is_digit(a[0]) && is_digit(b[0])) {
      if (const int order = compare_numbers(take_digits(a), take_digits(b)); order != 0) return order < 0;
      continue;
    }
    if (a[0] != b[0]) return a[0] < b[0];
    a.remove_prefix(1);
    b.remove_prefix(1);
  }
  if (a.empty() != b.empty()) return a.empty();
  return whole_a < whole_b;
}

std::vector<std::string> files_in(const fs::path& folder, const std::vector<std::string>& extensions) {
  std::vector<std::string> names;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    std::string name = entry.path().filename().string();
    const bool wanted = name[0] != '.' && std::find(extensions.begin(), extensions.end(),
                                                    extension_of(name)) != extensions.end();
    if (wanted && !entry.is_directory(error)) names.push_back(std::move(name));
  }
  std::sort(names.begin(), names.end(), natural_less);
  return names;
}

const std::vector<std::string>& image_extensions() {
  static const std::vector<std::string> extensions = {".png", ".jpg", ".jpeg", ".pgm",  ".ppm",
                                                      ".pnm", ".bmp", ".tif",  ".tiff", ".webp"};
  return extensions;
}

const std::vector<std::string>& depth_extensions() {
  static const std::vector<std::string> extensions = {".png", ".tif", ".tiff", ".exr", ".pgm"};
  return extensions;
}

std::string extension_of(const fs::path& file) { return lower_case(file.extension().string()); }

std::string lower_case(std::string text) {
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return text;
}

std::string_view stem_of(std::string_view file) {
  file.remove_prefix(std::min(file.size(), file.rfind('/') + 1));
  const std::size_t dot = file.rfind('.');
  return dot == std::string_view::npos || dot == 0 ? file : file.substr(0, dot);
}

std::optional<long> number_in(std::string_view file) {
  const std::string_view stem = stem_of(file);
  std::size_t end = stem.size();
  while (end > 0 && !is_digit(stem[end - 1])) --end;
  std::size_t begin = end;
  while (begin > 0 && is_digit(stem[begin - 1])) --begin;
  long number = 0;
  const auto [last, error] = std::from_chars(stem.data() + begin, stem.data() + end, number);
  if (error != std::errc() || begin == end) return std::nullopt;
  return number;
}

fs::path first_existing(const fs::path& folder, const std::vector<std::string>& names) {
  for (const std::string& name : names)
    if (fs::exists(folder / name)) return folder / name;
  return {};
}

}  // namespace framewise
