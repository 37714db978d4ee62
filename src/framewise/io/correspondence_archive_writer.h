// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <functional>
#include <memory>

#include "framewise/io/correspondence_archive.h"

namespace framewise {

// Writes an archive while a recording is run through: memory does not grow with it, and the same calls give
// the same bytes. What is being written is called FILE.part and gets its name by finish(); a run that breaks
// off leaves no archive, neither its own nor an older one of that name. Failures to write throw
// std::runtime_error naming the file.
class CorrespondenceArchiveWriter {
 public:
  // Throws InputError where the file cannot be made, or is there and is no HDF5 file.
  CorrespondenceArchiveWriter(const std::filesystem::path& file, const ArchiveProvenance& provenance);
  CorrespondenceArchiveWriter(const CorrespondenceArchiveWriter&) = delete;
  CorrespondenceArchiveWriter& operator=(const CorrespondenceArchiveWriter&) = delete;
  ~CorrespondenceArchiveWriter();

  void add_frame(const ArchivedFrame& frame);
  // index1 < index2. Throws std::invalid_argument where the vectors differ in length.
  void add_pair(std::size_t index1, std::size_t index2, const Correspondences& shared);
  void finish();

 private:
  struct Tables;
  void write(const std::function<void(Tables&)>& what);

  std::filesystem::path file_, unfinished_;
  std::unique_ptr<Tables> tables_;
  bool finished_ = false;
};

}  // namespace framewise
