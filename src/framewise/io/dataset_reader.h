// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "framewise/io/dataset.h"

namespace framewise {

// One layout of recordings. Inside the room alone; a reader fills in all that its files say, open_dataset()
// the rest.
struct DatasetReader {
  const char* name;    // as --format takes it
  const char* layout;  // what it is told by, in a few words
  // Why the path looks like this format: a sentence without its full stop. Empty where it does not.
  std::string (*recognise)(const std::filesystem::path& path);
  Dataset (*open)(const std::filesystem::path& path, const DatasetOptions& options);
};

DatasetReader euroc_reader();
DatasetReader kitti_reader();
DatasetReader kitti_depth_reader();
DatasetReader seven_scenes_reader();
DatasetReader icl_nuim_reader();
DatasetReader putkk_reader();
DatasetReader tum_reader();
DatasetReader blender_reader();
DatasetReader hololens_reader();
DatasetReader depth_reader();
DatasetReader images_reader();
DatasetReader video_reader();

}  // namespace framewise
