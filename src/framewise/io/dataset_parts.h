// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "framewise/io/dataset.h"

namespace framewise {

// What the readers of data sets have in common. Inside the room alone.

// FNV-1a, 64 bit: tells recordings apart, keeps no secrets.
class Fingerprint {
 public:
  void add(const std::string& text);
  std::string text() const;

 private:
  std::uint64_t hash_ = 0xcbf29ce484222325ull;
};

// A calibration and what it is called.
using NamedCalibration = std::pair<CameraFile, std::string>;

// The calibration of the options' camera file, else of camera.yaml in the folder, else what `known` gives,
// with what was typed over it. What a file leaves out about depth is taken from `otherwise`. Where there is
// none and the options need none, an empty one without a name; else InputError, which says that
// `expected_by_name` was.
void calibrate(Dataset& dataset, const DatasetOptions& options, const CameraFile& otherwise,
               const std::function<std::optional<NamedCalibration>()>& known,
               const std::string& expected_by_name);

// A recording that holds no more than its folder and name yet.
Dataset dataset_of(const std::filesystem::path& folder);

// The path of a file that a list names, as text; its time, name and size go into the fingerprint. Throws
// InputError, at the list's line (0: none), where there is no such file.
std::string existing_file(const std::filesystem::path& folder, const std::string& file, double time,
                          Fingerprint& fingerprint, const std::filesystem::path& list = {}, int line = 0);

// Throws InputError where the truth ends before the frames begin, or the other way round.
void check_truth(const std::filesystem::path& file, const Trajectory& truth,
                 const std::vector<FrameFiles>& frames);

// Throws InputError where the path is no folder.
void expect_folder(const std::filesystem::path& path, const char* expected);

// The folder from the root, without links and without a slash at its end.
std::filesystem::path whole_path(const std::filesystem::path& folder);

// The folder's own name, however the path is written.
std::string folder_name(const std::filesystem::path& folder);

// A calibration that does not say what 16-bit depth means: its factor is infinite. Floats are metres in any
// case; renderers write 1e10 where there is nothing, and what is beyond 1000 m is taken for that.
CameraFile depth_of_unknown_unit();

// Throws InputError where the first depth image is of 16 bits and the calibration's factor is still infinite.
void expect_depth_unit(const Dataset& dataset);

// Width and height of an image file.
std::pair<int, int> image_size(const std::filesystem::path& file);

}  // namespace framewise
