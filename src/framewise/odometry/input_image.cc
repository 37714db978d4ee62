// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/odometry/input_image.h"

#include <stdexcept>

#include "framewise/image/contrast_to_noise.h"
#include "framewise/image/flexion.h"
#include "framewise/image/gray_levels.h"
#include "framewise/image/hole_filling.h"
#include "framewise/image/relief.h"

namespace framewise {
namespace {

constexpr const char* kNames[] = {"color",   "depth-raw", "depth", "flexion-published",
                                  "flexion", "normal",    "auto"};

// A Kinect's depth is too coarse for neighbours one pixel away: the two normals of flexion would be
// unrelated.
constexpr FlexionOptions kSmoothFlexion{FlexionForm::kPublished, 6, 5.0, false};

// Features want corners well above the noise of 4 x 4 pixels, at which the finest of them are found.
constexpr double kLeastContrastToNoise = 4.5;

ReliefOptions smooth_relief() {
  ReliefOptions options;
  options.distance_px = 4;
  options.smoothing_sigma_px = 4;
  return options;
}

}  // namespace

void InputImage::check(const std::string& name) {
  std::string expected;
  for (const char* known : kNames) {
    if (name == known) return;
    expected += (expected.empty() ? "" : ", ") + std::string(known);
  }
  throw std::invalid_argument("input: found '" + name + "', expected one of " + expected);
}

InputImage::InputImage(const std::string& name, const Camera& camera, double max_depth)
    : name_(name), max_depth_(max_depth) {
  check(name);
  if (name != "color" && name != "depth" && name != "depth-raw") rays_.emplace(camera, DepthType::kZ);
}

cv::Mat InputImage::of(const Frame& frame) const {
  const std::string name = chosen(frame);
  if (!is_made_of_depth(name)) return frame.gray;
  return frame.depth.empty() ? cv::Mat() : of_depth(name, frame.depth);
}

std::string InputImage::chosen(const Frame& frame) const {
  if (name_ != "auto") return name_;
  return frame.depth.empty() || contrast_to_noise(frame.gray) > kLeastContrastToNoise ? "color" : "normal";
}

cv::Mat InputImage::of_depth(const std::string& name, const cv::Mat& depth) const {
  const DepthRange range{0, max_depth_};
  if (name == "depth-raw") return to_8_bit(depth_to_unit(depth, range));
  if (name == "depth") return equalise_to_8_bit(depth_to_unit(fill_holes(depth, {}), range), {});
  if (name == "flexion-published") return to_8_bit(flexion_image(depth, *rays_, {}));
  if (name == "flexion") return to_8_bit(flexion_image(depth, *rays_, kSmoothFlexion));
  return to_8_bit(normal_image(depth, *rays_, smooth_relief()));
}

}  // namespace framewise
