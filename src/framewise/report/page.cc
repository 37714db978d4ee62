// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/report/page.h"

#include <fmt/format.h>

#include <cmath>

#include "framewise/report/html.h"
#include "framewise/report/page_assets.h"
#include "framewise/report/plot_style.h"

namespace framewise {
namespace {

// Nothing is loaded: what the page needs is in it. plotly makes functions from text.
constexpr std::string_view kPolicy =
    "default-src 'none'; script-src 'unsafe-inline' 'unsafe-eval'; style-src 'unsafe-inline'; img-src data: "
    "blob:";

}  // namespace

std::string html_page(const Page& page) {
  const std::string title = html_text(page.title);
  std::string html = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"{}\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<link rel=\"icon\" href=\"data:,\">\n<title>{}</title>\n<style>\n",
      kPolicy, title);
  html += page_assets::style();
  html += page_plot_style();
  html += "\n</style>\n</head>\n<body>\n" + page.body + "<script type=\"application/json\" id=\"data\">" +
          page.data + "</script>\n<script>\n";
  html += page_assets::script();
  html += "</script>\n";
  if (page.has_scene && !page_assets::plotly().empty()) {
    html += "<script type=\"text/plain\" id=\"plotly\">";  // the script runs it when the page is shown
    html += page_assets::plotly();
    html += "</script>\n";
  }
  return html + "</body>\n</html>\n";
}

std::string html_section(const std::string& id, const std::string& heading, const std::string& content) {
  return fmt::format("<section id=\"{}\">\n<h2>{}</h2>\n{}</section>\n", id, html_text(heading), content);
}

std::string html_folded(const std::string& heading, const std::string& content) {
  return fmt::format("<details>\n<summary>{}</summary>\n{}</details>\n", html_text(heading), content);
}

std::string html_scene() {
  if (page_assets::plotly().empty())
    return "<p class=\"quiet\">This program was built without plotly: trajectories stand below from three "
           "sides.</p>\n";
  return "<button type=\"button\" id=\"draw-scene\" hidden>Draw in 3D (some seconds without a graphics "
         "card)</button>\n"
         "<div id=\"space\" hidden></div>\n";
}

std::string html_hints(const std::vector<Hint>& hints) {
  if (hints.empty()) return "";
  std::string html = "<ul class=\"hints\">\n";
  for (const bool warnings : {true, false})
    for (const Hint& hint : hints)
      if (hint.is_warning == warnings)
        html +=
            fmt::format("<li class=\"{}\">{}</li>\n", warnings ? "warning" : "note", html_text(hint.text));
  return html + "</ul>\n";
}

nlohmann::ordered_json brief(double value, int decimals) {
  if (!std::isfinite(value)) return nullptr;
  const double unit = std::pow(10, decimals), rounded = std::round(value * unit);
  if (std::abs(rounded) < 1e15) value = rounded / unit;
  if (value == std::round(value) && std::abs(value) < 1e15) return static_cast<std::int64_t>(value);
  return value;
}

}  // namespace framewise
