// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "simulate_options.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "framewise/io/camera_file.h"
#include "framewise/io/input_error.h"
#include "framewise/io/trajectory_files.h"
#include "framewise/simulation/mesh_scene.h"
#include "framewise/simulation/path.h"
#include "framewise/simulation/scene_catalog.h"

namespace framewise::apps {
namespace {

std::string names_of_scenes() {
  std::vector<std::string> names;
  for (const SceneKind& kind : scene_kinds()) names.push_back(kind.name);
  return fmt::format("{}", fmt::join(names, ", "));
}

Trajectory read_path(const std::string& file) {
  const TrajectoryFile read = read_trajectory(file, TrajectoryFormat::kTum);
  if (read.repeated > 0)
    throw InputError(file, 0, "timestamp",
                     fmt::format("{} poses at the time of the one before", read.repeated),
                     "one pose at a time");
  if (read.trajectory.size() < 2)
    throw InputError(file, 0, "", "a single pose", "at least 2 to move between");
  return read.trajectory;
}

void choose_scene(const SimulateChoice& choice, SimulateOptions& options) {
  if (choice.mesh_file.empty() == options.scene.empty())
    throw std::invalid_argument(
        fmt::format("scene is '{}' and mesh '{}', expected one of the two (scenes: {})", options.scene,
                    choice.mesh_file, names_of_scenes()));
  if (choice.mesh_file.empty()) return;
  if (choice.mesh_up != "y" && choice.mesh_up != "z")
    throw std::invalid_argument(fmt::format("mesh-up is '{}', expected y or z", choice.mesh_up));
  MeshFileOptions how = choice.mesh;
  how.up = choice.mesh_up == "y" ? UpAxis::kY : UpAxis::kZ;
  options.mesh = std::make_shared<const Mesh>(read_mesh(choice.mesh_file, how));
}

void choose_path(const std::string& path, SimulateOptions& options) {
  const auto& names = path_names();
  if (path.empty() || std::find(names.begin(), names.end(), path) != names.end())
    options.path = path;
  else if (std::filesystem::is_regular_file(path))
    options.poses = read_path(path);
  else
    throw std::invalid_argument(
        fmt::format("path is '{}', expected a file of poses or one of: {}", path, fmt::join(names, ", ")));
}

void add_scene_options(CLI::App& app, SimulateChoice& choice) {
  SimulateOptions& options = choice.options;
  options.scene.clear();
  app.add_option("SCENE", options.scene, names_of_scenes());
  const char* group = "A model in place of a scene";
  app.add_option("--mesh", choice.mesh_file, "OBJ, PLY, STL, glTF, ...: metres, z up")->group(group);
  app.add_option("--mesh-scale", choice.mesh.scale, "metres in one of its units")
      ->group(group)
      ->capture_default_str();
  app.add_option("--mesh-up", choice.mesh_up, "its axis that is up: y or z")
      ->group(group)
      ->capture_default_str();
  app.add_option(
      "--path", choice.path,
      fmt::format("{}; or a file of TUM poses; default: the scene's own", fmt::join(path_names(), ", ")));
  app.add_option("--frames", options.frames, "how many; default 300, or as long as the poses last");
  app.add_option("--rate", options.rate_hz, "frames a second")->capture_default_str();
  app.add_option("--seed", options.seed, "of textures, path and noise")->capture_default_str();
  app.add_option("--width", options.width, "pixels; the field of view stays the same")->capture_default_str();
  app.add_option("--height", options.height, "pixels")->capture_default_str();
  app.add_option("--layout", choice.layout, fmt::format("{}", fmt::join(recording_layouts(), ", ")))
      ->capture_default_str();
  app.add_option("--threads", options.threads, "0: all cores; the bytes are the same with any number")
      ->capture_default_str();
}

void add_camera_options(CLI::App& app, SimulateChoice& choice) {
  SimulateOptions& options = choice.options;
  ImagingOptions& imaging = options.imaging;
  const char* group = "Camera";
  const auto add = [&](const char* name, auto& value, const char* what) {
    return app.add_option(name, value, what)->group(group);
  };
  add("--distortion", choice.distortion, "k1 k2 p1 p2 k3 of the lens")->expected(4, 5)->delimiter(',');
  add("--headlamp", options.headlamp, "a lamp at the camera: its light at 1 m (a mine needs 12); 0: none")
      ->capture_default_str();
  add("--exposure", options.exposure, "times the usual light")->capture_default_str();
  add("--exposure-time", imaging.exposure_time, "motion blur: how long the shutter is open (s)");
  add("--blur-samples", imaging.blur_samples, "instants a blurred frame is the mean of")
      ->capture_default_str();
  add("--rolling-shutter", imaging.readout_time, "from the first row to the last (s)");
  add("--photons", imaging.photons, "noise: electrons in a pixel that is just white");
  add("--read-noise", imaging.read_noise, "of reading a pixel (electrons)");
  add("--gamma", imaging.gamma, "in place of sRGB's curve");
  add("--vignetting", imaging.vignetting, "0: none, to 1: that of a simple lens");
}

void add_sensor_options(CLI::App& app, SimulateChoice& choice) {
  const auto depth = [&](const char* name, auto& value, const char* what) {
    return app.add_option(name, value, what)->group("Depth");
  };
  depth("--depth", choice.depth, "exact, kinect, tof, lidar; with faults, depth_true is written beside it")
      ->capture_default_str();
  depth("--depth-noise", choice.options.depth.noise, "times the sensor's usual; 0: exact where it sees")
      ->capture_default_str();
  depth("--depth-type", choice.depth_type, "what is stored: z, or range along the ray")
      ->capture_default_str();
  depth("--depth-max", choice.options.depth_max, "farther is unknown (m); default: the sensor's reach");
  ImuOptions& imu = choice.imu;
  const auto inertial = [&](const char* name, auto& value, const char* what) {
    return app.add_option(name, value, what)->group("Inertial unit")->capture_default_str();
  };
  inertial("--imu-rate", imu.rate_hz, "readings a second (imu.csv, and imu_true.csv without noise); 0: none");
  inertial("--gyro-noise", imu.gyroscope_noise, "density (rad/s/sqrt(Hz))");
  inertial("--gyro-walk", imu.gyroscope_bias_walk, "of the bias (rad/s^2/sqrt(Hz))");
  inertial("--accel-noise", imu.accelerometer_noise, "density (m/s^2/sqrt(Hz))");
  inertial("--accel-walk", imu.accelerometer_bias_walk, "of the bias (m/s^3/sqrt(Hz))");
  inertial("--imu-offset", imu.time_offset, "by which its stamps are late (s)");
}

}  // namespace

void add_simulate_options(CLI::App& app, SimulateChoice& choice) {
  add_scene_options(app, choice);
  add_camera_options(app, choice);
  add_sensor_options(app, choice);
}

SimulateOptions resolved(const SimulateChoice& choice) {
  SimulateOptions options = choice.options;
  choose_scene(choice, options);
  choose_path(choice.path, options);
  std::copy(choice.distortion.begin(), choice.distortion.end(), options.distortion.begin());
  options.depth.sensor = depth_sensor_from_name(choice.depth);
  if (choice.imu.rate_hz != 0) options.imu = choice.imu;
  options.check();
  const RgbdSensor lens(sensor_of(options));  // refuses distortion that leaves a pixel without a ray
  if (options.mesh && !is_anything_in_view(options)) {
    const Eigen::AlignedBox3d box = bounds_of(*options.mesh);
    throw std::invalid_argument(
        fmt::format("mesh: found no face in view on path {}, expected one in some frame; it spans "
                    "({:.4g}, {:.4g}, {:.4g}) to ({:.4g}, {:.4g}, {:.4g}) m",
                    choice.path.empty() ? path_name(options) : choice.path, box.min().x(), box.min().y(),
                    box.min().z(), box.max().x(), box.max().y(), box.max().z()));
  }
  return options;
}

DepthStorage depth_storage(const SimulateOptions& options, const SimulateChoice& choice) {
  const auto type = depth_type_from_name(choice.depth_type);
  if (!type)
    throw std::invalid_argument(fmt::format("depth-type is '{}', expected z or range", choice.depth_type));
  const double reach = sensor_of(options).max_depth;
  DepthStorage storage;
  storage.type = *type;
  if (*type == DepthType::kRange) {
    storage.max = reach;
    storage.factor = 65535 / reach;
    return storage;
  }
  if (choice.layout == "kitti-depth" || options.depth.sensor == DepthSensor::kLidar || reach > 65)
    storage.factor = 256;
  else if (reach > 13.1)
    storage.factor = 1000;
  if (reach > 65535 / storage.factor)
    throw std::invalid_argument(
        fmt::format("depth-max is {:.4g}, expected at most {:.0f} m", reach, 65535 / storage.factor));
  if (reach != CameraFile().depth_max) storage.max = reach;
  return storage;
}

nlohmann::ordered_json record_of(const SimulateOptions& options, const SimulateChoice& choice,
                                 const DepthStorage& storage) {
  const RgbdOptions sensor = sensor_of(options);
  const ImagingOptions& imaging = options.imaging;
  nlohmann::ordered_json record = {{"version", FRAMEWISE_VERSION},
                                   {"scene", options.mesh ? "mesh" : options.scene},
                                   {"path", options.poses.empty() ? path_name(options) : choice.path},
                                   {"layout", choice.layout},
                                   {"frames", frame_count(options)},
                                   {"rate", options.rate_hz},
                                   {"seed", options.seed},
                                   {"width", options.width},
                                   {"height", options.height},
                                   {"light_cell", options.light_cell},
                                   {"distortion", options.distortion},
                                   {"headlamp", sensor.headlamp},
                                   {"exposure", sensor.exposure},
                                   {"exposure_time", imaging.exposure_time},
                                   {"blur_samples", imaging.blur_samples},
                                   {"rolling_shutter", imaging.readout_time},
                                   {"photons", imaging.photons},
                                   {"read_noise", imaging.read_noise},
                                   {"gamma", imaging.gamma},
                                   {"vignetting", imaging.vignetting},
                                   {"depth", depth_sensor_names()[static_cast<int>(options.depth.sensor)]},
                                   {"depth_noise", options.depth.noise},
                                   {"depth_type", name_of(storage.type)},
                                   {"depth_max", sensor.max_depth},
                                   {"depth_factor", storage.factor}};
  if (options.mesh)
    record["mesh"] = {{"file", choice.mesh_file}, {"scale", choice.mesh.scale}, {"up", choice.mesh_up}};
  if (options.imu)
    record["imu"] = {{"rate", options.imu->rate_hz},
                     {"gyro_noise", options.imu->gyroscope_noise},
                     {"gyro_walk", options.imu->gyroscope_bias_walk},
                     {"accel_noise", options.imu->accelerometer_noise},
                     {"accel_walk", options.imu->accelerometer_bias_walk},
                     {"offset", options.imu->time_offset}};
  return record;
}

}  // namespace framewise::apps
