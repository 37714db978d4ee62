// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/io/tum_layout.h"

#include <fmt/format.h>

#include <algorithm>

#include "framewise/io/file_lists.h"
#include "framewise/io/file_names.h"
#include "framewise/io/frame_times.h"
#include "framewise/io/input_error.h"
#include "framewise/io/trajectory_files.h"

namespace framewise {
namespace {

namespace fs = std::filesystem;

std::vector<double> times_of(const std::vector<ListedFile>& files) {
  std::vector<double> times;
  for (const ListedFile& file : files) times.push_back(file.time);
  return times;
}

void add_associated(Dataset& dataset, const fs::path& list, Fingerprint& fingerprint) {
  for (const AssociatedFiles& pair : read_association_list(list)) {
    const auto path_of = [&](const ListedFile& listed) {
      return existing_file(dataset.folder, listed.file, listed.time, fingerprint, list, listed.line);
    };
    FrameFiles frame{pair.color.time, path_of(pair.color), {}, pair.depth.time - pair.color.time};
    frame.depth = path_of(pair.depth);
    dataset.frames.push_back(std::move(frame));
  }
}

// A list, and where it is written down.
struct Listing {
  fs::path list;
  std::vector<ListedFile> files;
};

// Colour and depth that are close in time are a frame.
void add_by_time(Dataset& dataset, const Listing& color, const Listing& depth, double max_difference,
                 Fingerprint& fingerprint) {
  const auto& colors = color.files;
  const auto& depths = depth.files;
  const auto partner = associate_by_time(times_of(colors), times_of(depths), max_difference);
  const auto matched = std::count_if(partner.begin(), partner.end(), [](int j) { return j >= 0; });
  if (!depths.empty() && matched == 0)
    throw InputError(depth.list, 0, "",
                     fmt::format("times {} to {} s", depths.front().time, depths.back().time),
                     fmt::format("times within {} s of {}'s, {} to {} s", max_difference,
                                 color.list.filename().string(), colors.front().time, colors.back().time));
  dataset.unmatched_depth = depths.size() - static_cast<std::size_t>(matched);
  const auto path_of = [&](const Listing& listing, const ListedFile& listed) {
    return existing_file(dataset.folder, listed.file, listed.time, fingerprint, listing.list, listed.line);
  };
  for (std::size_t i = 0; i < colors.size(); ++i) {
    FrameFiles frame{colors[i].time, path_of(color, colors[i]), {}, 0};
    if (partner[i] >= 0) {
      const ListedFile& listed = depths[static_cast<std::size_t>(partner[i])];
      frame.depth = path_of(depth, listed);
      frame.depth_delay = listed.time - frame.time;
    }
    dataset.frames.push_back(std::move(frame));
  }
}

bool is_named_by_stamps(const fs::path& folder) {
  const auto names = files_in(folder, image_extensions());
  return !names.empty() && stamp_in(names.front());
}

// A folder's files as if a list named them by their stamps.
Listing list_of_folder(const fs::path& folder) {
  Listing listing{folder, {}};
  std::vector<int> lines;
  for (const std::string& name : files_in(folder, image_extensions())) {
    const auto stamp = stamp_in(name);
    if (!stamp)
      throw InputError(folder, 0, "", "'" + name + "'",
                       "files called by their stamps (seconds), or " + folder.filename().string() + ".txt");
    listing.files.push_back({*stamp, folder.filename().string() + "/" + name, 0});
  }
  std::sort(listing.files.begin(), listing.files.end(),
            [](const ListedFile& a, const ListedFile& b) { return a.time < b.time; });
  lines.assign(listing.files.size(), 0);
  if (!listing.files.empty()) check_seconds(folder, times_of(listing.files), lines);
  return listing;
}

Listing listing_of(const fs::path& folder, const char* name, bool required) {
  const fs::path list = folder / (std::string(name) + ".txt");
  if (fs::exists(list) || (required && !fs::is_directory(folder / name))) return {list, read_file_list(list)};
  Listing listing = list_of_folder(folder / name);
  if (required && listing.files.empty()) throw InputError(folder / name, 0, "", "no images", "some");
  return listing;
}

}  // namespace

fs::path association_file(const fs::path& folder) {
  return first_existing(folder, {"associations.txt", "association.txt", "associate.txt"});
}

bool has_tum_layout(const fs::path& folder) {
  return fs::exists(folder / "rgb.txt") || !association_file(folder).empty() ||
         (fs::is_directory(folder / "rgb") && is_named_by_stamps(folder / "rgb") &&
          !fs::exists(folder / "poses.txt"));
}

void read_tum_frames(Dataset& dataset, double max_time_difference) {
  Fingerprint fingerprint;
  const fs::path associations = association_file(dataset.folder);
  if (!associations.empty()) {
    add_associated(dataset, associations, fingerprint);
    dataset.times_source = associations.filename().string();
  } else {
    const Listing color = listing_of(dataset.folder, "rgb", true);
    add_by_time(dataset, color, listing_of(dataset.folder, "depth", false), max_time_difference, fingerprint);
    dataset.times_source = fs::is_directory(color.list) ? "the files' names" : "rgb.txt";
  }
  dataset.fingerprint = fingerprint.text();
}

void read_tum_truth(Dataset& dataset, const fs::path& file) {
  if (file.empty() || !fs::exists(file)) return;
  const TrajectoryFile read = read_trajectory(file, TrajectoryFormat::kTum);
  dataset.truth = read.trajectory;
  dataset.truth_norm_error = read.norm_error;
  dataset.truth_source = file.filename().string();
  check_truth(file, dataset.truth, dataset.frames);
}

}  // namespace framewise
