// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "framewise/io/dataset_parts.h"
#include "framewise/io/dataset_reader.h"
#include "framewise/io/file_names.h"
#include "framewise/io/input_error.h"
#include "framewise/io/video_file.h"

namespace framewise {
namespace {

namespace fs = std::filesystem;

std::string recognise_video(const fs::path& path) {
  return fs::is_regular_file(path) && is_video_name(path) ? "its name ends in " + extension_of(path) : "";
}

Dataset open_video(const fs::path& path, const DatasetOptions& options) {
  if (!fs::is_regular_file(path)) throw InputError(path, 0, "", "no file", "a video");
  Dataset dataset = dataset_of(path.parent_path());
  dataset.name = path.filename().string();
  calibrate(
      dataset, options, {}, [] { return std::nullopt; }, "");
  dataset.video = std::make_shared<VideoFile>(path);
  Fingerprint fingerprint;
  const std::string file = existing_file(path.parent_path(), dataset.name, 0, fingerprint);
  dataset.fingerprint = fingerprint.text();
  const auto& times = dataset.video->times();
  for (std::size_t i = 0; i < times.size(); ++i)
    dataset.frames.push_back({options.fps ? static_cast<double>(i) / *options.fps : times[i], file, {}, 0});
  dataset.times_source =
      options.fps ? fmt::format("{} frames a second, as given", *options.fps) : "the video";
  return dataset;
}

}  // namespace

DatasetReader video_reader() { return {"video", "a file .mp4, .avi, .mkv, …", recognise_video, open_video}; }

}  // namespace framewise
