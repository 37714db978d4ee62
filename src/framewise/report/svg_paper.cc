// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/report/svg_paper.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "framewise/report/html.h"

namespace framewise {
namespace {

constexpr double kLetterWidth = 6.4;

// Tenths of a pixel, without a fraction where there is none.
std::string px(double value) {
  const double tenths = std::round(10 * value) / 10;
  return fmt::format("{:.6g}", tenths == 0 ? 0 : tenths);
}

}  // namespace

SvgPaper::SvgPaper(double width, double height, const std::string& label)
    : head_(fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"plot\" viewBox=\"0 0 {0} {1}\" "
                        "width=\"{0}\" height=\"{1}\" role=\"img\" aria-label=\"{2}\"",
                        px(width), px(height), html_text(label))) {}

void SvgPaper::note(const std::string& name, double value) {
  head_ += fmt::format(" data-{}=\"{:.9g}\"", name, value);
}

void SvgPaper::text(double x, double y, const std::string& classes, const std::string& text) {
  body_ +=
      fmt::format("<text x=\"{}\" y=\"{}\" class=\"{}\">{}</text>", px(x), px(y), classes, html_text(text));
}

void SvgPaper::begin_group(const std::string& classes, const std::string& key) {
  body_ += fmt::format("<g class=\"{}\"", html_text(classes));
  if (!key.empty()) body_ += fmt::format(" data-key=\"{}\"", html_text(key));
  body_ += ">";
}

void SvgPaper::end_group() { body_ += "</g>\n"; }

void SvgPaper::rectangle(double x, double y, double width, double height, const std::string& classes) {
  body_ += fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" class=\"{}\"/>", px(x), px(y),
                       px(width), px(height), classes);
}

void SvgPaper::line(double x1, double y1, double x2, double y2, const std::string& classes) {
  path(fmt::format("M{} {}L{} {}", px(x1), px(y1), px(x2), px(y2)), classes);
}

void SvgPaper::path(const std::string& commands, const std::string& classes) {
  if (!commands.empty()) body_ += fmt::format("<path d=\"{}\" class=\"{}\"/>", commands, classes);
}

void SvgPaper::diamond(double x, double y, double radius, const std::string& classes) {
  path(fmt::format("M{} {}l{} {}l{} {}l{} {}z", px(x - radius), px(y), px(radius), px(-radius), px(radius),
                   px(radius), px(-radius), px(radius)),
       classes);
}

void SvgPaper::dot(double x, double y, const std::string& classes, const std::string& hint) {
  body_ += fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"3.5\" class=\"{}\"", px(x), px(y), classes);
  body_ += hint.empty() ? "/>" : fmt::format("><title>{}</title></circle>", html_text(hint));
}

void SvgPaper::axes(const PlotAxis& x, const PlotAxis& y, const std::string& x_label,
                    const std::string& y_label) {
  const double top = std::min(y.start, y.start + y.length), bottom = top + std::abs(y.length);
  begin_group("axis");
  for (const double tick : x.ticks()) {
    line(x.at(tick), top, x.at(tick), bottom, "grid");
    text(x.at(tick), bottom + 14, "middle", tick_text(tick));
  }
  for (const double tick : y.ticks()) {
    line(x.start, y.at(tick), x.start + x.length, y.at(tick), "grid");
    text(x.start - 5, y.at(tick) + 4, "end", tick_text(tick));
  }
  rectangle(x.start, top, x.length, bottom - top, "grid");
  text(x.start + x.length, bottom + 28, "end", x_label);
  text(4, top - 6, "", y_label);
  end_group();
}

double SvgPaper::legend(double x, double y, double width,
                        const std::vector<std::pair<std::string, std::string>>& name_and_ink) {
  constexpr double kLineHeight = 15;
  double at = x, line_y = y;
  for (const auto& [name, ink] : name_and_ink) {
    const double item = 16 + text_width(name) + 10;
    if (at > x && at + item > x + width) at = x, line_y += kLineHeight;
    begin_group("ink-" + ink);
    rectangle(at, line_y - 8, 10, 8, "area");
    end_group();
    text(at + 14, line_y, "", name);
    at += item;
  }
  return name_and_ink.empty() ? 0 : line_y - y + kLineHeight;
}

std::string SvgPaper::finish() const { return head_ + ">\n" + body_ + "</svg>\n"; }

std::string curve_commands(const std::vector<double>& x, const std::vector<double>& y) {
  constexpr std::size_t kColumns = 400;
  // Of each run of points the first, the lowest, the highest and the last.
  const std::size_t run = std::max<std::size_t>(1, x.size() / kColumns);
  std::string commands;
  bool is_down = false;
  const auto draw_to = [&](std::size_t i) {
    commands += fmt::format("{}{} {}{}", is_down ? 'L' : 'M', px(x[i]), px(y[i]),
                            is_down ? "" : "h0");  // so that a lone point shows
    is_down = true;
  };
  for (std::size_t from = 0; from < x.size();) {
    if (!std::isfinite(x[from]) || !std::isfinite(y[from])) {
      is_down = false;
      ++from;
      continue;
    }
    std::size_t to = from, low = from, high = from;
    for (; to < x.size() && to < from + 4 * (run > 1 ? run : 0) + 1 && std::isfinite(x[to]) &&
           std::isfinite(y[to]);
         ++to) {
      if (y[to] < y[low]) low = to;
      if (y[to] > y[high]) high = to;
    }
    std::vector<std::size_t> kept{from, std::min(low, high), std::max(low, high), to - 1};
    kept.erase(std::unique(kept.begin(), kept.end()), kept.end());
    for (const std::size_t i : kept) draw_to(i);
    from = to;
  }
  return commands;
}

double text_width(const std::string& text) {
  return kLetterWidth * static_cast<double>(std::count_if(
                            text.begin(), text.end(), [](unsigned char c) { return (c & 0xC0) != 0x80; }));
}

}  // namespace framewise
