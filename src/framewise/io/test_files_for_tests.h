// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

namespace framewise {

// A path in a folder of the test that runs: tests run side by side, each in a process of its own.
inline std::filesystem::path test_file(const std::string& name) {
  const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
  const auto folder = std::filesystem::path(::testing::TempDir()) / test->test_suite_name() / test->name();
  std::filesystem::create_directories(folder);
  return folder / name;
}

}  // namespace framewise
