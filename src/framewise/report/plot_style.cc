// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/report/plot_style.h"

#include <fmt/format.h>

namespace framewise {
namespace {

constexpr std::string_view kShapes =
    "svg.plot{font:11px 'DejaVu Sans',system-ui,sans-serif}"
    ".plot text{fill:currentColor;stroke:none}.plot .title{font-weight:bold;font-size:12px}"
    ".plot .line{fill:none;stroke:currentColor;stroke-width:1.4;stroke-linejoin:round;stroke-linecap:round}"
    ".plot .dots{fill:none;stroke:currentColor;stroke-width:5;stroke-linecap:round}"
    ".plot .area{fill:currentColor;stroke:none}.plot .hollow{fill:none;stroke:currentColor;stroke-width:1.2}"
    ".plot .box{fill:currentColor;fill-opacity:.3;stroke:none}"
    ".plot .level{stroke:currentColor;stroke-width:1;stroke-dasharray:5 4;fill:none}"
    ".plot .end{text-anchor:end}.plot .middle{text-anchor:middle}.plot .off{display:none}";

std::string inks(const std::string& before, std::string_view Ink::*color) {
  std::string rules;
  for (const Ink& ink : kInks) rules += fmt::format("{}.ink-{}{{color:{}}}", before, ink.name, ink.*color);
  return rules;
}

}  // namespace

std::string page_plot_style() {
  return fmt::format(
      "{}.plot .halo{{paint-order:stroke;stroke:var(--paper);stroke-width:3px}}"
      ".plot .grid{{stroke:var(--grid);fill:none}}.plot .axis{{color:var(--muted)}}{}"
      "@media (prefers-color-scheme:dark){{{}}}{}",
      kShapes, inks("", &Ink::light), inks(":root:not([data-theme=light]) ", &Ink::dark),
      inks(":root[data-theme=dark] ", &Ink::dark));
}

std::string file_plot_style() {
  return fmt::format(
      "svg.plot{{color:#222}}{}.plot .halo{{paint-order:stroke;stroke:#fff;stroke-width:3px}}.plot "
      ".grid{{stroke:#ddd;fill:none}}.plot .axis{{color:#555}}{}",
      kShapes, inks("", &Ink::light));
}

}  // namespace framewise
