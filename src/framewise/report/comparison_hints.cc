// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>

#include "framewise/report/comparison_figures.h"

namespace framewise {
namespace {

using HintedRows = std::vector<const ComparisonRow*>;

template <typename Holds>
HintedRows rows_that(const ComparisonReport& report, const std::string& dataset, Holds&& holds) {
  HintedRows rows;
  for (const ComparisonRow& row : report.comparison.rows)
    if (row.dataset == dataset && holds(row)) rows.push_back(&row);
  return rows;
}

// The first few by name.
std::string named(const HintedRows& rows) {
  constexpr std::size_t kNamed = 4;
  std::string text;
  for (std::size_t i = 0; i < std::min(rows.size(), kNamed); ++i)
    text += (i > 0 ? ", " : "") + row_label(*rows[i]);
  if (rows.size() > kNamed) text += fmt::format(" and {} more", rows.size() - kNamed);
  return text;
}

bool has_option(const ComparisonRow& row, std::string_view name, std::string_view value) {
  return std::any_of(row.options.begin(), row.options.end(),
                     [&](const auto& option) { return option.first == name && option.second == value; });
}

bool is_above(const Spread& error, const std::optional<double>& still) {
  return still && error.median >= *still;
}

class DatasetHints {
 public:
  DatasetHints(const ComparisonReport& report, const ComparedDataset& dataset)
      : report_(report), dataset_(dataset) {}

  std::vector<Hint> take() {
    if (!dataset_.path_length) add(true, "there is no truth to judge by", {});
    say("failed in every repeat",
        [](const ComparisonRow& row) { return row.failed == row.repeats && row.failed > 0; });
    say("failed in some repeats, and their figures are of those that are left",
        [](const ComparisonRow& row) { return row.failed < row.repeats && row.failed > 0; });
    say("take the length of every step from the truth (scale truth)",
        [](const ComparisonRow& row) { return has_option(row, "scale", "truth"); });
    say("take the rotation from the truth",
        [](const ComparisonRow& row) { return has_option(row, "rotation", "truth"); });
    say("are scaled to the truth before they are judged (sim3): not to be compared with the others in metres",
        [](const ComparisonRow& row) { return row.errors && row.errors->alignment == "sim3"; });
    say("are judged on a part of their frames (coverage under 1)",
        [](const ComparisonRow& row) { return row.errors && row.errors->coverage.median < 1; });
    say("have an ATE above that of a camera that never moved", [&](const ComparisonRow& row) {
      return row.errors && is_above(row.errors->ate, dataset_.static_ate);
    });
    say("have a relative translation error above that of a camera that never moved",
        [&](const ComparisonRow& row) {
          return row.errors &&
                 is_above(row.errors->rpe_translation_mm.rmse, dataset_.static_rpe_translation_mm);
        });
    say_if_it_turned();
    return std::move(hints_);
  }

 private:
  template <typename Holds>
  void say(const std::string& what, Holds&& holds) {
    if (const HintedRows rows = rows_that(report_, dataset_.name, holds); !rows.empty())
      add(true, what, rows);
  }
  void add(bool is_warning, const std::string& what, const HintedRows& rows) {
    std::string text = fmt::format("{}: {}", dataset_.name, what);
    if (!rows.empty())
      text = fmt::format("{}: rows that {}: {} ({} in all)", dataset_.name, what, named(rows), rows.size());
    hints_.push_back({is_warning, text + "."});
  }
  // As in the hints of a run: a scene 1 m away, moved five times more by turning.
  void say_if_it_turned() {
    if (!dataset_.static_rpe_translation_mm || !dataset_.static_rpe_rotation_deg) return;
    const double turned_mm = 1e3 * *dataset_.static_rpe_rotation_deg * 3.14159265358979323846 / 180;
    if (turned_mm > 5 * *dataset_.static_rpe_translation_mm)
      add(true, "the camera almost only turned: a translation found from images alone means little here", {});
  }

  const ComparisonReport& report_;
  const ComparedDataset& dataset_;
  std::vector<Hint> hints_;
};

}  // namespace

std::vector<Hint> comparison_hints(const ComparisonReport& report) {
  std::vector<Hint> hints;
  for (const std::string& what : report.missing) hints.push_back({true, what});
  for (const ComparedDataset& dataset : report.comparison.datasets)
    for (Hint& hint : DatasetHints(report, dataset).take()) hints.push_back(std::move(hint));
  if (report.comparison.repeats == 1)
    hints.push_back({false, "One seed: the figures do not show how they vary from run to run (--repeats)."});
  if (report.comparison.has_published)
    hints.push_back({false,
                     "Published figures are of whole sequences under their authors' alignment: compare "
                     "orders of magnitude."});
  return hints;
}

}  // namespace framewise
