// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/report/comparison_tables.h"

#include <fmt/format.h>

#include <algorithm>

namespace framewise {
namespace {

constexpr const char* kTooFewFrames = "fewer than 6 frames";

std::string digits(double value) { return fmt::format("{:.4g}", value); }

std::string digits(const Spread& s) {
  const std::string median = digits(s.median);
  if (digits(s.first_quartile) == median && digits(s.third_quartile) == median) return median;
  return fmt::format("{:.4g} [{:.4g}, {:.4g}]", s.median, s.first_quartile, s.third_quartile);
}

std::string digits(const std::optional<Interval>& interval) {
  return interval ? fmt::format("{:.4g} to {:.4g}", interval->low, interval->high) : kTooFewFrames;
}

std::string digits(const std::optional<double>& value, const std::string& otherwise) {
  return value ? digits(*value) : otherwise;
}

// Numbers the reasons that cells give, each once.
class Notes {
 public:
  std::string mark(const std::string& reason) {
    const auto found = std::find(reasons_.begin(), reasons_.end(), reason);
    const auto number = found - reasons_.begin() + 1;
    if (found == reasons_.end()) reasons_.push_back(reason);
    return fmt::format("[{}]", number);
  }
  std::vector<std::string> lines() const {
    std::vector<std::string> lines;
    for (std::size_t i = 0; i < reasons_.size(); ++i)
      lines.push_back(fmt::format("[{}] {}", i + 1, reasons_[i]));
    return lines;
  }

