// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "framewise/geometry/camera.h"
#include "framewise/geometry/depth_noise.h"
#include "framewise/simulation/rgbd_sensor.h"

namespace framewise {

// Depth as sensors measure it, of what is truly in the middle of each pixel. Answers are z in metres, CV_32F,
// NaN where the sensor sees nothing. The seed is the frame's; the bytes do not depend on the threads.

// Structured light, a Kinect's: normal noise on z (see DepthNoise), then disparities on a lattice. Nothing
// where the projector beside the camera does not reach, at edges, and on grazing surfaces.
//   Khoshelham, Elberink, Accuracy and resolution of Kinect depth data, Sensors 2012.
struct KinectOptions {
  DepthNoise noise;
  double baseline = 0.075;  // from camera to projector, along x (m)
  double focal_px = 580;    // of the infrared camera
  double step_px = 0.125;   // of disparity: an eighth of its pixels; 0: none
  double nearest = 0.45;    // m
  double grazing = 0.2;     // least cosine between ray and normal
  double edge = 0.05;       // jump between neighbours that loses both (share of the depth)
};
cv::Mat kinect_depth(const SurfaceImage& surface, const Camera& camera, const KinectOptions& options,
                     std::uint64_t seed);

// Time of flight: normal noise on the range r, of sigma_1m r^2 / cosine, as where background light is most of
// the light; ranges beyond half a wavelength of the modulation begin again from 0; at edges pixels of
// anything between the two surfaces; nothing where less light returns than from `darkest` of a surface at 1
// m.
//   Lange, Seitz, Solid-state time-of-flight range camera, IEEE Journal of Quantum Electronics 2001.
struct TimeOfFlightOptions {
  double sigma_1m = 0.0015;  // m
  double ambiguity = 7.5;    // m: 20 MHz
  double darkest = 0.004;    // least cosine / r^2
  double edge = 0.05;        // jump between neighbours that mixes them (share of the depth)
};
cv::Mat time_of_flight_depth(const SurfaceImage& surface, const Camera& camera,
                             const TimeOfFlightOptions& options, std::uint64_t seed);

// A spinning LiDAR at the camera's centre, its axis along the camera's y: beams at even elevations, shots at
// even azimuths, each measured in the pixel it falls into; normal noise on the range. The defaults are a
// Velodyne HDL-64E's at 10 turns a second, as in KITTI.
//   Geiger et al., Vision meets robotics: the KITTI dataset, IJRR 2013.
struct LidarOptions {
  int beams = 64;
  double lowest_deg = -24.8, highest_deg = 2;
  double azimuth_step_deg = 0.1728;
  double sigma = 0.02;    // m
  double grazing = 0.03;  // least cosine between ray and normal
};
cv::Mat lidar_depth(const SurfaceImage& surface, const Camera& camera, const LidarOptions& options,
                    std::uint64_t seed);

enum class DepthSensor { kExact, kKinect, kTimeOfFlight, kLidar };

struct DepthSensorOptions {
  DepthSensor sensor = DepthSensor::kExact;
  KinectOptions kinect;
  TimeOfFlightOptions time_of_flight;
  LidarOptions lidar;
  double noise = 1;  // times the sensor's usual, steps and mixtures too; 0: what it sees, it sees exactly

  // Throws std::invalid_argument naming the option, what was found and what was expected.
  void check() const;
};

// exact, kinect, tof, lidar: in the order of the enumerators.
const std::vector<std::string>& depth_sensor_names();
// Throws std::invalid_argument for a name that is none.
DepthSensor depth_sensor_from_name(const std::string& name);

// Where a sensor's depth ends unless said otherwise (m).
double usual_reach(DepthSensor sensor);

cv::Mat measure_depth(const SurfaceImage& surface, const Camera& camera, const DepthSensorOptions& options,
                      std::uint64_t seed);

}  // namespace framewise
