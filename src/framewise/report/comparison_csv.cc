// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/report/comparison_csv.h"

#include <fmt/format.h>

#include <functional>

namespace framewise {
namespace {

// A column of the table, and what a row has in it.
struct CsvColumn {
  std::string heading;
  std::function<std::string(const ComparisonRow&, const ComparedDataset&)> text;
};
using CsvColumns = std::vector<CsvColumn>;

std::string full(double value) { return fmt::format("{}", value); }

std::string reason(const ComparisonRow& row) {
  return row.failed == row.repeats && row.failed > 0 ? "failed" : row.no_errors;
}

std::string option(const ComparisonRow& row, const std::string& name) {
  for (const auto& [option, value] : row.options)
    if (option == name) return value.empty() ? "none" : value;
  return "default";
}

using SpreadOf = std::function<std::optional<Spread>(const ComparisonRow&)>;

void add_spread(CsvColumns& columns, const std::string& name, const SpreadOf& of) {
  const auto add = [&](const char* part, double Spread::*value) {
    columns.push_back({name + "_" + part, [=](const ComparisonRow& row, const ComparedDataset&) {
                         const auto spread = of(row);
                         return spread ? full((*spread).*value) : reason(row);
                       }});
  };
  add("median", &Spread::median);
  add("q1", &Spread::first_quartile);
  add("q3", &Spread::third_quartile);
}

SpreadOf error_spread(Spread ComparedErrors::*member) {
  return [member](const ComparisonRow& row) {
    return row.errors ? std::optional((*row.errors).*member) : std::nullopt;
  };
}

// What the interval and the comparison with the best row say of a relative error.
void add_relative_error(CsvColumns& columns, const std::string& name, ComparedError ComparedErrors::*member) {
  add_spread(columns, name, [member](const ComparisonRow& row) {
    return row.errors ? std::optional(((*row.errors).*member).rmse) : std::nullopt;
  });
  const auto add = [&](const char* part, std::function<std::string(const ComparedError&)> text) {
    columns.push_back({name + "_" + part, [member, text](const ComparisonRow& row, const ComparedDataset&) {
                         return row.errors ? text((*row.errors).*member) : reason(row);
                       }});
  };
  const auto bound = [](double Interval::*end) {
    return [end](const ComparedError& e) {
      return e.interval ? full((*e.interval).*end) : "fewer than 6 frames";
    };
  };
  const auto difference = [](std::function<std::string(const PairedDifference&)> text) {
    return [text](const ComparedError& e) {
      return e.is_best ? "best" : e.to_best ? text(*e.to_best) : "other frames";
    };
  };
  add("ci95_low", bound(&Interval::low));
  add("ci95_high", bound(&Interval::high));
  add("minus_best", difference([](const PairedDifference& d) { return full(d.median); }));
  add("minus_best_ci95_low", difference([](const PairedDifference& d) {
        return d.interval ? full(d.interval->low) : "fewer than 6 frames";
      }));
  add("minus_best_ci95_high", difference([](const PairedDifference& d) {
        return d.interval ? full(d.interval->high) : "fewer than 6 frames";
      }));
  add("p", difference([](const PairedDifference& d) { return full(d.p); }));
  add("p_holm", difference([](const PairedDifference& d) { return full(d.p_holm); }));
  add("real", difference([](const PairedDifference& d) { return d.is_real ? "yes" : "no"; }));
}

CsvColumns name_columns() {
  CsvColumns columns{
      {"dataset", [](const ComparisonRow& row, const ComparedDataset&) { return row.dataset; }},
      {"method", [](const ComparisonRow& row, const ComparedDataset&) { return row.method; }},
      {"features", [](const ComparisonRow& row, const ComparedDataset&) { return row.features; }}};
  for (const char* name :
       {"solver", "scale", "error", "ransac", "input", "detector", "descriptor", "matcher", "rotation"})
    columns.push_back(
        {name, [name](const ComparisonRow& row, const ComparedDataset&) { return option(row, name); }});
  return columns;
}

void add_status_columns(CsvColumns& columns) {
  columns.push_back({"repeats", [](const ComparisonRow& row, const ComparedDataset&) {
                       return fmt::format("{}", row.repeats);
                     }});
  columns.push_back({"failed", [](const ComparisonRow& row, const ComparedDataset&) {
                       return fmt::format("{}", row.failed);
                     }});
  add_spread(columns, "measured", [](const ComparisonRow& row) { return row.measured; });
  for (const char* status : {"ok", "low-parallax", "rotation-only", "predicted", "no-depth", "lost"})
    columns.push_back(
        {std::string("frames_") + status, [status](const ComparisonRow& row, const ComparedDataset&) {
           for (const auto& [name, frames] : row.statuses)
             if (name == status) return full(frames.median);
           return reason(row);
         }});
  columns.push_back({"missing_pairs", [](const ComparisonRow& row, const ComparedDataset&) {
                       return row.missing_pairs ? full(row.missing_pairs->median) : reason(row);
                     }});
}

void add_truth_columns(CsvColumns& columns) {
  const auto add_text = [&](const char* name, std::function<std::string(const ComparedErrors&)> text) {
    columns.push_back({name, [text](const ComparisonRow& row, const ComparedDataset&) {
                         return row.errors ? text(*row.errors) : reason(row);
                       }});
  };
  add_text("alignment", [](const ComparedErrors& e) { return e.alignment; });
  add_text("delta", [](const ComparedErrors& e) { return full(e.delta); });
  add_text("unit", [](const ComparedErrors& e) { return e.unit; });
  const auto add = [&](const char* name, std::optional<double> ComparedDataset::*value) {
    columns.push_back({name, [value](const ComparisonRow&, const ComparedDataset& dataset) {
                         return dataset.*value ? full(*(dataset.*value)) : "no truth";
                       }});
  };
  add("path_length_m", &ComparedDataset::path_length);
  add("static_ate_m", &ComparedDataset::static_ate);
  add("static_rpe_translation_mm", &ComparedDataset::static_rpe_translation_mm);
  add("static_rpe_rotation_deg", &ComparedDataset::static_rpe_rotation_deg);
}

void add_time_columns(CsvColumns& columns) {
  const auto add = [&](const char* name, std::function<std::optional<double>(const ComparedTimes&)> value) {
    columns.push_back({name, [value](const ComparisonRow& row, const ComparedDataset&) {
                         if (!row.times) return reason(row);
                         const auto number = value(*row.times);
                         return number ? full(*number) : "archive given";
                       }});
  };
  add("load_ms", [](const ComparedTimes& t) { return t.load_ms; });
  add("features_ms", [](const ComparedTimes& t) { return t.features_ms; });
  add("match_ms", [](const ComparedTimes& t) { return t.match_ms; });
  add("solve_ms", [](const ComparedTimes& t) { return std::optional(t.solve_ms); });
  const auto rate = [](double Interval::*end) {
    return [end](const ComparedTimes& t) {
      return t.frames_per_second ? std::optional((*t.frames_per_second).*end) : std::nullopt;
    };
  };
  add("frames_per_second_min", rate(&Interval::low));
  add("frames_per_second_mean", [](const ComparedTimes& t) { return t.mean_frames_per_second; });
  add("frames_per_second_max", rate(&Interval::high));
}

void add_published_columns(CsvColumns& columns) {
  const auto add = [&](const char* name, std::optional<double> PublishedResult::*value) {
    columns.push_back({name, [value](const ComparisonRow& row, const ComparedDataset&) {
                         if (!row.published) return std::string("not published");
                         const auto& number = (*row.published).*value;
                         return number ? full(*number) : row.published->outcome;
                       }});
  };
  add("published_ate_m", &PublishedResult::ate);
  add("published_rpe_translation_mm", &PublishedResult::rpe_translation_mm);
  add("published_rpe_rotation_deg", &PublishedResult::rpe_rotation_deg);
}

CsvColumns all_columns(bool with_published) {
  CsvColumns columns = name_columns();
  add_spread(columns, "ate_m", error_spread(&ComparedErrors::ate));
  add_relative_error(columns, "rpe_translation_mm", &ComparedErrors::rpe_translation_mm);
  add_relative_error(columns, "rpe_rotation_deg", &ComparedErrors::rpe_rotation_deg);
  add_spread(columns, "direction", error_spread(&ComparedErrors::direction));
  add_spread(columns, "coverage", error_spread(&ComparedErrors::coverage));
  add_status_columns(columns);
  add_truth_columns(columns);
  add_time_columns(columns);
  if (with_published) add_published_columns(columns);
  columns.push_back(
      {"reason", [](const ComparisonRow& row, const ComparedDataset&) {
         return !row.failure.empty() ? row.failure : row.no_errors.empty() ? "ok" : row.no_errors;
       }});
  return columns;
}

}  // namespace

Table comparison_csv_table(const Comparison& comparison) {
  const CsvColumns columns = all_columns(comparison.has_published);
  Table table;
  for (const CsvColumn& column : columns) table.columns.push_back({column.heading});
  for (const ComparisonRow& row : comparison.rows)
    for (const ComparedDataset& dataset : comparison.datasets) {
      if (dataset.name != row.dataset) continue;
      table.rows.emplace_back();
      for (const CsvColumn& column : columns) table.rows.back().emplace_back(column.text(row, dataset));
    }
  return table;
}

}  // namespace framewise
