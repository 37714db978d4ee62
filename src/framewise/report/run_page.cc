// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "framewise/report/html.h"
#include "framewise/report/page.h"
#include "framewise/report/record_fields.h"
#include "framewise/report/run_page_data.h"

namespace framewise {
namespace {

using Entries = std::vector<std::pair<std::string, std::string>>;

std::string facts(const RunReport& report) {
  const auto card = [](const std::string& what, const std::string& figure, const std::string& about) {
    return fmt::format("<div class=\"card\"><div>{}</div><strong>{}</strong><small>{}</small></div>\n",
                       html_text(what), html_text(figure), html_text(about));
  };
  std::string html = "<div class=\"cards\">\n";
  if (const auto& e = report.evaluation) {
    constexpr int kDigits = 3;  // at a glance; the table has more
    html += card("ATE", figure_text(e->ate.rmse, kDigits) + " m",
                 "RMSE; never moved: " + figure_text(e->static_baseline.ate, kDigits) + " m");
    if (e->rpe) {
      const std::string delta =
          fmt::format("RMSE over {:g} {}", e->options.relative.delta, name_of(e->options.relative.unit));
      html += card("RPE, translation", figure_text(1e3 * e->rpe->translation.rmse, kDigits) + " mm", delta);
      html += card("RPE, rotation", figure_text(e->rpe->rotation_deg.rmse, kDigits) + " deg", delta);
    }
  }
  if (const auto rate = record_number(report.record, "/frames_per_second"))
    html +=
        card("Speed", fmt::format("{:.1f} frames/s", *rate), fmt::format("{} frames", report.frames.size()));
  if (const auto measured = record_number(report.record, "/measured"))
    html += card("Measured", fmt::format("{:.1f} %", 100 * *measured), "of the frames");
  return html + "</div>\n";
}

Table::Cell still_cell(const std::optional<double>& still) {
  return still ? figure_text(*still) : "no pairs";
}

std::string errors_html(const Evaluation& e, const std::string& whose) {
  Table table;
  table.caption = fmt::format("Errors of {} matched poses{}", e.matched, whose);
  table.columns = {{"error", false}, {"RMSE"}, {"mean"}, {"median"},
                   {"std"},          {"min"},  {"max"},  {"never moved (RMSE)"}};
  const auto add = [&](const std::string& name, const Statistics& s, const Table::Cell& still) {
    table.rows.push_back({name, figure_text(s.rmse), figure_text(s.mean), figure_text(s.median),
                          figure_text(s.std), figure_text(s.min), figure_text(s.max), still});
  };
  add("ATE (m)", e.ate, figure_text(e.static_baseline.ate));
  add("absolute rotation (deg)", e.ate_rotation_deg, "");
  if (e.rpe) {
    add("RPE translation (m)", e.rpe->translation, still_cell(e.static_baseline.rpe_translation));
    add("RPE rotation (deg)", e.rpe->rotation_deg, still_cell(e.static_baseline.rpe_rotation_deg));
    add("RPE direction (0 to 2)", e.rpe->direction, "");
  }
  for (int axis = 0; axis < 3; ++axis)
    add(fmt::format("|{}| of the position (m)", "xyz"[axis]), e.axes.position[axis], "");
  for (int axis = 0; axis < 3; ++axis)
    add(fmt::format("|{} angle| (deg)", "xyz"[axis]), e.axes.euler_deg[axis], "");
  return html_table(table);
}

std::string evaluation_html(const RunReport& report) {
  if (!report.evaluation) return "<p>Nothing was evaluated; the hints above say why.</p>\n";
  const Evaluation& e = *report.evaluation;
  std::string tables =
      errors_html(e, report.final_evaluation ? ", causal: as known when the frame came" : "");
  if (report.final_evaluation)
    tables += errors_html(*report.final_evaluation, ", final: with what later frames told");
  const Entries definitions = {
      {"alignment", fmt::format("{}, scale {}", name_of(e.options.alignment),
                                figure_text(e.reference_from_estimate.scale))},
      {"relative error",
       fmt::format("over {:g} {}; {} pairs; E = {} (A true, B estimated motion)", e.options.relative.delta,
                   name_of(e.options.relative.unit), e.motions.size(),
                   e.options.relative.resolved_order() == RelativeErrorOrder::kEvo ? "B^-1 A" : "A B^-1")},
      {"coverage", fmt::format("{} of {} poses ({:.4g} %) judged by {} poses of the truth", e.matched,
                               e.estimate_poses, 100 * e.coverage, e.reference_poses)},
      {"path length", figure_text(e.path_length) + " m, of the truth along the matched poses"},
      {"cumulative deviation",
       fmt::format("{} m in x, {} m in y, {} m in z", figure_text(e.axes.cumulative.x()),
                   figure_text(e.axes.cumulative.y()), figure_text(e.axes.cumulative.z()))},
      {"never moved",
       "what a camera that stood still would have scored: same matches, same alignment, same pairs"},
      {"papers", "ATE and RPE: Sturm, Engelhard, Endres, Burgard, Cremers, IROS 2012, Eq. (1) to (3)"}};
  return tables + html_list(definitions);
}

std::string match_html(const RunReport& report) {
  std::string html =
      "<figure id=\"match\" hidden><div><img id=\"match-image\" alt=\"frame\"><svg "
      "id=\"match-lines\"></svg></div>"
      "<figcaption id=\"match-text\"></figcaption></figure>\n";
  if (report.images.empty())
    html += "<p class=\"quiet\">No images of frames were kept beside this run (report_data/).</p>\n";
  return html;
}

std::string scene_html(const RunReport& report, const Figures& figures) {
  std::string html = "<p class=\"legend\">";
  if (report.evaluation) html += "<span class=\"ink-truth\">truth</span> ";
  html += "<span class=\"ink-estimate\">estimate</span>";
  if (report.evaluation) html += " <span class=\"ink-difference\">difference</span>";
  html += "</p>\n<div class=\"stage\"><div>" + html_scene() + "</div>\n" + match_html(report) + "</div>\n";
  html += "<div class=\"plots\" id=\"maps\">\n";
  for (const Plot& plot : figures.maps) html += "<figure>" + plot_svg(plot) + "</figure>\n";
  return html + "</div>\n";
}

// At the foot of the window, wherever the reader is.
constexpr std::string_view kSlider =
    "<div class=\"slider\" hidden><button type=\"button\" id=\"play\" aria-label=\"play\">▶</button>"
    "<input type=\"range\" id=\"frame\" min=\"0\" value=\"0\" aria-label=\"frame\"><output "
    "id=\"frame-text\"></output>"
    "</div>\n";

std::string curves_html(const Figures& figures) {
  std::string html = "<div class=\"plots\">\n<figure>" + strip_svg(figures.statuses) + "</figure>\n";
  for (const Plot& plot : figures.curves) html += "<figure>" + plot_svg(plot) + "</figure>\n";
  return html + "</div>\n";
}

std::string method_text(const RunReport& report) {
  if (record_text(report.record, "/options/reference") == "map")
    return "Visual odometry against a local map of the frames before";
  return fmt::format("Visual odometry with {}, scale {}", record_text(report.record, "/options/solver"),
                     record_text(report.record, "/options/scale"));
}

std::string method_html(const RunReport& report) {
  Entries entries;
  const auto add = [&](const std::string& name, const std::string& place) {
    if (const std::string text = record_text(report.record, place); !text.empty())
      entries.emplace_back(name, text);
  };
  add("version", "/version");
  add("seed", "/options/seed");
  entries.emplace_back("machine", report.machine.empty() ? "not recorded" : report.machine);
  add("format", "/dataset/format");
  add("fingerprint of the recording", "/dataset/fingerprint");
  add("camera", "/dataset/camera/source");
  add("seconds", "/seconds");
  std::string html = "<p>The command that repeats this run:</p>\n<pre class=\"command\">" +
                     html_text(report.command.empty() ? "not recorded" : report.command) + "</pre>\n" +
                     html_list(entries);
  Entries options;
  if (report.record.contains("options") && report.record["options"].is_object())
    for (const auto& [name, value] : report.record["options"].items())
      options.emplace_back(name, record_text(value, ""));
  return html + html_folded("All options", html_list(options));
}

}  // namespace

std::string run_page(const RunReport& report) {
  const Figures figures = run_figures(report);
  Page page;
  page.title = report.title;
  page.has_scene = true;
  page.body = fmt::format(
      "<header><h1>{}</h1><p>{}</p><button type=\"button\" id=\"theme\">dark / "
      "light</button></header>\n<main>\n",
      html_text(report.title), html_text(method_text(report)));
  page.body += facts(report) + html_hints(run_hints(report));
  page.body +=
      "<noscript><p class=\"quiet\">Without JavaScript there is no slider and no 3D scene; figures and "
      "tables are whole.</p></noscript>\n";
  page.body += html_section("trajectory", "Trajectory", scene_html(report, figures));
  page.body += html_section("frames", "Frame by frame", curves_html(figures));
  page.body += html_section("evaluation", "Evaluation", evaluation_html(report));
  page.body += html_section("method", "Method", method_html(report));
  page.body += kSlider;
  page.body += "</main>\n";
  page.data = html_json(run_page_data(report));
  return html_page(page);
}

}  // namespace framewise
