// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/report/comparison_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace framewise {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

using RowIndices = std::vector<std::size_t>;

RowIndices rows_on(const Comparison& comparison, std::size_t dataset) {
  RowIndices rows;
  for (std::size_t i = 0; i < comparison.rows.size(); ++i)
    if (comparison.rows[i].dataset == comparison.datasets[dataset].name) rows.push_back(i);
  return rows;
}

std::string why_missing(const ComparisonRow& row) {
  return row.failed == row.repeats && row.failed > 0 ? "failed" : row.no_errors;
}

// An error of a row as bars show it: what it is called, where it is, and what others published.
struct ErrorKind {
  const char* name;
  const char* title;
  const char* unit;
  Spread (*spread)(const ComparedErrors&);
  bool (*is_best)(const ComparedErrors&);
  std::optional<double> PublishedResult::*published;
  std::optional<double> ComparedDataset::*still;
};

constexpr ErrorKind kErrorKinds[] = {
    {"ate", "Absolute trajectory error", "RMSE (m)", [](const ComparedErrors& e) { return e.ate; },
     [](const ComparedErrors&) { return false; }, &PublishedResult::ate, &ComparedDataset::static_ate},
    {"rpe-translation", "Relative translation error", "RMSE (mm)",
     [](const ComparedErrors& e) { return e.rpe_translation_mm.rmse; },
     [](const ComparedErrors& e) { return e.rpe_translation_mm.is_best; },
     &PublishedResult::rpe_translation_mm, &ComparedDataset::static_rpe_translation_mm},
    {"rpe-rotation", "Relative rotation error", "RMSE (deg)",
     [](const ComparedErrors& e) { return e.rpe_rotation_deg.rmse; },
     [](const ComparedErrors& e) { return e.rpe_rotation_deg.is_best; }, &PublishedResult::rpe_rotation_deg,
     &ComparedDataset::static_rpe_rotation_deg}};

BarPlot error_bars(const Comparison& comparison, const ComparedDataset& dataset, const RowIndices& rows,
                   const ErrorKind& kind) {
  BarPlot plot;
  plot.name = kind.name;
  plot.title = kind.title;
  plot.x_label = fmt::format("{}, median and quartiles over {} seed{}", kind.unit, comparison.repeats,
                             comparison.repeats == 1 ? "" : "s");
  if (comparison.has_published) plot.x_label += "; diamond: published";
  plot.level = (dataset.*kind.still).value_or(kUnknown);
  plot.level_name = "never moved";
  for (const std::size_t i : rows) {
    const ComparisonRow& row = comparison.rows[i];
    BarPlot::Bar bar;
    bar.label = row_label(row);
    bar.published = row.published ? (*row.published.*kind.published).value_or(kUnknown) : kUnknown;
    if (row.errors) {
      const Spread s = kind.spread(*row.errors);
      bar.median = s.median;
      bar.first_quartile = s.first_quartile;
      bar.third_quartile = s.third_quartile;
      bar.is_best = kind.is_best(*row.errors);
    } else {
      bar.missing = why_missing(row);
    }
    plot.bars.push_back(std::move(bar));
  }
  return plot;
}

// Features, matches and the method where all were timed, else the method alone.
double cost_ms(const ComparedTimes& times) {
  return times.features_ms.value_or(0) + times.match_ms.value_or(0) + times.solve_ms;
}

// Of points (cost, error) those that no other beats in both, by cost.
std::vector<std::pair<double, double>> pareto_front(std::vector<std::pair<double, double>> points) {
  std::sort(points.begin(), points.end());
  std::vector<std::pair<double, double>> front;
  for (const auto& point : points)
    if (front.empty() || point.second < front.back().second) front.push_back(point);
  return front;
}

Plot cost_plot(const Comparison& comparison, const RowIndices& rows) {
  Plot plot;
  plot.name = "error-over-time-cost";
  plot.title = "Error over time cost";
  plot.x_label = "ms a frame on one core: features, match and solve, as far as timed";
  plot.y_label = "RPE translation, RMSE (mm)";
  plot.is_log_x = plot.is_log_y = true;
  plot.nothing = "no row has both an error and a time";
  Plot::Series rows_series{"a row", "estimate", {}, {}, Plot::Draw::kDots, "rows", false, {}};
  std::vector<std::pair<double, double>> points;
  for (const std::size_t i : rows) {
    const ComparisonRow& row = comparison.rows[i];
    if (!row.errors || !row.times) continue;
    points.emplace_back(cost_ms(*row.times), row.errors->rpe_translation_mm.rmse.median);
    rows_series.x.push_back(points.back().first);
    rows_series.y.push_back(points.back().second);
    rows_series.hints.push_back(
        fmt::format("{}: {:.4g} mm, {:.4g} ms", row_label(row), points.back().second, points.back().first));
  }
  Plot::Series front{"none is better in both (Pareto)", "difference", {}, {}, {}, "front", false, {}};
  for (const auto& [cost, error] : pareto_front(points)) {
    front.x.push_back(cost);
    front.y.push_back(error);
  }
  plot.series = {std::move(front), std::move(rows_series)};
  return plot;
}

