// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "framewise/report/plot_axis.h"

namespace framewise {

// What plots draw on: elements of an SVG image, one after the other.
class SvgPaper {
 public:
  SvgPaper(double width, double height, const std::string& label);

  // Names a value for the page's script: data-NAME="VALUE".
  void note(const std::string& name, double value);

  void text(double x, double y, const std::string& classes, const std::string& text);
  void begin_group(const std::string& classes, const std::string& key = "");
  void end_group();
  void rectangle(double x, double y, double width, double height, const std::string& classes);
  void line(double x1, double y1, double x2, double y2, const std::string& classes);
  void path(const std::string& commands, const std::string& classes);
  void diamond(double x, double y, double radius, const std::string& classes);
  void dot(double x, double y, const std::string& classes, const std::string& hint = "");

  // The rectangle between two axes with ticks, numbers and labels.
  void axes(const PlotAxis& x, const PlotAxis& y, const std::string& x_label, const std::string& y_label);

  // Names beside squares of their inks, in a row that breaks; returns the height taken.
  double legend(double x, double y, double width,
                const std::vector<std::pair<std::string, std::string>>& name_and_ink);

  std::string finish() const;

 private:
  std::string head_, body_;
};

// A curve through points on the paper that breaks at what is not finite; of more points than a reader can
// tell apart in the width only the extremes are kept.
std::string curve_commands(const std::vector<double>& x, const std::vector<double>& y);

// How wide letters of the figures come out, about.
double text_width(const std::string& text);

}  // namespace framewise
