// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <stdexcept>

#include "commands.h"
#include "config.h"
#include "framewise/geometry/so3.h"
#include "framewise/image/match_drawing.h"
#include "framewise/io/dataset.h"
#include "framewise/io/feature_files.h"
#include "framewise/io/image_files.h"
#include "framewise/io/output_file.h"
#include "framewise/odometry/correspond.h"
#include "framewise/odometry/step.h"
#include "method_options.h"

namespace framewise::apps {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kDegrees = 180 / std::numbers::pi;

struct RelposeCommand {
  std::filesystem::path image1, image2, depth1, depth2, camera, config, drawing, features_folder;
  std::optional<double> depth_factor, depth_max;
  OdometryOptions odometry;
  bool quiet = false, json = false;

  bool has_depth() const { return !depth1.empty(); }
};

// Angles x, y, z (deg) of R = Rz(z) Ry(y) Rx(x).
std::array<double, 3> euler_deg(const Eigen::Matrix3d& R) {
  const Eigen::Vector3d angles = kDegrees * euler_zyx(R);
  return {angles.x(), angles.y(), angles.z()};
}

template <typename Matrix>
Json row_major(const Matrix& M) {
  Json numbers = Json::array();
  for (int i = 0; i < M.rows(); ++i)
    for (int j = 0; j < M.cols(); ++j) numbers.push_back(M(i, j));
  return numbers;
}

// What is not known is null.
Json relpose_json(const Step& step) {
  const bool measured = is_measured(step.status);
  const Pose& pose = step.cam2_from_cam1;
  return {{"rotation", measured ? row_major(pose.R) : Json()},
          {"translation", measured ? row_major(pose.t) : Json()},
          {"matches", step.matches},
          {"inliers", step.inliers},
          {"status", name(step.status)},
          {"covariance", measured ? row_major(step.covariance) : Json()},
          {"euler_deg", measured ? Json(euler_deg(pose.R)) : Json()}};
}

void print_relpose(const Step& step, bool metric) {
  fmt::print("{}: {} of {} matches agree\n", name(step.status), step.inliers, step.matches);
  if (!is_measured(step.status)) return;
  const Pose& pose = step.cam2_from_cam1;
  const auto [x, y, z] = euler_deg(pose.R);
  const Vector6d sigma = step.covariance.diagonal().cwiseSqrt();
  fmt::print(
      "rotation     {:.4f} deg; about x, y, z: {:.4f} {:.4f} {:.4f} deg; standard deviations {:.4f} {:.4f} "
      "{:.4f}\n",
      kDegrees * rotation_angle(pose.R), x, y, z, kDegrees * sigma[0], kDegrees * sigma[1],
      kDegrees * sigma[2]);
  fmt::print("translation  {:.5f} {:.5f} {:.5f} {}; standard deviations {:.5f} {:.5f} {:.5f}\n", pose.t.x(),
             pose.t.y(), pose.t.z(), metric ? "m" : "(of unit length)", sigma[3], sigma[4], sigma[5]);
}

// What the two images suggest where the user does not choose.
void choose_method(RelposeCommand& command, const CLI::App& app) {
  OdometryOptions& options = command.odometry;
  const bool given_solver = app.get_option("--solver")->count() > 0,
             given_scale = app.get_option("--scale")->count() > 0;
  if (!given_solver) options.solver = command.has_depth() ? "kabsch" : "nister-5pt";
  if (!given_scale && !command.has_depth()) options.scale = "none";
  if (options.scale == "truth" || options.scale == "first-pair")
    throw std::invalid_argument(
        fmt::format("scale: found '{}', expected depth, centroid or none with two images", options.scale));
  if (options.needs_rotation())
    throw std::invalid_argument("solver: found 'two-point', expected one that finds the rotation itself");
  if (!command.has_depth() && options.needs_depth())
    throw std::invalid_argument(
        fmt::format("solver {}, scale {}: found no depth images, expected --depth1 and --depth2",
                    options.solver, options.scale));
  options.check();
}

Observation observe_image(const RelposeCommand& command, const std::filesystem::path& image,
                          const std::filesystem::path& depth, const CameraFile& calibration) {
  const Frame frame =
      read_frame({0, image.string(), depth.string()}, calibration, command.camera.filename().string());
  return observe(frame, calibration.camera, command.odometry);
}

void write_extras(const RelposeCommand& command, const Observation& view1, const Observation& view2,
                  const Correspondences& shared, const Step& step) {
  if (!command.drawing.empty())
    write_image(command.drawing,
                draw_matches(view1.gray, view2.gray, shared.pixels1, shared.pixels2, step.inlier_mask));
  if (command.features_folder.empty()) return;
  make_output_folder(command.features_folder, "--export-features");
  const auto write = [&](const char* file, const std::filesystem::path& image, const Features& features) {
    write_features(command.features_folder / file, image.filename().string(), features.keypoints,
                   features.descriptors);
  };
  write("image1.txt", command.image1, view1.features);
  write("image2.txt", command.image2, view2.features);
}

int run(RelposeCommand& command, CLI::App& app) {
  if (!command.config.empty()) apply_config(app, command.config);
  choose_method(command, app);
  CameraFile calibration = read_camera_file(command.camera);
  calibration.depth_factor = command.depth_factor.value_or(calibration.depth_factor);
  calibration.depth_max = command.depth_max.value_or(calibration.depth_max);

  const OdometryOptions& options = command.odometry;
  const Camera& camera = calibration.camera;
  const Observation view1 = observe_image(command, command.image1, command.depth1, calibration);
  const Observation view2 = observe_image(command, command.image2, command.depth2, calibration);
  const Correspondences shared = correspond(view1, view2, camera, options);
  const Step step = estimate_step(shared, camera, options, options.seed);

  write_extras(command, view1, view2, shared, step);
  if (command.json)
    fmt::print("{}\n", relpose_json(step).dump(2));
  else if (!command.quiet)
    print_relpose(step, options.scale != "none");
  if (!is_measured(step.status))
    throw std::runtime_error(fmt::format("no motion could be measured between {} and {}: {}, {} matches",
                                         command.image1.string(), command.image2.string(), name(step.status),
                                         step.matches));
  return 0;
}

}  // namespace

