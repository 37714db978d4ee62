// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "framewise/io/mesh_file.h"
#include "framewise/io/recording_writer.h"
#include "framewise/simulation/simulate.h"

namespace framewise::apps {

// What simulate understands on the command line beyond the library's options.
struct SimulateChoice {
  SimulateOptions options;
  std::string mesh_file, mesh_up = "z";
  MeshFileOptions mesh;
  std::string path, depth = "exact", depth_type = "z", layout = "tum";
  std::vector<double> distortion;
  ImuOptions imu{.rate_hz = 0};  // 0: none
};

void add_simulate_options(CLI::App& app, SimulateChoice& choice);

// The library's options of a choice, checked. Throws InputError for a mesh that does not load and for a file
// of poses that makes no path, and std::invalid_argument for what else is wrong.
SimulateOptions resolved(const SimulateChoice& choice);

// How the depth of a recording is stored: the finest of 5000, 1000 and 256 units a metre that reaches as far
// as the sensor (KITTI's always 256), ranges in all of the 16 bits.
DepthStorage depth_storage(const SimulateOptions& options, const SimulateChoice& choice);

// All of it, for simulation.json.
nlohmann::ordered_json record_of(const SimulateOptions& options, const SimulateChoice& choice,
                                 const DepthStorage& storage);

}  // namespace framewise::apps
