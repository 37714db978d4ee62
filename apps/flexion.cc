// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/image/flexion.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <exception>
#include <filesystem>
#include <limits>
#include <map>
#include <memory>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "commands.h"
#include "framewise/image/densify.h"
#include "framewise/image/depth.h"
#include "framewise/image/gray_levels.h"
#include "framewise/image/hole_filling.h"
#include "framewise/image/inverse_depth_smoothing.h"
#include "framewise/image/relief.h"
#include "framewise/io/camera_file.h"
#include "framewise/io/image_files.h"
#include "framewise/io/input_error.h"
#include "progress.h"

namespace framewise::apps {
namespace {

namespace fs = std::filesystem;
constexpr double kNoLimit = std::numeric_limits<double>::infinity();

struct FlexionCommand {
  std::vector<std::string> inputs;
  fs::path camera, out;
  std::string kind = "flexion", form = "published", fill_method = "smooth", depth_type;
  std::string format;           // empty: 8 with --clahe, else 16
  std::optional<int> distance;  // the kind's own default
  double smooth = 0, fill_reach = 0;
  bool hole_rims = true, fill = false, clahe = false, densify = false, masks = false;
  std::optional<double> depth_factor, depth_max;
  std::vector<double> light{-1, -1, -1};
  DensifyOptions densifying;
  ClaheOptions equalisation;
  int threads = 0;
  bool quiet = false, json = false;

  std::string resolved_format() const { return !format.empty() ? format : clahe ? "8" : "16"; }
  ReliefOptions relief() const {
    return {distance.value_or(ReliefOptions().distance_px), smooth, {light.at(0), light.at(1), light.at(2)}};
  }
  FlexionOptions flexion() const {
    return {form == "published" ? FlexionForm::kPublished : FlexionForm::kNormalised,
            distance.value_or(FlexionOptions().distance_px), smooth, hole_rims};
  }
  FillOptions filling() const {
    return {fill_method == "smooth" ? FillMethod::kSmooth : FillMethod::kNearest, fill_reach};
  }
};

struct Job {
  fs::path input, output, mask;
};

struct Outcome {
  double known = 0;  // share of the image that is defined
  double seconds = 0;
  int width = 0, height = 0;
};

void check_one_of(const char* name, const std::string& found, std::initializer_list<const char*> expected) {
  if (std::find(expected.begin(), expected.end(), found) != expected.end()) return;
  throw std::invalid_argument(
      fmt::format("{}: found '{}', expected {}", name, found, fmt::join(expected, ", ")));
}

void check_positive(const char* name, const std::optional<double>& value) {
  if (value && (!(*value > 0) || !std::isfinite(*value)))
    throw std::invalid_argument(fmt::format("{}: found {}, expected more than 0", name, *value));
}

void check(const FlexionCommand& c) {
  check_one_of("kind", c.kind, {"flexion", "normal", "shaded", "depth"});
  check_one_of("form", c.form, {"published", "normalised"});
  check_one_of("format", c.resolved_format(), {"16", "8", "float"});
  check_one_of("fill-method", c.fill_method, {"smooth", "nearest"});
  if (!c.depth_type.empty()) check_one_of("depth-type", c.depth_type, {"z", "range"});
  check_positive("depth-factor", c.depth_factor);
  check_positive("depth-max", c.depth_max);
  if (c.clahe && c.resolved_format() != "8")
    throw std::invalid_argument(fmt::format("format: found {}, expected 8 with --clahe", c.format));
  if (c.masks && !c.densify)
    throw std::invalid_argument("masks: found no --densify, expected it with --masks");
  if (c.threads < 0)
    throw std::invalid_argument(fmt::format("threads: found {}, expected 0 or more", c.threads));
  c.relief().check();
  c.flexion().check();
  c.filling().check();
  c.densifying.check();
  c.equalisation.check();
}

// The camera file with what was typed in its place; a depth_max that nobody gave is none.
CameraFile resolved_camera(const FlexionCommand& command) {
  CameraFile otherwise;
  otherwise.depth_max = kNoLimit;
  CameraFile file = read_camera_file(command.camera, otherwise);
  override_depth(file, command.depth_type, command.depth_factor, command.depth_max);
  return file;
}

bool is_image_name(const fs::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return std::tolower(c); });
  return extension == ".png" || extension == ".tif" || extension == ".tiff" || extension == ".exr";
}

