// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/io/correspondence_archive_writer.h"

#include <fmt/format.h>

#include <cstdint>
#include <limits>
#include <stdexcept>

#include "framewise/io/correspondence_archive_layout.h"
#include "framewise/io/input_error.h"

namespace framewise {
namespace {

namespace fs = std::filesystem;
using hdf5::Handle;
using hdf5::Number;
using hdf5::Table;

archive_layout::PoseRow row_of(const std::optional<Pose>& pose) {
  archive_layout::PoseRow row;
  row.fill(std::numeric_limits<double>::quiet_NaN());
  if (pose)
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 4; ++j) row[4 * i + j] = j < 3 ? pose->R(i, j) : pose->t[i];
  return row;
}

void write_camera(const Handle& group, const ArchiveProvenance& provenance) {
  const Camera& camera = provenance.calibration.camera;
  hdf5::write_text(group, "source", provenance.calibration_source);
  hdf5::write_text(group, "model", name_of(camera.model));
  hdf5::write_numbers(group, "size", std::array<double, 2>{double(camera.width), double(camera.height)});
  hdf5::write_numbers(group, "intrinsics", std::array<double, 4>{camera.fx, camera.fy, camera.cx, camera.cy});
  hdf5::write_numbers(group, "distortion", camera.distortion);
  hdf5::write_numbers(group, "theta_range", camera.theta_range);
  hdf5::write_numbers(
      group, "depth_scale",
      std::array<double, 2>{provenance.calibration.depth_factor, provenance.calibration.depth_max});
}

void write_provenance(const Handle& root, const ArchiveProvenance& provenance) {
  hdf5::write_text(root, "format", archive_layout::kFormat);
  hdf5::write_text(root, "format_version", archive_layout::kFormatVersion);
  hdf5::write_text(root, "framewise", provenance.framewise_version);
  const Handle recording = hdf5::create_group(root, "recording");
  hdf5::write_text(recording, "name", provenance.dataset_name);
  hdf5::write_text(recording, "format", provenance.dataset_format);
  hdf5::write_text(recording, "fingerprint", provenance.dataset_fingerprint);
  hdf5::write_numbers(recording, "frames_with_depth",
                      std::array<double, 1>{double(provenance.frames_with_depth)});
  write_camera(hdf5::create_group(root, "camera"), provenance);
  const Handle options = hdf5::create_group(root, "options");
  for (const auto& [name, value] : provenance.options) hdf5::write_text(options, name, value);
}

// A typing error must not cost a file of another kind.
void check_replaceable(const fs::path& file) {
  if (fs::exists(file) && !(fs::is_regular_file(file) && H5Fis_hdf5(file.c_str()) > 0))
    throw InputError(file, 0, "", "something that is no archive", "a file to create (--archive)");
}

}  // namespace

// What is open; the file is closed last.
struct CorrespondenceArchiveWriter::Tables {
  explicit Tables(Handle open_file) : file(std::move(open_file)) {
    const Handle frames = hdf5::create_group(file, "frames"), pairs = hdf5::create_group(file, "pairs");
    times = Table::create(frames, "time", Number::kDouble, 1);
    truth = Table::create(frames, "world_from_cam", Number::kDouble, 12);
    pair_frames = Table::create(pairs, "frames", Number::kUnsigned64, 2);
    pair_ends = Table::create(pairs, "end", Number::kUnsigned64, 1);
    pair_depth = Table::create(pairs, "has_depth", Number::kUnsigned8, 1);
    matches = archive_layout::make_match_tables(hdf5::create_group(file, "matches"), Table::create);
  }

  Handle file;
  Table times, truth, pair_frames, pair_ends, pair_depth;
  archive_layout::MatchTables matches;
  std::uint64_t end = 0;  // of the last pair's matches
};

CorrespondenceArchiveWriter::CorrespondenceArchiveWriter(const fs::path& file,
                                                         const ArchiveProvenance& provenance)
    : file_(file), unfinished_(file.string() + ".part") {
  const hdf5::Session session;
  check_replaceable(file);
  try {
    auto tables = std::make_unique<Tables>(hdf5::create_file(unfinished_));
    write_provenance(tables->file, provenance);
    tables_ = std::move(tables);
  } catch (const hdf5::Failure&) {
    throw InputError(file, 0, "", "a file that cannot be written", "a file to create (--archive)");
  }
  fs::remove(file);
}

CorrespondenceArchiveWriter::~CorrespondenceArchiveWriter() {
  const hdf5::Session session;
  tables_.reset();
  std::error_code ignored;
  if (!finished_) fs::remove(unfinished_, ignored);
}

void CorrespondenceArchiveWriter::write(const std::function<void(Tables&)>& what) {
  const hdf5::Session session;
  try {
    what(*tables_);
  } catch (const hdf5::Failure&) {
    throw std::runtime_error(file_.string() + ": writing failed (is the disk full?)");
  }
}

void CorrespondenceArchiveWriter::add_frame(const ArchivedFrame& frame) {
  const auto truth = row_of(frame.world_from_cam);
  write([&](Tables& tables) {
    tables.times.append(&frame.time, 1);
    tables.truth.append(truth.data(), 1);
  });
}

void CorrespondenceArchiveWriter::add_pair(std::size_t index1, std::size_t index2,
                                           const Correspondences& shared) {
  archive_layout::each_column(shared, [&](const char* name, const auto& column) {
    if (column.size() != shared.size())
      throw std::invalid_argument(
          fmt::format("{}: found {} rows, expected {} as in x1", name, column.size(), shared.size()));
  });
  const std::array<std::uint64_t, 2> frames = {index1, index2};
  const std::uint8_t has_depth = shared.has_depth;
  write([&](Tables& tables) {
    archive_layout::each_column(shared, [&, i = 0](const char*, const auto& column) mutable {
      tables.matches[i++].append(column.data(), column.size());
    });
    tables.end += shared.size();
    tables.pair_frames.append(frames.data(), 1);
    tables.pair_ends.append(&tables.end, 1);
    tables.pair_depth.append(&has_depth, 1);
  });
}

void CorrespondenceArchiveWriter::finish() {
  write([&](Tables& tables) {
    hdf5::write_text(tables.file, "complete", "yes");
    hdf5::flush(tables.file);
    Handle file = std::move(tables.file);
    tables_.reset();
    file.close("file");
  });
  fs::rename(unfinished_, file_);
  finished_ = true;
}

}  // namespace framewise
