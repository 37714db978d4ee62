// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "framewise/io/grid_file.h"
#include "recording.h"

namespace framewise::apps {

// A folder that one process of `run` fills. The key says what is in it: with another key it is other work.
struct PlannedJob {
  std::filesystem::path folder;
  std::vector<std::string> arguments;  // of `run`, without --out and --archive
  nlohmann::ordered_json key;
};

struct PlannedDataset {
  Recording recording;
  std::string label;             // its name, told apart from others of the same name
  std::filesystem::path folder;  // truth.tum
};

struct PlannedArchive {
  std::size_t dataset = 0;
  bool is_given = false;       // the data set is itself an archive
  std::filesystem::path file;  // in the job's folder where it is not given
  PlannedJob job;
};

// A method with features on a data set, once for each seed.
struct PlannedRow {
  std::size_t dataset = 0, archive = 0;
  std::string method, features;
  std::vector<std::pair<std::string, std::string>> options;  // resolved
  std::vector<PlannedJob> runs;
};

struct ComparePlan {
  std::vector<PlannedDataset> datasets;
  std::vector<PlannedArchive> archives;  // each once, though many rows use it
  std::vector<PlannedRow> rows;
};

struct PlanOptions {
  std::filesystem::path out;
  std::uint64_t seed = 0;
  std::size_t repeats = 1;
};

// Opens the data sets and lays out the work. `dataset_arguments`, as typed, are handed on to the making of
// archives. Throws InputError for data sets that cannot be opened and for options that `run` does not have.
ComparePlan make_compare_plan(const std::vector<std::filesystem::path>& paths, const Grid& grid,
                              const DatasetOptions& dataset_options,
                              const std::vector<std::string>& dataset_arguments, const PlanOptions& options);

}  // namespace framewise::apps
