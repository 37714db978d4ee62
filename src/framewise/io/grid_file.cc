// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/io/grid_file.h"

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <fstream>
#include <iterator>

#include "framewise/io/input_error.h"

namespace framewise {
namespace {

constexpr const char* kRowExpected = "a row such as {name: Kabsch, solver: kabsch}";

// An option's values, each with its part of the name.
struct Axis {
  std::string option;
  std::vector<std::pair<std::string, std::string>> values;  // part, value
};

std::size_t line_of(const YAML::Node& node) { return static_cast<std::size_t>(node.Mark().line + 1); }

std::string kind_of(const YAML::Node& node) {
  if (node.IsScalar()) return "'" + node.Scalar() + "'";
  return node.IsSequence() ? "a list" : node.IsMap() ? "a map" : "nothing";
}

class GridParser {
 public:
  explicit GridParser(const std::filesystem::path& source) { grid_.source = source; }

  Grid parse(const YAML::Node& root) {
    if (!root.IsMap()) refuse(root, "", root.IsNull() ? "an empty grid" : kind_of(root), "rows: or axes:");
    for (const auto& entry : root) {
      const std::string key = entry.first.Scalar();
      if (key != "axes" && key != "rows" && key != "exclude" && key != "features")
        refuse(entry.first, "", "'" + key + "'", "axes, rows, exclude or features");
    }
    if (const YAML::Node axes = root["axes"]) add_methods("axes", axes, "");
    for (const YAML::Node& row : list_of_maps(root, "rows", kRowExpected))
      add_methods("rows", row, name_in(row, "rows"));
    for (const YAML::Node& rule : list_of_maps(root, "exclude", "a rule such as {solver: eigensolver}"))
      exclude(rule);
    for (const YAML::Node& row :
         list_of_maps(root, "features", "features such as {name: ORB, detector: orb}"))
      grid_.features.push_back(plain_entry(row, "features", name_in(row, "features")));
    if (grid_.features.empty()) grid_.features.push_back({"default", {}, 0});
    if (grid_.methods.empty())
      throw InputError(grid_.source, 0, "", "a grid without methods", "one row or more under rows: or axes:");
    refuse_twins(grid_.methods, "rows");
    refuse_twins(grid_.features, "features");
    return std::move(grid_);
  }

 private:
  [[noreturn]] void refuse(const YAML::Node& at, const std::string& field, const std::string& found,
                           const std::string& expected) const {
    throw InputError(grid_.source, line_of(at), field, found, expected);
  }

  std::vector<YAML::Node> list_of_maps(const YAML::Node& root, const std::string& key,
                                       const std::string& expected) const {
    std::vector<YAML::Node> maps;
    const YAML::Node list = root[key];
    if (!list || list.IsNull()) return maps;
    if (!list.IsSequence()) refuse(list, key, kind_of(list), "a list, each " + expected);
    for (const YAML::Node& item : list) {
      if (!item.IsMap()) refuse(item, key, kind_of(item), expected);
      maps.push_back(item);
    }
    return maps;
  }

  std::string plain(const YAML::Node& value, const std::string& field) const {
    if (!value.IsScalar()) refuse(value, field, kind_of(value), "one value");
    return value.Scalar();
  }

  std::string name_in(const YAML::Node& row, const std::string& field) const {
    return row["name"] ? plain(row["name"], field + ": name") : "";
  }

  Axis axis(const std::string& option, const YAML::Node& values, const std::string& field) const {
    Axis axis{option, {}};
    if (values.IsMap())
      for (const auto& entry : values)
        axis.values.emplace_back(plain(entry.first, field), plain(entry.second, field));
    else if (values.IsSequence())
      for (const YAML::Node& value : values)
        axis.values.emplace_back(plain(value, field), plain(value, field));
    else
      axis.values.emplace_back("", plain(values, field));
    if (axis.values.empty()) refuse(values, field, "no values", "one or more");
    return axis;
  }

