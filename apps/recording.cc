// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "recording.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "framewise/io/input_error.h"
#include "framewise/io/trajectory_files.h"
#include "framewise/io/video_file.h"
#include "method_options.h"

namespace framewise::apps {
namespace {

Recording of_images(Dataset dataset, double max_truth_gap) {
  Recording recording;
  recording.path = dataset.folder;
  recording.from = {FRAMEWISE_VERSION,
                    dataset.name,
                    dataset.format,
                    dataset.fingerprint,
                    dataset.frames_with_depth,
                    dataset.calibration,
                    dataset.calibration_source,
                    {}};
  for (const FrameFiles& frame : dataset.frames) {
    recording.times.push_back(frame.time);
    recording.truth.push_back(pose_at(dataset.truth, frame.time, max_truth_gap));
  }
  recording.images = std::move(dataset);
  return recording;
}

constexpr std::array<const char*, 12> kOptionsOfImages = {
    "format",          "camera",  "register-depth",      "depth-type",    "depth-factor",
    "depth-max",       "fps",     "max-time-difference", "max-truth-gap", "archive",
    "export-features", "geometry"};

// Any file but a video; whether it is a whole archive, its reader finds out.
bool is_archive(const std::filesystem::path& path) {
  return std::filesystem::is_regular_file(path) && !is_video_name(path);
}

Recording of_archive(std::unique_ptr<CorrespondenceArchive> archive, const std::filesystem::path& path) {
  Recording recording;
  recording.path = path;
  recording.from = archive->provenance();
  for (const ArchivedFrame& frame : archive->frames()) {
    recording.times.push_back(frame.time);
    recording.truth.push_back(frame.world_from_cam);
  }
  recording.archive = std::move(archive);
  return recording;
}

}  // namespace

bool Recording::has_truth() const {
  return std::any_of(truth.begin(), truth.end(), [](const auto& pose) { return pose.has_value(); });
}

Trajectory Recording::true_trajectory() const {
  Trajectory trajectory;
  for (std::size_t i = 0; i < size(); ++i)
    if (truth[i]) trajectory.add(times[i], *truth[i]);
  return trajectory;
}

void add_dataset_options(CLI::App& app, DatasetOptions& o) {
  app.add_option("--format", o.format,
                 fmt::format("of the data set; else recognised: {}", fmt::join(dataset_formats(), ", ")));
  app.add_option("--camera", o.camera_file,
                 "camera YAML (Framewise, ROS, Kalibr, OpenCV); else camera.yaml in the data set,\n"
                 "else what the format brings");
  app.add_option("--register-depth", o.register_depth,
                 "false: depth is taken as it is where its camera is another one")
      ->capture_default_str();
  app.add_option("--depth-type", o.depth_type,
                 "z along the optical axis, or range along the ray; else the calibration's");
  app.add_option("--depth-factor", o.depth_factor, "raw depth units in a metre; else the calibration's");
  app.add_option("--depth-max", o.depth_max,
                 "farther is unknown (m); 16-bit ranges then reach from 0 to it unless a factor says else");
  app.add_option("--fps", o.fps, "frames a second where the data set has no stamps");
  app.add_option("--max-time-difference", o.max_time_difference,
                 "colour and depth farther apart are not one frame (s)")
      ->capture_default_str();
  app.add_option("--max-truth-gap", o.max_truth_gap, "no truth is interpolated across more (s)")
      ->capture_default_str();
}

nlohmann::ordered_json dataset_options_json(const DatasetOptions& o) {
  nlohmann::ordered_json json = {{"register-depth", o.register_depth},
                                 {"max-time-difference", o.max_time_difference},
                                 {"max-truth-gap", o.max_truth_gap}};
  if (!o.format.empty()) json["format"] = o.format;
  if (!o.depth_type.empty()) json["depth-type"] = o.depth_type;
  if (o.fps) json["fps"] = *o.fps;
  return json;
}

Trajectory read_truth(const std::filesystem::path& path, DatasetOptions options) {
  // A truth without its images is a reference as well.
  if (const auto truth = path / "groundtruth.txt"; options.format.empty() && std::filesystem::exists(truth))
    return read_trajectory(truth).trajectory;
  options.needs_camera = false;
  const Dataset dataset = open_dataset(path, options);
  if (dataset.truth.empty())
    throw InputError(path, 0, "", fmt::format("no truth in this recording ({})", dataset.format),
                     "a data set with truth, such as groundtruth.txt");
  return dataset.truth;
}

Recording open_recording(const std::filesystem::path& path, const DatasetOptions& options) {
  if (is_archive(path)) return of_archive(std::make_unique<CorrespondenceArchive>(path), path);
  return of_images(open_dataset(path, options), options.max_truth_gap);
}

void apply_archive(CLI::App& command, const Recording& recording, const OdometryOptions& options) {
  const auto refuse = [&](const std::string& name, const std::string& found, const std::string& expected) {
    throw InputError(recording.path, 0, name, found, expected);
  };
  for (const char* name : kOptionsOfImages)
    if (command.get_option(std::string("--") + name)->count() > 0)
      refuse(name, "an archive, which has no images", "a data set for this option");

  const auto& archived = recording.from.options;
  for (const auto& [name, chosen] : correspondence_option_texts(options)) {
    const auto kept = archived.find(name);
    if (kept == archived.end() || kept->second == chosen) continue;
    CLI::Option* option = command.get_option("--" + name);
    if (option->count() > 0)
      refuse(name, "'" + kept->second + "', which its matches were made with",
             "'" + chosen + "' as chosen (make an archive with it)");
    option->add_result(kept->second);
    option->run_callback();
  }
}

}  // namespace framewise::apps
