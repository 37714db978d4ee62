// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/io/file_lists.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <sstream>
#include <tuple>

#include "framewise/io/input_error.h"

namespace framewise {
namespace {

struct Line {
  int number;
  std::vector<std::string> words;
};

// The lines that say something, split at blanks.
std::vector<Line> read_words(const std::filesystem::path& path, std::size_t words_expected,
                             const char* expected) {
  std::ifstream file(path);
  if (!file) throw InputError(path, 0, "", "no file", expected);
  std::vector<Line> lines;
  std::string text;
  for (int number = 1; std::getline(file, text); ++number) {
    std::istringstream stream(text.substr(0, text.find('#')));
    Line line{number, {}};
    for (std::string word; stream >> word;) line.words.push_back(word);
    if (line.words.empty()) continue;
    if (line.words.size() != words_expected)
      throw InputError(path, number, "", fmt::format("{} words", line.words.size()), expected);
    lines.push_back(std::move(line));
  }
  if (lines.empty()) throw InputError(path, 0, "", "an empty list", expected);
  return lines;
}

bool is_depth_first(const Line& line) {
  return line.words[1].find("depth") != std::string::npos && line.words[3].find("depth") == std::string::npos;
}

double parse_time(const std::filesystem::path& path, int line, const std::string& word) {
  double time = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), time);
  if (error != std::errc() || end != word.data() + word.size() || !std::isfinite(time))
    throw InputError(path, line, "", "'" + word + "'", "a time in seconds");
  return time;
}

}  // namespace

// Seconds since 1970 have ten digits; a camera that waits a quarter of an hour between frames is none.
void check_seconds(const std::filesystem::path& path, const std::vector<double>& times,
                   const std::vector<int>& lines) {
  for (std::size_t i = 1; i < times.size(); ++i)
    if (times[i] <= times[i - 1])
      throw InputError(path, lines[i], "", fmt::format("time {} after {}", times[i], times[i - 1]),
                       "times that increase (is this one recording?)");
  std::vector<double> steps;
  for (std::size_t i = 1; i < times.size(); ++i) steps.push_back(times[i] - times[i - 1]);
  if (!steps.empty()) std::nth_element(steps.begin(), steps.begin() + steps.size() / 2, steps.end());
  const bool too_late = times.front() > 1e11;
  if (too_late || (!steps.empty() && steps[steps.size() / 2] > 1000))
    throw InputError(path, lines.front(), "", fmt::format("time {}", times.front()),
                     "seconds (are these nano-, micro- or milliseconds?)");
}

std::vector<ListedFile> read_file_list(const std::filesystem::path& path) {
  std::vector<ListedFile> files;
  std::vector<double> times;
  std::vector<int> numbers;
  for (const Line& line : read_words(path, 2, "lines of 'time file'")) {
    times.push_back(parse_time(path, line.number, line.words[0]));
    numbers.push_back(line.number);
    files.push_back({times.back(), line.words[1], line.number});
  }
  check_seconds(path, times, numbers);
  return files;
}

std::vector<AssociatedFiles> read_association_list(const std::filesystem::path& path) {
  std::vector<AssociatedFiles> pairs;
  std::vector<double> times;
  std::vector<int> numbers;
  const auto lines = read_words(path, 4, "lines of 'time file time file'");
  const std::size_t color = is_depth_first(lines.front()) ? 2 : 0, depth = 2 - color;
  const auto file_at = [&](const Line& line, std::size_t word) {
    return ListedFile{parse_time(path, line.number, line.words[word]), line.words[word + 1], line.number};
  };
  for (const Line& line : lines) {
    pairs.push_back({file_at(line, color), file_at(line, depth)});
    times.push_back(pairs.back().color.time);
    numbers.push_back(line.number);
  }
  check_seconds(path, times, numbers);
  return pairs;
}

std::vector<int> associate_by_time(const std::vector<double>& times, const std::vector<double>& others,
                                   double max_difference) {
  std::vector<std::tuple<double, int, int>> candidates;
  std::size_t first = 0;
  for (std::size_t i = 0; i < times.size(); ++i) {
    while (first < others.size() && others[first] < times[i] - max_difference) ++first;
    for (std::size_t j = first; j < others.size() && others[j] <= times[i] + max_difference; ++j)
      candidates.emplace_back(std::abs(others[j] - times[i]), static_cast<int>(i), static_cast<int>(j));
  }
  std::sort(candidates.begin(), candidates.end());

  std::vector<int> partner(times.size(), -1);
  std::vector<bool> taken(others.size(), false);
  for (const auto& [difference, i, j] : candidates) {
    if (partner[i] >= 0 || taken[j]) continue;
    partner[i] = j;
    taken[j] = true;
  }
  return partner;
}

}  // namespace framewise