  // The product of a row's options, the first varies slowest.
  void add_methods(const std::string& section, const YAML::Node& row, const std::string& name) {
    if (!row.IsMap()) refuse(row, section, kind_of(row), "a map of options and their values");
    std::vector<Axis> axes;
    std::size_t count = 1;
    for (const auto& entry : row) {
      const std::string option = entry.first.Scalar();
      if (option == "name" && section != "axes") continue;
      axes.push_back(axis(option, entry.second, section + ": " + option));
      count *= axes.back().values.size();
      if (count > kMostMethods) refuse(row, section, "more than 10000 methods", "fewer");
    }
    if (axes.empty()) refuse(row, section, "no options", "one or more, such as solver: kabsch");
    for (std::size_t i = 0; i < count; ++i) add_method(axes, i, count, name, line_of(row));
  }

  void add_method(const std::vector<Axis>& axes, std::size_t index, std::size_t count,
                  const std::string& name, std::size_t line) {
    GridEntry method{"", {}, line};
    std::vector<std::string> parts, values;
    if (!name.empty()) parts.push_back(name);
    for (const Axis& axis : axes) {
      count /= axis.values.size();
      const auto& [part, value] = axis.values[index / count % axis.values.size()];
      method.options.emplace_back(axis.option, value);
      if (!part.empty()) parts.push_back(part);
      values.push_back(value);
    }
    method.name = fmt::format("{}", fmt::join(parts.empty() ? values : parts, "."));
    grid_.methods.push_back(std::move(method));
  }

  GridEntry plain_entry(const YAML::Node& row, const std::string& section, const std::string& name) const {
    GridEntry entry{name, {}, line_of(row)};
    std::vector<std::string> values;
    for (const auto& item : row) {
      const std::string option = item.first.Scalar();
      if (option == "name") continue;
      entry.options.emplace_back(option, plain(item.second, section + ": " + option));
      values.push_back(entry.options.back().second);
    }
    if (entry.name.empty()) entry.name = fmt::format("{}", fmt::join(values, "."));
    if (entry.name.empty()) refuse(row, section, "neither a name nor options", "one or both");
    return entry;
  }

  void exclude(const YAML::Node& rule) {
    const OptionList wanted = plain_entry(rule, "exclude", "exclude").options;
    if (wanted.empty()) refuse(rule, "exclude", "no options", "those of the methods to leave out");
    const auto has = [](const GridEntry& method, const std::pair<std::string, std::string>& option) {
      return std::find(method.options.begin(), method.options.end(), option) != method.options.end();
    };
    const auto excluded = [&](const GridEntry& method) {
      return std::all_of(wanted.begin(), wanted.end(),
                         [&](const auto& option) { return has(method, option); });
    };
    if (std::erase_if(grid_.methods, excluded) == 0)
      refuse(rule, "exclude", "a rule that no method meets", "values that a method has");
  }

  void refuse_twins(const std::vector<GridEntry>& entries, const std::string& section) const {
    for (auto entry = entries.begin(); entry != entries.end(); ++entry)
      if (std::any_of(entries.begin(), entry, [&](const GridEntry& e) { return e.name == entry->name; }))
        throw InputError(grid_.source, entry->line, section, "the name '" + entry->name + "' twice",
                         "names that differ (name: or {part: value, ...} gives one)");
  }

  static constexpr std::size_t kMostMethods = 10000;
  Grid grid_;
};

}  // namespace

Grid parse_grid(std::string_view text, const std::filesystem::path& source) {
  YAML::Node root;
  try {
    root = YAML::Load(std::string(text));
    return GridParser(source).parse(root);
  } catch (const YAML::Exception& error) {
    throw InputError(source, static_cast<std::size_t>(error.mark.line + 1), "", error.msg, "a grid in YAML");
  }
}

Grid read_grid_file(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file || std::filesystem::is_directory(path))
    throw InputError(path, 0, "", "no file", "a grid in YAML");
  return parse_grid(std::string(std::istreambuf_iterator<char>(file), {}), path);
}

}  // namespace framewise
