// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/io/mesh_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <fstream>
#include <opencv2/imgcodecs.hpp>
#include <stdexcept>

#include "framewise/io/input_error.h"

namespace framewise {
namespace {

namespace fs = std::filesystem;

class MeshFile : public testing::Test {
 protected:
  void SetUp() override {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::temp_directory_path() / (std::string("framewise_mesh_file_") + test->name());
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  fs::path file(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
    return folder_ / name;
  }

  std::string refusal(const fs::path& path) const {
    try {
      read_mesh(path);
    } catch (const InputError& error) {
      return error.what();
    }
    return "accepted";
  }

  fs::path folder_;
};

constexpr const char* kSquare =
    "mtllib look.mtl\nv 0 0 0\nv 2 0 0\nv 2 3 0\nv 0 3 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nusemtl a\n"
    "f 1/1 2/2 3/3 4/4\n";

TEST_F(MeshFile, FacesAreCutIntoTrianglesWithNormalsAndColours) {
  file("look.mtl", "newmtl a\nKd 0.5 0.25 0.125\nKe 0 1 2\n");
  const Mesh mesh = read_mesh(file("square.obj", kSquare));
  ASSERT_EQ(mesh.triangles.size(), 2u);
  double area = 0;
  for (const auto& [a, b, c] : mesh.triangles)
    area += 0.5 * (mesh.positions[b] - mesh.positions[a]).cross(mesh.positions[c] - mesh.positions[a]).z();
  EXPECT_FLOAT_EQ(area, 6);
  for (const auto& normal : mesh.normals) EXPECT_NEAR((normal - Eigen::Vector3f::UnitZ()).norm(), 0, 1e-6);
  const MeshMaterial& look = mesh.materials.at(mesh.material_of_triangle[0]);
  EXPECT_EQ(look.color, Eigen::Vector3f(0.5f, 0.25f, 0.125f));
  EXPECT_EQ(look.emission, Eigen::Vector3f(0, 1, 2));
  EXPECT_TRUE(look.image.empty());
}

TEST_F(MeshFile, UnitsAndUpAreTurnedIntoMetresAndZ) {
  file("look.mtl", "newmtl a\n");
  const fs::path square = file("square.obj", kSquare);
  const Mesh mesh = read_mesh(square, {.scale = 0.001, .up = UpAxis::kY});
  float highest = 0;
  for (const auto& x : mesh.positions) highest = std::max(highest, x.z());
  EXPECT_FLOAT_EQ(highest, 0.003f);
  EXPECT_NEAR((mesh.normals[0] + Eigen::Vector3f::UnitY()).norm(), 0, 1e-6);
  EXPECT_THROW(read_mesh(square, {.scale = 0}), std::invalid_argument);
  EXPECT_THROW(read_mesh(square, {.scale = std::nan("")}), std::invalid_argument);
}

TEST_F(MeshFile, ImagesAreReadFromBesideTheModel) {
  cv::imwrite((folder_ / "skin.png").string(), cv::Mat(4, 8, CV_8UC3, cv::Scalar(10, 20, 30)));
  file("look.mtl", "newmtl a\nmap_Kd skin.png\n");
  const Mesh mesh = read_mesh(file("square.obj", kSquare));
  const cv::Mat& image = mesh.materials.at(mesh.material_of_triangle[0]).image;
  ASSERT_EQ(image.size(), cv::Size(8, 4));
  EXPECT_EQ(image.at<cv::Vec3b>(0, 0), cv::Vec3b(10, 20, 30));
  for (std::size_t i = 0; i < mesh.uv.size(); ++i)
    EXPECT_LT((mesh.uv[i] - mesh.positions[i].head<2>().cwiseQuotient(Eigen::Vector2f(2, 3))).norm(), 1e-6);
}

TEST_F(MeshFile, ColoursOfVerticesAreKept) {
  const Mesh mesh = read_mesh(
      file("points.ply",
           "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
           "property uchar red\nproperty uchar green\nproperty uchar blue\nelement face 1\n"
           "property list uchar int vertex_indices\nend_header\n"
           "0 0 0 255 0 0\n1 0 0 255 0 0\n0 1 0 255 0 0\n3 0 1 2\n"));
  ASSERT_EQ(mesh.colors.size(), 3u);
  for (const auto& color : mesh.colors) EXPECT_EQ(color, Eigen::Vector3f(1, 0, 0));
}

TEST_F(MeshFile, WhatIsNoModelIsRefusedByItsName) {
  const auto expect = [&](const fs::path& path, const std::string& words) {
    const std::string said = refusal(path);
    EXPECT_THAT(said, testing::HasSubstr(path.filename().string()));
    EXPECT_THAT(said, testing::HasSubstr(words));
    EXPECT_EQ(said.find('\n'), std::string::npos) << said;
  };
  expect(folder_ / "none.obj", "no file");
  expect(folder_, "no file");
  expect(file("empty.ply", ""), "empty");
  expect(file("text.xyzzy", "hello"), "expected a model");
  expect(file("lines.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nl 1 2\nl 2 3\n"), "faces: found none");
  expect(file("nan.obj", "v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"), "vertex: found nan");
  expect(file("index.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n"), "out of range");
  file("look.mtl", "newmtl a\nmap_Kd none.png\n");
  expect(file("skinless.obj", kSquare), "texture: found 'none.png'");
}

}  // namespace
}  // namespace framewise
