// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "method_options.h"

#include <fmt/format.h>

#include <set>

namespace framewise::apps {

void add_method_options(CLI::App& app, OdometryOptions& options) {
  const auto add = [&](const std::string& name, auto& field, const char* help) {
    app.add_option("--" + name, field, help)->capture_default_str();
  };
  visit_solver_options(options, add);
  visit_correspondence_options(options, add);
}

void add_map_options(CLI::App& app, OdometryOptions& options) {
  visit_map_options(options, [&](const std::string& name, auto& field, const char* help) {
    app.add_option("--" + name, field, help)->capture_default_str();
  });
}

std::vector<std::string> method_options_chosen(const CLI::App& app) {
  // What both a map and a pair of frames are told.
  static const std::set<std::string> kShared = {
      "depth-border-px",   "min-depth",          "max-depth", "depth-max-edge",
      "depth-noise-floor", "depth-noise-growth", "threads",   "seed"};
  OdometryOptions options;
  std::vector<std::string> chosen;
  const auto look = [&](const std::string& name, const auto&, const char*) {
    if (!kShared.contains(name) && app.get_option("--" + name)->count() > 0) chosen.push_back(name);
  };
  visit_solver_options(options, look);
  visit_correspondence_options(options, look);
  return chosen;
}

nlohmann::ordered_json options_json(OdometryOptions options) {
  options.matcher = options.matcher_for(options.input);
  nlohmann::ordered_json json;
  const auto add = [&](const char* name, const auto& field, const char*) { json[name] = field; };
  visit_solver_options(options, add);
  visit_correspondence_options(options, add);
  return json;
}

nlohmann::ordered_json map_options_json(OdometryOptions options) {
  nlohmann::ordered_json json;
  visit_map_options(options, [&](const char* name, const auto& field, const char*) { json[name] = field; });
  return json;
}

std::map<std::string, std::string> correspondence_option_texts(OdometryOptions options) {
  options.matcher = options.matcher_for(options.input);
  std::map<std::string, std::string> texts;
  visit_correspondence_options(options, [&](const char* name, const auto& field, const char*) {
    texts[name] = fmt::format("{}", field);
  });
  return texts;
}

}  // namespace framewise::apps
