// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "inspect_report.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace framewise::apps {
namespace {

using OrderedJson = nlohmann::ordered_json;

constexpr std::size_t kListedGaps = 20;

double rate_of(const FrameRate& rate) { return rate.median_step > 0 ? 1 / rate.median_step : 0; }

OrderedJson rate_json(const FrameRate& rate) {
  OrderedJson gaps = OrderedJson::array();
  for (std::size_t i = 0; i < std::min(kListedGaps, rate.gaps.size()); ++i)
    gaps.push_back({{"after", rate.gaps[i].after}, {"seconds", rate.gaps[i].length}});
  return {{"per_second", rate_of(rate)},
          {"jitter_ms", 1e3 * rate.jitter},
          {"longest_step", rate.longest_step},
          {"gaps", rate.gaps.size()},
          {"first_gaps", gaps}};
}

OrderedJson camera_fields(const Camera& camera) {
  if (camera.model == CameraModel::kEquirectangular)
    return {{"model", name_of(camera.model)},
            {"width", camera.width},
            {"height", camera.height},
            {"theta_range", camera.theta_range}};
  return {{"model", name_of(camera.model)},
          {"width", camera.width},
          {"height", camera.height},
          {"fx", camera.fx},
          {"fy", camera.fy},
          {"cx", camera.cx},
          {"cy", camera.cy},
          {"distortion", camera.distortion}};
}

OrderedJson calibration_json(const Dataset& dataset) {
  if (!dataset.has_camera()) return nullptr;
  const CameraFile& file = dataset.calibration;
  OrderedJson json = camera_fields(file.camera);
  json["source"] = dataset.calibration_source;
  json["depth_type"] = name_of(file.depth_type);
  json["depth_factor"] = file.depth_factor;
  json["depth_max"] = file.depth_max;
  json["depth_camera"] = file.depth_camera ? camera_fields(file.depth_camera->camera) : OrderedJson(nullptr);
  return json;
}

OrderedJson depth_json(const Inspection& x) {
  if (!x.images.depth) return nullptr;
  OrderedJson json = {{"images", x.images.depth->images}, {"unknown", x.images.depth->unknown}};
  for (std::size_t k = 0; k < DepthSummary::kShares.size(); ++k)
    json["metres"][fmt::format("p{:.0f}", 100 * DepthSummary::kShares[k])] = x.images.depth->quantiles[k];
  return json;
}

OrderedJson edges_json(const Inspection& x) {
  if (!x.images.edges) return nullptr;
  const EdgeFit& fit = *x.images.edges;
  return {{"pixels", fit.edges}, {"zoom", fit.zoom},         {"du", fit.du},        {"dv", fit.dv},
          {"score", fit.score},  {"as_it_is", fit.as_it_is}, {"spread", fit.spread}};
}

OrderedJson truth_json(const Inspection& x) {
  const Dataset& d = x.dataset;
  if (d.truth.empty()) return nullptr;
  return {{"source", d.truth_source},
          {"poses", d.truth.size()},
          {"coverage", x.truth_coverage},
          {"path_length", path_length(d.truth)},
          {"rate", rate_json(x.truth_poses)}};
}

const char* verdict_name(Verdict verdict) {
  constexpr std::array<const char*, 4> kNames = {"fine", "warning", "untold", "nothing to check"};
  return kNames[static_cast<std::size_t>(verdict)];
}

std::string camera_text(const Dataset& d) {
  if (!d.has_camera()) return "not known";
  const Camera& c = d.calibration.camera;
  std::string text = fmt::format("{} {} x {}", name_of(c.model), c.width, c.height);
  if (c.model != CameraModel::kEquirectangular)
    text += fmt::format(", fx {} fy {} cx {} cy {}{}", c.fx, c.fy, c.cx, c.cy,
                        c.is_distorted() ? ", distorted" : "");
  text += fmt::format(" ({})", d.calibration_source);
  if (d.registration) text += "; depth is moved into it from a camera of its own";
  return text;
}

std::string rate_text(const FrameRate& rate) {
  std::string text = fmt::format("{:.4g} a second, jitter {:.2g} ms", rate_of(rate), 1e3 * rate.jitter);
  if (!rate.gaps.empty())
    text += fmt::format(", {} gap(s), the longest {:.3g} s", rate.gaps.size(), rate.longest_step);
  return text;
}

std::string frames_text(const Inspection& x) {
  const Dataset& d = x.dataset;
  const double seconds = d.frames.back().time - d.frames.front().time;
  return fmt::format("{} in {:.4g} s ({} with colour, {} with depth); {}", d.frames.size(), seconds,
                     d.frames_with_color, d.frames_with_depth, rate_text(x.frames));
}

std::string depth_text(const Inspection& x) {
  const DepthSummary& depth = *x.images.depth;
  const CameraFile& file = x.dataset.calibration;
  return fmt::format(
      "{:.3g} m in the median, {:.3g} to {:.3g} m for 5 to 95 %; {:.0f} % unknown ({} images; {} units in a "
      "metre, {})",
      depth.median(), depth.quantiles[1], depth.quantiles[5], 100 * depth.unknown, depth.images,
      file.depth_factor, name_of(file.depth_type));
}

std::string truth_text(const Inspection& x) {
  const Dataset& d = x.dataset;
  if (d.truth.empty()) return "none";
  return fmt::format("{} poses ({}), {:.0f} % of the frames, {:.4g} m long; {}", d.truth.size(),
                     d.truth_source, 100 * x.truth_coverage, path_length(d.truth), rate_text(x.truth_poses));
}

std::string facts_text(const Inspection& x) {
  const Dataset& d = x.dataset;
  std::string text;
  const auto line = [&](const char* name, const std::string& fact) {
    text += fmt::format("{:<12}{}\n", name, fact);
  };
  line("data set", fmt::format("{}: {}, since {}", d.name, d.format, d.recognised_by));
  line("images", fmt::format("{} x {}", x.images.width, x.images.height));
  line("camera", camera_text(d));
  line("frames", frames_text(x));
  line("stamps", d.times_source);
  if (x.images.depth) line("depth", depth_text(x));
  line("truth", truth_text(x));
  if (!d.gyroscope.empty())
    line("gyroscope", fmt::format("{} rates from {} to {} s", d.gyroscope.size(), d.gyroscope.times.front(),
                                  d.gyroscope.times.back()));
  return text;
}

std::string checks_text(const std::vector<Check>& checks, Verdict verdict, const char* mark) {
  std::string text;
  for (const Check& check : checks)
    if (check.verdict == verdict) text += fmt::format("{:<12}{}: {}\n", mark, check.name, check.text);
  return text;
}

}  // namespace

