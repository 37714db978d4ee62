// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <opencv2/core.hpp>
#include <vector>

#include "framewise/geometry/camera.h"

namespace framewise {

struct TrackOptions {
  int window = 21;            // side of the patches compared (pixels, odd)
  int levels = 3;             // halvings above the image itself: each doubles the motion that is found
  int max_iterations = 30;    // on a level
  double min_step_px = 0.01;  // on a level it ends with a step shorter than this
  double min_texture = 1e-4;  // least eigenvalue of a patch's gradient matrix a pixel, of grey values 0 to 1
  double max_backward_px = 0.5;  // tracked back from where it was found, a point ends this near its start

  // Throws std::invalid_argument that names the value.
  void check() const;
};

// Where points went: an entry for every one of them.
struct Tracks {
  std::vector<cv::Point2f> pixels;
  std::vector<std::uint8_t> found;  // 0: lost, and its pixel means nothing
};

// An image at all the scales tracking looks at, made once for the pairs before and after it.
struct TrackedImage {
  std::vector<cv::Mat> levels;  // as cv::buildOpticalFlowPyramid makes them, with derivatives
  cv::Size size;
  int window;
};

// gray: CV_8U.
TrackedImage tracked_image(const cv::Mat& gray, const TrackOptions& options = {});

// Follows points from image 1 to image 2 by their patches, from the coarsest scale to the finest, and back
// again; what does not come back to where it began, has no texture or lies outside an image is lost. Both
// images are made with the same options.
//   Lucas, Kanade, An iterative image registration technique, IJCAI 1981; Bouguet, Pyramidal implementation
//   of the Lucas Kanade feature tracker, 2000; Kalal et al., Forward-backward error, ICPR 2010.
// predicted2, unless empty: where each point is expected in image 2; one that is not finite is lost. It does
// not change where a point is found, but how far it may be.
Tracks track_points(const TrackedImage& image1, const TrackedImage& image2,
                    const std::vector<cv::Point2f>& pixels1, const TrackOptions& options = {},
                    const std::vector<cv::Point2f>& predicted2 = {});
Tracks track_points(const cv::Mat& gray1, const cv::Mat& gray2, const std::vector<cv::Point2f>& pixels1,
                    const TrackOptions& options = {}, const std::vector<cv::Point2f>& predicted2 = {});

// Where pixels of camera 1 are in a camera 2 that is turned but not moved, x2 = cam2_from_cam1 x1: the
// homography at infinity, for any camera model. NaN where either view does not see the direction.
std::vector<cv::Point2f> predict_by_rotation(const Camera& camera, const Eigen::Matrix3d& cam2_from_cam1,
                                             const std::vector<cv::Point2f>& pixels1);

// Pixel i of either image is the same thing.
struct PixelMatches {
  std::vector<cv::Point2f> pixels1, pixels2;
};

// The points that were found.
PixelMatches tracked_matches(const std::vector<cv::Point2f>& pixels1, const Tracks& tracks);

}  // namespace framewise
