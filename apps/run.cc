// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <atomic>
#include <memory>

#include "commands.h"
#include "config.h"
#include "frame_keeper.h"
#include "framewise/io/correspondence_archive_writer.h"
#include "framewise/io/feature_files.h"
#include "framewise/io/input_error.h"
#include "framewise/io/output_file.h"
#include "framewise/io/run_files.h"
#include "framewise/io/trajectory_files.h"
#include "framewise/odometry/map_odometer.h"
#include "framewise/report/evaluation_json.h"
#include "known_rotation.h"
#include "method_options.h"
#include "progress.h"
#include "report_files.h"
#include "run_record.h"

namespace framewise::apps {
namespace {

using Json = nlohmann::ordered_json;

struct RunCommand {
  std::filesystem::path path, out, config, archive, features_folder, figures;
  DatasetOptions dataset;
  OdometryOptions odometry;
  std::string rotation = "none", reference = "auto";
  bool quiet = false, json = false, no_report = false;
};

FrameLine line_of(const FrameResult& result, double parallax_deg) {
  FrameLine line;
  line.index = result.index;
  line.time = result.time;
  line.status = name(result.step.status);
  line.matches = result.step.matches;
  line.inliers = result.step.inliers;
  line.has_step = is_measured(result.step.status);
  line.cam1_from_cam2 = result.step.cam2_from_cam1.inverse();
  line.covariance = inverse_covariance(result.step.cam2_from_cam1, result.step.covariance);
  line.world_from_cam = result.world_from_cam;
  line.load_ms = 1e3 * result.seconds.load;
  line.features_ms = 1e3 * result.seconds.features;
  line.match_ms = 1e3 * result.seconds.match;
  line.step_ms = 1e3 * result.seconds.step;
  line.parallax_deg = parallax_deg;
  line.refine_ms = 1e3 * result.seconds.refine;
  line.input = result.input;
  line.overlap = result.step.overlap;
  line.free_directions = fmt::format("{}", fmt::join(result.step.free_directions, "; "));
  return line;
}

// auto: a map, unless a method between two frames was chosen or its correspondences are to be kept.
std::string chosen_reference(const RunCommand& command, const CLI::App& app, const Recording& recording) {
  if (command.reference == "map")
    for (const std::string& name : method_options_chosen(app))
      if (name != "scale")
        throw std::invalid_argument(
            fmt::format("reference: found map with --{}, which is of a method between two frames; expected "
                        "--reference frame",
                        name));
  if (command.reference != "auto") return command.reference;
  const bool has_images = recording.images && recording.images->frames_with_color > 0;
  const bool looks_forward = recording.from.calibration.camera.model != CameraModel::kEquirectangular;
  const bool keeps_pairs = !command.archive.empty() || !command.features_folder.empty();
  // Without depth, what the length of the first motion is may be said of a map as well.
  std::vector<std::string> chosen = method_options_chosen(app);
  const std::string& scale = command.odometry.scale;
  if (recording.from.frames_with_depth == 0 && (scale == "none" || scale == "truth"))
    std::erase(chosen, "scale");
  const bool maps = has_images && looks_forward && !keeps_pairs && chosen.empty();
  return maps ? "map" : "frame";
}

void check_means(const RunCommand& command, const Recording& recording) {
  const OdometryOptions& method = command.odometry;
  if (recording.images && recording.images->frames_with_color == 0 && method.input == "color")
    throw InputError(recording.path, 0, "colour", "depth images alone",
                     "--input depth, flexion or normal, which looks for features in depth");
  const bool maps = method.reference == "map";
  if (maps && !recording.images)
    throw InputError(recording.path, 0, "reference", "an archive, which has no images",
                     "a data set for --reference map");
  if (maps && recording.images->frames_with_color == 0)
    throw InputError(recording.path, 0, "colour", "depth images alone", "colour for --reference map");
  if (maps && recording.from.calibration.camera.model == CameraModel::kEquirectangular)
    throw InputError(recording.path, 0, "camera", "an equirectangular camera",
                     "one that looks forward for --reference map");
  if (!maps && (method.needs_depth() || method.scale == "first-pair") &&
      recording.from.frames_with_depth == 0)
    throw InputError(recording.path, 0, "depth", "no depth images",
                     "some for this method (without: --solver nister-5pt --scale none)");
  if (method.needs_rotation() && command.rotation == "none")
    throw std::invalid_argument(
        "solver two-point: found no known rotation, expected --rotation truth, gyro or a file");
  if (!method.needs_rotation() && command.rotation != "none")
    throw std::invalid_argument(fmt::format(
        "rotation: found '{}' with solver {}, which finds the rotation itself; expected solver two-point",
        command.rotation, method.solver));
  if (command.odometry.scale == "truth" && !recording.has_truth())
    throw InputError(recording.path, 0, "truth", "none", "one for --scale truth, such as groundtruth.txt");
}

PriorKnowledge knowledge(const RunCommand& command, const Recording& recording) {
  PriorKnowledge known;
  if (recording.has_truth()) known.truth = [&recording](std::size_t i) { return recording.truth[i]; };
  if (command.odometry.needs_rotation())
    known.rotation = rotation_source(command.rotation, recording, command.dataset.max_truth_gap);
  return known;
}

using FrameSink = std::function<void(const FrameResult&)>;

// What is caught of the frames on their way besides their results.
struct Catch {
  PairsInFlight pairs;
  std::optional<FrameKeeper> keeper;  // where there will be a report
};

// Takes the correspondences from the recording's archive; returns how many pairs it did not hold.
std::size_t run_archive(const RunCommand& command, const Recording& recording, const Clock& clock,
                        const FrameSink& sink, Catch& caught) {
  std::atomic<std::size_t> missing = 0;
  const PairSource source{recording.size(), [&](std::size_t i) { return recording.times[i]; },
                          [&](std::size_t i, std::size_t j) {
                            auto shared = recording.archive->pair(i, j);
                            missing += !shared;
                            if (shared) caught.pairs.see(j, *shared);
                            return shared;
                          },
                          knowledge(command, recording)};
  run_odometry(source, recording.from.calibration.camera, command.odometry, clock, sink);
  return missing;
}

OdometryTaps export_taps(const RunCommand& command, const Dataset& images) {
  OdometryTaps taps;
  if (command.features_folder.empty()) return taps;
  make_output_folder(command.features_folder, "--export-features");
  taps.features = [&](std::size_t i, const Features& features) {
    write_features(command.features_folder / fmt::format("frame_{:06}.txt", i),
                   std::filesystem::path(images.frames[i].color).filename().string(), features.keypoints,
                   features.descriptors);
  };
  return taps;
}

// The recording's images; those that the report shows are caught as they are loaded.
FrameSource frame_source(const RunCommand& command, const Recording& recording, Catch& caught) {
  return {recording.size(),
          [&](std::size_t i) {
            const Dataset& images = *recording.images;
            const Frame frame =
                reads_color(command.odometry.input) ? load_frame(images, i) : load_depth(images, i);
            if (caught.keeper) caught.keeper->see_image(i, frame);
            return frame;
          },
          knowledge(command, recording)};
}

MapRun run_map(const RunCommand& command, const Recording& recording, const Clock& clock,
               const FrameSink& sink, Catch& caught) {
  const FrameSource source = frame_source(command, recording, caught);
  OdometryTaps taps;
  taps.pair = [&](std::size_t, std::size_t j, const Correspondences& seen) { caught.pairs.see(j, seen); };
  return run_map_odometry(source, recording.from.calibration.camera, command.odometry, clock, sink, taps);
}

void run_images(const RunCommand& command, const Recording& recording, const Clock& clock,
                const FrameSink& sink, Catch& caught) {
  const FrameSource source = frame_source(command, recording, caught);
  OdometryTaps taps = export_taps(command, *recording.images);
  const auto run_into = [&](const FrameSink& into) {
    run_odometry(source, recording.from.calibration.camera, command.odometry, clock, into, taps);
  };
  taps.pair = [&](std::size_t, std::size_t j, const Correspondences& shared) { caught.pairs.see(j, shared); };
  if (command.archive.empty()) return run_into(sink);

  ArchiveProvenance provenance = recording.from;
  provenance.options = correspondence_option_texts(command.odometry);
  CorrespondenceArchiveWriter archive(command.archive, provenance);
  taps.pair = [&](std::size_t i, std::size_t j, const Correspondences& shared) {
    caught.pairs.see(j, shared);
    archive.add_pair(i, j, shared);
  };
  run_into([&](const FrameResult& result) {
    archive.add_frame({result.time, recording.truth[result.index]});
    sink(result);
  });
  archive.finish();
}

Json resolved_options(const RunCommand& command, const Recording& recording) {
  Json options = {{"reference", command.odometry.reference}};
  if (command.odometry.reference == "map") options.update(map_options_json(command.odometry));
  options.update(options_json(command.odometry));
  options["rotation"] = command.rotation;
  if (!recording.images) return options;
  options.update(dataset_options_json(command.dataset));
  return options;
}

Json learned_json(const LearnedCamera& learned) {
  return {{"k1_correction", learned.k1_correction}, {"readout_s", learned.readout}};
}

int run(RunCommand& command, CLI::App& app, const Invocation& invocation) {
  if (!command.config.empty()) apply_config(app, command.config);
  // Whether a scale alone is of a map or of a method, the recording's depth decides.
  const bool says_scale_alone =
      command.reference == "auto" && method_options_chosen(app) == std::vector<std::string>{"scale"};
  if (command.reference == "map" || says_scale_alone) command.odometry.reference = "map";
  command.odometry.check();
  const Recording recording = open_recording(command.path, command.dataset);
  if (recording.archive) apply_archive(app, recording, command.odometry);
  command.odometry.reference = chosen_reference(command, app, recording);
  // Without depth the length of the first motion is the unit.
  if (command.odometry.reference == "map" && recording.from.frames_with_depth == 0 &&
      command.odometry.scale == "depth")
    command.odometry.scale = "none";
  command.odometry.check();
  check_means(command, recording);
  RunFiles files(command.out);
  Catch caught;
  remove_report(command.out);
  if (!command.no_report) caught.keeper.emplace(command.out / kReportData, recording.size());

  Tally tally;
  std::optional<MapRun> mapped;
  double seconds = 0;
  {
    Progress progress("run", recording.size(), command.quiet);
    const Clock clock = [&] { return progress.seconds(); };
    const FrameSink sink = [&](const FrameResult& result) {
      const Correspondences shared = caught.pairs.take(result);
      files.add(line_of(result, parallax_deg(result.step, shared)));
      if (caught.keeper) caught.keeper->add(result, shared);
      tally.add(result);
      progress.advance();
    };
    if (command.odometry.reference == "map")
      mapped = run_map(command, recording, clock, sink, caught);
    else if (recording.archive)
      tally.missing_pairs = run_archive(command, recording, clock, sink, caught);
    else
      run_images(command, recording, clock, sink, caught);
    seconds = progress.seconds();
  }

  const auto evaluation = evaluate_run(recording, command.odometry, tally.trajectory);
  Json run = run_record(recording, resolved_options(command, recording), tally, seconds, evaluation);
  std::optional<Evaluation> final_evaluation;
  if (mapped) run["learned"] = learned_json(mapped->learned);
  if (mapped && !mapped->final_poses.empty()) {
    const std::vector<Pose>& final_poses = mapped->final_poses;
    Trajectory final;
    for (std::size_t i = 0; i < final_poses.size(); ++i) final.add(recording.times[i], final_poses[i]);
    write_tum_trajectory(command.out / "trajectory_final.tum", final);
    const bool is_another = has_moved(tally.trajectory, final);
    if (is_another) final_evaluation = evaluate_run(recording, command.odometry, final);
    const auto& judged = is_another ? final_evaluation : evaluation;
    run["evaluation_final"] = judged ? Json(to_json(*judged)) : Json(nullptr);
  }
  run["command"] = invocation.command;
  run["machine"] = invocation.machine;
  files.write_record(run.dump(2, ' ', false, Json::error_handler_t::replace));
  if (caught.keeper) {
    const Camera& camera = recording.from.calibration.camera;
    caught.keeper->finish(camera.width, camera.height, recording.true_trajectory());
    write_report(command.out, command.figures);
  }
  if (command.json)
    fmt::print("{}\n", run.dump(2, ' ', false, Json::error_handler_t::replace));
  else if (!command.quiet)
    print_summary(run, evaluation, final_evaluation, command.out, !command.no_report);

  if (tally.frames > 1 && tally.measured() <= 1)
    throw std::runtime_error(fmt::format("no motion could be measured in {} frames ({} has their statuses)",
                                         tally.frames, (command.out / "frames.csv").string()));
  if (tally.frames > 1 && command.odometry.scale == "first-pair" && !tally.has_moved)
    throw std::runtime_error(
        "scale first-pair: no pair of frames had a measured translation and depth, so that no length is "
        "known "
        "(a camera that only turns has none)");
  return 0;
}

}  // namespace

void add_run(CLI::App& program, Action& action, const Invocation& invocation) {
  const auto command = std::make_shared<RunCommand>();
  CLI::App* app = program.add_subcommand("run", "Odometry of a recording, or of the archive of one");
  app->add_option(
         "DATASET", command->path,
         "a recording (folder or video; docs/datasets.md lists the formats), or a correspondence archive")
      ->required();
  app->add_option("--out", command->out, "folder for trajectory.tum, frames.csv, run.json and report.html")
      ->required();
  app->add_option("--archive", command->archive, "HDF5 file to write the correspondences of all pairs to");
  app->add_option("--export-features", command->features_folder,
                  "folder to write keypoints and descriptors to, a text file a frame");
  add_dataset_options(*app, command->dataset);
  app->add_option("--reference", command->reference,
                  "what a frame is related to: map (a local map of the frames before), frame (the frame\n"
                  "before, by the solver below); auto: map unless a method between two frames is chosen")
      ->check(CLI::IsMember({"auto", "map", "frame"}))
      ->capture_default_str();
  add_method_options(*app, command->odometry);
  add_map_options(*app, command->odometry);
  app->add_option(
         "--rotation", command->rotation,
         "of solver two-point: truth, gyro (the data set's), or a file: a trajectory of the camera,\n"
         "or a gyroscope in its axes (EuRoC's imu0/data.csv)")
      ->capture_default_str();
  app->add_option("--config", command->config, "YAML file of these options; the command line wins");
  app->add_flag("--no-report", command->no_report, "no report.html, and nothing kept for it");
  app->add_option("--figures", command->figures, "folder to write the report's plots to as SVG and PNG")
      ->excludes("--no-report");
  app->add_flag("--json", command->json, "print run.json on standard output");
  app->add_flag("--quiet", command->quiet, "print nothing but errors");
  app->footer(
      "Examples:\n"
      "  framewise run rgbd_dataset_freiburg1_desk --out out/desk\n"
      "  framewise run my_recording --camera my_camera.yaml --solver nister-5pt --scale depth --out "
      "out/mine\n"
      "  framewise run my_recording --archive mine.h5 --out out/kabsch\n"
      "  framewise run mine.h5 --solver nister-5pt --out out/nister-5pt");
  app->callback([command, app, &action, &invocation] {
    action = [command, app, &invocation] { return run(*command, *app, invocation); };
  });
}

}  // namespace framewise::apps
