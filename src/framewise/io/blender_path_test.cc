// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/io/blender_path.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "framewise/geometry/so3.h"
#include "framewise/io/input_error.h"
#include "framewise/io/test_files_for_tests.h"

namespace framewise {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

fs::path written(const std::string& name, const std::string& text) {
  const fs::path path = test_file(name);
  std::ofstream(path, std::ios::binary) << text;
  return path;
}

BlenderPath read(const std::string& name, const std::string& text) {
  return read_blender_path(written(name, text));
}

std::string refusal(const std::string& name, const std::string& text) {
  try {
    read(name, text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

// A camera at (1, 2, 3) turned by 90 degrees about x, as Blender's looks along the world's +y, upright.
void expect_looks_along_y(const Pose& pose) {
  EXPECT_LT((pose.t - Eigen::Vector3d(1, 2, 3)).norm(), 1e-15);
  EXPECT_LT((pose.R.col(0) - Eigen::Vector3d(1, 0, 0)).norm(), 1e-12);   // right
  EXPECT_LT((pose.R.col(1) - Eigen::Vector3d(0, 0, -1)).norm(), 1e-12);  // down
  EXPECT_LT((pose.R.col(2) - Eigen::Vector3d(0, 1, 0)).norm(), 1e-12);   // forward
}

TEST(BlenderPath, ReadsEverySpellingOfOnePose) {
  const std::string half = "0.70710678118654752";
  for (const auto& [name, text] : std::vector<std::pair<std::string, std::string>>{
           {"a.csv", "frame,x,y,z,rx_deg,ry_deg,rz_deg\n7,1,2,3,90,0,0\n"},
           {"b.csv", "frame;x;y;z;rx;ry;rz;lens\n7;1;2;3;1.5707963267948966;0;0;50\n"},
           {"c.txt", "qw qx qy qz x y z Frame\n" + half + " " + half + " 0 0 1 2 3 7\n"},
           {"d.json",
            R"({"frames": [{"frame": 7, "location": [1,2,3], "rotation_euler": [1.5707963267948966,0,0]}]})"},
           {"e.json", R"({"frames": [{"frame": 7, "location": [1,2,3], "rotation_quaternion": [1,1,0,0]}]})"},
           {"f.json", R"({"frames": [{"file_path": "./train/r_007", "transform_matrix":
              [[1,0,0,1],[0,0,-1,2],[0,1,0,3],[0,0,0,1]]}]})"}}) {
    const BlenderPath path = read(name, text);
    ASSERT_EQ(path.world_from_cam.size(), 1u) << name;
    ASSERT_EQ(path.world_from_cam.begin()->first, 7) << name;
    expect_looks_along_y(path.world_from_cam.at(7));
  }
}

TEST(BlenderPath, TheLensMakesTheCamera) {
  const std::string frames = R"("frames": [{"frame": 1, "location": [0,0,0], "rotation_euler": [0,0,0]}])";
  const BlenderPath path =
      read("camera.json",
           R"({"fps": 25, "width": 720, "height": 480, "lens": 50, "sensor_width": 36, )" + frames + "}");
  EXPECT_EQ(path.fps, 25);
  ASSERT_TRUE(path.camera);
  EXPECT_DOUBLE_EQ(path.camera->fx, 1000);
  EXPECT_EQ(path.camera->cx, 359.5);
  EXPECT_EQ(path.camera->cy, 239.5);
  const BlenderPath angle =
      read("angle.json", R"({"w": 800, "h": 800, "camera_angle_x": 1.5707963267948966, )" + frames + "}");
  EXPECT_NEAR(angle.camera->fx, 400, 1e-9);
  EXPECT_FALSE(read("none.json", "{" + frames + "}").camera);
}

TEST(BlenderPath, ARefusalNamesWhatIsWrong) {
  EXPECT_THAT(refusal("bad.csv", "frame,x,y,z,rx,ry,rz\n1,0,0,0,0,0,zero\n"),
              HasSubstr(":2: rz: found 'zero'"));
  EXPECT_THAT(refusal("bad.csv", "frame,x,y,z\n1,0,0,0\n"), HasSubstr("no column 'rx'"));
  EXPECT_THAT(refusal("bad.csv", "frame,x,y,z,rx,ry,rz\n1,0,0,0,0,0\n"),
              HasSubstr(":2: columns: found 6, expected 7"));
  EXPECT_THAT(refusal("bad.csv", "frame,x,y,z,rx,ry,rz\n1,0,0,0,0,0,0\n1,0,0,0,0,0,0\n"),
              HasSubstr("1 again"));
  EXPECT_THAT(refusal("bad.csv", "frame,x,y,z,qw,qx,qy,qz\n1,0,0,0,0,0,0,0\n"), HasSubstr("quaternion"));
  EXPECT_THAT(refusal("bad.csv", "frame,x,y,z,rx,ry,rz\n1.5,0,0,0,0,0,0\n"), HasSubstr("whole number"));
  EXPECT_THAT(refusal("bad.csv", ""), HasSubstr("0 lines"));
  EXPECT_THAT(refusal("bad.json", "{"), HasSubstr("no JSON"));
  EXPECT_THAT(refusal("bad.json", R"({"frames": []})"), HasSubstr("frames: found nothing"));
  EXPECT_THAT(refusal("bad.json", R"({"frames": [{"frame": 1, "location": [1, 2]}]})"),
              HasSubstr("frames[0].location: found [1,2], expected 3 numbers"));
  EXPECT_THAT(refusal("bad.json", R"({"frames": [7]})"), HasSubstr("frames[0]: found 7"));
  EXPECT_THROW(read_blender_path("/no/such/path.csv"), InputError);
}

}  // namespace
}  // namespace framewise
