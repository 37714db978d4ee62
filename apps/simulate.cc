// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/simulation/simulate.h"

#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "commands.h"
#include "framewise/io/tum_writer.h"
#include "progress.h"

namespace framewise::apps {
namespace {

constexpr double kDepthFactor = 5000;  // raw units a metre, as in the TUM benchmark

struct SimulateCommand {
  std::filesystem::path out;
  SimulateOptions options;
  bool quiet = false, json = false;
};

std::string record(const SimulateOptions& options) {
  const nlohmann::ordered_json record = {{"version", FRAMEWISE_VERSION}, {"scene", options.scene},
                                         {"frames", options.frames},     {"rate", options.rate_hz},
                                         {"seed", options.seed},         {"width", options.width},
                                         {"height", options.height},     {"light_cell", options.light_cell},
                                         {"depth_factor", kDepthFactor}};
  return record.dump(2) + "\n";
}

int run(const SimulateCommand& command) {
  command.options.check();
  TumWriter writer(command.out, sensor_of(command.options).camera, kDepthFactor);
  {
    Progress progress("simulate", command.options.frames, command.quiet);
    simulate(command.options, [&](const SimulatedFrame& simulated) {
      writer.add(simulated.frame);
      progress.advance();
      return true;
    });
  }
  writer.finish(true_trajectory(command.options, command.options.frames));
  writer.write_text("simulation.json", record(command.options));
  if (command.json)
    fmt::print("{}", record(command.options));
  else if (!command.quiet)
    fmt::print("Written: {} ({} frames)\n", command.out.string(), command.options.frames);
  return 0;
}

}  // namespace

void add_simulate(CLI::App& program, Action& action) {
  const auto command = std::make_shared<SimulateCommand>();
  SimulateOptions& options = command->options;
  CLI::App* app =
      program.add_subcommand("simulate", "A ray-traced recording with exact truth, in TUM RGB-D layout");
  app->add_option("SCENE", options.scene, "room")->required();
  app->add_option("--out", command->out, "folder to create")->required();
  app->add_option("--frames", options.frames, "how many")->capture_default_str();
  app->add_option("--rate", options.rate_hz, "frames a second")->capture_default_str();
  app->add_option("--seed", options.seed, "of textures and path")->capture_default_str();
  app->add_option("--width", options.width, "pixels; the field of view stays the same")
      ->capture_default_str();
  app->add_option("--height", options.height, "pixels")->capture_default_str();
  app->add_option("--threads", options.threads, "0: all cores; the bytes are the same with any number")
      ->capture_default_str();
  app->add_flag("--json", command->json, "print simulation.json on standard output");
  app->add_flag("--quiet", command->quiet, "print nothing but errors");
  app->footer("Example:\n  framewise simulate room --frames 300 --out data/room");
  app->callback([command, &action] { action = [command] { return run(*command); }; });
}

}  // namespace framewise::apps
