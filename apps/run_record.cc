// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "run_record.h"

#include <fmt/format.h>

#include "framewise/report/evaluation_json.h"
#include "framewise/report/evaluation_text.h"

namespace framewise::apps {
namespace {

using Json = nlohmann::ordered_json;

Json camera_json(const Recording& recording) {
  const Camera& c = recording.from.calibration.camera;
  return {{"source", recording.from.calibration_source},
          {"model", name_of(c.model)},
          {"width", c.width},
          {"height", c.height},
          {"fx", c.fx},
          {"fy", c.fy},
          {"cx", c.cx},
          {"cy", c.cy},
          {"distortion", c.distortion},
          {"depth_factor", recording.from.calibration.depth_factor},
          {"depth_max", recording.from.calibration.depth_max}};
}

// Null where the run worked on images.
Json archive_json(const Recording& recording, const Tally& tally) {
  if (!recording.archive) return nullptr;
  return {{"file", recording.path.filename().string()},
          {"written_by", recording.from.framewise_version},
          {"pairs", recording.archive->num_pairs()},
          {"missing_pairs", tally.missing_pairs}};
}

}  // namespace

std::optional<Evaluation> evaluate_run(const Recording& recording, const OdometryOptions& odometry,
                                       const Trajectory& estimate) {
  const Trajectory truth = recording.true_trajectory();
  if (truth.size() < 2 || estimate.size() < 2) return std::nullopt;
  EvaluationOptions options;
  options.association.max_difference = 1e-6;
  if (odometry.scale == "none") options.alignment = Alignment::kSim3;
  // Where one of the two never moved there is nothing to align but the first pose; rotations are judged all
  // the same.
  for (const Alignment alignment : {options.alignment, Alignment::kSe3}) {
    options.alignment = alignment;
    try {
      return evaluate(truth, estimate, options);
    } catch (const std::invalid_argument&) {
    }
  }
  return std::nullopt;
}

bool has_moved(const Trajectory& causal, const Trajectory& final) {
  if (causal.size() != final.size()) return true;
  for (std::size_t i = 0; i < final.size(); ++i)
    if ((causal.world_from_cam[i].matrix() - final.world_from_cam[i].matrix()).cwiseAbs().maxCoeff() > 1e-9)
      return true;
  return false;
}

Json run_record(const Recording& recording, const Json& options, const Tally& tally, double seconds,
                const std::optional<Evaluation>& evaluation) {
  Json statuses = Json::object();
  for (const Status status : kAllStatuses)
    statuses[std::string(name(status))] = tally.by_status[static_cast<std::size_t>(status)];
  const double per_frame_ms = tally.frames > 0 ? 1e3 / static_cast<double>(tally.frames) : 0;
  return {{"version", FRAMEWISE_VERSION},
          {"dataset",
           {{"name", recording.from.dataset_name},
            {"format", recording.from.dataset_format},
            {"fingerprint", recording.from.dataset_fingerprint},
            {"frames", recording.size()},
            {"frames_with_depth", recording.from.frames_with_depth},
            {"camera", camera_json(recording)}}},
          {"archive", archive_json(recording, tally)},
          {"options", options},
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
            {"match", tally.seconds.match * per_frame_ms},
            {"step", tally.seconds.step * per_frame_ms}}},
          {"evaluation", evaluation ? Json(to_json(*evaluation)) : Json(nullptr)}};
}

void print_summary(const Json& run, const std::optional<Evaluation>& evaluation,
                   const std::optional<Evaluation>& final_evaluation, const std::filesystem::path& out,
                   bool has_report) {
  std::string statuses;
  for (const auto& [status, count] : run["statuses"].items())
    if (count != 0)
      statuses += fmt::format("{}{} {}", statuses.empty() ? "" : ", ", count.get<int>(), status);
  fmt::print("{}: {} frames at {:.1f} a second: {}\n", run["dataset"]["name"].get<std::string>(),
             run["frames"].get<int>(), run["frames_per_second"].get<double>(), statuses);
  fmt::print("RANSAC: {:.1f} iterations a step; the share of inliers asks for {:.1f}\n",
             run["ransac"]["iterations_per_step"].get<double>(),
             run["ransac"]["iterations_theory_per_step"].get<double>());
  if (const Json& archive = run["archive"]; !archive.is_null() && archive["missing_pairs"] > 0)
    fmt::print("{} pairs to bridge a loss are not in the archive: run on the images to have them\n",
               archive["missing_pairs"].get<std::size_t>());
  const bool has_final = run.contains("evaluation_final");
  if (evaluation && final_evaluation) fmt::print("Causal: each pose as it was known when its frame came\n");
  if (evaluation)
    fmt::print("{}", to_text(*evaluation));
  else
    fmt::print("No truth beside the recording: nothing to evaluate against.\n");
  if (final_evaluation)
    fmt::print("\nFinal: the poses with what later frames told of them\n{}", to_text(*final_evaluation));
  else if (evaluation && has_final)
    fmt::print("\nCausal and final are the same: later frames moved no pose\n");
  fmt::print("Written: {}\n", (out / "{trajectory.tum").string() +
                                  (has_final ? ",trajectory_final.tum" : "") + ",frames.csv,run.json" +
                                  (has_report ? ",report.html}" : "}"));
}

}  // namespace framewise::apps
