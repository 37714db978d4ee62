// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "framewise/geometry/correspondences.h"
#include "framewise/io/camera_file.h"

// The correspondences of a recording's frame pairs in one HDF5 file: matched once, solved many times.
//   /           format, format_version, framewise (the version that wrote it), complete
//   /recording  name, format, fingerprint; frames_with_depth
//   /camera     source, model; size, intrinsics (fx fy cx cy), distortion (5), theta_range,
//               depth_scale (factor, max)
//   /options    a text for each option that shaped features and matches, named as on the command line
//   /frames     time (s); world_from_cam: rows of the 3 x 4 matrix [R t], the truth, NaN where unknown
//   /pairs      frames: the two indices; end: the pair's matches end before this row of /matches and begin
//               where those of the pair before end; has_depth
//   /matches    pixels1, pixels2, x1, x2, z1, z2, sigma1, sigma2, distance: as in Correspondences
// The first four lines are attributes, the others tables (rows x columns, little-endian). All neighbours (i,
// i + 1) are there, and the pairs that bridged a loss in the run that wrote it.
namespace framewise {

// Where an archive's matches come from.
struct ArchiveProvenance {
  std::string framewise_version;
  std::string dataset_name, dataset_format, dataset_fingerprint;
  std::size_t frames_with_depth = 0;
  CameraFile calibration;
  std::string calibration_source;
  std::map<std::string, std::string> options;
};

struct ArchivedFrame {
  double time = 0;                     // s
  std::optional<Pose> world_from_cam;  // the truth
};

// Reads an archive pair by pair.
class CorrespondenceArchive {
 public:
  // Throws InputError where the file is no archive, is cut short or was never finished.
  explicit CorrespondenceArchive(const std::filesystem::path& file);
  ~CorrespondenceArchive();

  const ArchiveProvenance& provenance() const { return provenance_; }
  const std::vector<ArchivedFrame>& frames() const { return frames_; }
  std::size_t num_pairs() const { return pairs_.size(); }

  // Empty where the archive does not hold the pair. May be called from any thread. Throws InputError where
  // the matches cannot be read.
  std::optional<Correspondences> pair(std::size_t index1, std::size_t index2) const;

 private:
  struct Tables;
  struct Rows {
    std::size_t first, count;  // of the match tables
    bool has_depth;
  };
  void read_frames(const Tables& tables);
  void read_pairs(const Tables& tables);

  std::filesystem::path file_;
  ArchiveProvenance provenance_;
  std::vector<ArchivedFrame> frames_;
  std::map<std::pair<std::size_t, std::size_t>, Rows> pairs_;
  std::unique_ptr<Tables> tables_;
};

}  // namespace framewise
