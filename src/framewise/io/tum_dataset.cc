// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
// The TUM RGB-D benchmark, and recordings that follow it.
//   Sturm et al., A benchmark for the evaluation of RGB-D SLAM systems, IROS 2012.
#include <fstream>
#include <regex>

#include "framewise/io/dataset_reader.h"
#include "framewise/io/input_error.h"
#include "framewise/io/tum_layout.h"

namespace framewise {
namespace {

namespace fs = std::filesystem;

// The benchmark's three cameras are told by the folder's name or by the line "# file:
// 'rgbd_dataset_freiburgN_…'".
std::optional<std::string> freiburg_in(const fs::path& folder) {
  const std::regex pattern("freiburg[123]");
  std::smatch found;
  const std::string name = folder_name(folder);
  if (std::regex_search(name, found, pattern)) return found.str();
  for (const char* list : {"rgb.txt", "depth.txt", "groundtruth.txt"}) {
    std::ifstream file(folder / list);
    std::string line;
    while (std::getline(file, line) && line.starts_with('#'))
      if (std::regex_search(line, found, pattern)) return found.str();
  }
  return std::nullopt;
}

std::string recognise_tum(const fs::path& folder) {
  if (const fs::path list = association_file(folder); !list.empty())
    return "it has " + list.filename().string();
  if (fs::exists(folder / "rgb.txt")) return "it has rgb.txt";
  return has_tum_layout(folder) ? "the files of its folder rgb are called by their stamps" : "";
}

Dataset open_tum(const fs::path& folder, const DatasetOptions& options) {
  expect_folder(folder, "a data set in TUM RGB-D layout");
  Dataset dataset = dataset_of(folder);
  calibrate(
      dataset, options, {},
      [&]() -> std::optional<NamedCalibration> {
        const auto name = freiburg_in(folder);
        return name ? std::optional(NamedCalibration(*known_calibration(*name), *name)) : std::nullopt;
      },
      "a name of the TUM benchmark (freiburg1, 2, 3)");
  read_tum_frames(dataset, options.max_time_difference);
  read_tum_truth(dataset, folder / "groundtruth.txt");
  return dataset;
}

}  // namespace

DatasetReader tum_reader() {
  return {"tum", "rgb.txt, depth.txt, groundtruth.txt; or associations.txt", recognise_tum, open_tum};
}

}  // namespace framewise
