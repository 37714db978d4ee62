// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <filesystem>
#include <fstream>
#include <limits>
#include <opencv2/imgproc.hpp>
#include <string>
#include <vector>

#include "framewise/geometry/camera.h"
#include "framewise/geometry/trajectory.h"
#include "framewise/image/depth.h"
#include "framewise/image/frame.h"
#include "framewise/io/dataset.h"
#include "framewise/io/image_files.h"
#include "framewise/simulation/simulate.h"

// Images with true depth and true poses, to judge features by.
namespace framewise::bench {

struct View {
  cv::Mat gray, depth;  // as in Frame, registered
  Pose world_from_cam;
};

struct Views {
  std::string name;
  Camera camera;
  std::vector<View> views;

  Pose cam2_from_cam1(std::size_t i1, std::size_t i2) const {
    return views[i2].world_from_cam.inverse() * views[i1].world_from_cam;
  }

  // Where a pixel of one view is in another; empty where its depth is unknown or the other does not see it.
  std::optional<Eigen::Vector2d> seen_in(std::size_t i1, const cv::Point2f& pixel1, std::size_t i2) const {
    const Eigen::Vector2d pixel(pixel1.x, pixel1.y);
    const auto bearing = camera.bearing(pixel);
    const auto z = depth_at(views[i1].depth, pixel, {});
    if (!bearing || !z) return std::nullopt;
    const auto there = camera.project(cam2_from_cam1(i1, i2) * Eigen::Vector3d(*z / bearing->z() * *bearing));
    return there && camera.contains(*there) ? there : std::nullopt;
  }
};

// The simulated room, so many frames of its hand-held path.
inline Views room_views(int frames) {
  SimulateOptions options;
  options.frames = frames;
  Views room{"room", sensor_of(options).camera, {}};
  simulate(options, [&](const SimulatedFrame& f) {
    room.views.push_back({f.frame.gray, f.frame.depth, f.world_from_cam});
    return true;
  });
  return room;
}

inline Views tum_views(const std::filesystem::path& folder) {
  const Dataset dataset = open_dataset(folder, {});
  Views tum{dataset.name, dataset.calibration.camera, {}};
  for (std::size_t i = 0; i < dataset.frames.size(); ++i) {
    const auto pose = pose_at(dataset.truth, dataset.frames[i].time, 0.1);
    const Frame frame = load_frame(dataset, i);
    if (pose && !frame.depth.empty()) tum.views.push_back({frame.gray, frame.depth, *pose});
  }
  return tum;
}

// Depth as the colour camera of 7-Scenes would have it: the depth camera (f 585) stands 25 mm beside.
inline cv::Mat seven_scenes_depth(const cv::Mat& raw, const Camera& color) {
  cv::Mat depth(raw.size(), CV_32F, cv::Scalar(std::numeric_limits<float>::quiet_NaN()));
  for (int v = 0; v < raw.rows; ++v)
    for (int u = 0; u < raw.cols; ++u) {
      const std::uint16_t mm = raw.at<std::uint16_t>(v, u);
      if (mm == 0 || mm == 65535) continue;
      const double z = mm / 1000.0;
      const cv::Point at(cvRound(color.fx * ((u - 320) / 585.0 - 0.025 / z) + color.cx),
                         cvRound(color.fy * (v - 240) / 585.0 + color.cy));
      if (!cv::Rect(0, 0, depth.cols, depth.rows).contains(at)) continue;
      float& nearest = depth.at<float>(at);
      if (!(nearest <= z)) nearest = static_cast<float>(z);
    }
  return depth;
}

inline Views seven_scenes_views(const std::filesystem::path& folder) {
  Views scenes{"7scenes", {CameraModel::kPinhole, 640, 480, 525, 525, 321, 237, {}, {}}, {}};
  const Pose depth_from_color{Eigen::Matrix3d::Identity(), Eigen::Vector3d(0.025, 0, 0)};
  for (int i = 0;; ++i) {
    std::string number = std::to_string(i);
    const std::string stem = (folder / ("frame-" + std::string(6 - number.size(), '0') + number)).string();
    std::ifstream file(stem + ".pose.txt");
    if (!file) return scenes;
    Eigen::Matrix4d m;
    for (int k = 0; k < 16; ++k) file >> m(k / 4, k % 4);
    const Pose world_from_depth{m.topLeftCorner<3, 3>(), m.topRightCorner<3, 1>()};
    scenes.views.push_back({read_gray(stem + ".color.jpg"),
                            seven_scenes_depth(read_depth_file(stem + ".depth.png"), scenes.camera),
                            world_from_depth * depth_from_color});
  }
}

// The room, and those recordings of the folder that exist.
inline std::vector<Views> all_views(const std::filesystem::path& data) {
  std::vector<Views> all{room_views(60)};
  if (std::filesystem::exists(data / "tum_fr1_rpy_000_080"))
    all.push_back(tum_views(data / "tum_fr1_rpy_000_080"));
  if (std::filesystem::exists(data / "7scenes_redkitchen_000_150"))
    all.push_back(seven_scenes_views(data / "7scenes_redkitchen_000_150"));
  return all;
}

}  // namespace framewise::bench
