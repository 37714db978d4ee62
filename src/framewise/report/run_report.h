// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "framewise/evaluation/evaluation.h"
#include "framewise/report/plot.h"

namespace framewise {

// A frame of a run. What is not known is NaN.
struct ReportedFrame {
  double time = 0;  // s
  std::string status;
  double matches = 0, inliers = 0;
  double parallax_deg = 0;  // median over the inliers
  double load_ms = 0, features_ms = 0, match_ms = 0, step_ms = 0;
};

// A match in pixels of the camera's image, from where its feature was to where it is.
struct DrawnMatch {
  float x1 = 0, y1 = 0, x2 = 0, y2 = 0;
  bool is_inlier = false;
};

// A small image of a frame with its matches to the frame before.
struct MatchImage {
  std::size_t index = 0;  // of the frame
  std::string jpeg;       // empty where there are only matches
  std::vector<DrawnMatch> matches;
};

// All that the page about a run is made of.
struct RunReport {
  std::string title;              // name of the recording
  std::string command, machine;   // as they were; empty where not known
  nlohmann::ordered_json record;  // run.json
  std::vector<ReportedFrame> frames;
  Trajectory estimate, final, truth;           // world_from_cam; empty where there is none
  std::optional<Evaluation> evaluation;        // of the estimate
  std::optional<Evaluation> final_evaluation;  // where later frames moved poses
  int image_width = 0, image_height = 0;
  std::vector<MatchImage> images;    // by index
  std::vector<std::string> missing;  // what could not be read or made, and why: a sentence each
};

// What times are counted from: that of the first frame that has one (s).
double first_time(const RunReport& report);

// The same curves for the page and for files.
struct Figures {
  std::vector<Plot> maps;    // trajectories from three sides
  std::vector<Plot> curves;  // over time
  StripPlot statuses;
};
Figures run_figures(const RunReport& report);

// A name for a file, and the figure.
std::vector<std::pair<std::string, std::string>> run_figure_files(const RunReport& report);

// Where a reader would draw a wrong conclusion. A warning is about the figures, a note about their meaning.
struct Hint {
  bool is_warning = false;
  std::string text;
};
std::vector<Hint> run_hints(const RunReport& report);

// The page: one HTML file that needs nothing else. Long runs are decimated in it.
std::string run_page(const RunReport& report);

}  // namespace framewise
