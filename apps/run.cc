// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>
#include <nlohmann/json.hpp>

#include "commands.h"
#include "config.h"
#include "framewise/evaluation/evaluation.h"
#include "framewise/io/dataset.h"
#include "framewise/io/input_error.h"
#include "framewise/io/run_files.h"
#include "framewise/odometry/odometer.h"
#include "framewise/report/evaluation_json.h"
#include "framewise/report/evaluation_text.h"
#include "progress.h"

namespace framewise::apps {
namespace {

using Json = nlohmann::ordered_json;

struct RunCommand {
  std::filesystem::path dataset_folder, out, config;
  DatasetOptions dataset;
  OdometryOptions odometry;
  bool quiet = false, json = false;
};

// What is counted while frames come in.
struct Tally {
  std::size_t frames = 0;
  std::array<std::size_t, kAllStatuses.size()> by_status{};
  StageSeconds seconds;
  double iterations = 0, iterations_theory = 0;  // of RANSAC, over all steps
  std::size_t steps = 0;                         // with a motion
  Trajectory trajectory;

  void add(const FrameResult& result) {
    ++frames;
    ++by_status[static_cast<std::size_t>(result.step.status)];
    seconds.load += result.seconds.load;
    seconds.features += result.seconds.features;
    seconds.step += result.seconds.step;
    iterations += result.step.iterations;
    iterations_theory += result.step.iterations_theory;
    steps += result.step.iterations > 0;
    trajectory.add(result.time, result.world_from_cam);
  }

