// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/io/camera_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "framewise/io/input_error.h"

namespace framewise {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

fs::path camera_yaml(const std::string& text) {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  const fs::path folder = fs::path(testing::TempDir()) / test->test_suite_name() / test->name();
  fs::create_directories(folder);
  std::ofstream(folder / "camera.yaml") << text;
  return folder / "camera.yaml";
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
