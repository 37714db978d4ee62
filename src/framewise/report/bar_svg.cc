// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "framewise/report/plot.h"
#include "framewise/report/svg_paper.h"

namespace framewise {
namespace {

constexpr double kPaper = 480, kMargin = 14, kAbove = 44, kBar = 15, kUnder = 36;
constexpr std::size_t kLabelLetters = 30;
constexpr double kLogFrom = 20;  // largest over smallest: with more the small ones could not be told apart

std::string shortened(const std::string& label) {
  if (label.size() <= kLabelLetters) return label;
  std::size_t end = kLabelLetters - 1;
  while (end > 0 && (static_cast<unsigned char>(label[end]) & 0xC0) == 0x80) --end;
  return label.substr(0, end) + "…";
}

PlotAxis axis_of_bars(const BarPlot& plot, double left) {
  std::vector<double> values{plot.level};
  for (const BarPlot::Bar& bar : plot.bars) {
    values.push_back(bar.published);
    if (bar.missing.empty())
      values.insert(values.end(), {bar.median, bar.first_quartile, bar.third_quartile});
  }
  double low = INFINITY, high = 0;
  for (const double value : values)
    if (std::isfinite(value) && value > 0) low = std::min(low, value), high = std::max(high, value);
  PlotAxis x = axis_of(values, high > kLogFrom * low, true);
  x.start = left;
  x.length = kPaper - left - kMargin;
  return x;
}

void draw_bar(SvgPaper& paper, const BarPlot::Bar& bar, const PlotAxis& x, double y) {
  paper.text(x.start - 6, y + 4, bar.is_best ? "end title" : "end", shortened(bar.label));
  if (const double published = x.at(bar.published); std::isfinite(published)) {
    paper.begin_group("ink-truth");
    paper.diamond(published, y, 4.5, "hollow");
    paper.end_group();
  }
  if (!bar.missing.empty()) {
    paper.begin_group("ink-lost");
    paper.text(x.start + 4, y + 4, "", bar.missing);
    paper.end_group();
    return;
  }
  // 0 has no place on a logarithmic axis: then the mark stands at its low end.
  const auto at = [&](double value) { return std::isfinite(x.at(value)) ? x.at(value) : x.start; };
  const double low = at(bar.first_quartile), high = at(bar.third_quartile), middle = at(bar.median);
  paper.begin_group(bar.is_best ? "ink-difference" : "ink-estimate");
  paper.line(x.start, y, middle, y, "line");
  if (high > low) paper.rectangle(low, y - 5, high - low, 10, "box");
  paper.dot(middle, y, "area",
            fmt::format("{}: {:.4g} [{:.4g}, {:.4g}]", bar.label, bar.median, bar.first_quartile,
                        bar.third_quartile));
  paper.end_group();
}

}  // namespace

std::string bar_svg(const BarPlot& plot) {
  double left = 60;
  for (const BarPlot::Bar& bar : plot.bars) left = std::max(left, text_width(shortened(bar.label)) + 12);
  const double bottom = kAbove + kBar * static_cast<double>(std::max<std::size_t>(plot.bars.size(), 1)) + 4;
  SvgPaper paper(kPaper, bottom + kUnder, plot.title);
  paper.text(4, 14, "title", plot.title);

  const PlotAxis x = axis_of_bars(plot, left);
  PlotAxis y;
  y.start = kAbove - 4;
  y.length = bottom - y.start;
  paper.begin_group("axis");
  for (const double tick : x.ticks()) {
    paper.line(x.at(tick), y.start, x.at(tick), bottom, "grid");
    paper.text(x.at(tick), bottom + 14, "middle", tick_text(tick));
  }
  paper.text(kPaper - 4, bottom + 30, "end", plot.x_label);
  paper.end_group();
  if (const double level = x.at(plot.level); std::isfinite(level)) {
    paper.line(level, y.start, level, bottom, "level");
    const bool at_end = level > kPaper - text_width(plot.level_name) / 2 - 4;
    paper.text(at_end ? kPaper - 4 : level, y.start - 6, at_end ? "end" : "middle", plot.level_name);
  }
  for (std::size_t i = 0; i < plot.bars.size(); ++i)
    draw_bar(paper, plot.bars[i], x, kAbove + kBar * (static_cast<double>(i) + 0.5));
  return paper.finish();
}

}  // namespace framewise
