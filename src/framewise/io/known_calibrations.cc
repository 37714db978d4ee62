// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include <array>

#include "framewise/io/camera_file.h"

namespace framewise {
namespace {

CameraFile pinhole(int width, int height, double fx, double fy, double cx, double cy,
                   const std::array<double, 5>& distortion, double depth_factor) {
  CameraFile file;
  file.camera = {CameraModel::kPinhole, width, height, fx, fy, cx, cy, distortion};
  file.depth_factor = depth_factor;
  return file;
}

// Shotton et al., Scene coordinate regression forests, CVPR 2013: the depth camera's 585 585 320 240.
CameraFile seven_scenes_depth() { return pinhole(640, 480, 585, 585, 320, 240, {}, 1000); }

// The colour camera, fitted to RedKitchen: u = 525 (X - 0.025) / Z + 321, v = 525 Y / Z + 237.
CameraFile seven_scenes() {
  CameraFile file = pinhole(640, 480, 525, 525, 321, 237, {}, 1000);
  file.depth_camera = {seven_scenes_depth().camera, {Eigen::Matrix3d::Identity(), {-0.025, 0, 0}}};
  return file;
}

}  // namespace

std::optional<CameraFile> known_calibration(const std::string& name) {
  // Sturm et al., A benchmark for the evaluation of RGB-D SLAM systems, IROS 2012; values of its web page.
  if (name == "freiburg1")
    return pinhole(640, 480, 517.3, 516.5, 318.6, 255.3, {0.2624, -0.9531, -0.0054, 0.0026, 1.1633}, 5000);
  if (name == "freiburg2")
    return pinhole(640, 480, 520.9, 521.0, 325.1, 249.7, {0.2312, -0.7849, -0.0033, -0.0001, 0.9172}, 5000);
  if (name == "freiburg3") return pinhole(640, 480, 535.4, 539.2, 320.1, 247.6, {}, 5000);
  // Kraft et al., Toward evaluation of visual navigation algorithms on RGB-D data from the first- and
  // second-generation Kinect, 2017.
  if (name == "putkk-kinect1")
    return pinhole(640, 480, 532.7725, 531.85745, 312.23007, 260.11708,
                   {0.16054, -0.24682, 0.00136, 0.00149, 0}, 1000);
  if (name == "putkk-kinect2")
    return pinhole(1920, 1080, 1078.68499, 1076.47426, 952.65923, 530.73866,
                   {0.027128, -0.0038764, -0.00037827, -0.0024099, 0.058628}, 1000);
  // Handa et al., A benchmark for RGB-D visual odometry, 3D reconstruction and SLAM, ICRA 2014; its fy is
  // -480.
  if (name == "icl-nuim") return pinhole(640, 480, 481.20, 480, 319.5, 239.5, {}, 5000);
  if (name == "7-scenes") return seven_scenes();
  if (name == "7-scenes-depth") return seven_scenes_depth();
  return std::nullopt;
}

}  // namespace framewise
