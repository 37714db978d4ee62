// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace framewise {

// Curves and points over two axes. What is not finite is a gap. Inks are names of the style sheet (truth,
// estimate, difference, x, y, z, load, features, match, step, ok, lost, ...; plot_style.h has their colours).
struct Plot {
  enum class Draw { kLine, kDots };
  struct Series {
    std::string name;  // in the legend; empty: not there
    std::string ink;
    std::vector<double> x, y;
    Draw draw = Draw::kLine;
    std::string key;                 // by which a page finds it
    bool is_hidden = false;          // there, but only drawn when a page shows it
    std::vector<std::string> hints;  // of each dot, shown when pointed at
  };

  std::string name;  // of its file
  std::string title, x_label, y_label;
  std::vector<Series> series;
  std::vector<std::pair<double, std::string>> levels;  // dashed lines across, with their words
  bool has_equal_scales = false;                       // a map: a metre is as long either way
  bool is_log_x = false, is_log_y = false;             // what is not positive is then a gap
  bool follows_frames = false;                         // x is the frame's time: a page may mark one
  std::string nothing = "no finite value";             // said in its place where there is nothing to draw
};

// A figure for a page, and with standalone_svg for a file. 480 wide; maps are 480 high.
std::string plot_svg(const Plot& plot);

// A strip of colour for each frame; frame i lasts from times[i] to times[i + 1].
struct StripPlot {
  std::string name, title;
  std::vector<double> times;
  std::vector<std::string> inks;  // one for each; also what the legend says
  double end = 0;                 // of the last frame
};
std::string strip_svg(const StripPlot& plot);

// A row for each method: the median with its quartiles over repeats, or words where there is none.
struct BarPlot {
  struct Bar {
    std::string label;
    double median = 0, first_quartile = 0, third_quartile = 0;
    double published = 0;  // NaN: none
    std::string missing;   // why there is no figure; empty where there is
    bool is_best = false;
  };
  std::string name, title, x_label;
  std::vector<Bar> bars;
  double level = 0;  // a dashed line with its words; NaN: none
  std::string level_name;
};
std::string bar_svg(const BarPlot& plot);

// The figure as a file of its own, on white, with its colours in it.
std::string standalone_svg(const std::string& svg);

}  // namespace framewise
