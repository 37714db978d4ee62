// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/io/published_tables.h"

#include <algorithm>

#include "framewise/io/csv_table.h"

namespace framewise {
namespace {

std::string changed_case(std::string text, int (*change)(int)) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [&](unsigned char c) { return static_cast<char>(change(c)); });
  return text;
}

std::string our_scale(const std::string& translation) {
  if (translation == "first-pair-scale") return "first-pair";
  if (translation == "full-3d") return "depth";
  return translation;
}

// Built letter by letter: GCC 12 warns wrongly of string::replace.
std::string plain_name(const std::string& name) {
  const std::string lower = changed_case(name, std::tolower);
  constexpr std::string_view kLong = "freiburg", kShort = "fr";
  std::string plain;
  for (std::size_t at = 0; at < lower.size();) {
    const bool is_long = std::string_view(lower).substr(at).starts_with(kLong);
    if (is_long)
      plain += kShort;
    else
      plain += lower[at];
    at += is_long ? kLong.size() : 1;
  }
  return plain;
}

}  // namespace

std::vector<PublishedFigures> read_published_figures(const std::filesystem::path& path) {
  const CsvTable table(path);
  const std::size_t sequence = table.column("sequence"), solver = table.column("solver"),
                    translation = table.column("translation"), error = table.column("ransac_error"),
                    feature = table.column("feature"), ate = table.column("ate_rmse_m"),
                    rpe_translation = table.column("rpe_trans_rmse_m"),
                    rpe_rotation = table.column("rpe_rot_rmse_deg"), outcome = table.column("outcome");
  std::vector<PublishedFigures> figures;
  for (std::size_t row = 0; row < table.num_rows(); ++row)
    figures.push_back(
        {table.text(row, sequence), table.text(row, solver), our_scale(table.text(row, translation)),
         table.text(row, error), changed_case(table.text(row, feature), std::toupper), table.number(row, ate),
         table.number(row, rpe_translation), table.number(row, rpe_rotation), table.text(row, outcome)});
  return figures;
}

bool is_of_sequence(const std::string& dataset, const std::string& sequence) {
  return !sequence.empty() && plain_name(dataset).find(plain_name(sequence)) != std::string::npos;
}

}  // namespace framewise
