// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>
#include <optional>
#include <string>

#include "framewise/geometry/camera.h"
#include "framewise/image/depth_rays.h"
#include "framewise/image/frame.h"

namespace framewise {

// The 8-bit image that features are looked for in, by its name on the command line:
//   color              the colour image's gray
//   depth-raw          depth from 0 to max_depth as 255 levels, holes 0
//   depth              holes filled, contrast equalised locally (CLAHE)
//   flexion-published  flexion.h in its published form, neighbours one pixel away, nothing added
//   flexion            flexion of smoothed inverse depth, neighbours farther away
//   auto               color where it shows more than noise, else normal, frame by frame
//   normal             the surface normal's component against the optical axis, likewise
// All but the first are made of the depth image alone, and see in the dark.
class InputImage {
 public:
  // max_depth (m): the brightest level of the depth images. Throws std::invalid_argument listing the names.
  InputImage(const std::string& name, const Camera& camera, double max_depth);

  // Empty where the frame does not have the image it is made of.
  cv::Mat of(const Frame& frame) const;

  // Of those names, the one whose image of() is: itself, unless it is auto.
  std::string chosen(const Frame& frame) const;

  static void check(const std::string& name);

 private:
  cv::Mat of_depth(const std::string& name, const cv::Mat& depth) const;

  std::string name_;
  double max_depth_;
  std::optional<DepthRays> rays_;  // where surfaces are looked at
};

// Whether the name's image is made of the depth image; that of auto is where colour tells too little.
inline bool is_made_of_depth(const std::string& input_name) { return input_name != "color"; }

// Whether colour is ever looked at.
inline bool reads_color(const std::string& input_name) {
  return input_name == "color" || input_name == "auto";
}

}  // namespace framewise
