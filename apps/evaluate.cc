// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "commands.h"
#include "evaluate_options.h"
#include "evo_result_of_evaluation.h"
#include "framewise/evaluation/evaluation.h"
#include "framewise/io/input_error.h"
#include "framewise/io/trajectory_files.h"
#include "framewise/report/evaluation_json.h"
#include "framewise/report/evaluation_text.h"
#include "recording.h"

namespace framewise::apps {
namespace {

namespace fs = std::filesystem;

struct EvaluateCommand {
  fs::path reference, estimate;
  fs::path times;          // of KITTI files, which hold none
  DatasetOptions dataset;  // how the reference is read, where it is one
  EvaluateOptions options;
  fs::path save_results;
  std::string metric = "ate";
  bool json = false, quiet = false;
  int threads = 0;         // one thread is always enough here, and nothing is drawn:
  std::uint64_t seed = 0;  // both are taken because every command takes them
};

// A file that has no stamps takes those of --times.
TrajectoryFile read_with_times(const fs::path& path, const fs::path& times) {
  TrajectoryFile file = read_trajectory(path);
  if (!file.has_times && !times.empty()) file = read_trajectory(path, file.format, times);
  return file;
}

struct EvaluateInput {
  TrajectoryFile reference, estimate;
};

TrajectoryFile read_reference(const EvaluateCommand& command) {
  if (fs::is_regular_file(command.reference)) return read_with_times(command.reference, command.times);
  TrajectoryFile of_data_set;
  of_data_set.trajectory = read_truth(command.reference, command.dataset);
  return of_data_set;
}

EvaluateInput read_input(const EvaluateCommand& command) {
  EvaluateInput input{read_reference(command), read_with_times(command.estimate, command.times)};
  if (!command.times.empty() && input.reference.format != TrajectoryFormat::kKitti &&
      input.estimate.format != TrajectoryFormat::kKitti)
    throw InputError(command.times, 0, "--times", "two trajectories with stamps of their own",
                     "one in KITTI's format");
  return input;
}

// Without stamps a pose is known by its place in the file alone.
void match_by_index_without_times(const EvaluateCommand& command, const EvaluateInput& input,
                                  EvaluationOptions& options) {
  if (input.reference.has_times && input.estimate.has_times) return;
  const fs::path& without = input.reference.has_times ? command.estimate : command.reference;
  const bool neither = input.reference.has_times == input.estimate.has_times;
  if (neither && command.options.association.empty()) options.association.method = AssociationMethod::kIndex;
  if (options.association.method != AssociationMethod::kIndex)
    throw InputError(without, 0, "", "poses without stamps", "--times FILE or --association index");
  if (options.relative.unit == DeltaUnit::kSeconds)
    throw InputError(without, 0, "", "poses without stamps", "--times FILE, or a delta in another unit");
}

void save_results(const EvaluateCommand& command, const Evaluation& evaluation, bool has_times) {
  EvoResult result = evo_result(evaluation, metric_from_name(command.metric));
  result.has_times = has_times;
  result.reference_name = command.reference.filename().string();
  result.estimate_name = command.estimate.filename().string();
  // The archive keeps the two apart by name.
  if (result.reference_name == result.estimate_name || result.reference_name.empty())
    result.reference_name = "reference_" + result.reference_name;
  write_evo_result(command.save_results, result, "--save-results");
}

int run(const EvaluateCommand& command) {
  EvaluationOptions options = command.options.resolved();
  metric_from_name(command.metric);
  const EvaluateInput input = read_input(command);
  match_by_index_without_times(command, input, options);
  const Evaluation evaluation = evaluate(input.reference.trajectory, input.estimate.trajectory, options);
  if (!command.save_results.empty()) save_results(command, evaluation, input.estimate.has_times);
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
  app->add_option("--times", command->times, "the stamps of poses in KITTI's format, a line each (s)");
  command->options.add_to(*app);
  CLI::Option* save = app->add_option("--save-results", command->save_results,
                                      "a zip file of the errors, as evo_res and evo's Python API read it");
  app->add_option(
         "--metric", command->metric,
         "of --save-results: ate, rpe-translation or rpe-direction (-rotation, -full, -rotation-part "
         "of either, rpe-distance, rpe-distance-ratio)")
      ->capture_default_str()
      ->needs(save);
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
      "  framewise evaluate groundtruth.txt out/trajectory.tum --preset tum\n"
      "  framewise evaluate groundtruth.txt out/trajectory.tum --save-results kabsch.zip --metric "
      "rpe-rotation");
  app->callback([command, &action] { action = [command] { return run(*command); }; });
}

}  // namespace framewise::apps
