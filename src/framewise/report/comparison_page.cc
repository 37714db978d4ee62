// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cmath>

#include "framewise/report/comparison_csv.h"
#include "framewise/report/comparison_figures.h"
#include "framewise/report/comparison_tables.h"
#include "framewise/report/html.h"
#include "framewise/report/page.h"

namespace framewise {
namespace {

// A cell that sorts by its value, and last where it has none.
std::string value_cell(const std::optional<double>& value, const std::string& otherwise,
                       const std::string& more = "") {
  if (!value) return fmt::format("<td class=\"number\">{}</td>", html_text(otherwise));
  return fmt::format("<td class=\"number\" data-value=\"{:.9g}\">{:.4g}{}</td>", *value, *value,
                     html_text(more));
}

std::string spread_cell(const std::optional<Spread>& spread, const std::string& otherwise,
                        bool is_best = false) {
  if (!spread) return value_cell(std::nullopt, otherwise);
  const bool varies = spread->first_quartile != spread->third_quartile;
  const std::string cell = value_cell(
      spread->median, "",
      varies ? fmt::format(" [{:.4g}, {:.4g}]", spread->first_quartile, spread->third_quartile) : "");
  return is_best ? "<td class=\"number best\"" + cell.substr(std::string("<td class=\"number\"").size())
                 : cell;
}

std::string text_cell(const std::string& text) { return fmt::format("<td>{}</td>", html_text(text)); }

std::string published_cells(const ComparisonRow& row) {
  const std::string none = row.published ? row.published->outcome : "–";
  const PublishedResult p = row.published.value_or(PublishedResult{});
  return value_cell(p.ate, none) + value_cell(p.rpe_translation_mm, none) +
         value_cell(p.rpe_rotation_deg, none);
}

std::string row_html(const ComparisonReport& report, std::size_t index) {
  const ComparisonRow& row = report.comparison.rows[index];
  const bool has_failed = row.failed == row.repeats && row.failed > 0;
  const std::string none = has_failed ? "failed" : row.no_errors;
  const auto spread_of = [&](auto get) {
    return row.errors ? std::optional<Spread>(get(*row.errors)) : std::nullopt;
  };
  std::string html = fmt::format(
      "<tr{} data-dataset=\"{}\" data-features=\"{}\"><td><input type=\"checkbox\" data-row=\"{}\" "
      "aria-label=\"draw {}\"{}{}></td>",
      has_failed ? " class=\"failed\"" : "", html_text(row.dataset), html_text(row.features), index,
      html_text(row_label(row)), report.trajectories[index].empty() ? " disabled" : "",
      row.errors && row.errors->rpe_translation_mm.is_best ? " checked" : "");
  html += text_cell(row.dataset) + text_cell(row.method) + text_cell(row.features);
  html += spread_cell(spread_of([](const ComparedErrors& e) { return e.ate; }), none);
  html += spread_cell(spread_of([](const ComparedErrors& e) { return e.rpe_translation_mm.rmse; }), none,
                      row.errors && row.errors->rpe_translation_mm.is_best);
  html += spread_cell(spread_of([](const ComparedErrors& e) { return e.rpe_rotation_deg.rmse; }), none,
                      row.errors && row.errors->rpe_rotation_deg.is_best);
  html += spread_cell(spread_of([](const ComparedErrors& e) { return e.coverage; }), none);
  html += spread_cell(row.measured, none);
  html += fmt::format("<td class=\"number\" data-value=\"{}\">{} of {}</td>", row.failed, row.failed,
                      row.repeats);
  html += value_cell(row.times ? std::optional(row.times->solve_ms) : std::nullopt, none);
  html += value_cell(row.times ? row.times->mean_frames_per_second : std::nullopt,
                     row.times ? "archive given" : none);
  if (report.comparison.has_published) html += published_cells(row);
  const std::string alignment = row.errors ? "alignment " + row.errors->alignment : "";
  return html + text_cell(row.failure.empty() ? alignment : row.failure) + "</tr>\n";
}

std::string sortable_table(const ComparisonReport& report) {
  struct Heading {
    const char* text;
    bool is_number;
  };
  std::vector<Heading> headings = {{"data set", false},  {"method", false},  {"features", false},
                                   {"ATE (m)", true},    {"RPE (mm)", true}, {"RPE (deg)", true},
                                   {"coverage", true},   {"measured", true}, {"failed", true},
                                   {"solve (ms)", true}, {"frames/s", true}};
  if (report.comparison.has_published)
    for (const char* name : {"published ATE (m)", "published RPE (mm)", "published RPE (deg)"})
      headings.push_back({name, true});
  headings.push_back({"remark", false});
  std::string html = fmt::format(
      "<div class=\"wide\"><table id=\"rows\"><caption>RMSE{}; bold: the least of its data "
      "set</caption>\n<thead><tr><th scope=\"col\">draw</th>",
      report.comparison.repeats > 1 ? ", median [quartiles] over seeds" : "");
  for (const Heading& heading : headings)
    html += fmt::format("<th scope=\"col\"{}>{}</th>", heading.is_number ? " class=\"number\"" : "",
                        heading.text);
  html += "</tr></thead>\n<tbody>\n";
  for (std::size_t i = 0; i < report.comparison.rows.size(); ++i) html += row_html(report, i);
  return html + "</tbody></table></div>\n";
}

constexpr std::string_view kControls =
    "<div class=\"controls\"><input type=\"search\" id=\"filter\" placeholder=\"filter rows\" "
    "aria-label=\"filter rows\">"
    "<select id=\"filter-dataset\" aria-label=\"data set\"></select><select id=\"filter-features\" "
    "aria-label=\"features\"></select>"
    "<output id=\"count\"></output><button type=\"button\" id=\"csv\">CSV</button><button type=\"button\" "
    "id=\"latex\">LaTeX</button></div>\n";

std::string about_dataset(const ComparedDataset& d) {
  std::string text = fmt::format("{}, {} frames, {} with depth, {} with truth", d.format, d.frames,
                                 d.frames_with_depth, d.frames_with_truth);
  if (d.path_length)
    text +=
        fmt::format("; the truth is {:.4g} m long; a camera that never moved: ATE {} m, RPE {} mm and {} deg",
                    *d.path_length, figure_text(d.static_ate.value_or(NAN)),
                    figure_text(d.static_rpe_translation_mm.value_or(NAN)),
                    figure_text(d.static_rpe_rotation_deg.value_or(NAN)));
  return text;
}

std::string trajectories_html(const std::vector<DatasetFigures>& figures) {
  std::string html =
      std::string(
          "<p class=\"quiet\">Rows that are ticked in the table are drawn: the first whole repeat of each, "
          "aligned as it was judged; at most 200 points.</p>\n"
          "<div class=\"controls\"><select id=\"scene-dataset\" aria-label=\"data set\"></select></div>\n"
          "<p class=\"legend\" id=\"drawn\"></p>\n") +
      html_scene();
  for (std::size_t i = 0; i < figures.size(); ++i) {
    html += fmt::format("<div class=\"plots maps\" data-dataset=\"{}\">\n", i);
    for (const Plot& map : figures[i].maps) html += "<figure>" + plot_svg(map) + "</figure>\n";
    html += "</div>\n";
  }
  return html;
}

std::string errors_html(const ComparisonReport& report, const std::vector<DatasetFigures>& figures) {
  std::string html;
  for (std::size_t i = 0; i < figures.size(); ++i) {
    const ComparedDataset& dataset = report.comparison.datasets[i];
    html += fmt::format("<h3>{}</h3>\n<p class=\"quiet\">{}</p>\n<div class=\"plots\">\n",
                        html_text(dataset.name), html_text(about_dataset(dataset)));
    for (const BarPlot& bars : figures[i].bars) html += "<figure>" + bar_svg(bars) + "</figure>\n";
    html += "<figure>" + plot_svg(figures[i].cost) + "</figure>\n</div>\n";
  }
  return html;
}

nlohmann::ordered_json points_json(const Trajectory& trajectory) {
  auto points = nlohmann::ordered_json::array();
  for (const std::size_t i : drawn_points(trajectory)) {
    const Eigen::Vector3d& t = trajectory.world_from_cam[i].t;
    points.push_back({brief(t.x(), 4), brief(t.y(), 4), brief(t.z(), 4)});
  }
  return points;
}

nlohmann::ordered_json comparison_data(const ComparisonReport& report) {
  auto datasets = nlohmann::ordered_json::array(), rows = datasets;
  const auto& compared = report.comparison.datasets;
  for (std::size_t i = 0; i < compared.size(); ++i)
    datasets.push_back({{"name", compared[i].name}, {"truth", points_json(report.truths[i])}});
  for (std::size_t i = 0; i < report.comparison.rows.size(); ++i) {
    const ComparisonRow& row = report.comparison.rows[i];
    rows.push_back({{"label", row_label(row)},
                    {"dataset", row.dataset},
                    {"points", points_json(report.trajectories[i])}});
  }
  return {{"kind", "comparison"},
          {"datasets", std::move(datasets)},
          {"rows", std::move(rows)},
          {"csv", to_csv(comparison_csv_table(report.comparison))},
          {"latex", comparison_latex(report.comparison)}};
}

std::string how_html(const ComparisonReport& report) {
  const Comparison& c = report.comparison;
  std::string html = "<p>The command that repeats this comparison:</p>\n<pre class=\"command\">" +
                     html_text(report.command.empty() ? "not recorded" : report.command) + "</pre>\n";
  html += html_list(
      {{"version", c.version},
       {"grid", c.grid},
       {"seeds", fmt::format("{} from {}", c.repeats, c.seed)},
       {"machine", report.machine.empty() ? "not recorded" : report.machine},
       {"intervals", fmt::format("{:g} %, moving-block bootstrap over frames, {} draws",
                                 100 * c.statistics.bootstrap.confidence, c.statistics.bootstrap.resamples)},
       {"differences", fmt::format("to the best row, frame by frame; sign flips, Holm's correction, {:g}",
                                   c.statistics.significance)}});
  for (const Table& table : comparison_tables(c)) html += html_folded(table.caption, html_table(table));
  return html;
}

}  // namespace

std::string comparison_page(const ComparisonReport& report) {
  std::vector<DatasetFigures> figures;
  for (std::size_t i = 0; i < report.comparison.datasets.size(); ++i)
    figures.push_back(comparison_figures(report, i));
  Page page;
  page.title = "Comparison: " + report.comparison.grid;
  page.has_scene = true;
  page.body = fmt::format(
      "<header><h1>{}</h1><p>{} rows on {} data sets</p><button type=\"button\" id=\"theme\">dark / "
      "light</button></header>\n<main>\n",
      html_text(page.title), report.comparison.rows.size(), report.comparison.datasets.size());
  page.body += html_hints(comparison_hints(report));
  page.body +=
      "<noscript><p class=\"quiet\">Without JavaScript tables cannot be sorted and there is no 3D scene; "
      "figures and tables are whole.</p></noscript>\n";
  page.body += html_section("table", "All rows", std::string(kControls) + sortable_table(report));
  page.body += html_section("errors", "Errors and times", errors_html(report, figures));
  page.body += html_section("trajectories", "Trajectories", trajectories_html(figures));
  page.body += html_section("how", "How it was made, and all tables", how_html(report));
  page.body += "</main>\n";
  page.data = html_json(comparison_data(report));
  return html_page(page);
}

}  // namespace framewise
