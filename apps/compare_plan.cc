// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "compare_plan.h"

#include <fmt/format.h>

#include <algorithm>

#include "framewise/io/input_error.h"
#include "framewise/io/trajectory_files.h"
#include "method_options.h"

namespace framewise::apps {
namespace {

namespace fs = std::filesystem;
using Key = nlohmann::ordered_json;

std::string as_folder_name(const std::string& name) {
  std::string plain;
  for (const unsigned char c : name)
    plain += std::isalnum(c) || std::strchr("._-", c) ? static_cast<char>(c) : '_';
  return plain.empty() || plain[0] == '.' ? fmt::format("_{}", plain) : plain;
}

// Tells folders of different keys apart; that a folder is the right one says the key in it.
std::string short_hash(const Key& key) {
  return fmt::format("{:08x}", static_cast<std::uint32_t>(std::hash<std::string>()(key.dump())));
}

// A grid's method and features together.
struct Method {
  OdometryOptions odometry;
  std::string rotation = "none";
  OptionList typed;  // features and method, as the grid has them
};

void take_option(CLI::App& options, Method& method, const Grid& grid, const GridEntry& entry,
                 const std::string& name, const std::string& value) {
  if (name == "rotation") {
    method.rotation = value;
    return;
  }
  CLI::Option* option = options.get_option_no_throw("--" + name);
  if (!option || name == "seed" || name == "threads" || name == "help")
    throw InputError(grid.source, entry.line, entry.name, "'" + name + "'",
                     "an option of the method or its features (framewise run --help), not of the data set");
  try {
    option->clear();
    option->add_result(value);
    option->run_callback();
  } catch (const CLI::Error& error) {
    throw InputError(grid.source, entry.line, entry.name + ": " + name, "'" + value + "'", error.what());
  }
}

Method combined(const Grid& grid, const GridEntry& features, const GridEntry& row) {
  Method method;
  CLI::App options;
  add_method_options(options, method.odometry);
  for (const GridEntry* entry : {&features, &row})
    for (const auto& [name, value] : entry->options) {
      take_option(options, method, grid, *entry, name, value);
      std::erase_if(method.typed, [&](const auto& earlier) { return earlier.first == name; });
      method.typed.emplace_back(name, value);
    }
  try {
    method.odometry.check();
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(fmt::format("{}:{}: {} with {}: {}", grid.source.string(), row.line, row.name,
                                            features.name, error.what()));
  }
  return method;
}

Key calibration_key(const CameraFile& file) {
  const auto numbers = [](const Camera& c) {
    return Key{name_of(c.model), c.width, c.height, c.fx, c.fy, c.cx, c.cy, c.distortion, c.theta_range};
  };
  Key key{numbers(file.camera), file.depth_factor, file.depth_max, name_of(file.depth_type)};
  if (file.depth_camera) key.push_back(numbers(file.depth_camera->camera));
  return key;
}

std::string truth_text(const Recording& recording) {
  std::string text;
  for (std::size_t i = 0; i < recording.size(); ++i)
    if (recording.truth[i]) text += tum_line(recording.times[i], *recording.truth[i]) + "\n";
  return text;
}

Key dataset_key(const Recording& recording) {
  return {{"name", recording.from.dataset_name},
          {"fingerprint", recording.from.dataset_fingerprint},
          {"calibration", calibration_key(recording.from.calibration)},
          {"truth", short_hash(truth_text(recording))}};
}

// A file that an option names may change while its name stays.
Key rotation_key(const std::string& rotation) {
  std::error_code error;
  const auto size = fs::file_size(rotation, error);
  if (error) return rotation;
  return {rotation, size, fs::last_write_time(rotation, error).time_since_epoch().count()};
}

class Planner {
 public:
  Planner(const Grid& grid, const std::vector<std::string>& dataset_arguments, const PlanOptions& options)
      : grid_(grid), dataset_arguments_(dataset_arguments), options_(options) {}

  void add_dataset(const fs::path& path, const DatasetOptions& dataset_options) {
    PlannedDataset dataset;
    dataset.recording = open_recording(path, dataset_options);
    if (dataset.recording.archive && !dataset_arguments_.empty())
      throw InputError(path, 0, dataset_arguments_.front(), "an archive, which has no images",
                       "a data set for this option");
    const Key key = dataset_key(dataset.recording);
    dataset.label = dataset.recording.from.dataset_name;
    const std::string name = as_folder_name(dataset.label) + "-" + short_hash(key);
    dataset.folder = options_.out / "datasets" / name;
    for (const PlannedDataset& other : plan_.datasets) {
      if (other.folder == dataset.folder)
        throw InputError(path, 0, "DATASET", "the same recording twice", "each once");
      if (other.label == dataset.label) dataset.label = name;
    }
    plan_.datasets.push_back(std::move(dataset));
    for (const GridEntry& features : grid_.features)
      for (const GridEntry& method : grid_.methods) add_row(features, method);
  }

