// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <memory>

#include "commands.h"
#include "report_files.h"

namespace framewise::apps {
namespace {

struct ReportCommand {
  std::filesystem::path folder, figures;
  bool quiet = false;
};

int report(const ReportCommand& command) {
  write_report(command.folder, command.figures);
  if (!command.quiet) fmt::print("Written: {}\n", (command.folder / "report.html").string());
  return 0;
}

}  // namespace

void add_report(CLI::App& program, Action& action) {
  const auto command = std::make_shared<ReportCommand>();
  CLI::App* app =
      program.add_subcommand("report", "One page about a run or a comparison, to open in a browser");
  app->add_option("DIR", command->folder, "folder that `run` or `compare` wrote; gets report.html")
      ->required();
  app->add_option("--figures", command->figures, "folder to write every plot to as SVG and PNG");
  app->add_flag("--quiet", command->quiet, "print nothing but errors");
  app->footer(
      "Examples:\n"
      "  framewise report out/desk\n"
      "  framewise report out/compared --figures paper/figures");
  app->callback([command, &action] { action = [command] { return report(*command); }; });
}

}  // namespace framewise::apps