  // Frames whose motion was measured; the first has none to measure.
  std::size_t measured() const {
    std::size_t count = 0;
    for (const Status status : kAllStatuses)
      if (is_measured(status)) count += by_status[static_cast<std::size_t>(status)];
    return count;
  }
};

FrameLine line_of(const FrameResult& result) {
  FrameLine line;
  line.index = result.index;
  line.time = result.time;
  line.status = name(result.step.status);
  line.matches = result.step.matches;
  line.inliers = result.step.inliers;
  line.has_step = is_measured(result.step.status);
  line.cam1_from_cam2 = result.step.cam2_from_cam1.inverse();
  line.world_from_cam = result.world_from_cam;
  line.load_ms = 1e3 * result.seconds.load;
  line.features_ms = 1e3 * result.seconds.features;
  line.step_ms = 1e3 * result.seconds.step;
  return line;
}

Json options_json(const RunCommand& command) {
  const OdometryOptions& o = command.odometry;
  return {{"solver", o.solver},
          {"error", o.error},
          {"scale", o.scale},
          {"detector", o.features.detector},
          {"descriptor", o.features.descriptor},
          {"features", o.features.count},
          {"matcher", o.matcher},
          {"subpixel", o.subpixel},
          {"refine", o.refine},
          {"keypoint-sigma-px", o.keypoint_sigma_px},
          {"depth-noise-floor", o.depth_noise.floor},
          {"depth-noise-growth", o.depth_noise.growth},
          {"max-error-m", o.max_error_m},
          {"max-error-px", o.max_error_px},
          {"min-inliers", o.min_inliers},
          {"max-bridge", o.max_bridge},
          {"depth-border-px", o.depth.border_px},
          {"depth-max-edge", o.depth.max_edge},
          {"min-depth", o.depth.min_depth},
          {"max-depth", o.depth.max_depth},
          {"confidence", o.ransac.confidence},
          {"min-iterations", o.ransac.min_iterations},
          {"max-iterations", o.ransac.max_iterations},
          {"max-time-difference", command.dataset.max_time_difference},
          {"max-truth-gap", command.dataset.max_truth_gap},
          {"threads", o.threads},
          {"seed", o.seed}};
}

Json camera_json(const Dataset& dataset) {
  const Camera& c = dataset.calibration.camera;
  return {{"source", dataset.calibration_source},
          {"model", name_of(c.model)},
          {"width", c.width},
          {"height", c.height},
          {"fx", c.fx},
          {"fy", c.fy},
          {"cx", c.cx},
          {"cy", c.cy},
          {"distortion", c.distortion},
          {"depth_factor", dataset.calibration.depth_factor},
          {"depth_max", dataset.calibration.depth_max}};
}

// Against the truth at the frames' own times. Steps of no known length are judged up to one scale.
std::optional<Evaluation> evaluate_run(const RunCommand& command, const Dataset& dataset,
                                       const Tally& tally) {
  const Trajectory truth = truth_at_frames(dataset, command.dataset.max_truth_gap);
  if (truth.size() < 2 || tally.frames < 2) return std::nullopt;
  EvaluationOptions options;
  options.association.max_difference = 1e-6;
  if (command.odometry.scale == "none") options.alignment = Alignment::kSim3;
  try {
    return evaluate(truth, tally.trajectory, options);
  } catch (const std::invalid_argument&) {
    return std::nullopt;  // an estimate that never moved has no scale
  }
}

Json record(const RunCommand& command, const Dataset& dataset, const Tally& tally, double seconds,
            const std::optional<Evaluation>& evaluation) {
  Json statuses = Json::object();
  for (const Status status : kAllStatuses)
    statuses[std::string(name(status))] = tally.by_status[static_cast<std::size_t>(status)];
  const double per_frame_ms = tally.frames > 0 ? 1e3 / static_cast<double>(tally.frames) : 0;
  return {{"version", FRAMEWISE_VERSION},
          {"dataset",
           {{"name", dataset.name},
            {"format", dataset.format},
            {"fingerprint", dataset.fingerprint},
            {"frames", dataset.frames.size()},
            {"frames_with_depth", dataset.frames_with_depth},
            {"camera", camera_json(dataset)}}},
          {"options", options_json(command)},
          {"frames", tally.frames},
          {"statuses", statuses},
          {"measured", tally.frames > 0 ? static_cast<double>(tally.measured()) / tally.frames : 0},
          {"seconds", seconds},
          {"frames_per_second", seconds > 0 ? tally.frames / seconds : 0},
          {"ransac",
           {{"iterations_per_step", tally.steps > 0 ? tally.iterations / tally.steps : 0},
            {"iterations_theory_per_step", tally.steps > 0 ? tally.iterations_theory / tally.steps : 0}}},
          {"milliseconds_per_frame",
           {{"load", tally.seconds.load * per_frame_ms},
            {"features", tally.seconds.features * per_frame_ms},
            {"step", tally.seconds.step * per_frame_ms}}},
          {"evaluation", evaluation ? Json(to_json(*evaluation)) : Json(nullptr)}};
}

void print_summary(const RunCommand& command, const Json& run, const std::optional<Evaluation>& evaluation) {
  std::string statuses;
  for (const auto& [status, count] : run["statuses"].items())
    if (count != 0)
      statuses += fmt::format("{}{} {}", statuses.empty() ? "" : ", ", count.get<int>(), status);
  fmt::print("{}: {} frames at {:.1f} a second: {}\n", run["dataset"]["name"].get<std::string>(),
             run["frames"].get<int>(), run["frames_per_second"].get<double>(), statuses);
  fmt::print("RANSAC: {:.1f} iterations a step; the share of inliers asks for {:.1f}\n",
             run["ransac"]["iterations_per_step"].get<double>(),
             run["ransac"]["iterations_theory_per_step"].get<double>());
  if (evaluation)
    fmt::print("{}", to_text(*evaluation));
  else
    fmt::print("No truth beside the recording: nothing to evaluate against.\n");
  fmt::print("Written: {}\n", (command.out / "{trajectory.tum,frames.csv,run.json}").string());
}

void check_means(const RunCommand& command, const Dataset& dataset) {
  if (command.odometry.needs_depth() && dataset.frames_with_depth == 0)
    throw InputError(dataset.folder, 0, "depth", "no depth images",
                     "some for this method (without: --solver nister-5pt --scale none)");
  if (command.odometry.scale == "truth" && dataset.truth.empty())
    throw InputError(dataset.folder, 0, "groundtruth.txt", "no truth", "one for --scale truth");
}

int run(RunCommand& command, CLI::App& app) {
  if (!command.config.empty()) apply_config(app, command.config);
  command.odometry.check();
  const Dataset dataset = open_dataset(command.dataset_folder, command.dataset);
  check_means(command, dataset);
  RunFiles files(command.out);

  const FrameSource source{dataset.frames.size(), [&](std::size_t i) { return load_frame(dataset, i); },
                           [&](std::size_t i) {
                             return pose_at(dataset.truth, dataset.frames[i].time,
                                            command.dataset.max_truth_gap);
                           }};
  Tally tally;
  double seconds = 0;
  {
    Progress progress("run", source.size, command.quiet);
    const Clock clock = [&] { return progress.seconds(); };
    run_odometry(source, dataset.calibration.camera, command.odometry, clock, [&](const FrameResult& result) {
      files.add(line_of(result));
      tally.add(result);
      progress.advance();
    });
    seconds = progress.seconds();
  }

  const auto evaluation = evaluate_run(command, dataset, tally);
  const Json run = record(command, dataset, tally, seconds, evaluation);
  files.write_record(run.dump(2));
  if (command.json)
    fmt::print("{}\n", run.dump(2));
  else if (!command.quiet)
    print_summary(command, run, evaluation);

  if (tally.frames > 1 && tally.measured() <= 1)
    throw std::runtime_error(fmt::format("no motion could be measured in {} frames ({} has their statuses)",
                                         tally.frames, (command.out / "frames.csv").string()));
  return 0;
}

void add_method_options(CLI::App& app, OdometryOptions& o) {
  app.add_option("--solver", o.solver,
                 "kabsch (3D-3D), or from bearings: eight-point, seven-point, nister-5pt,\n"
                 "stewenius-5pt, kneip-5pt-rotation, eigensolver")
      ->capture_default_str();
  app.add_option("--scale", o.scale, "length of a step from bearings: depth, truth or none")
      ->capture_default_str();
  app.add_option("--error", o.error, "what makes an inlier: point-to-point (kabsch), sampson (bearings)")
      ->capture_default_str();
  app.add_option("--detector", o.features.detector, "orb")->capture_default_str();
  app.add_option("--descriptor", o.features.descriptor, "orb")->capture_default_str();
  app.add_option("--features", o.features.count, "features asked for in a frame")->capture_default_str();
  app.add_option("--matcher", o.matcher, "brute-force (exact, cross-checked)")->capture_default_str();
  app.add_option("--subpixel", o.subpixel, "matches to fractions of a pixel: align (patches), or none")
      ->capture_default_str();
  app.add_option("--refine", o.refine, "the inliers once more, weighed by their noise: covariance, or none")
      ->capture_default_str();
  app.add_option("--keypoint-sigma-px", o.keypoint_sigma_px,
                 "noise of a feature's position at its finest scale")
      ->capture_default_str();
  app.add_option("--depth-noise-floor", o.depth_noise.floor, "sigma_z = floor + growth (z - 0.4 m)^2 (m)")
      ->capture_default_str();
  app.add_option("--depth-noise-growth", o.depth_noise.growth, "sigma_z = floor + growth (z - 0.4 m)^2 (1/m)")
      ->capture_default_str();
  app.add_option("--max-error-m", o.max_error_m, "largest point-to-point error of an inlier (m)")
      ->capture_default_str();
  app.add_option("--max-error-px", o.max_error_px, "largest epipolar error of an inlier (pixels)")
      ->capture_default_str();
  app.add_option("--min-inliers", o.min_inliers, "with fewer a frame is lost")->capture_default_str();
  app.add_option("--max-bridge", o.max_bridge, "how long a good frame stays the reference after a loss (s)")
      ->capture_default_str();
  app.add_option("--depth-max-edge", o.depth.max_edge,
                 "depth jump that makes an edge, as a share of the depth")
      ->capture_default_str();
  app.add_option("--min-depth", o.depth.min_depth, "nearer points are not used (m)")->capture_default_str();
  app.add_option("--max-depth", o.depth.max_depth, "farther points are not used (m)")->capture_default_str();
  app.add_option("--confidence", o.ransac.confidence, "RANSAC stops at this probability")
      ->capture_default_str();
  app.add_option("--max-iterations", o.ransac.max_iterations, "RANSAC stops at this many")
      ->capture_default_str();
  app.add_option("--threads", o.threads, "0: all cores; does not change the result")->capture_default_str();
  app.add_option("--seed", o.seed, "of every random choice")->capture_default_str();
}

}  // namespace

void add_run(CLI::App& program, Action& action) {
  const auto command = std::make_shared<RunCommand>();
  CLI::App* app = program.add_subcommand("run", "Odometry of a recording: a folder in TUM RGB-D layout");
  app->add_option("DATASET", command->dataset_folder,
                  "folder with rgb.txt, depth.txt and perhaps groundtruth.txt")
      ->required();
  app->add_option("--out", command->out, "folder for trajectory.tum, frames.csv and run.json")->required();
  app->add_option("--camera", command->dataset.camera_file,
                  "camera YAML; else camera.yaml in the data set, else told by the name freiburg1, 2, 3");
  app->add_option("--depth-factor", command->dataset.depth_factor, "raw depth units in a metre");
  app->add_option("--depth-max", command->dataset.depth_max,
                  "depth images know nothing farther than this (m)");
  app->add_option("--max-time-difference", command->dataset.max_time_difference,
                  "colour and depth farther apart are not one frame (s)")
      ->capture_default_str();
  app->add_option("--max-truth-gap", command->dataset.max_truth_gap,
                  "no truth is interpolated across more (s)")
      ->capture_default_str();
  add_method_options(*app, command->odometry);
  app->add_option("--config", command->config, "YAML file of these options; the command line wins");
  app->add_flag("--json", command->json, "print run.json on standard output");
  app->add_flag("--quiet", command->quiet, "print nothing but errors");
  app->footer(
      "Examples:\n"
      "  framewise run rgbd_dataset_freiburg1_desk --out out/desk\n"
      "  framewise run my_recording --camera my_camera.yaml --solver nister-5pt --scale depth --out "
      "out/mine");
  app->callback([command, app, &action] { action = [command, app] { return run(*command, *app); }; });
}

}  // namespace framewise::apps