std::vector<fs::path> files_of(const std::vector<std::string>& inputs) {
  std::vector<fs::path> files;
  for (const fs::path input : inputs) {
    if (!fs::is_directory(input)) {
      files.push_back(input);
      continue;
    }
    std::vector<fs::path> found;
    for (const auto& entry : fs::directory_iterator(input))
      if (entry.is_regular_file() && is_image_name(entry.path())) found.push_back(entry.path());
    if (found.empty())
      throw InputError(input, 0, "", "a folder without .png, .tif, .tiff or .exr", "depth images");
    std::sort(found.begin(), found.end());
    files.insert(files.end(), found.begin(), found.end());
  }
  return files;
}

std::vector<Job> plan(const FlexionCommand& command) {
  const std::string extension = command.resolved_format() == "float" ? ".tiff" : ".png";
  std::vector<Job> jobs;
  std::map<fs::path, fs::path> input_of;
  for (const fs::path& input : files_of(command.inputs)) {
    const fs::path output = command.out / (input.stem().string() + extension);
    std::error_code error;
    if (fs::equivalent(input, output, error))
      throw InputError(input, 0, "", "an image that would be overwritten", "another folder for --out");
    const auto [place, is_new] = input_of.emplace(output, input);
    if (!is_new)
      throw InputError(input, 0, "", fmt::format("the name of {}", place->second.string()),
                       "names that differ, since results are named by them");
    jobs.push_back(
        {input, output, command.masks ? command.out / (input.stem().string() + "_mask.png") : fs::path()});
  }
  return jobs;
}

class Converter {
 public:
  Converter(const FlexionCommand& command, const CameraFile& file)
      : command_(command), file_(file), rays_(file.camera, file.depth_type) {}

  Outcome operator()(const Job& job) const {
    const cv::Mat raw = read(job.input);
    // The images of a surface do not depend on the unit, and the file's own is exact in float.
    const double per_metre = raw.type() == CV_16U ? file_.depth_factor : 1;
    cv::Mat depth = in_own_unit(raw, per_metre);
    if (command_.densify) {
      DenseDepth dense = densify(depth, command_.densifying);
      depth = dense.depth;
      if (command_.masks) write_image(job.mask, dense.mask);
    }
    if (command_.fill) depth = fill_holes(depth, command_.filling());
    const cv::Mat image = command_.kind == "depth" ? smoothed(depth) / per_metre : image_of(depth);
    write_image(job.output, in_format(image));
    return {share_known(image), 0, raw.cols, raw.rows};
  }

 private:
  cv::Mat read(const fs::path& path) const {
    const cv::Mat raw = read_depth_file(path);
    const Camera& camera = file_.camera;
    if (raw.cols != camera.width || raw.rows != camera.height)
      throw InputError(
          path, 0, "size", fmt::format("{} x {}", raw.cols, raw.rows),
          fmt::format("{} x {} as in {}", camera.width, camera.height, command_.camera.string()));
    return raw;
  }

  cv::Mat in_own_unit(const cv::Mat& raw, double per_metre) const {
    cv::Mat values;
    raw.convertTo(values, CV_32F);
    return depth_from_raw(values, 1, file_.depth_max * per_metre);
  }

  cv::Mat smoothed(const cv::Mat& depth) const {
    return command_.smooth > 0 ? smooth_inverse_depth(depth, command_.smooth) : depth;
  }

  cv::Mat image_of(const cv::Mat& depth) const {
    if (command_.kind == "flexion") return flexion_image(depth, rays_, command_.flexion());
    if (command_.kind == "normal") return normal_image(depth, rays_, command_.relief());
    return shaded_relief(depth, rays_, command_.relief());
  }

