// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace framewise {

// When the frames of a recording were taken that lists no stamps beside its files.
struct FrameTimes {
  std::vector<double> times;  // s, strictly increasing, one a frame
  std::string source;         // where they are from, for people
};

// One stamp (s) a line. Throws InputError.
std::vector<double> read_times(const std::filesystem::path& path);

// The times of `names` (files in their order): those of times_file where it is not empty and exists; else
// `fps`, where it was typed; else the names, where each is a stamp (seconds with a decimal point, or
// nanoseconds of 16 digits or more); else an assumed rate. Throws InputError where times_file has another
// number of stamps, or stamps that do not increase or are not seconds.
FrameTimes frame_times(const std::filesystem::path& times_file, const std::vector<std::string>& names,
                       const std::optional<double>& fps, double assumed_fps);

// The stamp a name is, as above. Empty where it is none.
std::optional<double> stamp_in(std::string_view file);

}  // namespace framewise
