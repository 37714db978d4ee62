// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/io/camera_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "framewise/io/input_error.h"
#include "framewise/io/test_files_for_tests.h"

namespace framewise {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

fs::path camera_yaml(const std::string& text) {
  const fs::path path = test_file("camera.yaml");
  std::ofstream(path) << text;
  return path;
}

const std::string kPinhole = "width: 64\nheight: 48\nfx: 50\nfy: 51\ncx: 32\ncy: 24\n";

std::string refusal(const std::string& text) {
  try {
    read_camera_file(camera_yaml(text));
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(CameraFile, ReadsTheThreeModels) {
  EXPECT_EQ(read_camera_file(camera_yaml(kPinhole)).camera.model, CameraModel::kPinhole);
  const CameraFile fisheye =
      read_camera_file(camera_yaml("model: fisheye\ndistortion: [1, 2, 3, 4]\n" + kPinhole));
  EXPECT_EQ(fisheye.camera.model, CameraModel::kFisheye);
  EXPECT_EQ(fisheye.camera.distortion, (std::array<double, 5>{1, 2, 3, 4, 0}));
  const CameraFile sphere = read_camera_file(
      camera_yaml("model: equirectangular\nwidth: 64\nheight: 32\ntheta_range_deg: [45, 135]\n"));
  EXPECT_EQ(sphere.camera.model, CameraModel::kEquirectangular);
  EXPECT_NEAR(sphere.camera.theta_range[1], 0.75 * M_PI, 1e-12);
  EXPECT_EQ(sphere.depth_type, DepthType::kRange);
}

TEST(CameraFile, SaysHowDepthIsToBeRead) {
  const CameraFile plain = read_camera_file(camera_yaml(kPinhole));
  EXPECT_EQ(plain.depth_type, DepthType::kZ);
  EXPECT_EQ(plain.depth_factor, 5000);
  const CameraFile range = read_camera_file(camera_yaml(kPinhole + "depth_type: range\ndepth_max: 20\n"));
  EXPECT_EQ(range.depth_type, DepthType::kRange);
  EXPECT_DOUBLE_EQ(range.depth_factor, 65535.0 / 20);  // 16 bits from 0 to the maximum
  const CameraFile known =
      read_camera_file(camera_yaml(kPinhole + "depth_type: range\ndepth_max: 20\ndepth_factor: 256\n"));
  EXPECT_EQ(known.depth_factor, 256);
}

TEST(CameraFile, TakesWhatItLeavesOutFromTheCaller) {
  CameraFile otherwise;
  otherwise.depth_max = 99;
  otherwise.depth_factor = 256;
  EXPECT_EQ(read_camera_file(camera_yaml(kPinhole), otherwise).depth_max, 99);
  EXPECT_EQ(read_camera_file(camera_yaml(kPinhole), otherwise).depth_factor, 256);
  EXPECT_EQ(read_camera_file(camera_yaml(kPinhole + "depth_max: 5\n"), otherwise).depth_max, 5);
}

TEST(CameraFile, ReadsRosCameraInfo) {
  const Camera file =
      read_camera_file(
          camera_yaml(
              "image_width: 640\nimage_height: 480\ncamera_name: left\ncamera_matrix:\n  rows: 3\n  cols: 3\n"
              "  data: [517.3, 0, 318.6, 0, 516.5, 255.3, 0, 0, 1]\ndistortion_model: plumb_bob\n"
              "distortion_coefficients:\n  rows: 1\n  cols: 5\n  data: [0.1, 0.2, 0.3, 0.4, 0.5]\n"))
          .camera;
  EXPECT_EQ(file.width, 640);
  EXPECT_EQ(file.fy, 516.5);
  EXPECT_EQ(file.cx, 318.6);
  EXPECT_EQ(file.distortion, (std::array<double, 5>{0.1, 0.2, 0.3, 0.4, 0.5}));
  const Camera message =
      read_camera_file(camera_yaml("height: 480\nwidth: 640\ndistortion_model: equidistant\n"
                                   "D: [0.1, 0.2, 0.3, 0.4]\nK: [500, 0, 320, 0, 501, 240, 0, 0, 1]\n"))
          .camera;
  EXPECT_EQ(message.model, CameraModel::kFisheye);
  EXPECT_EQ(message.fy, 501);
  EXPECT_EQ(message.distortion[3], 0.4);
}

TEST(CameraFile, ReadsKalibr) {
  const Camera camera =
      read_camera_file(
          camera_yaml("cam0:\n  camera_model: pinhole\n  distortion_coeffs: [0.1, 0.2, 0.3, 0.4]\n"
                      "  distortion_model: equidistant\n  intrinsics: [461.6, 460.3, 362.7, 248.1]\n"
                      "  resolution: [752, 480]\n  rostopic: /cam0\n"))
          .camera;
  EXPECT_EQ(camera.model, CameraModel::kFisheye);
  EXPECT_EQ(camera.width, 752);
  EXPECT_EQ(camera.fx, 461.6);
  EXPECT_EQ(camera.cy, 248.1);
  EXPECT_EQ(camera.distortion, (std::array<double, 5>{0.1, 0.2, 0.3, 0.4, 0}));
  EXPECT_THAT(refusal("cam0:\n  camera_model: omni\n  intrinsics: [1, 2, 3, 4]\n"),
              HasSubstr("cam0.camera_model: found 'omni', expected pinhole"));
}

TEST(CameraFile, ReadsOpenCvsFileStorage) {
  const std::string storage =
      "%YAML:1.0\n---\nimage_width: 640\nimage_height: 480\ncamera_matrix: !!opencv-matrix\n   rows: 3\n   "
      "cols: 3\n"
      "   dt: d\n   data: [ 5.3276e+02, 0., 3.12e+02, 0., 5.31e+02, 2.6e+02, 0., 0., 1. ]\n"
      "distortion_coefficients: !!opencv-matrix\n   rows: 5\n   cols: 1\n   dt: d\n   data: [ .1, -.2, 0., "
      "0., ";
  const Camera camera = read_camera_file(camera_yaml(storage + ".3 ]\n")).camera;
  EXPECT_EQ(camera.fx, 532.76);
  EXPECT_EQ(camera.fy, 531);
  EXPECT_EQ(camera.distortion, (std::array<double, 5>{0.1, -0.2, 0, 0, 0.3}));
  EXPECT_THAT(refusal(storage + ".3, 1, 2, 3 ]\n"), HasSubstr("distortion_coefficients: found 8 numbers"));
  EXPECT_THAT(
      refusal(
          "%YAML:1.0\ncamera_matrix: !!opencv-matrix\n   data: [ 1, 2 ]\nimage_width: 6\nimage_height: 4\n"),
      HasSubstr("camera_matrix: found [1, 2], expected [fx, 0, cx"));
}

TEST(CameraFile, KnowsADepthCameraBesideTheCamera) {
  const std::string depth =
      kPinhole + "depth_camera:\n  width: 32\n  height: 24\n  fx: 30\n  fy: 30\n  cx: 16\n  cy: 12\n";
  const CameraFile file = read_camera_file(
      camera_yaml(depth + "  camera_from_depth_camera: [1, 0, 0, -0.025, 0, 1, 0, 0, 0, 0, 1, 0]\n"));
  ASSERT_TRUE(file.depth_camera);
  EXPECT_EQ(file.camera_of_depth().width, 32);
  EXPECT_EQ(file.depth_camera->cam_from_depth_cam.t.x(), -0.025);
  EXPECT_THAT(refusal(depth), HasSubstr("depth_camera.camera_from_depth_camera: found nothing"));
  EXPECT_THAT(refusal(depth + "  camera_from_depth_camera: [1, 2]\n"), HasSubstr("found 2 numbers"));
  EXPECT_THAT(refusal(depth + "  camera_from_depth_camera: [1, 0, 0, 0, 0, 2, 0, 0, 0, 0, 1, 0]\n"),
              HasSubstr("a rotation matrix"));
  EXPECT_THAT(refusal(kPinhole + "depth_camera: 5\n"), HasSubstr("depth_camera: found '5', expected a map"));
}

TEST(CameraFile, WhatIsTypedGoesBeforeWhatIsWritten) {
  CameraFile file;
  override_depth(file, "range", std::nullopt, 20);
  EXPECT_EQ(file.depth_type, DepthType::kRange);
  EXPECT_DOUBLE_EQ(file.depth_factor, 65535.0 / 20);
  override_depth(file, "z", 1000, std::nullopt);
  EXPECT_EQ(file.depth_type, DepthType::kZ);
  EXPECT_EQ(file.depth_factor, 1000);
  EXPECT_EQ(file.depth_max, 20);
  EXPECT_THROW(override_depth(file, "far", std::nullopt, std::nullopt), std::invalid_argument);
}

TEST(CameraFile, NamesTheFieldThatIsWrong) {
  EXPECT_THAT(refusal(kPinhole + "depth_type: depth\n"),
              HasSubstr("depth_type: found 'depth', expected z or range"));
  EXPECT_THAT(
      refusal("model: equirectangular\nwidth: 64\nheight: 32\ntheta_range_deg: [0, 180]\ndepth_type: z\n"),
      HasSubstr("depth_type"));
  EXPECT_THAT(refusal("model: equirectangular\nwidth: 64\nheight: 32\n"), HasSubstr("theta_range_deg"));
  EXPECT_THAT(refusal(kPinhole + "depth_max: far\n"), HasSubstr("depth_max"));
}

}  // namespace
}  // namespace framewise
