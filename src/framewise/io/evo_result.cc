// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/io/evo_result.h"

#include <fmt/format.h>

#include <bit>
#include <cstring>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "framewise/io/trajectory_files.h"
#include "framewise/io/zip_file.h"

namespace framewise {
namespace {

static_assert(std::endian::native == std::endian::little, "the arrays are written as they lie in memory");

// NumPy's file of an array of doubles in C order, format 1.0: magic, version, length of the header, the
// header padded with blanks so that the data begin at a multiple of 64 bytes.
std::string npy(const std::vector<double>& values, const std::string& shape) {
  constexpr std::size_t before_header = 10, alignment = 64;
  std::string header = fmt::format("{{'descr': '<f8', 'fortran_order': False, 'shape': {}, }}", shape);
  header.append(alignment - 1 - (before_header + header.size()) % alignment, ' ').push_back('\n');
  std::string file = std::string("\x93NUMPY\1\0", 8);
  file.push_back(static_cast<char>(header.size() & 0xff));
  file.push_back(static_cast<char>(header.size() >> 8));
  file += header;
  const std::size_t begin = file.size();
  file.resize(begin + values.size() * sizeof(double));
  if (!values.empty()) std::memcpy(file.data() + begin, values.data(), values.size() * sizeof(double));
  return file;
}

std::string vector_npy(const std::vector<double>& values) {
  return npy(values, fmt::format("({},)", values.size()));
}

std::string matrix_npy(const Eigen::Matrix4d& matrix) {
  std::vector<double> values;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) values.push_back(matrix(i, j));
  return npy(values, "(4, 4)");
}

std::vector<double> travelled(const Trajectory& trajectory) {
  std::vector<double> along(trajectory.size(), 0.0);
  for (std::size_t i = 1; i < trajectory.size(); ++i)
    along[i] = along[i - 1] + (trajectory.world_from_cam[i].t - trajectory.world_from_cam[i - 1].t).norm();
  return along;
}

std::vector<double> since_start(std::vector<double> times) {
  const double start = times.empty() ? 0 : times.front();
  for (double& t : times) t -= start;
  return times;
}

// The last `count`: of relative errors the first pose has none.
std::vector<double> last(const std::vector<double>& values, std::size_t count) {
  return {values.end() - static_cast<std::ptrdiff_t>(count), values.end()};
}

std::string kitti_line(const Pose& pose) {
  std::string line;
  for (int i = 0; i < 3; ++i)
    line +=
        fmt::format("{}{} {} {} {}", i > 0 ? " " : "", pose.R(i, 0), pose.R(i, 1), pose.R(i, 2), pose.t[i]);
  return line + "\n";
}

ZipEntry trajectory_entry(const std::string& name, const Trajectory& trajectory, bool has_times) {
  std::string text;
  for (std::size_t i = 0; i < trajectory.size(); ++i)
    text += has_times ? tum_line(trajectory.times[i], trajectory.world_from_cam[i]) + "\n"
                      : kitti_line(trajectory.world_from_cam[i]);
  return {name + (has_times ? ".tum" : ".kitti"), text};
}

void check(const EvoResult& result) {
  const std::size_t poses = result.estimate.size(), errors = result.errors.size();
  if (result.reference.size() != poses || (poses != errors && poses != errors + 1))
    throw std::invalid_argument(fmt::format(
        "evo result: {} poses of the reference, {} of the estimate and {} errors, expected as many "
        "poses of both, one for each error or one more",
        result.reference.size(), poses, errors));
}

}  // namespace

void write_evo_result(const std::filesystem::path& path, const EvoResult& result, const char* option) {
  check(result);
  using Json = nlohmann::ordered_json;
  const Json info = {{"title", result.title},
                     {"ref_name", result.reference_name},
                     {"est_name", result.estimate_name},
                     {"label", result.label}};
  Json stats;
  for (const auto& [name, value] : result.statistics) stats[name] = value;

  const std::size_t count = result.errors.size();
  const auto& times = result.estimate.times;
  std::vector<ZipEntry> entries = {{"info.json", info.dump(-1, ' ', false, Json::error_handler_t::replace)},
                                   {"stats.json", stats.dump()}};
  entries.push_back({"error_array.npy", vector_npy(result.errors)});
  if (result.has_times) {
    entries.push_back({"seconds_from_start.npy", vector_npy(last(since_start(times), count))});
    entries.push_back({"timestamps.npy", vector_npy(last(times, count))});
    entries.push_back({"distances_from_start.npy", vector_npy(last(travelled(result.reference), count))});
    entries.push_back({"distances.npy", vector_npy(last(travelled(result.estimate), count))});
  }
  if (result.alignment)
    entries.push_back({"alignment_transformation_sim3.npy", matrix_npy(*result.alignment)});
  entries.push_back(trajectory_entry(result.reference_name, result.reference, result.has_times));
  entries.push_back(trajectory_entry(result.estimate_name, result.estimate, result.has_times));
  write_zip(path, entries, option);
}

}  // namespace framewise