OrderedJson inspection_json(const Inspection& x, const std::vector<Check>& checks) {
  const Dataset& d = x.dataset;
  OrderedJson warnings = OrderedJson::array(), all = OrderedJson::array();
  for (const Check& check : checks) {
    all.push_back({{"name", check.name}, {"verdict", verdict_name(check.verdict)}, {"text", check.text}});
    if (check.verdict == Verdict::kWarning) warnings.push_back({{"name", check.name}, {"text", check.text}});
  }
  return {
      {"version", FRAMEWISE_VERSION},
      {"name", d.name},
      {"path", d.folder.string()},
      {"format", d.format},
      {"recognised_by", d.recognised_by},
      {"fingerprint", d.fingerprint},
      {"image", {{"width", x.images.width}, {"height", x.images.height}}},
      {"camera", calibration_json(d)},
      {"frames",
       {{"count", d.frames.size()},
        {"with_color", d.frames_with_color},
        {"with_depth", d.frames_with_depth},
        {"unmatched_depth", d.unmatched_depth},
        {"first", d.frames.front().time},
        {"last", d.frames.back().time},
        {"times_source", d.times_source},
        {"rate", rate_json(x.frames)},
        {"depth_delay_ms", 1e3 * x.median_delay},
        {"out_of_step", x.out_of_step}}},
      {"depth", depth_json(x)},
      {"edges", edges_json(x)},
      {"truth", truth_json(x)},
      {"motions", x.images.motions.size()},
      {"lengths_by_depth_over_truth", x.images.length_ratios},
      {"gyroscope", d.gyroscope.empty() ? OrderedJson(nullptr) : OrderedJson{{"rates", d.gyroscope.size()}}},
      {"warnings", warnings},
      {"checks", all}};
}

std::string inspection_text(const Inspection& x, const std::vector<Check>& checks, bool warnings_only) {
  const std::string warnings = checks_text(checks, Verdict::kWarning, "WARNING");
  if (warnings_only) return warnings;
  return facts_text(x) + checks_text(checks, Verdict::kUntold, "cannot tell") + warnings +
         (warnings.empty() ? "no usual mistake was found\n" : "");
}

}  // namespace framewise::apps