  cv::Mat in_format(const cv::Mat& image) const {
    const std::string format = command_.resolved_format();
    const bool is_depth = command_.kind == "depth";
    if (format == "float") return image;
    if (is_depth && format == "16") return depth_to_raw(image, file_.depth_factor);
    const cv::Mat unit =
        is_depth ? depth_to_unit(image, {0, std::isfinite(file_.depth_max) ? file_.depth_max : 0}) : image;
    if (command_.clahe) return equalise_to_8_bit(unit, command_.equalisation);
    return format == "16" ? to_16_bit(unit) : to_8_bit(unit);
  }

  static double share_known(const cv::Mat& image) {
    return cv::countNonZero(image == image) / static_cast<double>(image.total());  // NaN is not itself
  }

  const FlexionCommand& command_;
  CameraFile file_;
  DepthRays rays_;
};

// All jobs, side by side. After a failure no job is begun; those before it are done, and the first failure is
// told.
std::vector<Outcome> convert_all(const std::vector<Job>& jobs, const Converter& convert, int threads,
                                 Progress& progress) {
  std::vector<Outcome> outcomes(jobs.size());
  std::vector<std::exception_ptr> failures(jobs.size());
  std::atomic<std::size_t> next = 0;
  std::atomic<bool> failed = false;
  std::mutex telling;
  const auto work = [&] {
    while (!failed) {
      const std::size_t i = next++;
      if (i >= jobs.size()) return;
      try {
        const double begin = progress.seconds();
        outcomes[i] = convert(jobs[i]);
        outcomes[i].seconds = progress.seconds() - begin;
        const std::lock_guard lock(telling);
        progress.advance();
      } catch (...) {
        failures[i] = std::current_exception();
        failed = true;
      }
    }
  };
  const std::size_t wanted = threads > 0 ? threads : std::max(1u, std::thread::hardware_concurrency());
  {
    std::vector<std::jthread> workers;
    for (std::size_t k = 1; k < std::min(wanted, jobs.size()); ++k) workers.emplace_back(work);
    work();
  }
  for (const std::exception_ptr& failure : failures)
    if (failure) std::rethrow_exception(failure);
  return outcomes;
}

nlohmann::ordered_json record(const FlexionCommand& command, const CameraFile& file,
                              const std::vector<Job>& jobs, const std::vector<Outcome>& outcomes,
                              double seconds) {
  nlohmann::ordered_json images = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < jobs.size(); ++i)
    images.push_back({{"input", jobs[i].input.string()},
                      {"output", jobs[i].output.string()},
                      {"width", outcomes[i].width},
                      {"height", outcomes[i].height},
                      {"known", outcomes[i].known},
                      {"milliseconds", 1e3 * outcomes[i].seconds}});
  const bool flexion = command.kind == "flexion";
  return {{"version", FRAMEWISE_VERSION},
          {"kind", command.kind},
          {"form", flexion ? nlohmann::ordered_json(command.form) : nlohmann::ordered_json(nullptr)},
          {"distance", flexion ? command.flexion().distance_px : command.relief().distance_px},
          {"smooth", command.smooth},
          {"densify", command.densify},
          {"fill", command.fill},
          {"clahe", command.clahe},
          {"format", command.resolved_format()},
          {"camera", command.camera.string()},
          {"depth_type", name_of(file.depth_type)},
          {"depth_factor", file.depth_factor},
          {"depth_max", std::isfinite(file.depth_max) ? nlohmann::ordered_json(file.depth_max)
                                                      : nlohmann::ordered_json(nullptr)},
          {"seconds", seconds},
          {"images", images}};
}

int run(const FlexionCommand& command) {
  check(command);
  const CameraFile file = resolved_camera(command);
  const std::vector<Job> jobs = plan(command);
  const Converter convert(command, file);
  std::error_code error;
  fs::create_directories(command.out, error);
  if (error) throw std::invalid_argument(fmt::format("out: {}: {}", command.out.string(), error.message()));

  Progress progress("flexion", jobs.size(), command.quiet);
  const std::vector<Outcome> outcomes = convert_all(jobs, convert, command.threads, progress);
  if (command.json)
    fmt::print("{}\n", record(command, file, jobs, outcomes, progress.seconds()).dump(2));
  else if (!command.quiet)
    fmt::print("Written: {} ({} {} images)\n", command.out.string(), jobs.size(), command.kind);
  return 0;
}

