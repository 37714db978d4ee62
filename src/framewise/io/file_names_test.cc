// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/io/file_names.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

namespace framewise {
namespace {

namespace fs = std::filesystem;

TEST(FileNames, NumbersCountAsNumbers) {
  std::vector<std::string> names = {"img10.png", "img2.png", "img1.png", "img02.png",
                                    "a",         "img",      "b2",       "b11"};
  std::sort(names.begin(), names.end(), natural_less);
  EXPECT_EQ(names, (std::vector<std::string>{"a", "b2", "b11", "img", "img1.png", "img02.png", "img2.png",
                                             "img10.png"}));
  EXPECT_FALSE(natural_less("x", "x"));
  EXPECT_TRUE(natural_less("9", "123456789012345678901234567890"));
}

TEST(FileNames, AreListedInNaturalOrderByTheirEndings) {
  const fs::path folder = fs::path(testing::TempDir()) / "framewise_file_names";
  fs::remove_all(folder);
  fs::create_directories(folder / "folder.png");
  for (const char* name : {"10.PNG", "9.png", "notes.txt", ".hidden.png", "8.jpg"})
    std::ofstream(folder / name) << 1;
  EXPECT_EQ(files_in(folder, {".png"}), (std::vector<std::string>{"9.png", "10.PNG"}));
  EXPECT_TRUE(files_in(folder / "nothing", {".png"}).empty());
  EXPECT_EQ(first_existing(folder, {"no", "notes.txt", "8.jpg"}), folder / "notes.txt");
  EXPECT_EQ(first_existing(folder, {"no"}), fs::path());
}

TEST(FileNames, NumbersAndStemsInNames) {
  EXPECT_EQ(number_in("frame-000012.color.png"), 12);
  EXPECT_EQ(number_in("depth_image_scene0003.png"), 3);
  EXPECT_EQ(number_in("12"), 12);
  EXPECT_EQ(number_in("a12/depth.png"), std::nullopt);
  EXPECT_EQ(number_in(""), std::nullopt);
  EXPECT_EQ(number_in("99999999999999999999.png"), std::nullopt);
  EXPECT_EQ(stem_of("rgb/1305031229.528748.png"), "1305031229.528748");
  EXPECT_EQ(stem_of("12"), "12");
  EXPECT_EQ(extension_of("A.JPG"), ".jpg");
}

}  // namespace
}  // namespace framewise