void add_relpose(CLI::App& program, Action& action) {
  const auto command = std::make_shared<RelposeCommand>();
  CLI::App* app = program.add_subcommand("relpose", "The motion between two images: cam2_from_cam1");
  app->add_option("IMAGE1", command->image1, "an image of the camera")->required();
  app->add_option("IMAGE2", command->image2, "another")->required();
  app->add_option("--camera", command->camera, "camera YAML")->required();
  CLI::Option* depth1 = app->add_option("--depth1", command->depth1, "depth image registered to IMAGE1");
  app->add_option("--depth2", command->depth2, "depth image registered to IMAGE2")->needs(depth1);
  depth1->needs("--depth2");
  app->add_option("--depth-factor", command->depth_factor, "raw depth units in a metre");
  app->add_option("--depth-max", command->depth_max, "depth images know nothing farther than this (m)");
  app->add_option("--draw", command->drawing,
                  "image to write: both images, inliers joined in green, other matches in red");
  app->add_option("--export-features", command->features_folder,
                  "folder to write keypoints and descriptors to: image1.txt, image2.txt");
  add_method_options(*app, command->odometry);
  app->add_option("--config", command->config, "YAML file of these options; the command line wins");
  app->add_flag("--json", command->json, "print one JSON object");
  app->add_flag("--quiet", command->quiet, "print nothing but errors");
  app->footer(
      "Without depth the solver is nister-5pt and the translation has length 1; with both depth images the\n"
      "solver is kabsch and the translation is in metres.\n"
      "Examples:\n"
      "  framewise relpose left.png right.png --camera camera.yaml --draw matches.png\n"
      "  framewise relpose a.png b.png --depth1 a_depth.png --depth2 b_depth.png --camera camera.yaml "
      "--json");
  app->callback([command, app, &action] { action = [command, app] { return run(*command, *app); }; });
}

}  // namespace framewise::apps
