// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "method_options.h"

#include <fmt/format.h>

namespace framewise::apps {

void add_method_options(CLI::App& app, OdometryOptions& options) {
  const auto add = [&](const std::string& name, auto& field, const char* help) {
    app.add_option("--" + name, field, help)->capture_default_str();
  };
  visit_solver_options(options, add);
  visit_correspondence_options(options, add);
}

nlohmann::ordered_json options_json(OdometryOptions options) {
  options.matcher = options.matcher_for(options.input);
  nlohmann::ordered_json json;
  const auto add = [&](const char* name, const auto& field, const char*) { json[name] = field; };
  visit_solver_options(options, add);
  visit_correspondence_options(options, add);
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
