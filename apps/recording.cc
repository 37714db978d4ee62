// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "recording.h"

#include <algorithm>

#include "framewise/io/input_error.h"
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

Recording open_recording(const std::filesystem::path& path, const DatasetOptions& options) {
  if (std::filesystem::is_regular_file(path))
    return of_archive(std::make_unique<CorrespondenceArchive>(path), path);
  return of_images(open_dataset(path, options), options.max_truth_gap);
}

void apply_archive(CLI::App& command, const Recording& recording, const OdometryOptions& options) {
  const auto refuse = [&](const std::string& name, const std::string& found, const std::string& expected) {
    throw InputError(recording.path, 0, name, found, expected);
  };
  for (const char* name : {"camera", "depth-factor", "depth-max", "max-time-difference", "max-truth-gap",
                           "archive", "export-features"})
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
