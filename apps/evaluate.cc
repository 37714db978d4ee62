// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <map>
#include <memory>
#include <nlohmann/json.hpp>

#include "commands.h"
#include "framewise/evaluation/evaluation.h"
#include "framewise/evaluation/presets.h"
#include "framewise/io/trajectory_files.h"
#include "framewise/report/evaluation_json.h"
#include "framewise/report/evaluation_text.h"
#include "recording.h"

namespace framewise::apps {
namespace {

struct EvaluateCommand {
  std::filesystem::path reference, estimate;
  DatasetOptions dataset;  // how the reference is read, where it is one
  std::string preset;
  // Unset: as the preset has it.
  std::string align, unit, association, pairs;
  std::optional<double> delta, max_difference, time_offset;
  bool json = false, quiet = false;
  int threads = 0;         // one thread is always enough here, and nothing is drawn:
  std::uint64_t seed = 0;  // both are taken because every command takes them
};

template <typename T>
T choose(const char* option, const std::string& found, const std::map<std::string, T>& known) {
  if (const auto choice = known.find(found); choice != known.end()) return choice->second;
  std::string expected;
  for (const auto& [name, value] : known) expected += (expected.empty() ? "" : ", ") + name;
  throw std::invalid_argument(fmt::format("{}: found '{}', expected one of {}", option, found, expected));
}

Trajectory read_reference(const EvaluateCommand& command) {
  const bool is_file = std::filesystem::is_regular_file(command.reference);
  return is_file ? read_trajectory(command.reference).trajectory
                 : read_truth(command.reference, command.dataset);
}

// The preset, and over it what was asked for by name.
EvaluationOptions options_of(const EvaluateCommand& command) {
  EvaluationOptions options =
      command.preset.empty() ? EvaluationOptions{} : evaluation_preset(command.preset);
  if (!command.align.empty()) options.alignment = alignment_from_name(command.align);
  if (!command.unit.empty()) {
    options.relative.unit = delta_unit_from_name(command.unit);
    options.relative.pairs.reset();  // what suits the unit
  }
  if (!command.association.empty())
    options.association.method =
        choose<AssociationMethod>("association", command.association,
                                  {{"nearest", AssociationMethod::kNearest},
                                   {"greedy", AssociationMethod::kGreedy},
                                   {"interpolated", AssociationMethod::kInterpolated},
                                   {"index", AssociationMethod::kIndex}});
  if (command.delta) options.relative.delta = *command.delta;
  if (command.max_difference) options.association.max_difference = *command.max_difference;
  if (command.time_offset) options.association.time_offset = *command.time_offset;
  if (!command.pairs.empty())
    options.relative.pairs = choose<PairChoice>(
        "pairs", command.pairs,
        {{"consecutive", PairChoice::kConsecutive}, {"all", PairChoice::kAll}, {"tum", PairChoice::kTum}});
  options.check();
  return options;
}

int run(const EvaluateCommand& command) {
  const EvaluationOptions options = options_of(command);
  const Trajectory reference = read_reference(command);
  const Trajectory estimate = read_trajectory(command.estimate).trajectory;
  const Evaluation evaluation = evaluate(reference, estimate, options);
  if (command.json)
    fmt::print("{}\n", to_json(evaluation).dump(2));
  else if (!command.quiet)
    fmt::print("{}", to_text(evaluation));
  return 0;
}

}  // namespace

void add_evaluate(CLI::App& program, Action& action) {
  const auto command = std::make_shared<EvaluateCommand>();
  CLI::App* app = program.add_subcommand("evaluate", "How far an estimated trajectory is from the true one");
  app->add_option("REFERENCE", command->reference,
                  "trajectory file (TUM, KITTI, EuRoC) or data set with truth")
      ->required();
  app->add_option("ESTIMATE", command->estimate, "trajectory file")->required();
  app->add_option("--preset", command->preset,
                  "settings of another tool: evo, tum, kitti or lab; options given beside it win");
  app->add_option("--align", command->align, "none, se3 (default), sim3, scale, yaw or origin");
  app->add_option("--delta", command->delta, "span of the relative error (default 1)");
  app->add_option("--unit", command->unit, "of delta: frames (default), seconds, metres or degrees");
  app->add_option(
      "--pairs", command->pairs,
      "consecutive (evo's default), all (evo's --all_pairs) or tum (their --fixed_delta; the default for "
      "seconds)");
  app->add_option(
      "--association", command->association,
      "nearest (default, evo), greedy (TUM tools), interpolated (truth moved to the estimate's times) or "
      "index");
  app->add_option("--max-difference", command->max_difference,
                  "largest time difference of a match (s, default 0.01)");
  app->add_option("--time-offset", command->time_offset, "added to the estimate's times (s, default 0)");
  app->add_option("--format", command->dataset.format, "of a data set as the reference; else recognised");
  app->add_option("--fps", command->dataset.fps, "frames a second of a data set without stamps");
  app->add_option("--register-depth", command->dataset.register_depth,
                  "false: the truth of 7-Scenes stays the depth camera's")
      ->capture_default_str();
  app->add_option("--threads", command->threads, "0: all cores; does not change the result")
      ->capture_default_str();
  app->add_option("--seed", command->seed, "of every random choice (there is none here)")
      ->capture_default_str();
  app->add_flag("--json", command->json, "print one JSON object");
  app->add_flag("--quiet", command->quiet, "print nothing but errors");
  app->footer(
      "Examples:\n"
      "  framewise evaluate groundtruth.txt out/trajectory.tum\n"
      "  framewise evaluate rgbd_dataset_freiburg1_desk out/trajectory.tum --delta 1 --unit seconds --json\n"
      "  framewise evaluate groundtruth.txt out/trajectory.tum --preset tum");
  app->callback([command, &action] { action = [command] { return run(*command); }; });
}

}  // namespace framewise::apps
