// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/io/frame_times.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "framewise/io/file_lists.h"
#include "framewise/io/file_names.h"
#include "framewise/io/input_error.h"
#include "framewise/io/number_rows.h"

namespace framewise {
namespace {

FrameTimes from_file(const std::filesystem::path& file, std::size_t frames) {
  FrameTimes found{read_times(file), file.filename().string()};
  if (found.times.size() != frames)
    throw InputError(file, 0, "stamps", std::to_string(found.times.size()),
                     fmt::format("{}, one for each image", frames));
  std::vector<int> lines;
  for (std::size_t i = 0; i < frames; ++i) lines.push_back(static_cast<int>(i) + 1);
  check_seconds(file, found.times, lines);
  return found;
}

std::optional<FrameTimes> from_names(const std::vector<std::string>& names) {
  FrameTimes found{{}, "the files' names"};
  for (const std::string& name : names) {
    const auto stamp = stamp_in(name);
    if (!stamp || (!found.times.empty() && !(*stamp > found.times.back()))) return std::nullopt;
    found.times.push_back(*stamp);
  }
  return found;
}

}  // namespace

std::vector<double> read_times(const std::filesystem::path& path) {
  std::vector<double> times;
  const NumberRows rows(path, "a stamp a line");
  for (const NumberRow& row : rows) {
    rows.expect_columns(row, row.fields.size() == 1, "1 (a stamp in seconds)");
    times.push_back(rows.number(row, 0, "timestamp"));
  }
  return times;
}

FrameTimes frame_times(const std::filesystem::path& times_file, const std::vector<std::string>& names,
                       const std::optional<double>& fps, double assumed_fps) {
  if (!times_file.empty() && std::filesystem::exists(times_file)) return from_file(times_file, names.size());
  if (!fps)
    if (auto found = from_names(names)) return *found;
  const double rate = fps.value_or(assumed_fps);
  FrameTimes even{{}, fmt::format("{} frames a second, {}", rate, fps ? "as given" : "assumed (--fps)")};
  for (std::size_t i = 0; i < names.size(); ++i) even.times.push_back(static_cast<double>(i) / rate);
  return even;
}

std::optional<double> stamp_in(std::string_view file) {
  const std::string_view stem = stem_of(file);
  double value = 0;
  const auto [end, error] =
      std::from_chars(stem.data(), stem.data() + stem.size(), value, std::chars_format::fixed);
  if (error != std::errc() || end != stem.data() + stem.size() || !std::isfinite(value)) return std::nullopt;
  if (stem.find('.') != std::string_view::npos) return value;
  return stem.size() >= 16 ? std::optional<double>(value / 1e9) : std::nullopt;
}

}  // namespace framewise