Plot::Series map_series(const Trajectory& trajectory, const std::string& ink, int across, int up) {
  Plot::Series series;
  series.ink = ink;
  for (const std::size_t i : drawn_points(trajectory)) {
    series.x.push_back(trajectory.world_from_cam[i].t[across]);
    series.y.push_back(trajectory.world_from_cam[i].t[up]);
  }
  return series;
}

Plot map_of_rows(const ComparisonReport& report, std::size_t dataset, const RowIndices& rows, int across,
                 int up) {
  constexpr std::string_view kAxisNames = "xyz";
  Plot plot;
  plot.name = fmt::format("map-{}{}", kAxisNames[across], kAxisNames[up]);
  plot.title = fmt::format("Trajectories, {} over {}", kAxisNames[up], kAxisNames[across]);
  plot.x_label = fmt::format("{} (m)", kAxisNames[across]);
  plot.y_label = fmt::format("{} (m)", kAxisNames[up]);
  plot.has_equal_scales = true;
  plot.nothing = "no trajectory";
  plot.series.push_back(map_series(report.truths[dataset], "truth", across, up));
  if (!plot.series.back().x.empty()) plot.series.back().name = "truth";
  for (const std::size_t i : rows) {
    if (report.trajectories[i].empty()) continue;
    const auto& errors = report.comparison.rows[i].errors;
    Plot::Series series = map_series(report.trajectories[i], "estimate", across, up);
    series.key = std::to_string(i);
    series.is_hidden = !errors || !errors->rpe_translation_mm.is_best;
    if (!series.is_hidden) series.name = row_label(report.comparison.rows[i]);
    plot.series.push_back(std::move(series));
  }
  return plot;
}

}  // namespace

std::string row_label(const ComparisonRow& row) {
  return row.features.empty() ? row.method : row.method + " with " + row.features;
}

std::vector<std::size_t> drawn_points(const Trajectory& trajectory) {
  constexpr std::size_t kMost = 200;
  const std::size_t count = std::min(kMost, trajectory.size());
  std::vector<std::size_t> points;
  for (std::size_t i = 0; i < count; ++i)
    points.push_back(count > 1 ? i * (trajectory.size() - 1) / (count - 1) : 0);
  return points;
}

DatasetFigures comparison_figures(const ComparisonReport& report, std::size_t dataset) {
  const Comparison& comparison = report.comparison;
  const RowIndices rows = rows_on(comparison, dataset);
  DatasetFigures figures;
  for (const ErrorKind& kind : kErrorKinds)
    figures.bars.push_back(error_bars(comparison, comparison.datasets[dataset], rows, kind));
  figures.cost = cost_plot(comparison, rows);
  for (const auto& [across, up] : {std::pair(0, 1), {0, 2}, {1, 2}})
    figures.maps.push_back(map_of_rows(report, dataset, rows, across, up));
  return figures;
}

std::vector<std::pair<std::string, std::string>> comparison_figure_files(const ComparisonReport& report) {
  std::vector<std::pair<std::string, std::string>> files;
  for (std::size_t i = 0; i < report.comparison.datasets.size(); ++i) {
    std::string name = report.comparison.datasets[i].name;
    for (char& c : name)
      if (!std::isalnum(static_cast<unsigned char>(c)) && c != '-') c = '_';
    const auto add = [&](const std::string& figure, const std::string& svg) {
      files.emplace_back(fmt::format("{}-{}-{}", i + 1, name, figure), standalone_svg(svg));
    };
    const DatasetFigures figures = comparison_figures(report, i);
    for (const BarPlot& bars : figures.bars) add(bars.name, bar_svg(bars));
    add(figures.cost.name, plot_svg(figures.cost));
    for (const Plot& map : figures.maps) add(map.name, plot_svg(map));
  }
  return files;
}

}  // namespace framewise
