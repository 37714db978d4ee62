// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/io/csv_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "framewise/io/input_error.h"
#include "framewise/io/test_files_for_tests.h"

namespace framewise {
namespace {

class CsvTableOfText : public testing::Test {
 protected:
  CsvTable table(const std::string& text) {
    std::ofstream(path_, std::ios::binary) << text;
    return CsvTable(path_);
  }
  void TearDown() override { std::filesystem::remove(path_); }

  const std::filesystem::path path_ = test_file("table.csv");
};

TEST_F(CsvTableOfText, HasItsValuesByNameOfColumn) {
  const CsvTable t = table("a,b,c\n1,x,2.5e-3\n,,\n");
  ASSERT_EQ(t.num_rows(), 2u);
  EXPECT_EQ(t.number(0, t.column("a")), 1);
  EXPECT_EQ(t.text(0, t.column("b")), "x");
  EXPECT_EQ(t.number(0, t.column("c")), 2.5e-3);
  EXPECT_EQ(t.number(1, t.column("c")), std::nullopt);
}

TEST_F(CsvTableOfText, QuotesKeepCommasLineEndsAndQuotes) {
  const CsvTable t = table("name,value\r\n\"a,\"\"b\"\"\nc\",7\r\n\r\nplain,8");
  ASSERT_EQ(t.num_rows(), 2u);
  EXPECT_EQ(t.text(0, 0), "a,\"b\"\nc");
  EXPECT_EQ(t.number(0, 1), 7);
  EXPECT_EQ(t.number(1, 1), 8);
}

TEST_F(CsvTableOfText, SaysWhatIsWrong) {
  const auto refused = [&](const std::string& text, const std::string& words) {
    try {
      const CsvTable t = table(text);
      for (std::size_t row = 0; row < t.num_rows(); ++row) t.number(row, t.column("b"));
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), testing::HasSubstr(words));
      return;
    }
    ADD_FAILURE() << "taken: " << text;
  };
  refused("", "empty file");
  refused("\n\n", "empty file");
  refused("a,c\n1,2\n", "b: found no such column");
  refused("a,b\n1,2\n1,2,3\n", ":3: found 3 values, expected 2");
  refused("b,b\n1,2\n", "twice");
  refused("a,b\n1,\"2\n", ":2: found a quote that does not end");
  refused("a,b\n1,\"2\"3\n", "text after a value in quotes");
  refused("a,b\n\"1\n1\",2\n1,two\n", ":4: b: found 'two', expected a number");
  refused("a,b\n1,nan\n", "found 'nan'");
  refused("a,b\n1,2 \n", "found '2 '");
}

TEST_F(CsvTableOfText, NeedsAFile) {
  EXPECT_THROW(CsvTable("/nowhere/at/all.csv"), InputError);
  EXPECT_THROW(CsvTable(testing::TempDir()), InputError);
}

}  // namespace
}  // namespace framewise
