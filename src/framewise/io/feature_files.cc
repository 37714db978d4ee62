// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/io/feature_files.h"

#include <fmt/format.h>

#include <iterator>
#include <stdexcept>

#include "framewise/io/output_file.h"

namespace framewise {
namespace {

void check_rows(const std::vector<cv::KeyPoint>& keypoints, const cv::Mat& descriptors) {
  if (!descriptors.empty() && descriptors.rows != static_cast<int>(keypoints.size()))
    throw std::invalid_argument(fmt::format("descriptors: found {} rows, expected {}, one a keypoint",
                                            descriptors.rows, keypoints.size()));
  if (!descriptors.empty() && descriptors.type() != CV_8U && descriptors.type() != CV_32F)
    throw std::invalid_argument(
        fmt::format("descriptors: found type {}, expected CV_8U or CV_32F", descriptors.type()));
}

template <typename Value>
void append_row(std::string& text, const cv::Mat& descriptors, int row) {
  if (descriptors.empty()) return;  // tracked features have none
  const auto* values = descriptors.ptr<Value>(row);
  for (int i = 0; i < descriptors.cols; ++i) fmt::format_to(std::back_inserter(text), " {}", values[i]);
}

}  // namespace

void write_features(const std::filesystem::path& file, const std::string& image_name,
                    const std::vector<cv::KeyPoint>& keypoints, const cv::Mat& descriptors) {
  check_rows(keypoints, descriptors);
  std::string text =
      fmt::format("# {}: x y size angle_deg response octave, {} {} of the descriptor\n", image_name,
                  descriptors.cols, descriptors.depth() == CV_8U ? "bytes" : "floats");
  for (int i = 0; i < static_cast<int>(keypoints.size()); ++i) {
    const cv::KeyPoint& k = keypoints[i];
    fmt::format_to(std::back_inserter(text), "{} {} {} {} {} {}", k.pt.x, k.pt.y, k.size, k.angle, k.response,
                   k.octave);
    if (descriptors.depth() == CV_8U)
      append_row<std::uint8_t>(text, descriptors, i);
    else
      append_row<float>(text, descriptors, i);
    text += '\n';
  }
  std::ofstream stream = open_output_file(file, "--export-features");
  stream << text;
  stream.close();
  if (!stream) throw std::runtime_error(file.string() + ": writing failed (is the disk full?)");
}

}  // namespace framewise
