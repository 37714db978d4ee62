// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/features/tracking.h"

#include <cmath>
#include <limits>
#include <opencv2/video/tracking.hpp>
#include <stdexcept>

#include "framewise/features/tracking_input.h"

namespace framewise {
namespace {

void check_image(const TrackedImage& image, const char* name, const TrackOptions& options) {
  if (image.levels.empty() || image.window != options.window)
    throw std::invalid_argument(std::string(name) + ": found one " +
                                (image.levels.empty() ? "that is empty" : "made for another window") +
                                ", expected tracked_image with the same options");
}

std::string text(const cv::Size& size) {
  return std::to_string(size.width) + " x " + std::to_string(size.height);
}

// False for NaN. Within half a pixel of a pixel's centre, as Camera::contains.
bool is_inside(const cv::Size& size, const cv::Point2f& p) {
  return p.x >= -0.5f && p.y >= -0.5f && p.x < size.width - 0.5f && p.y < size.height - 0.5f;
}

// Moves those points of `to` whose `found` is set, and clears it where a point is lost.
void follow(const TrackedImage& image1, const TrackedImage& image2, const std::vector<cv::Point2f>& from,
            std::vector<cv::Point2f>& to, std::vector<std::uint8_t>& found, const TrackOptions& options) {
  std::vector<cv::Point2f> starts, ends;
  for (std::size_t i = 0; i < from.size(); ++i)
    if (found[i]) starts.push_back(from[i]), ends.push_back(to[i]);
  if (starts.empty()) return;
  std::vector<std::uint8_t> seen;
  const cv::TermCriteria until(cv::TermCriteria::COUNT | cv::TermCriteria::EPS, options.max_iterations,
                               options.min_step_px);
  cv::calcOpticalFlowPyrLK(image1.levels, image2.levels, starts, ends, seen, cv::noArray(),
                           cv::Size(options.window, options.window), options.levels, until,
                           cv::OPTFLOW_USE_INITIAL_FLOW, options.min_texture);
  for (std::size_t i = 0, k = 0; i < from.size(); ++i) {
    if (!found[i]) continue;
    to[i] = ends[k];
    found[i] = seen[k++] && is_inside(image2.size, to[i]);
  }
}

}  // namespace

void TrackOptions::check() const {
  check_tracking_option(window >= 3 && window <= 255 && window % 2 == 1, "window", window,
                        "an odd number from 3 to 255");
  check_tracking_option(levels >= 0 && levels <= 10, "levels", levels, "0 to 10");
  check_tracking_option(max_iterations >= 1 && max_iterations <= 100, "max_iterations", max_iterations,
                        "1 to 100");
  check_tracking_option(min_step_px > 0 && min_step_px <= 10, "min_step_px", min_step_px,
                        "more than 0, at most 10");
  check_tracking_option(min_texture >= 0 && min_texture <= 1, "min_texture", min_texture, "0 to 1");
  check_tracking_option(max_backward_px > 0, "max_backward_px", max_backward_px, "more than 0");
}

TrackedImage tracked_image(const cv::Mat& gray, const TrackOptions& options) {
  options.check();
  check_tracking_image(gray);
  TrackedImage image{{}, gray.size(), options.window};
  cv::buildOpticalFlowPyramid(gray, image.levels, cv::Size(options.window, options.window), options.levels);
  return image;
}

Tracks track_points(const TrackedImage& image1, const TrackedImage& image2,
                    const std::vector<cv::Point2f>& pixels1, const TrackOptions& options,
                    const std::vector<cv::Point2f>& predicted2) {
  options.check();
  check_image(image1, "image1", options);
  check_image(image2, "image2", options);
  if (image1.size != image2.size)
    throw std::invalid_argument("image2: found " + text(image2.size) + " pixels beside " + text(image1.size) +
                                ", expected images of one size");
  if (!predicted2.empty() && predicted2.size() != pixels1.size())
    throw std::invalid_argument("predicted2: found " + std::to_string(predicted2.size()) + " for " +
                                std::to_string(pixels1.size()) + " pixels, expected as many, or none");

  const std::vector<cv::Point2f>& start2 = predicted2.empty() ? pixels1 : predicted2;
  Tracks tracks{start2, std::vector<std::uint8_t>(pixels1.size())};
  for (std::size_t i = 0; i < pixels1.size(); ++i)
    tracks.found[i] = is_inside(image1.size, pixels1[i]) && is_inside(image2.size, start2[i]);
  follow(image1, image2, pixels1, tracks.pixels, tracks.found, options);

  // The way back begins as far from its end as the way there did.
  std::vector<cv::Point2f> back = tracks.pixels;
  for (std::size_t i = 0; i < back.size(); ++i) back[i] += pixels1[i] - start2[i];
  follow(image2, image1, tracks.pixels, back, tracks.found, options);
  for (std::size_t i = 0; i < back.size(); ++i)
    tracks.found[i] &= cv::norm(back[i] - pixels1[i]) <= options.max_backward_px;
  return tracks;
}

Tracks track_points(const cv::Mat& gray1, const cv::Mat& gray2, const std::vector<cv::Point2f>& pixels1,
                    const TrackOptions& options, const std::vector<cv::Point2f>& predicted2) {
  return track_points(tracked_image(gray1, options), tracked_image(gray2, options), pixels1, options,
                      predicted2);
}

std::vector<cv::Point2f> predict_by_rotation(const Camera& camera, const Eigen::Matrix3d& cam2_from_cam1,
                                             const std::vector<cv::Point2f>& pixels1) {
  camera.check();
  std::vector<cv::Point2f> predicted;
  predicted.reserve(pixels1.size());
  for (const cv::Point2f& p : pixels1) {
    const auto x1 = camera.bearing({p.x, p.y});
    const auto pixel2 = x1 ? camera.project(cam2_from_cam1 * *x1) : std::nullopt;
    constexpr float kNowhere = std::numeric_limits<float>::quiet_NaN();
    predicted.push_back(pixel2 ? cv::Point2f(static_cast<float>(pixel2->x()), static_cast<float>(pixel2->y()))
                               : cv::Point2f(kNowhere, kNowhere));
  }
  return predicted;
}

PixelMatches tracked_matches(const std::vector<cv::Point2f>& pixels1, const Tracks& tracks) {
  PixelMatches matches;
  for (std::size_t i = 0; i < pixels1.size(); ++i) {
    if (!tracks.found[i]) continue;
    matches.pixels1.push_back(pixels1[i]);
    matches.pixels2.push_back(tracks.pixels[i]);
  }
  return matches;
}

}  // namespace framewise
