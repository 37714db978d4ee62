// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
// PUTKK: the TUM benchmark's layout, millimetres, one of two cameras.
//   Kraft et al., Toward evaluation of visual navigation algorithms on RGB-D data from the first- and
//   second-generation Kinect, Machine Vision and Applications 2017.
#include "framewise/io/dataset_reader.h"
#include "framewise/io/file_names.h"
#include "framewise/io/tum_layout.h"

namespace framewise {
namespace {

namespace fs = std::filesystem;

std::string recognise_putkk(const fs::path& folder) {
  const std::string name = folder_name(folder);
  const bool named = lower_case(name).find("putkk") != std::string::npos;
  return named && has_tum_layout(folder) ? "its name, " + name + ", says putkk" : "";
}

// The folder is named by its Kinect, as in putkk_Dataset_1_Kin_1; else the images' size tells it.
std::string kinect_of(const Dataset& dataset) {
  const std::string name = lower_case(folder_name(dataset.folder));
  for (const char* number : {"1", "2"})
    for (const char* kinect : {"kin_", "kin", "kinect_", "kinect"})
      if (name.ends_with(std::string(kinect) + number)) return std::string("putkk-kinect") + number;
  return image_size(dataset.frames.front().color).first == 1920 ? "putkk-kinect2" : "putkk-kinect1";
}

Dataset open_putkk(const fs::path& folder, const DatasetOptions& options) {
  expect_folder(folder, "a data set of PUTKK");
  Dataset dataset = dataset_of(folder);
  read_tum_frames(dataset, options.max_time_difference);
  CameraFile millimetres;
  millimetres.depth_factor = 1000;
  calibrate(
      dataset, options, millimetres,
      [&] {
        const std::string name = kinect_of(dataset);
        return NamedCalibration(*known_calibration(name), name);
      },
      "");
  read_tum_truth(dataset, folder / "groundtruth.txt");
  return dataset;
}

}  // namespace

DatasetReader putkk_reader() {
  return {"putkk", "a name with putkk, rgb and depth folders", recognise_putkk, open_putkk};
}

}  // namespace framewise
