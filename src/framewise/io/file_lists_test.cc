// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/io/file_lists.h"

#include <gtest/gtest.h>

#include <fstream>

#include "framewise/io/input_error.h"
#include "framewise/io/test_files_for_tests.h"

namespace framewise {
namespace {

std::filesystem::path write_list(const std::string& text) {
  const auto path = test_file("list.txt");
  std::ofstream(path, std::ios::binary) << text;
  return path;
}

std::string complaint(const std::string& text) {
  try {
    read_file_list(write_list(text));
  } catch (const InputError& error) {
    return error.what();
  }
  return "no complaint";
}

TEST(FileLists, ReadTimesAndNames) {
  const auto files =
      read_file_list(write_list("# comment\n\n1.5 rgb/a.png\r\n\t2.25   rgb/b.png  # the second\n"));
  ASSERT_EQ(files.size(), 2u);
  EXPECT_EQ(files[0].time, 1.5);
  EXPECT_EQ(files[0].file, "rgb/a.png");
  EXPECT_EQ(files[1].time, 2.25);
  EXPECT_EQ(files[1].line, 4);
}

TEST(FileLists, RefuseWhatIsNoListAndSayWhere) {
  EXPECT_NE(complaint("# only a comment\n").find("an empty list"), std::string::npos);
  EXPECT_NE(complaint("1 a.png\nx b.png\n").find(":2: found 'x'"), std::string::npos);
  EXPECT_NE(complaint("1 a.png\nnan b.png\n").find(":2:"), std::string::npos);
  EXPECT_NE(complaint("1 a.png b.png\n").find("3 words"), std::string::npos);
  EXPECT_NE(complaint("2 a.png\n1 b.png\n").find("times that increase"), std::string::npos);
  EXPECT_NE(complaint("1305031229528748000 a.png\n1305031229561000000 b.png\n").find("nano"),
            std::string::npos);
  EXPECT_NE(complaint("1305031229528.7 a.png\n").find("milliseconds"), std::string::npos);
  EXPECT_NE(complaint("0 a.png\n33333333 b.png\n66666666 c.png\n").find("nano"), std::string::npos);
  EXPECT_THROW(read_file_list("/no/such/list.txt"), InputError);
}

TEST(FileLists, AssociationsMayNameDepthFirst) {
  const auto usual = read_association_list(write_list("1 rgb/a.png 1.5 depth/b.png\n"));
  EXPECT_EQ(usual[0].color.file, "rgb/a.png");
  const auto other = read_association_list(write_list("1 depth/b.png 2 rgb/a.png\n"));
  EXPECT_EQ(other[0].color.file, "rgb/a.png");
  EXPECT_EQ(other[0].color.time, 2);
  EXPECT_EQ(other[0].depth.time, 1);
}

TEST(AssociateByTime, GivesTheClosestPairsFirstAndEachOnce) {
  const std::vector<double> times = {0.00, 0.03, 0.06, 0.09}, others = {0.005, 0.028, 0.031, 0.2};
  EXPECT_EQ(associate_by_time(times, others, 0.02), (std::vector<int>{0, 2, -1, -1}));
  // 0.028 is taken by nobody: 0.03 prefers 0.031, and 0.00 is too far from it.
}

TEST(AssociateByTime, HandlesALongRecordingQuickly) {
  std::vector<double> times, others;
  for (int i = 0; i < 100000; ++i) {
    times.push_back(i / 30.0);
    others.push_back(i / 30.0 + 0.004);
  }
  const auto partner = associate_by_time(times, others, 0.02);
  for (int i = 0; i < 100000; ++i) ASSERT_EQ(partner[i], i);
}

}  // namespace
}  // namespace framewise
