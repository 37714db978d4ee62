// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "commands.h"
#include "inspect_report.h"
#include "recording.h"

namespace framewise::apps {
namespace {

struct InspectCommand {
  std::filesystem::path path;
  DatasetOptions dataset;
  int threads = 0;  // taken because every command takes it
  std::uint64_t seed = 0;
  bool json = false, quiet = false;
};

int inspect(InspectCommand command) {
  command.dataset.needs_camera = false;
  const Inspection inspection = inspect_recording(open_dataset(command.path, command.dataset),
                                                  command.dataset.max_truth_gap, command.seed);
  const std::vector<Check> checks = check_recording(inspection);
  if (command.json)
    fmt::print("{}\n", inspection_json(inspection, checks).dump(2));
  else
    fmt::print("{}", inspection_text(inspection, checks, command.quiet));
  return 0;
}

}  // namespace

void add_inspect(CLI::App& program, Action& action) {
  const auto command = std::make_shared<InspectCommand>();
  CLI::App* app = program.add_subcommand("inspect", "What a recording is, and which usual mistakes it shows");
  app->add_option("DATASET", command->path,
                  "a recording: folder or video (docs/datasets.md lists the formats)")
      ->required();
  add_dataset_options(*app, command->dataset);
  app->add_option("--threads", command->threads, "0: all cores; does not change the result")
      ->capture_default_str();
  app->add_option("--seed", command->seed, "of every random choice")->capture_default_str();
  app->add_flag("--json", command->json, "print one JSON object");
  app->add_flag("--quiet", command->quiet, "print nothing but warnings");
  app->footer(
      "Examples:\n"
      "  framewise inspect rgbd_dataset_freiburg1_desk\n"
      "  framewise inspect my_images --camera my_camera.yaml --fps 25 --json\n"
      "  framewise inspect scans --camera scanner.yaml --depth-type range --depth-max 20");
  app->callback([command, &action] { action = [command] { return inspect(*command); }; });
}

}  // namespace framewise::apps
