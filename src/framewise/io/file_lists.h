// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace framewise {

// A line of a list: a time and the file recorded then.
struct ListedFile {
  double time = 0;   // s
  std::string file;  // as written, relative to the list; a path object takes a kilobyte, and there are many
  int line = 0;
};

// Reads "time file" lines; '#' starts a comment. Throws InputError for an empty list, a line that is not a
// time and a name, times that do not increase, and times that are not seconds.
std::vector<ListedFile> read_file_list(const std::filesystem::path& path);

struct AssociatedFiles {
  ListedFile color, depth;
};

// Reads "time file time file" lines as the TUM benchmark's associate.py writes them: colour first, unless the
// first line's files lie in folders called depth and then rgb (ICL-NUIM).
std::vector<AssociatedFiles> read_association_list(const std::filesystem::path& path);

// Throws InputError, at the line of the offender, for times that do not increase and times that are not
// seconds. At least one.
void check_seconds(const std::filesystem::path& path, const std::vector<double>& times,
                   const std::vector<int>& lines);

// For each time of `times` the index of its partner in `others`, or -1: pairs closer than max_difference (s),
// each used once, the closest pairs first. Both ascending.
std::vector<int> associate_by_time(const std::vector<double>& times, const std::vector<double>& others,
                                   double max_difference);

}  // namespace framewise
