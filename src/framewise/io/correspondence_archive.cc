// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/io/correspondence_archive.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <new>
#include <stdexcept>

#include "framewise/io/correspondence_archive_layout.h"
#include "framewise/io/input_error.h"

namespace framewise {
namespace {

namespace fs = std::filesystem;
using hdf5::Handle;
using hdf5::Number;
using hdf5::Table;

template <typename T>
std::vector<T> whole(const Table& table) {
  std::vector<T> rows(table.rows());
  table.read(0, rows.size(), rows.data());
  return rows;
}

std::optional<Pose> pose_of(const archive_layout::PoseRow& row) {
  Pose pose;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 4; ++j) (j < 3 ? pose.R(i, j) : pose.t[i]) = row[4 * i + j];
  if (!pose.R.allFinite() || !pose.t.allFinite()) return std::nullopt;
  return pose;
}

void check_format(const fs::path& path, const Handle& root) {
  const auto names = hdf5::attribute_names(root);
  const auto has = [&](const char* name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  const auto require = [&](const char* name, const char* expected) {
    const std::string found = has(name) ? fmt::format("'{}'", hdf5::read_text(root, name)) : "nothing";
    if (found != fmt::format("'{}'", expected)) throw InputError(path, 0, name, found, expected);
  };
  require("format", archive_layout::kFormat);
  require("format_version", archive_layout::kFormatVersion);
  if (!has("complete"))
    throw InputError(path, 0, "", "an archive whose writing broke off", "a whole archive");
}

void read_camera(const fs::path& path, const Handle& group, ArchiveProvenance& provenance) {
  Camera& camera = provenance.calibration.camera;
  provenance.calibration_source = hdf5::read_text(group, "source");
  const auto model = camera_model_from_name(hdf5::read_text(group, "model"));
  if (!model) throw hdf5::Failure("model");
  camera.model = *model;
  const auto size = hdf5::read_numbers(group, "size", 2), f = hdf5::read_numbers(group, "intrinsics", 4),
             distortion = hdf5::read_numbers(group, "distortion", camera.distortion.size()),
             theta = hdf5::read_numbers(group, "theta_range", 2),
             depth = hdf5::read_numbers(group, "depth_scale", 2);
  camera.width = static_cast<int>(size[0]), camera.height = static_cast<int>(size[1]);
  camera.fx = f[0], camera.fy = f[1], camera.cx = f[2], camera.cy = f[3];
  std::copy(distortion.begin(), distortion.end(), camera.distortion.begin());
  camera.theta_range = {theta[0], theta[1]};
  provenance.calibration.depth_factor = depth[0], provenance.calibration.depth_max = depth[1];
  try {
    camera.check();
  } catch (const std::invalid_argument& error) {
    throw InputError(path, 0, "camera", error.what(), "a camera");
  }
}

ArchiveProvenance read_provenance(const fs::path& path, const Handle& root) {
  ArchiveProvenance provenance;
  provenance.framewise_version = hdf5::read_text(root, "framewise");
  const Handle recording = hdf5::open_group(root, "recording");
  provenance.dataset_name = hdf5::read_text(recording, "name");
  provenance.dataset_format = hdf5::read_text(recording, "format");
  provenance.dataset_fingerprint = hdf5::read_text(recording, "fingerprint");
  provenance.frames_with_depth =
      static_cast<std::size_t>(hdf5::read_numbers(recording, "frames_with_depth", 1)[0]);
  read_camera(path, hdf5::open_group(root, "camera"), provenance);
  const Handle options = hdf5::open_group(root, "options");
  for (const std::string& name : hdf5::attribute_names(options))
    provenance.options[name] = hdf5::read_text(options, name);
  return provenance;
}

}  // namespace

// What stays open; the file is closed last.
struct CorrespondenceArchive::Tables {
  Handle file;
  archive_layout::MatchTables matches;
};

CorrespondenceArchive::CorrespondenceArchive(const fs::path& file) : file_(file) {
  const hdf5::Session session;
  if (!fs::is_regular_file(file) || H5Fis_hdf5(file.c_str()) <= 0)
    throw InputError(file, 0, "", "no HDF5 file", "a correspondence archive (framewise run --archive)");
  try {
    auto tables = std::make_unique<Tables>();
    tables->file = hdf5::open_file(file);
    check_format(file, tables->file);
    provenance_ = read_provenance(file, tables->file);
    tables->matches =
        archive_layout::make_match_tables(hdf5::open_group(tables->file, "matches"), Table::open);
    read_frames(*tables);
    read_pairs(*tables);
    tables_ = std::move(tables);
  } catch (const hdf5::Failure& failure) {
    throw InputError(file, 0, failure.what(), "data that cannot be read",
                     "a whole archive (is it cut short?)");
  } catch (const std::bad_alloc&) {
    throw InputError(file, 0, "", "tables larger than the memory", "a correspondence archive");
  } catch (const std::length_error&) {
    throw InputError(file, 0, "", "tables larger than the memory", "a correspondence archive");
  }
}

CorrespondenceArchive::~CorrespondenceArchive() {
  const hdf5::Session session;
  tables_.reset();
}

void CorrespondenceArchive::read_frames(const Tables& tables) {
  const Handle group = hdf5::open_group(tables.file, "frames");
  const auto times = whole<double>(Table::open(group, "time", Number::kDouble, 1));
  const auto truth =
      whole<archive_layout::PoseRow>(Table::open(group, "world_from_cam", Number::kDouble, 12));
  if (truth.size() != times.size())
    throw InputError(file_, 0, "frames/world_from_cam", fmt::format("{} rows", truth.size()),
                     fmt::format("{} as in time", times.size()));
  for (std::size_t i = 0; i < times.size(); ++i) frames_.push_back({times[i], pose_of(truth[i])});
}

void CorrespondenceArchive::read_pairs(const Tables& tables) {
  const auto require = [&](bool holds, const char* field, const std::string& found, const char* expected) {
    if (!holds) throw InputError(file_, 0, field, found, expected);
  };
  const Handle group = hdf5::open_group(tables.file, "pairs");
  const auto frames =
      whole<std::array<std::uint64_t, 2>>(Table::open(group, "frames", Number::kUnsigned64, 2));
  const auto ends = whole<std::uint64_t>(Table::open(group, "end", Number::kUnsigned64, 1));
  const auto has_depth = whole<std::uint8_t>(Table::open(group, "has_depth", Number::kUnsigned8, 1));
  require(ends.size() == frames.size() && has_depth.size() == frames.size(), "pairs",
          fmt::format("{}, {} and {} rows", frames.size(), ends.size(), has_depth.size()),
          "the same number in each table");
  std::uint64_t first = 0;
  for (std::size_t k = 0; k < frames.size(); first = ends[k++]) {
    const auto [index1, index2] = frames[k];
    require(index1 < index2 && index2 < frames_.size(), "pairs/frames",
            fmt::format("{} and {} in row {}", index1, index2, k), "two frames in their order");
    require(first <= ends[k], "pairs/end", fmt::format("{} after {}", ends[k], first), "rows that increase");
    pairs_[{index1, index2}] = {first, ends[k] - first, has_depth[k] != 0};
  }
  for (const Table& table : tables.matches)
    require(table.rows() == first, "matches", fmt::format("{} rows", table.rows()),
            "as many as the pairs have in each table");
  for (std::size_t i = 1; i < frames_.size(); ++i)
    require(pairs_.contains({i - 1, i}), "pairs", fmt::format("none of frames {} and {}", i - 1, i),
            "all neighbours");
}

std::optional<Correspondences> CorrespondenceArchive::pair(std::size_t index1, std::size_t index2) const {
  const auto found = pairs_.find({index1, index2});
  if (found == pairs_.end()) return std::nullopt;
  const Rows& rows = found->second;
  Correspondences shared;
  shared.has_depth = rows.has_depth;
  const hdf5::Session session;
  try {
    archive_layout::each_column(shared, [&, i = 0](const char*, auto& column) mutable {
      column.resize(rows.count);
      tables_->matches[i++].read(rows.first, rows.count, column.data());
    });
  } catch (const hdf5::Failure& failure) {
    throw InputError(file_, 0, fmt::format("matches/{}", failure.what()),
                     fmt::format("data of frames {} and {} that cannot be read", index1, index2),
                     "a whole archive");
  }
  return shared;
}

}  // namespace framewise
