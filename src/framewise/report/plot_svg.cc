// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "framewise/report/plot.h"
#include "framewise/report/plot_style.h"
#include "framewise/report/svg_paper.h"

namespace framewise {
namespace {

constexpr double kWidth = 480, kLeft = 58, kRight = 10, kBelow = 36;

using Values = std::vector<double>;

Values all(const Plot& plot, Values Plot::Series::*member) {
  Values values;
  for (const Plot::Series& series : plot.series)
    values.insert(values.end(), (series.*member).begin(), (series.*member).end());
  return values;
}

// The axes' values so that a unit is as long either way.
void equalise(PlotAxis& x, PlotAxis& y) {
  const auto per_pixel = [](const PlotAxis& axis) { return (axis.high - axis.low) / std::abs(axis.length); };
  const double unit = std::max(per_pixel(x), per_pixel(y));
  for (PlotAxis* axis : {&x, &y}) {
    const double middle = (axis->low + axis->high) / 2, half = unit * std::abs(axis->length) / 2;
    axis->low = middle - half;
    axis->high = middle + half;
  }
}

bool is_drawn(const PlotAxis& x, const PlotAxis& y, double at_x, double at_y) {
  return std::isfinite(x.at(at_x)) && std::isfinite(y.at(at_y));
}

bool has_points(const Plot& plot, const PlotAxis& x, const PlotAxis& y) {
  for (const Plot::Series& series : plot.series)
    for (std::size_t i = 0; i < std::min(series.x.size(), series.y.size()); ++i)
      if (is_drawn(x, y, series.x[i], series.y[i])) return true;
  return false;
}

void draw_series(SvgPaper& paper, const Plot::Series& series, const PlotAxis& x, const PlotAxis& y) {
  const std::size_t size = std::min(series.x.size(), series.y.size());
  paper.begin_group(fmt::format("{}ink-{}", series.is_hidden ? "off " : "", series.ink), series.key);
  Values at_x, at_y;
  for (std::size_t i = 0; i < size; ++i) {
    at_x.push_back(x.at(series.x[i]));
    at_y.push_back(y.at(series.y[i]));
  }
  if (series.draw == Plot::Draw::kLine) {
    paper.path(curve_commands(at_x, at_y), "line");
  } else {
    for (std::size_t i = 0; i < size; ++i)
      if (std::isfinite(at_x[i]) && std::isfinite(at_y[i]))
        paper.dot(at_x[i], at_y[i], "area", i < series.hints.size() ? series.hints[i] : "");
  }
  paper.end_group();
}

void draw_levels(SvgPaper& paper, const Plot& plot, const PlotAxis& x, const PlotAxis& y) {
  for (const auto& [value, words] : plot.levels) {
    const double at = y.at(value);
    if (!std::isfinite(at)) continue;
    paper.line(x.start, at, x.start + x.length, at, "level");
    paper.text(x.start + x.length - 4, at - 4, "end halo", words);
  }
}

}  // namespace

std::string plot_svg(const Plot& plot) {
  const double height = plot.has_equal_scales ? kWidth : 250;
  SvgPaper paper(kWidth, height, plot.title);
  paper.text(4, 14, "title", plot.title);
  std::vector<std::pair<std::string, std::string>> names;
  for (const Plot::Series& series : plot.series)
    if (!series.name.empty()) names.emplace_back(series.name, series.ink);
  const double top = 36 + paper.legend(4, 31, kWidth - 8, names) + 4;

  Values y_values = all(plot, &Plot::Series::y);
  for (const auto& level : plot.levels) y_values.push_back(level.first);
  PlotAxis x = axis_of(all(plot, &Plot::Series::x), plot.is_log_x, false);
  PlotAxis y = axis_of(y_values, plot.is_log_y, !plot.has_equal_scales);
  if (plot.follows_frames && !plot.is_log_x) x.low = std::max(x.low, 0.);
  x.start = kLeft;
  x.length = kWidth - kLeft - kRight;
  y.start = height - kBelow;
  y.length = top - y.start;
  if (plot.has_equal_scales) equalise(x, y);

  paper.axes(x, y, plot.x_label, plot.y_label);
  if (!has_points(plot, x, y)) paper.text(kLeft + x.length / 2, (top + y.start) / 2, "middle", plot.nothing);
  for (const Plot::Series& series : plot.series) draw_series(paper, series, x, y);
  draw_levels(paper, plot, x, y);
  paper.note("low", x.low);
  paper.note("high", x.high);
  paper.note("left", x.start);
  paper.note("length", x.length);
  paper.note("top", top);
  paper.note("bottom", y.start);
  paper.note("y-low", y.low);
  paper.note("y-high", y.high);
  paper.note("frames", plot.follows_frames ? 1 : 0);
  return paper.finish();
}

std::string strip_svg(const StripPlot& plot) {
  constexpr double kHeight = 86, kTop = 42, kThick = 20;
  SvgPaper paper(kWidth, kHeight, plot.title);
  paper.text(4, 14, "title", plot.title);
  std::vector<std::pair<std::string, std::string>> names;
  for (const std::string& ink : plot.inks)
    if (std::none_of(names.begin(), names.end(), [&](const auto& known) { return known.second == ink; }))
      names.emplace_back(ink, ink);
  paper.legend(4, 30, kWidth - 8, names);

  PlotAxis x;
  x.start = kLeft;
  x.length = kWidth - kLeft - kRight;
  if (!plot.times.empty()) {
    x.low = plot.times.front();
    x.high = plot.end > x.low ? plot.end : x.low + 1;
  }
  for (std::size_t i = 0, next; i < plot.times.size(); i = next) {
    for (next = i + 1; next < plot.times.size() && plot.inks[next] == plot.inks[i];) ++next;
    const double from = x.at(plot.times[i]), to = x.at(next < plot.times.size() ? plot.times[next] : x.high);
    paper.begin_group("ink-" + plot.inks[i]);
    paper.rectangle(from, kTop, std::max(to - from, 0.5), kThick, "area");
    paper.end_group();
  }
  for (const double tick : x.ticks())
    paper.text(x.at(tick), kTop + kThick + 14, "middle axis", tick_text(tick));
  for (const auto& [name, value] : {std::pair("low", x.low),
                                    {"high", x.high},
                                    {"left", x.start},
                                    {"length", x.length},
                                    {"top", kTop},
                                    {"bottom", kTop + kThick},
                                    {"frames", 1.}})
    paper.note(name, value);
  return paper.finish();
}

std::string standalone_svg(const std::string& svg) {
  const std::size_t head_end = svg.find(">\n");
  return svg.substr(0, head_end + 2) + "<style>" + file_plot_style() +
         "</style><rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n" + svg.substr(head_end + 2);
}

}  // namespace framewise
