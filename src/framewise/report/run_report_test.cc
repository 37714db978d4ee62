// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/report/run_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace framewise {
namespace {

using testing::HasSubstr;
using testing::Not;

// A camera that goes `step` along x and turns `turn` about y from frame to frame.
Trajectory path(std::size_t frames, double step, double turn, double scale = 1) {
  Trajectory trajectory;
  for (std::size_t i = 0; i < frames; ++i) {
    const double k = static_cast<double>(i);
    const Eigen::AngleAxisd rotation(k * turn, Eigen::Vector3d::UnitY());
    trajectory.add(k / 30,
                   {rotation.toRotationMatrix(), scale * Eigen::Vector3d(k * step, 0.1 * step * (i % 3), 0)});
  }
  return trajectory;
}

RunReport report_of(const Trajectory& truth, const Trajectory& estimate,
                    Alignment alignment = Alignment::kSe3) {
  RunReport report;
  report.title = "room";
  report.record = {{"options", {{"scale", "depth"}, {"solver", "kabsch"}}}};
  report.truth = truth;
  report.estimate = estimate;
  for (const double time : estimate.times) report.frames.push_back({time, "ok", 100, 90, 0.5, 1, 2, 3, 4});
  EvaluationOptions options;
  options.alignment = alignment;
  report.evaluation = evaluate(truth, estimate, options);
  return report;
}

std::string warnings(const RunReport& report) {
  std::string text;
  for (const Hint& hint : run_hints(report))
    if (hint.is_warning) text += hint.text + "\n";
  return text;
}

TEST(RunHints, WarnOfNothingWhereAllIsWell) {
  const Trajectory truth = path(20, 0.05, 0.01);
  EXPECT_EQ(warnings(report_of(truth, truth)), "");
}

TEST(RunHints, WarnOfScaleFromTruth) {
  const Trajectory truth = path(20, 0.05, 0.01);
  RunReport report = report_of(truth, truth);
  report.record["options"]["scale"] = "truth";
  EXPECT_THAT(warnings(report), HasSubstr("taken from the truth"));
}

TEST(RunHints, WarnOfASim3ScaleFarFromOne) {
  const Trajectory truth = path(20, 0.05, 0.01);
  EXPECT_THAT(warnings(report_of(truth, path(20, 0.05, 0.01, 0.5), Alignment::kSim3)),
              HasSubstr("2 times as large"));
  EXPECT_EQ(warnings(report_of(truth, path(20, 0.05, 0.01, 1.01), Alignment::kSim3)), "");
}

TEST(RunHints, WarnOfCoverageUnderOne) {
  EXPECT_THAT(warnings(report_of(path(10, 0.05, 0.01), path(20, 0.05, 0.01))),
              HasSubstr("Only 10 of 20 poses"));
}

TEST(RunHints, WarnOfErrorsAboveThoseOfACameraThatNeverMoved) {
  EXPECT_THAT(warnings(report_of(path(20, 0.05, 0.01), path(20, -0.5, 0.01))), HasSubstr("is above the"));
}

TEST(RunHints, WarnOfPureRotation) {
  const Trajectory truth = path(20, 0.0005, 0.05);
  EXPECT_THAT(warnings(report_of(truth, truth)), HasSubstr("almost only turned"));
}

TEST(RunHints, CountFramesThatWereNotMeasured) {
  const Trajectory truth = path(20, 0.05, 0.01);
  RunReport report = report_of(truth, truth);
  report.frames[3].status = report.frames[4].status = "lost";
  EXPECT_THAT(warnings(report), HasSubstr("2 of 20 frames have no measured motion"));
}

TEST(RunPage, OfNothingAtAllIsAPage) {
  RunReport report;
  EXPECT_THAT(run_page(report), HasSubstr("</html>"));
  report.frames.resize(1);
  EXPECT_THAT(run_page(report), HasSubstr("</html>"));
}

TEST(RunPage, LoadsNothingAndHasNoNaN) {
  const Trajectory truth = path(20, 0.05, 0.01);
  RunReport report = report_of(truth, truth);
  report.frames[2].inliers = report.frames[3].time = std::numeric_limits<double>::quiet_NaN();
  const std::string page = run_page(report), head = page.substr(0, page.find("id=\"plotly\""));
  EXPECT_THAT(head, HasSubstr("default-src 'none'"));
  EXPECT_THAT(head, Not(HasSubstr("src=\"http")));
  EXPECT_THAT(head, Not(HasSubstr("\"nan\"")));
  EXPECT_THAT(head, Not(HasSubstr(" nan")));
}

TEST(RunPage, IsDecimatedForLongRuns) {
  const Trajectory truth = path(1000, 0.01, 0.001), longer = path(6000, 0.01, 0.0001);
  EXPECT_LT(run_page(report_of(longer, longer)).size(),
            1.3 * static_cast<double>(run_page(report_of(truth, truth)).size()));
  EXPECT_LT(run_page(report_of(truth, truth)).size(), 3'000'000u);
}

TEST(RunPage, JudgesTheFinalTrajectoryWhereLaterFramesMovedPoses) {
  const Trajectory truth = path(20, 0.05, 0.01), causal = path(20, 0.051, 0.01),
                   last = path(20, 0.0505, 0.01);
  RunReport report = report_of(truth, causal);
  EXPECT_THAT(run_page(report), Not(HasSubstr("with what later frames told")));
  report.final = last;
  report.final_evaluation = evaluate(truth, last, {});
  const std::string page = run_page(report);
  EXPECT_THAT(page, HasSubstr("causal: as known when the frame came"));
  EXPECT_THAT(page, HasSubstr("final: with what later frames told"));
}

TEST(FigureFiles, HaveNamesOfTheirOwn) {
  const Trajectory truth = path(20, 0.05, 0.01);
  std::vector<std::string> names;
  for (const auto& [name, svg] : run_figure_files(report_of(truth, truth))) {
    names.push_back(name);
    EXPECT_THAT(svg, HasSubstr("<svg "));
  }
  const std::size_t count = names.size();
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  EXPECT_EQ(names.size(), count);
  EXPECT_GE(count, 10u);
}

}  // namespace
}  // namespace framewise
