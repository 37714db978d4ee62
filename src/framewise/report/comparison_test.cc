// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/report/comparison.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "framewise/report/comparison_csv.h"
#include "framewise/report/comparison_json.h"
#include "framewise/report/comparison_tables.h"

namespace framewise {
namespace {

using testing::HasSubstr;

ComparedError error(double rmse, bool best) {
  ComparedError e{{rmse, 0.9 * rmse, 1.1 * rmse, 5}, Interval{0.8 * rmse, 1.25 * rmse}, best, std::nullopt};
  if (!best) e.to_best = PairedDifference{0.5, Interval{-0.1, 1.2}, 0.03, 0.06, false, 79, 2};
  return e;
}

ComparisonRow good_row(const std::string& method, double rmse, bool best) {
  ComparisonRow row;
  row.dataset = "room";
  row.method = method;
  row.features = "ORB";
  row.options = {{"solver", "kabsch"}, {"rotation", ""}};
  row.repeats = 5;
  const Spread one{1, 1, 1, 5};
  row.errors = ComparedErrors{"se3",
                              1,
                              "frames",
                              {0.125, 0.1, 0.15, 5},
                              {0.4, 0.4, 0.4, 5},
                              one,
                              error(rmse, best),
                              error(2 * rmse, best)};
  row.measured = one;
  for (const char* status : {"ok", "low-parallax", "rotation-only", "predicted", "no-depth", "lost"})
    row.statuses.emplace_back(status, Spread{10, 10, 10, 5});
  row.missing_pairs = Spread{0, 0, 0, 5};
  row.times = ComparedTimes{3.0, 20.0, 5.0, 1.5, Interval{20, 60}, 37.7};
  return row;
}

ComparisonRow failed_row(const std::string& dataset, const std::string& why) {
  ComparisonRow row;
  row.dataset = dataset;
  row.method = "2-point";
  row.features = "ORB";
  row.repeats = row.failed = 5;
  row.failure = why;
  return row;
}

// A row that is best, one that cannot be told from it, one that failed.
Comparison three_rows() {
  Comparison c;
  c.version = "1.2.3";
  c.grid = "lab";
  c.repeats = 5;
  c.datasets = {{"room", "data/room", "tum", "0123", "datasets/room", 80, 80, 80, 3.25, 0.5, 12.0, 2.0}};
  c.rows = {good_row("Kabsch", 8, true), good_row("5-point", 9, false),
            failed_row("room", "exit code 2: no, known rotation")};
  return c;
}

std::size_t lines(const std::string& text) {
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

TEST(ComparisonTables, SayWhatAFigureIsWorthNothingWithout) {
  const std::string text = comparison_markdown(three_rows());
  for (const char* words :
       {"Comparison: lab", "alignment se3", "RPE over delta 1 frames",
        "truth for 80 of 80 frames, 3.25 m long", "a camera that never moved: ATE 0.5 m, RPE 12 mm and 2 deg",
        "over 5 seeds", "Holm"})
    EXPECT_THAT(text, HasSubstr(words));
}

TEST(ComparisonTables, MarkTheBestAndWhatIsNotToldFromIt) {
  const std::string text = comparison_markdown(three_rows());
  EXPECT_THAT(text, HasSubstr("**8 [7.2, 8.8]**"));
  EXPECT_THAT(text, HasSubstr(" 9 [8.1, 9.9] = |"));
  EXPECT_THAT(text, HasSubstr("0.06 | no "));
  Comparison told = three_rows();
  told.rows[1].errors->rpe_translation_mm.to_best->is_real = true;
  EXPECT_THAT(comparison_markdown(told), HasSubstr(" 9 [8.1, 9.9] |"));
  EXPECT_THAT(comparison_markdown(told), HasSubstr("| worse "));
}

TEST(ComparisonTables, NoCellIsEmptyAndAFailureSaysWhy) {
  Comparison c = three_rows();
  c.rows.push_back(good_row("no truth", 1, false));
  c.rows.back().errors.reset();
  c.rows.back().no_errors = "no truth";
  c.rows.back().times->load_ms = c.rows.back().times->features_ms = std::nullopt;
  c.rows.back().times->frames_per_second.reset();
  c.datasets.emplace_back().name = "dark";
  c.rows.push_back(failed_row("dark", "exit code 1: no motion"));
  std::vector<Table> tables = comparison_tables(c);
  EXPECT_EQ(tables.size(), 6u);
  tables.push_back(comparison_csv_table(c));
  for (const Table& table : tables)
    for (const auto& row : table.rows)
      for (std::size_t i = 0; i < row.size(); ++i)
        EXPECT_FALSE(row[i].text.empty()) << table.caption << ": " << table.columns[i].heading;
  const std::string text = comparison_markdown(c);
  EXPECT_THAT(text, HasSubstr("failed [1]"));
  EXPECT_THAT(text, HasSubstr("- [1] exit code 2: no, known rotation\n"));
  EXPECT_THAT(text, HasSubstr("- [1] exit code 1: no motion\n"));
  EXPECT_THAT(text, HasSubstr("there is no truth to judge by"));
}

TEST(ComparisonTables, PutPublishedFiguresBesideOurs) {
  Comparison c = three_rows();
  EXPECT_THAT(comparison_markdown(c), testing::Not(HasSubstr("published")));
  c.has_published = true;
  c.rows[0].published = PublishedResult{0.724, 19, 0.413, "ok"};
  c.rows[1].published = PublishedResult{{}, {}, {}, "failed"};
  for (const std::string& text : {comparison_markdown(c), comparison_latex(c)}) {
    EXPECT_THAT(text, HasSubstr("published ATE (m)"));
    EXPECT_THAT(text, HasSubstr("0.724"));
  }
  const std::string csv = to_csv(comparison_csv_table(c));
  EXPECT_THAT(csv, HasSubstr(",0.724,19,0.413,ok\n"));
  EXPECT_THAT(csv, HasSubstr(",failed,failed,failed,ok\n"));
  EXPECT_THAT(csv, HasSubstr("not published"));
}

TEST(ComparisonTables, NameTheRowsThatWereAlignedOtherwise) {
  Comparison c = three_rows();
  c.rows.push_back(good_row("Arun", 8, false));
  c.rows[1].errors->alignment = "sim3";
  EXPECT_THAT(comparison_markdown(c), HasSubstr("alignment se3 (sim3 for 5-point with ORB)"));
}

TEST(ComparisonCsv, HasALineForEachRowWithNumbersInFull) {
  Comparison c = three_rows();
  c.rows[0].errors->ate.median = 0.1234567890123;
  const std::string csv = to_csv(comparison_csv_table(c));
  EXPECT_EQ(lines(csv), 4u);
  EXPECT_THAT(csv, HasSubstr("dataset,method,features,solver,"));
  EXPECT_THAT(csv, HasSubstr("0.1234567890123"));
  EXPECT_THAT(csv, HasSubstr("\"exit code 2: no, known rotation\""));
}

TEST(ComparisonJson, ReadBackIsTheSame) {
  Comparison c = three_rows();
  c.rows[0].folder = "rows/room/ORB/Kabsch";
  c.rows[1].published = PublishedResult{0.3, std::nullopt, 1.5, "ok"};
  c.rows[1].times->frames_per_second.reset();
  c.rows[1].times->mean_frames_per_second.reset();
  c.datasets.push_back({"dark", "data/dark", "depth", "4567", "", 3, 3, 0, {}, {}, {}, {}});
  c.rows.push_back(failed_row("dark", "why"));
  const auto json = to_json(c);
  EXPECT_EQ(to_json(comparison_from_json(json)).dump(1), json.dump(1));
  auto without = json;
  without["rows"][0].erase("errors");
  EXPECT_THROW(comparison_from_json(without), nlohmann::json::exception);
}

TEST(ComparisonJson, HasNullAndAReasonWhereThereIsNoFigure) {
  const auto json = to_json(three_rows());
  EXPECT_EQ(json["rows"].size(), 3u);
  EXPECT_EQ(json["rows"][0]["errors"]["rpe_translation_mm"]["rmse"]["median"], 8);
  EXPECT_TRUE(json["rows"][0]["errors"]["rpe_translation_mm"]["best"]);
  EXPECT_TRUE(json["rows"][0]["reason"].is_null());
  EXPECT_EQ(json["rows"][1]["errors"]["rpe_rotation_deg"]["minus_best"]["p_holm"], 0.06);
  EXPECT_TRUE(json["rows"][2]["errors"].is_null());
  EXPECT_EQ(json["rows"][2]["reason"], "exit code 2: no, known rotation");
  EXPECT_EQ(json["datasets"][0]["static_baseline"]["rpe_translation_mm"], 12);
}

}  // namespace
}  // namespace framewise
