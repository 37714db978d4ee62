// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "report_files.h"

#include <fmt/format.h>

#include "figure_files.h"
#include "framewise/io/input_error.h"
#include "framewise/io/output_file.h"
#include "report_comparison.h"
#include "report_run.h"

namespace framewise::apps {

namespace fs = std::filesystem;

void write_whole(const fs::path& path, const std::string& text, const char* option) {
  const fs::path part = path.string() + ".part";
  auto file = open_output_file(part, option);
  file << text;
  file.close();
  if (!file) throw std::runtime_error(path.string() + ": writing failed (is the disk full?)");
  fs::rename(part, path);
}

void remove_report(const fs::path& folder) {
  std::error_code ignored;
  fs::remove(folder / "report.html", ignored);
  fs::remove_all(folder / kReportData, ignored);
}

void write_report(const fs::path& folder, const fs::path& figures) {
  if (is_comparison_folder(folder)) {
    const ComparisonReport report = read_comparison(folder);
    write_whole(folder / "report.html", comparison_page(report), "DIR");
    if (!figures.empty()) write_figures(figures, comparison_figure_files(report));
    return;
  }
  if (!is_run_folder(folder))
    throw InputError(folder, 0, "DIR",
                     fs::exists(folder) ? "neither run.json nor results.json" : "no such folder",
                     "a folder that `run` or `compare` wrote");
  const RunReport report = read_run(folder);
  write_whole(folder / "report.html", run_page(report), "DIR");
  if (!figures.empty()) write_figures(figures, run_figure_files(report));
}

}  // namespace framewise::apps
