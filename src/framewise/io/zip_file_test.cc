// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/io/zip_file.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <iterator>

#include "framewise/io/input_error.h"

namespace framewise {
namespace {

namespace fs = std::filesystem;

struct ZipFile : ::testing::Test {
  void SetUp() override {
    folder = fs::path(::testing::TempDir()) / ("zip_file_test_" + std::to_string(getpid()));
    fs::create_directories(folder);
  }
  void TearDown() override { fs::remove_all(folder); }
  std::string bytes(const std::string& name) const {
    std::ifstream file(folder / name, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  fs::path folder;
};

TEST_F(ZipFile, HoldsItsEntriesAsTheyAre) {
  write_zip(folder / "a.zip", {{"one.txt", "first content"}, {"two.bin", std::string("\0\1\2", 3)}}, "--x");
  const std::string archive = bytes("a.zip");
  EXPECT_EQ(archive.substr(0, 4), "PK\3\4");
  EXPECT_LT(archive.find("first content"), archive.find("two.bin"));
  EXPECT_NE(archive.find(std::string("\0\1\2", 3)), std::string::npos);
}

TEST_F(ZipFile, HasTheSameBytesInAnyTimeZone) {
  const std::vector<ZipEntry> entries = {{"one.txt", "1"}};
  setenv("TZ", "Pacific/Auckland", 1);
  write_zip(folder / "a.zip", entries, "--x");
  setenv("TZ", "America/Los_Angeles", 1);
  write_zip(folder / "b.zip", entries, "--x");
  unsetenv("TZ");
  EXPECT_EQ(bytes("a.zip"), bytes("b.zip"));
}

TEST_F(ZipFile, ReplacesAnOlderOne) {
  write_zip(folder / "a.zip", {{"old.txt", "old"}}, "--x");
  write_zip(folder / "a.zip", {{"new.txt", "new"}}, "--x");
  EXPECT_EQ(bytes("a.zip").find("old"), std::string::npos);
}

TEST_F(ZipFile, WhatCannotBeWrittenIsNamed) {
  for (const fs::path& path : {folder, folder / "missing" / "a.zip"}) {
    try {
      write_zip(path, {{"one.txt", "1"}}, "--save-results");
      FAIL() << path;
    } catch (const InputError& error) {
      const std::string what = error.what();
      EXPECT_NE(what.find(path.string()), std::string::npos) << what;
      EXPECT_NE(what.find("--save-results"), std::string::npos) << what;
    }
  }
}

}  // namespace
}  // namespace framewise
