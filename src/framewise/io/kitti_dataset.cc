// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
// KITTI odometry: a sequence's folder with calib.txt, times.txt and images of one camera of its four.
//   Geiger, Lenz, Urtasun, Are we ready for autonomous driving?, CVPR 2012.
#include <fmt/format.h>

#include <fstream>
#include <sstream>

#include "framewise/io/dataset_parts.h"
#include "framewise/io/dataset_reader.h"
#include "framewise/io/file_names.h"
#include "framewise/io/frame_times.h"
#include "framewise/io/input_error.h"
#include "framewise/io/trajectory_files.h"

namespace framewise {
namespace {

namespace fs = std::filesystem;

constexpr double kKittiRate = 10;
constexpr double kDepthFactor = 256, kDepthMax = 200;  // raw units in a metre; the LiDAR's reach (m)

struct KittiCamera {
  CameraFile file;
  Pose cam_from_cam0;
};

using Projection = Eigen::Matrix<double, 3, 4, Eigen::RowMajor>;

// The line "P0: 12 numbers" of calib.txt.
Projection read_projection(const fs::path& file, const std::string& name) {
  std::ifstream stream(file);
  if (!stream) throw InputError(file, 0, "", "no file", "KITTI's calib.txt");
  std::string line;
  for (std::size_t number = 1; std::getline(stream, line); ++number) {
    if (!line.starts_with(name + ":")) continue;
    std::istringstream text(line.substr(name.size() + 1));
    Projection P;
    int found = 0;
    while (found < 12 && text >> P.data()[found]) ++found;
    std::string rest;
    if (found < 12 || text >> rest)
      throw InputError(file, number, name, fmt::format("{} numbers", found + (rest.empty() ? 0 : 1)),
                       "12 numbers, a 3x4 matrix");
    return P;
  }
  throw InputError(file, 0, name, "nothing", "a line '" + name + ": 12 numbers'");
}

// Rectified cameras: P = K [I | t], with cam_from_cam0 = (I, t).
KittiCamera read_kitti_camera(const fs::path& file, const std::string& name, int width, int height) {
  const Projection P = read_projection(file, name);
  const Eigen::Matrix3d K = P.leftCols<3>();
  KittiCamera found;
  found.file.camera = {CameraModel::kPinhole, width, height, K(0, 0), K(1, 1), K(0, 2), K(1, 2), {}, {}};
  try {
    found.file.camera.check();
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(fmt::format("{}: {}: {}", file.string(), name, error.what()));
  }
  found.file.depth_factor = kDepthFactor;
  found.file.depth_max = kDepthMax;
  found.cam_from_cam0.t = K.inverse() * P.col(3);
  return found;
}

fs::path image_folder(const fs::path& folder) {
  for (const char* name : {"image_0", "image_2", "image_1", "image_3"})
    if (fs::is_directory(folder / name)) return folder / name;
  return {};
}

std::string recognise_kitti(const fs::path& folder) {
  const fs::path images = image_folder(folder);
  if (images.empty() || !fs::exists(folder / "calib.txt")) return "";
  return fmt::format("it has {} and calib.txt", images.filename().string());
}

// Depth images that are called as the colour images are: beside those, or where the depth benchmark has them.
fs::path kitti_depth_folder(const fs::path& folder) {
  return first_existing(folder,
                        {"depth", "proj_depth/velodyne_raw/image_02", "proj_depth/groundtruth/image_02"});
}

// poses.txt beside the images, or poses/NN.txt beside the folder sequences/NN.
fs::path poses_file(const fs::path& folder) {
  if (fs::exists(folder / "poses.txt")) return folder / "poses.txt";
  const fs::path whole = whole_path(folder);
  const fs::path apart = whole.parent_path().parent_path() / "poses" / (whole.filename().string() + ".txt");
  return fs::exists(apart) ? apart : fs::path();
}

void read_kitti_truth(Dataset& dataset, const Pose& cam_from_cam0) {
  const fs::path file = poses_file(dataset.folder);
  if (file.empty()) return;
  const Trajectory poses = read_trajectory(file, TrajectoryFormat::kKitti).trajectory;
  if (poses.size() != dataset.frames.size())
    throw InputError(file, 0, "poses", std::to_string(poses.size()),
                     fmt::format("{}, one for each image", dataset.frames.size()));
  const bool moved = !cam_from_cam0.t.isZero(0);
  for (std::size_t i = 0; i < poses.size(); ++i)
    dataset.truth.add(dataset.frames[i].time,
                      moved ? poses.world_from_cam[i] * cam_from_cam0.inverse() : poses.world_from_cam[i]);
  dataset.truth_source = file.filename().string();
}

Dataset open_kitti(const fs::path& folder, const DatasetOptions& options) {
  expect_folder(folder, "a sequence of KITTI odometry");
  const fs::path images = image_folder(folder);
  const auto names = files_in(images, image_extensions());
  if (names.empty()) throw InputError(folder, 0, "", "no images in image_0", "a sequence of KITTI odometry");
  Dataset dataset = dataset_of(folder);
  const std::string projection = fmt::format("P{}", images.filename().string().back());
  KittiCamera camera;
  camera.file.depth_factor = kDepthFactor;
  camera.file.depth_max = kDepthMax;
  const bool calibrated = fs::exists(folder / "calib.txt");
  if (calibrated) {
    const auto [width, height] = image_size(images / names.front());
    camera = read_kitti_camera(folder / "calib.txt", projection, width, height);
  }
  calibrate(
      dataset, options, camera.file,
      [&] {
        return calibrated ? std::optional(NamedCalibration(camera.file, "calib.txt, " + projection))
                          : std::nullopt;
      },
      "calib.txt");

  const FrameTimes times = frame_times(folder / "times.txt", names, options.fps, kKittiRate);
  dataset.times_source = times.source;
  const fs::path depths = kitti_depth_folder(folder);
  Fingerprint fingerprint;
  for (std::size_t i = 0; i < names.size(); ++i) {
    FrameFiles frame{times.times[i], existing_file(images, names[i], times.times[i], fingerprint), {}, 0};
    const std::string depth = std::string(stem_of(names[i])) + ".png";
    if (!depths.empty() && fs::exists(depths / depth))
      frame.depth = existing_file(depths, depth, times.times[i], fingerprint);
    dataset.frames.push_back(std::move(frame));
  }
  dataset.fingerprint = fingerprint.text();
  read_kitti_truth(dataset, camera.cam_from_cam0);
  return dataset;
}

}  // namespace

DatasetReader kitti_reader() {
  return {"kitti", "image_0 and calib.txt, with times.txt and poses.txt", recognise_kitti, open_kitti};
}

}  // namespace framewise
