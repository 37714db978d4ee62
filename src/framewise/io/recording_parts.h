// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <fstream>
#include <opencv2/core.hpp>
#include <string>

#include "framewise/geometry/trajectory.h"
#include "framewise/io/recording_writer.h"

namespace framewise {

// What the writers of recordings have in common. Inside the room alone. All throw std::runtime_error naming
// the file or folder that cannot be written.

std::ofstream open_output(const std::filesystem::path& file);
void close_output(std::ofstream& stream, const std::filesystem::path& file);
void write_whole(const std::filesystem::path& file, const std::string& text);
void make_folder(const std::filesystem::path& folder);

// The quickest ways to write a photograph and to write 16-bit depth.
void write_photo_png(const std::filesystem::path& file, const cv::Mat& image);
void write_depth_png(const std::filesystem::path& file, const cv::Mat& depth);

// camera.yaml, as the README has it.
std::string camera_yaml(const Camera& camera, const DepthStorage& storage);

// groundtruth.txt of the TUM benchmark.
std::string tum_truth(const Trajectory& truth);

}  // namespace framewise
