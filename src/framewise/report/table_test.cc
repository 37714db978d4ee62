// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/report/table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace framewise {
namespace {

using testing::HasSubstr;
using testing::Not;

Table small_table() {
  Table table;
  table.caption = "Errors of a_b, 95 %";
  table.columns = {{"method", false}, {"ATE (m)"}};
  table.rows = {{"S.E.nister", {"0.12", true}}, {"Kabsch & co", "failed [1]"}};
  table.notes = {"[1] exit code 2: a|b"};
  return table;
}

TEST(TableText, IsCsvThatProgramsReadBack) {
  Table table = small_table();
  table.rows.push_back({"with, comma", "a \"quote\"\nand a line"});
  EXPECT_EQ(to_csv(table),
            "method,ATE (m)\nS.E.nister,0.12\nKabsch & co,failed [1]\n\"with, comma\",\"a \"\"quote\"\"\nand "
            "a line\"\n");
}

TEST(TableText, IsMarkdownWhoseColumnsStandUnderTheirHeadings) {
  EXPECT_EQ(to_markdown(small_table()),
            "Errors of a\\_b, 95 %\n\n"
            "| method      |    ATE (m) |\n"
            "|:------------|-----------:|\n"
            "| S.E.nister  |   **0.12** |\n"
            "| Kabsch & co | failed [1] |\n"
            "\n- [1] exit code 2: a\\|b\n");
}

TEST(TableText, IsLatexWithoutCommandsFromNames) {
  const std::string text = to_latex(small_table());
  EXPECT_THAT(text, HasSubstr("\\begin{tabular}{lr}\n\\hline\nmethod & ATE (m) \\\\\n\\hline\n"));
  EXPECT_THAT(text, HasSubstr("S.E.nister & \\textbf{0.12} \\\\\n"));
  EXPECT_THAT(text, HasSubstr("Kabsch \\& co & failed {[}1{]} \\\\\n"));
  EXPECT_THAT(text, HasSubstr("Errors of a\\_b, 95 \\%"));
  EXPECT_THAT(text, Not(HasSubstr("toprule")));
}

TEST(TableText, EscapesEveryLetterThatLatexReads) {
  Table table;
  table.columns = {{"\\input{x}"}};
  table.rows = {{"$a_1^2 {#} ~ 50% <b>"}};
  const std::string text = to_latex(table);
  EXPECT_THAT(text, HasSubstr("\\textbackslash{}input\\{x\\}"));
  EXPECT_THAT(text, HasSubstr("\\$a\\_1\\textasciicircum{}2 \\{\\#\\} \\textasciitilde{} 50\\% $<$b$>$"));
}

TEST(TableText, KeepsACellOnItsLine) {
  Table table;
  table.columns = {{"a", false}};
  table.rows = {{"two\nlines | <script> [a](b)"}};
  EXPECT_THAT(to_markdown(table), HasSubstr("| two lines \\| \\<script\\> [a\\](b) |"));
}

TEST(TableText, RefusesRowsOfAnotherLength) {
  Table table = small_table();
  table.rows.push_back({"one"});
  EXPECT_THROW(to_csv(table), std::invalid_argument);
  EXPECT_THROW(to_markdown(table), std::invalid_argument);
  EXPECT_THROW(to_latex(table), std::invalid_argument);
}

TEST(TableText, OfNoRowsIsItsHeader) {
  Table table;
  table.columns = {{"a"}, {"b"}};
  EXPECT_EQ(to_csv(table), "a,b\n");
  EXPECT_THAT(to_markdown(table), HasSubstr("|   a |   b |"));
}

}  // namespace
}  // namespace framewise
