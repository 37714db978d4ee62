// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/odometry/input_image.h"

#include <stdexcept>

#include "framewise/image/flexion.h"
#include "framewise/image/gray_levels.h"
#include "framewise/image/hole_filling.h"
#include "framewise/image/relief.h"

namespace framewise {
namespace {

constexpr const char* kNames[] = {"color", "depth-raw", "depth", "flexion-published", "flexion", "normal"};

// A Kinect's depth is too coarse for neighbours one pixel away: the two normals of flexion would be
// unrelated.
constexpr FlexionOptions kSmoothFlexion{FlexionForm::kPublished, 6, 5.0, false};

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
  if (!is_made_of_depth(name_)) return frame.gray;
  return frame.depth.empty() ? cv::Mat() : of_depth(frame.depth);
}

cv::Mat InputImage::of_depth(const cv::Mat& depth) const {
  const DepthRange range{0, max_depth_};
  if (name_ == "depth-raw") return to_8_bit(depth_to_unit(depth, range));
  if (name_ == "depth") return equalise_to_8_bit(depth_to_unit(fill_holes(depth, {}), range), {});
  if (name_ == "flexion-published") return to_8_bit(flexion_image(depth, *rays_, {}));
  if (name_ == "flexion") return to_8_bit(flexion_image(depth, *rays_, kSmoothFlexion));
  return to_8_bit(normal_image(depth, *rays_, smooth_relief()));
}

}  // namespace framewise
