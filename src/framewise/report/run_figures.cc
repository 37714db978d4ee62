// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "framewise/report/run_report.h"

namespace framewise {
namespace {

using Values = std::vector<double>;
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kDegrees = 180 / 3.14159265358979323846;

Values positions(const Trajectory& trajectory, int axis) {
  Values values;
  for (const Pose& pose : trajectory.world_from_cam) values.push_back(pose.t[axis]);
  return values;
}

// From each true position to the estimated one; no more than a reader can tell apart.
Values differences(const TrajectoryPair& poses, int axis) {
  constexpr std::size_t kMost = 150;
  Values values;
  const std::size_t every = std::max<std::size_t>(1, poses.size() / kMost);
  for (std::size_t i = 0; i < poses.size(); i += every)
    values.insert(values.end(), {poses.reference.world_from_cam[i].t[axis],
                                 poses.estimate.world_from_cam[i].t[axis], kNaN});
  return values;
}

// World axes as the camera has them: seen from above the camera's z is ahead and y is down.
Plot map(const RunReport& report, const std::string& name, int across, int up) {
  constexpr std::string_view kAxes = "xyz";
  Plot plot;
  plot.name = name;
  plot.title = fmt::format("Trajectory, {} over {}", kAxes[up], kAxes[across]);
  plot.x_label = fmt::format("{} (m)", kAxes[across]);
  plot.y_label = fmt::format("{} (m)", kAxes[up]);
  plot.has_equal_scales = true;
  plot.nothing = "no pose";
  const auto add = [&](const char* series_name, const char* ink, Values x, Values y) {
    if (!x.empty()) plot.series.push_back({series_name, ink, std::move(x), std::move(y), {}, "", false, {}});
  };
  if (const auto& e = report.evaluation) {
    add("difference", "difference", differences(e->poses, across), differences(e->poses, up));
    add("truth", "truth", positions(e->poses.reference, across), positions(e->poses.reference, up));
    add("estimate", "estimate", positions(e->poses.estimate, across), positions(e->poses.estimate, up));
    const Trajectory last = transformed(e->reference_from_estimate, report.final);
    add("final", "final", positions(last, across), positions(last, up));
  } else {
    add("estimate", "estimate", positions(report.estimate, across), positions(report.estimate, up));
    add("final", "final", positions(report.final, across), positions(report.final, up));
  }
  return plot;
}

Plot over_time(const std::string& name, const std::string& title, const std::string& y_label) {
  Plot plot;
  plot.name = name;
  plot.title = title;
  plot.x_label = "time (s)";
  plot.y_label = y_label;
  plot.follows_frames = true;
  return plot;
}

class ErrorCurves {
 public:
  ErrorCurves(const Evaluation& e, double start) : e_(e) {
    for (const double time : e.poses.estimate.times) pose_times_.push_back(time - start);
    for (const RelativeMotion& motion : e.motions) motion_times_.push_back(motion.to_time - start);
  }

  std::vector<Plot> plots() const {
    const RelativeErrorOrder order = e_.options.relative.resolved_order();
    const std::string delta =
        fmt::format("over {:g} {}", e_.options.relative.delta, name_of(e_.options.relative.unit));
    std::vector<Plot> plots;
    plots.push_back(curve("error-position",
                          "Distance from the truth, aligned by " + name_of(e_.options.alignment), "m",
                          pose_times_, absolute_errors(e_.poses, PoseRelation::kTranslation)));
    plots.back().levels = {{e_.static_baseline.ate, "RMSE of a camera that never moved"}};
    plots.push_back(curve("error-step-translation", "Translation error " + delta, "m", motion_times_,
                          relative_errors(e_.motions, PoseRelation::kTranslation, order)));
    add_level(plots.back(), e_.static_baseline.rpe_translation);
    Values angles = relative_errors(e_.motions, PoseRelation::kRotationAngle, order);
    for (double& angle : angles) angle *= kDegrees;
    plots.push_back(curve("error-step-rotation", "Rotation error " + delta, "deg", motion_times_, angles));
    add_level(plots.back(), e_.static_baseline.rpe_rotation_deg);
    plots.push_back(by_axis());
    plots.push_back(cumulative());
    return plots;
  }

