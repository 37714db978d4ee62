// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/report/html.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

namespace framewise {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(HtmlText, HasNothingThatHtmlReads) {
  EXPECT_EQ(html_text("a<b>&\"'"), "a&#60;b&#62;&#38;&#34;&#39;");
  EXPECT_EQ(html_text(std::string("a\0\x1b"
                                  "b\n",
                                  5)),
            "ab\n");
}

TEST(HtmlText, IsUtf8WhateverComesIn) {
  EXPECT_EQ(html_text("Zażółć 深 😀"), "Zażółć 深 😀");
  const std::string replaced = "\xEF\xBF\xBD";
  EXPECT_EQ(html_text("\xff"), replaced);
  EXPECT_EQ(html_text("\xc5"), replaced) << "cut short";
  EXPECT_EQ(html_text("\xc0\xaf"), replaced + replaced) << "overlong";
  EXPECT_EQ(html_text("\xed\xa0\x80"), replaced + replaced + replaced) << "a surrogate";
}

TEST(HtmlJson, CannotEndItsScriptAndReadsBackTheSame) {
  const nlohmann::ordered_json json = {{"</script><!--", "</SCRIPT>&"}};
  EXPECT_THAT(html_json(json), Not(HasSubstr("<")));
  EXPECT_EQ(nlohmann::ordered_json::parse(html_json(json)), json);
  EXPECT_NO_THROW(html_json({{"name", "\xff"}}));
}

// RFC 4648, section 10.
TEST(DataUri, IsTheStandardsBase64) {
  const std::pair<const char*, const char*> cases[] = {{"", ""},
                                                       {"f", "Zg=="},
                                                       {"fo", "Zm8="},
                                                       {"foo", "Zm9v"},
                                                       {"foob", "Zm9vYg=="},
                                                       {"fooba", "Zm9vYmE="},
                                                       {"foobar", "Zm9vYmFy"}};
  for (const auto& [bytes, digits] : cases)
    EXPECT_EQ(data_uri("text/plain", bytes), std::string("data:text/plain;base64,") + digits);
  EXPECT_EQ(data_uri("x", std::string("\xff\xfe\x00", 3)), "data:x;base64,//4A");
}

TEST(HtmlTable, RefusesRowsOfAnotherLength) {
  Table table;
  table.columns = {{"a"}, {"b"}};
  table.rows = {{"1"}};
  EXPECT_THROW(html_table(table), std::invalid_argument);
}

TEST(FigureText, SaysWhatIsNotKnown) {
  EXPECT_EQ(figure_text(0.125), "0.125");
  EXPECT_EQ(figure_text(std::numeric_limits<double>::quiet_NaN()), "unknown");
}

}  // namespace
}  // namespace framewise