void add_depth_options(CLI::App& app, FlexionCommand& c) {
  app.add_option("--depth-type", c.depth_type,
                 "z along the optical axis, or range along the ray; else the camera's");
  app.add_option("--depth-factor", c.depth_factor, "raw 16-bit units in a metre; else the camera's");
  app.add_option("--depth-max", c.depth_max,
                 "farther is unknown (m); 16-bit ranges then reach from 0 to it unless a factor says else");
}

void add_image_options(CLI::App& app, FlexionCommand& c) {
  app.add_option("--kind", c.kind,
                 "flexion; normal (the normal's part towards the camera); shaded (relief under a light);\n"
                 "depth (what remains of depth after the steps below)")
      ->capture_default_str();
  app.add_option("--form", c.form,
                 "of flexion: published, or normalised (the cosine between the two normals)")
      ->capture_default_str();
  app.add_flag("!--no-hole-rims", c.hole_rims,
               "published flexion: unknown beside a hole, where the definition draws its rim");
  app.add_option("--distance", c.distance, "of the neighbours (pixels); flexion: 1, normal and shaded: 4");
  app.add_option("--light", c.light, "of shaded: X Y Z from the surface to the light, camera axes")
      ->expected(3)
      ->capture_default_str();
  app.add_flag("--densify", c.densify, "first fit planes between sparse depths, such as a LiDAR's");
  app.add_option("--densify-reach", c.densifying.max_reach_px, "how far a depth may come from (pixels)")
      ->capture_default_str();
  app.add_flag("--masks", c.masks,
               "with --densify: NAME_mask.png, 255 measured, 128 interpolated, 0 unknown");
  app.add_flag("--fill", c.fill, "then fill the holes");
  app.add_option("--fill-method", c.fill_method, "smooth (from the rim), or nearest")->capture_default_str();
  app.add_option("--fill-reach", c.fill_reach, "farther from all depths stays unknown (pixels); 0: no limit")
      ->capture_default_str();
  app.add_option("--smooth", c.smooth, "then smooth inverse depth: sigma (pixels), 0.6 to 16; 0: not")
      ->capture_default_str();
  app.add_flag("--clahe", c.clahe, "equalise the contrast of tiles, to 8 bits");
  app.add_option("--clahe-limit", c.equalisation.clip_limit, "of that contrast")->capture_default_str();
  app.add_option("--format", c.format, "16 or 8 (PNG, 0 where unknown) or float (TIFF, NaN where unknown)");
}

}  // namespace

void add_flexion(CLI::App& program, Action& action) {
  const auto command = std::make_shared<FlexionCommand>();
  CLI::App* app =
      program.add_subcommand("flexion", "Images of the surface from depth images, for dark places");
  app->add_option("DEPTH", command->inputs, "16-bit PNG, 16-bit or float TIFF, EXR; or folders of them")
      ->required();
  app->add_option("--camera", command->camera, "camera YAML")->required();
  app->add_option("--out", command->out, "folder for the images, named as their depth images")->required();
  add_image_options(*app, *command);
  add_depth_options(*app, *command);
  app->add_option("--threads", command->threads, "0: all cores; does not change the result")
      ->capture_default_str();
  app->add_flag("--json", command->json, "print what was done on standard output");
  app->add_flag("--quiet", command->quiet, "print nothing but errors");
  app->footer(
      "Examples:\n"
      "  framewise flexion depth/ --camera camera.yaml --out flexion\n"
      "  framewise flexion depth/ --camera camera.yaml --kind normal --smooth 4 --format 8 --out normals\n"
      "  framewise flexion depth/ --camera camera.yaml --kind depth --fill --clahe --out matchable\n"
      "  framewise flexion lidar/ --camera kitti.yaml --depth-factor 256 --kind depth --densify --masks "
      "--out dense");
  app->callback([command, &action] { action = [command] { return run(*command); }; });
}

}  // namespace framewise::apps