 private:
  static void add_level(Plot& plot, const std::optional<double>& still) {
    if (still) plot.levels = {{*still, "RMSE of a camera that never moved"}};
  }
  static Plot curve(const std::string& name, const std::string& title, const std::string& unit,
                    const Values& times, Values errors) {
    Plot plot = over_time(name, title, unit);
    plot.series = {{"", "difference", times, std::move(errors), {}, "", false, {}}};
    plot.nothing = "no two poses are delta apart";
    return plot;
  }
  Plot by_axis() const {
    Plot plot = over_time("error-by-axis", "Estimate minus truth by axis of the truth's world", "m");
    for (int axis = 0; axis < 3; ++axis) {
      Values values;
      for (std::size_t i = 0; i < e_.poses.size(); ++i)
        values.push_back(e_.poses.estimate.world_from_cam[i].t[axis] -
                         e_.poses.reference.world_from_cam[i].t[axis]);
      const std::string axis_name(1, "xyz"[axis]);
      plot.series.push_back({axis_name, axis_name, pose_times_, std::move(values), {}, "", false, {}});
    }
    return plot;
  }
  Plot cumulative() const {
    Plot plot =
        over_time("error-cumulative", "Cumulative deviation: sum of the distances by axis so far", "m");
    const auto sums = cumulative_deviation(e_.poses);
    for (int axis = 0; axis < 3; ++axis) {
      const std::string axis_name(1, "xyz"[axis]);
      plot.series.push_back({axis_name,
                             axis_name,
                             pose_times_,
                             Values(sums.col(axis).begin(), sums.col(axis).end()),
                             {},
                             "",
                             false,
                             {}});
    }
    return plot;
  }

  const Evaluation& e_;
  Values pose_times_, motion_times_;
};

Values member_of(const std::vector<ReportedFrame>& frames, double ReportedFrame::*member) {
  Values values;
  for (const ReportedFrame& frame : frames) values.push_back(frame.*member);
  return values;
}

std::vector<Plot> frame_curves(const std::vector<ReportedFrame>& frames, const Values& times) {
  const auto series = [&](const char* name, const char* ink, double ReportedFrame::*member) {
    return Plot::Series{name, ink, times, member_of(frames, member), {}, "", false, {}};
  };
  Plot matches = over_time("matches", "Matches and inliers", "count");
  matches.series = {series("matches", "matches", &ReportedFrame::matches),
                    series("inliers", "inliers", &ReportedFrame::inliers)};
  Plot parallax =
      over_time("parallax", "Parallax: what the step's translation moves the inliers by (median)", "deg");
  parallax.series = {series("", "estimate", &ReportedFrame::parallax_deg)};
  parallax.nothing = "not known: no column parallax_deg with a value in frames.csv";
  Plot stages = over_time("milliseconds", "Milliseconds by stage", "ms");
  stages.series = {series("load", "load", &ReportedFrame::load_ms),
                   series("features", "features", &ReportedFrame::features_ms),
                   series("match", "match", &ReportedFrame::match_ms),
                   series("step", "step", &ReportedFrame::step_ms)};
  return {matches, parallax, stages};
}

}  // namespace

double first_time(const RunReport& report) {
  for (const ReportedFrame& frame : report.frames)
    if (std::isfinite(frame.time)) return frame.time;
  return 0;
}

Figures run_figures(const RunReport& report) {
  Figures figures;
  for (const auto& [name, across, up] : {std::tuple("map-xy", 0, 1), {"map-xz", 0, 2}, {"map-yz", 1, 2}})
    figures.maps.push_back(map(report, name, across, up));
  const double start = first_time(report);
  Values times;
  for (const ReportedFrame& frame : report.frames) times.push_back(frame.time - start);
  if (report.evaluation) figures.curves = ErrorCurves(*report.evaluation, start).plots();
  for (Plot& plot : frame_curves(report.frames, times)) figures.curves.push_back(std::move(plot));
  figures.statuses.name = "statuses";
  figures.statuses.title = "Status of each frame";
  for (std::size_t i = 0; i < times.size(); ++i) {
    if (!std::isfinite(times[i])) continue;
    figures.statuses.times.push_back(times[i]);
    figures.statuses.inks.push_back(report.frames[i].status);
  }
  if (const Values& known = figures.statuses.times; known.size() > 1)
    figures.statuses.end = 2 * known.back() - known[known.size() - 2];
  return figures;
}

std::vector<std::pair<std::string, std::string>> run_figure_files(const RunReport& report) {
  const Figures figures = run_figures(report);
  std::vector<std::pair<std::string, std::string>> files;
  for (const auto* plots : {&figures.maps, &figures.curves})
    for (const Plot& plot : *plots) files.emplace_back(plot.name, standalone_svg(plot_svg(plot)));
  files.emplace_back(figures.statuses.name, standalone_svg(strip_svg(figures.statuses)));
  return files;
}

}  // namespace framewise