  ComparePlan plan() { return std::move(plan_); }

 private:
  void add_row(const GridEntry& features, const GridEntry& entry) {
    const Method method = combined(grid_, features, entry);
    PlannedRow row;
    row.dataset = plan_.datasets.size() - 1;
    row.archive = archive_for(method);
    row.method = entry.name;
    row.features = features.name;
    Key options = options_json(method.odometry);
    for (const char* name : {"threads", "seed"}) options.erase(name);
    options["rotation"] = method.rotation;
    for (const auto& [name, value] : options.items())
      row.options.emplace_back(name, value.is_string() ? value.get<std::string>() : value.dump());
    options["rotation"] = rotation_key(method.rotation);
    add_runs(row, method, options);
    plan_.rows.push_back(std::move(row));
  }

  void add_runs(PlannedRow& row, const Method& method, const Key& options) const {
    const PlannedArchive& archive = plan_.archives[row.archive];
    Key key = {{"version", FRAMEWISE_VERSION}, {"archive", archive.job.key}, {"options", options}};
    const fs::path folder = options_.out / "rows" / plan_.datasets[row.dataset].folder.filename() /
                            as_folder_name(row.features) /
                            (as_folder_name(row.method) + "-" + short_hash(key));
    for (std::size_t i = 0; i < options_.repeats; ++i) {
      const std::uint64_t seed = options_.seed + i;
      PlannedJob job;
      job.folder = folder / fmt::format("seed_{}", seed);
      key["seed"] = seed;
      job.key = key;
      job.arguments = {"run", archive.file.string(), "--seed", std::to_string(seed)};
      for (const auto& [name, value] : method.typed)
        job.arguments.push_back(fmt::format("--{}={}", name, value));
      row.runs.push_back(std::move(job));
    }
  }

  // The archive that holds these correspondences, planned if it is not yet.
  std::size_t archive_for(const Method& method) {
    const PlannedDataset& dataset = plan_.datasets.back();
    PlannedArchive archive;
    archive.dataset = plan_.datasets.size() - 1;
    archive.is_given = dataset.recording.archive != nullptr;
    archive.job.key = {{"version", FRAMEWISE_VERSION}, {"dataset", dataset_key(dataset.recording)}};
    const auto texts =
        archive.is_given ? dataset.recording.from.options : correspondence_option_texts(method.odometry);
    archive.job.key["options"] = texts;
    if (archive.is_given) {
      archive.file = dataset.recording.path;
    } else {
      archive.job.key["dataset_arguments"] = dataset_arguments_;
      archive.job.key["seed"] = options_.seed;
      archive.job.folder = options_.out / "archives" /
                           (dataset.folder.filename().string() + "-" + short_hash(archive.job.key));
      archive.file = archive.job.folder / "matches.h5";
      archive.job.arguments = archive_arguments(dataset.recording, method);
    }
    for (std::size_t i = 0; i < plan_.archives.size(); ++i)
      if (plan_.archives[i].file == archive.file) return i;
    plan_.archives.push_back(std::move(archive));
    return plan_.archives.size() - 1;
  }

  // With a solver that works on what the data set has, whatever the rows want: matches do not depend on it.
  std::vector<std::string> archive_arguments(const Recording& recording, const Method& method) const {
    std::vector<std::string> arguments{"run", recording.path.string(), "--seed",
                                       std::to_string(options_.seed)};
    const bool depth = recording.from.frames_with_depth > 0;
    arguments.insert(arguments.end(),
                     {"--solver", depth ? "kabsch" : "nister-5pt", "--scale", depth ? "depth" : "none"});
    const auto shaping = correspondence_option_texts(method.odometry);
    for (const auto& [name, value] : method.typed)
      if (shaping.contains(name)) arguments.push_back(fmt::format("--{}={}", name, value));
    arguments.insert(arguments.end(), dataset_arguments_.begin(), dataset_arguments_.end());
    return arguments;
  }

  const Grid& grid_;
  const std::vector<std::string>& dataset_arguments_;
  const PlanOptions& options_;
  ComparePlan plan_;
};

}  // namespace

ComparePlan make_compare_plan(const std::vector<fs::path>& paths, const Grid& grid,
                              const DatasetOptions& dataset_options,
                              const std::vector<std::string>& dataset_arguments, const PlanOptions& options) {
  Planner planner(grid, dataset_arguments, options);
  for (const fs::path& path : paths) planner.add_dataset(path, dataset_options);
  return planner.plan();
}

}  // namespace framewise::apps
