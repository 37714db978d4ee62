// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "framewise/io/correspondence_archive.h"
#include "framewise/io/dataset.h"
#include "framewise/odometry/options.h"

namespace framewise::apps {

// What `run` works on: a data set with images, or the correspondences an archive kept of one. `images` or
// `archive` is there.
struct Recording {
  std::filesystem::path path;
  ArchiveProvenance from;
  std::vector<double> times;               // of the frames (s)
  std::vector<std::optional<Pose>> truth;  // world_from_cam at these times
  std::optional<Dataset> images;
  std::unique_ptr<CorrespondenceArchive> archive;

  std::size_t size() const { return times.size(); }
  bool has_truth() const;
  Trajectory true_trajectory() const;  // of the frames whose truth is known
};

// What says how a data set is to be read: --format, --camera, --depth-type and so on.
void add_dataset_options(CLI::App& app, DatasetOptions& options);

// The options above as run.json writes them down.
nlohmann::ordered_json dataset_options_json(const DatasetOptions& options);

// The truth of a data set, which needs neither images nor a calibration that is known. Throws InputError
// where there is none.
Trajectory read_truth(const std::filesystem::path& path, DatasetOptions options);

// An HDF5 file is an archive, anything else a data set. Throws InputError.
Recording open_recording(const std::filesystem::path& path, const DatasetOptions& options);

// Options that shaped an archive's correspondences take the archive's values. Throws InputError where one was
// chosen otherwise, and where an option was chosen that needs images.
void apply_archive(CLI::App& command, const Recording& recording, const OdometryOptions& options);

}  // namespace framewise::apps
