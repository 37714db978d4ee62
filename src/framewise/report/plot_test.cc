// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/report/plot.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "framewise/report/plot_axis.h"
#include "framewise/report/svg_paper.h"

namespace framewise {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

TEST(PlotAxis, ShowsAllValuesWithRoundTicksWithin) {
  for (const auto& values : std::vector<std::vector<double>>{
           {3}, {0, 1}, {-2, 5}, {1e-9, 2e-9}, {1e9, 1e9 + 1}, {-1e12, 1e12}, {0}, {kNaN, 7, INFINITY}}) {
    for (const bool from_zero : {false, true}) {
      PlotAxis axis = axis_of(values, false, from_zero);
      axis.length = 100;
      for (const double value : values)
        if (std::isfinite(value)) {
          EXPECT_GE(axis.at(value), 0);
          EXPECT_LE(axis.at(value), 100);
        }
      const auto ticks = axis.ticks();
      EXPECT_GE(ticks.size(), 2u);
      EXPECT_LE(ticks.size(), 12u);
      EXPECT_TRUE(std::is_sorted(ticks.begin(), ticks.end()));
    }
  }
}

TEST(PlotAxis, LogarithmicLeavesOutWhatIsNotPositive) {
  const std::vector<double> values{-1, 0, 0.01, 100};
  PlotAxis axis = axis_of(values, true, false);
  EXPECT_GT(axis.low, 0);
  EXPECT_TRUE(std::isnan(axis.at(0)));
  EXPECT_LT(axis.at(0.01), axis.at(100));
  EXPECT_NEAR(axis.at(1), (axis.at(0.01) + axis.at(100)) / 2, 1e-12);
  EXPECT_GE(axis.ticks().size(), 3u);
}

TEST(Curve, BreaksAtWhatIsNotFinite) {
  EXPECT_EQ(curve_commands({0, 1, 2, 3}, {5, kNaN, 6, 7}), "M0 5h0M2 6h0L3 7");
  EXPECT_EQ(curve_commands({}, {}), "");
}

TEST(Curve, KeepsTheExtremesOfLongOnes) {
  std::vector<double> x, y;
  for (int i = 0; i < 100000; ++i) {
    x.push_back(i * 0.004);
    y.push_back(i == 51234 ? 99 : i == 51235 ? -99 : i % 3);
  }
  const std::string commands = curve_commands(x, y);
  EXPECT_LT(commands.size(), 40000u);
  EXPECT_THAT(commands, HasSubstr(" 99"));
  EXPECT_THAT(commands, HasSubstr(" -99"));
}

TEST(PlotSvg, SaysWhereThereIsNothingAndHasNoNumberThatIsNone) {
  Plot plot;
  plot.title = "</svg><script>";
  plot.nothing = "no pose";
  plot.series = {{"a", "truth", {kNaN, 1}, {2, kNaN}, {}, "\"key", false, {}}};
  for (const bool is_map : {false, true}) {
    plot.has_equal_scales = is_map;
    const std::string svg = plot_svg(plot);
    EXPECT_THAT(svg, HasSubstr("no pose"));
    EXPECT_THAT(svg, Not(HasSubstr("<script>")));
    EXPECT_THAT(svg, Not(HasSubstr("nan")));
    EXPECT_THAT(svg, Not(HasSubstr("inf\"")));
  }
}

TEST(PlotSvg, OfAMapHasOneScale) {
  Plot plot;
  plot.has_equal_scales = true;
  plot.series = {{"a", "truth", {0, 10}, {0, 1}, {}, "", false, {}}};
  const std::string svg = plot_svg(plot);
  const auto note = [&](const std::string& name) {
    return std::stod(svg.substr(svg.find("data-" + name + "=\"") + name.size() + 7));
  };
  EXPECT_NEAR((note("high") - note("low")) / note("length"),
              (note("y-high") - note("y-low")) / (note("bottom") - note("top")), 1e-6);
}

TEST(BarSvg, SaysFailuresAndShowsFarValuesOnOneAxis) {
  BarPlot plot;
  plot.level = kNaN;
  plot.bars = {{"good", 0.01, 0.009, 0.012, kNaN, "", true},
               {"bad <", 100, 90, 110, 50, "", false},
               {"worst", 0, 0, 0, kNaN, "failed", false}};
  const std::string svg = bar_svg(plot);
  EXPECT_THAT(svg, HasSubstr(">failed<"));
  EXPECT_THAT(svg, HasSubstr("bad &#60;"));
  EXPECT_THAT(svg, Not(HasSubstr("nan")));
  plot.bars.clear();
  EXPECT_THAT(bar_svg(plot), HasSubstr("</svg>"));
}

TEST(StandaloneSvg, HasItsColours) {
  const std::string svg =
      standalone_svg(strip_svg({"statuses", "Status", {0, 1, 2}, {"ok", "ok", "lost"}, 3}));
  EXPECT_THAT(svg, HasSubstr("<style>"));
  EXPECT_THAT(svg, HasSubstr(".ink-lost{color:"));
  EXPECT_THAT(svg, Not(HasSubstr("var(")));
}

}  // namespace
}  // namespace framewise
