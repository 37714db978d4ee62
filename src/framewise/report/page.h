// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "framewise/report/run_report.h"

namespace framewise {

// What all pages are made of: a document with its style, its script and, where the program was built with it,
// plotly for scenes. The browser is told to load nothing from anywhere.
struct Page {
  std::string title;
  std::string body;  // HTML
  std::string data;  // JSON for the script (html_json)
  bool has_scene = false;
};
std::string html_page(const Page& page);

// A part of a page under a heading; is_open: without, it opens when its heading is clicked.
std::string html_section(const std::string& id, const std::string& heading, const std::string& content);
std::string html_folded(const std::string& heading, const std::string& content);

// Where a scene is drawn, with the button that asks for it; a sentence in a program without plotly.
std::string html_scene();

std::string html_hints(const std::vector<Hint>& hints);

// A number for a page's data: as many digits as the eye needs, null for what is not finite.
nlohmann::ordered_json brief(double value, int decimals);

}  // namespace framewise