 private:
  std::vector<std::string> reasons_;
};

using Rows = std::vector<const ComparisonRow*>;

Rows rows_of(const Comparison& comparison, const ComparedDataset& dataset) {
  Rows rows;
  for (const ComparisonRow& row : comparison.rows)
    if (row.dataset == dataset.name) rows.push_back(&row);
  return rows;
}

bool has_published(const Rows& rows) {
  return std::any_of(rows.begin(), rows.end(), [](const ComparisonRow* row) { return row->published; });
}

std::string label(const ComparisonRow& row) { return row.method + " with " + row.features; }

// In a few words, with the mark of the note that has them all.
std::string missing(const ComparisonRow& row, Notes& notes) {
  if (row.failed == row.repeats && row.failed > 0) return fmt::format("failed {}", notes.mark(row.failure));
  return fmt::format("{} {}", row.no_errors, notes.mark(row.no_errors));
}

// Which alignment, and which rows have another than the most.
std::string alignment_words(const Rows& rows) {
  std::map<std::string, std::vector<std::string>> methods;
  for (const ComparisonRow* row : rows)
    if (row->errors) methods[row->errors->alignment].push_back(label(*row));
  if (methods.empty()) return "none, there are no errors";
  const auto most = std::max_element(methods.begin(), methods.end(), [](const auto& a, const auto& b) {
    return a.second.size() < b.second.size();
  });
  std::string words = most->first;
  for (const auto& [alignment, labels] : methods)
    if (alignment != most->first) words += fmt::format(" ({} for {})", alignment, fmt::join(labels, ", "));
  return words;
}

std::string truth_words(const ComparedDataset& dataset) {
  if (!dataset.path_length) return "there is no truth to judge by";
  const auto first = [](const std::optional<double>& value) { return digits(value, "unknown"); };
  return fmt::format(
      "truth for {} of {} frames, {} m long; a camera that never moved: ATE {} m, RPE {} mm and {} deg",
      dataset.frames_with_truth, dataset.frames, first(dataset.path_length), first(dataset.static_ate),
      first(dataset.static_rpe_translation_mm), first(dataset.static_rpe_rotation_deg));
}

std::string relative_words(const Rows& rows) {
  for (const ComparisonRow* row : rows)
    if (row->errors) return fmt::format("RPE over delta {:g} {}", row->errors->delta, row->errors->unit);
  return "no RPE";
}

std::string repeat_words(const Comparison& comparison) {
  if (comparison.repeats == 1) return fmt::format("seed {}", comparison.seed);
  return fmt::format("median [quartiles] over {} seeds from {}", comparison.repeats, comparison.seed);
}

Table::Cell error_cell(const ComparedError& error) {
  const bool is_told = error.is_best || !error.to_best || error.to_best->is_real;
  return {digits(error.rmse) + (is_told ? "" : " ="), error.is_best};
}

void add_published(const ComparisonRow& row, std::vector<Table::Cell>& cells) {
  const std::string none = row.published ? row.published->outcome : "not published";
  const PublishedResult published = row.published.value_or(PublishedResult{});
  for (const auto& value : {published.ate, published.rpe_translation_mm, published.rpe_rotation_deg})
    cells.push_back(digits(value, none));
}

Table errors_table(const Comparison& comparison, const ComparedDataset& dataset, const Rows& rows) {
  Table table;
  table.caption = fmt::format(
      "Errors on {}. RMSE, {}; alignment {}; {}; {}. 95 %: bootstrap interval over frames. Bold: the least "
      "of the "
      "data set; =: not told apart from it.",
      dataset.name, repeat_words(comparison), alignment_words(rows), relative_words(rows),
      truth_words(dataset));
  table.columns = {{"method", false}, {"features", false}, {"ATE (m)"}, {"RPE (mm)"},
                   {"95 %"},          {"RPE (deg)"},       {"95 %"},    {"direction"},
                   {"coverage"},      {"measured"},        {"failed"}};
  const bool published = has_published(rows);
  if (published)
    for (const char* name : {"published ATE (m)", "published RPE (mm)", "published RPE (deg)"})
      table.columns.push_back({name});
  Notes notes;
  for (const ComparisonRow* row : rows) {
    std::vector<Table::Cell> cells{row->method, row->features};
    if (const auto& e = row->errors) {
      cells.insert(cells.end(),
                   {digits(e->ate), error_cell(e->rpe_translation_mm), digits(e->rpe_translation_mm.interval),
                    error_cell(e->rpe_rotation_deg), digits(e->rpe_rotation_deg.interval),
                    digits(e->direction), digits(e->coverage)});
    } else {
      cells.insert(cells.end(), 7, missing(*row, notes));
    }
    cells.push_back(row->measured ? digits(*row->measured) : missing(*row, notes));
    const std::string mark = row->failed > 0 ? fmt::format(" {}", notes.mark(row->failure)) : "";
    cells.push_back(fmt::format("{} of {}{}", row->failed, row->repeats, mark));
    if (published) add_published(*row, cells);
    table.rows.push_back(std::move(cells));
  }
  table.notes = notes.lines();
  return table;
}

void add_difference(const ComparisonRow& row, const ComparedError* error, Notes& notes,
                    std::vector<Table::Cell>& cells) {
  if (!error || (!error->is_best && !error->to_best)) {
    cells.insert(cells.end(), 4, error ? Table::Cell("other frames") : missing(row, notes));
  } else if (error->is_best) {
    cells.insert(cells.end(), 4, Table::Cell("best", true));
  } else {
    const PairedDifference& d = *error->to_best;
    cells.insert(cells.end(), {digits(d.median), digits(d.interval), digits(d.p_holm),
                               d.is_real ? (d.median > 0 ? "worse" : "better") : "no"});
  }
}

std::size_t count_comparisons(const Rows& rows) {
  return static_cast<std::size_t>(std::count_if(rows.begin(), rows.end(), [](const ComparisonRow* row) {
    return row->errors && row->errors->rpe_translation_mm.to_best;
  }));
}

Table differences_table(const Comparison& comparison, const ComparedDataset& dataset, const Rows& rows) {
  Table table;
  table.caption = fmt::format(
      "Differences on {}: error minus that of the row with the least RMSE, frame by frame: their median, its "
      "95 % "
      "bootstrap interval, p by sign flips, corrected for their number ({}, Holm); real: p below {:g}.",
      dataset.name, count_comparisons(rows), comparison.statistics.significance);
  table.columns = {{"method", false}, {"features", false}, {"mm a frame"}, {"95 %"}, {"p"},
                   {"real", false},   {"deg a frame"},     {"95 %"},       {"p"},    {"real", false}};
  Notes notes;
  for (const ComparisonRow* row : rows) {
    std::vector<Table::Cell> cells{row->method, row->features};
    add_difference(*row, row->errors ? &row->errors->rpe_translation_mm : nullptr, notes, cells);
    add_difference(*row, row->errors ? &row->errors->rpe_rotation_deg : nullptr, notes, cells);
    table.rows.push_back(std::move(cells));
  }
  table.notes = notes.lines();
  return table;
}

Table times_table(const ComparedDataset& dataset, const Rows& rows) {
  Table table;
  table.caption = fmt::format(
      "Times on {}: milliseconds a frame on one core, means; features and matches were found once for all "
      "rows. "
      "Frames a second without loading: the slowest frame, all frames, the fastest.",
      dataset.name);
  table.columns = {{"method", false}, {"features", false}, {"load"}, {"features"}, {"match"},
                   {"solve"},         {"frames/s min"},    {"mean"}, {"max"}};
  Notes notes;
  for (const ComparisonRow* row : rows) {
    std::vector<Table::Cell> cells{row->method, row->features};
    if (const auto& t = row->times) {
      const std::string none = "archive given";
      for (const auto& value : {t->load_ms, t->features_ms, t->match_ms})
        cells.push_back(digits(value, none));
      cells.push_back(digits(t->solve_ms));
      const auto& rate = t->frames_per_second;
      cells.push_back(rate ? digits(rate->low) : none);
      cells.push_back(digits(t->mean_frames_per_second, none));
      cells.push_back(rate ? digits(rate->high) : none);
    } else {
      cells.insert(cells.end(), 7, missing(*row, notes));
    }
    table.rows.push_back(std::move(cells));
  }
  table.notes = notes.lines();
  return table;
}

}  // namespace

std::vector<Table> comparison_tables(const Comparison& comparison) {
  std::vector<Table> tables;
  for (const ComparedDataset& dataset : comparison.datasets) {
    const Rows rows = rows_of(comparison, dataset);
    tables.push_back(errors_table(comparison, dataset, rows));
    tables.push_back(differences_table(comparison, dataset, rows));
    tables.push_back(times_table(dataset, rows));
  }
  return tables;
}

std::string comparison_markdown(const Comparison& comparison) {
  std::string text = fmt::format("# Comparison: {}\n", comparison.grid);
  for (const Table& table : comparison_tables(comparison)) text += fmt::format("\n{}", to_markdown(table));
  return text;
}

std::string comparison_latex(const Comparison& comparison) {
  std::string text;
  for (const Table& table : comparison_tables(comparison))
    text += fmt::format("{}{}", text.empty() ? "" : "\n", to_latex(table));
  return text;
}

}  // namespace framewise
