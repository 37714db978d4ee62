// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/image/edge_alignment.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "framewise/image/depth.h"
#include "framewise/image/image_check.h"

namespace framewise {
namespace {

constexpr float kStep = 0.08f;                                // of depth, as a share of the nearer
constexpr std::size_t kMostEdges = 700, kFewestEdges = 1500;  // of a view; of all views
constexpr int kZooms = 8, kMost_du = 20, kMost_dv = 12, kStep_px = 2;
constexpr double kZoomStep = 0.02;

// Each pixel's gradient as the share of pixels whose gradient is smaller: of no unit, and blind to contrast.
cv::Mat gradient_rank(const cv::Mat& gray) {
  cv::Mat smooth, dx, dy, size;
  cv::GaussianBlur(gray, smooth, {}, 1.0);
  cv::Sobel(smooth, dx, CV_32F, 1, 0);
  cv::Sobel(smooth, dy, CV_32F, 0, 1);
  cv::magnitude(dx, dy, size);
  constexpr int kBins = 4096;
  const auto bin = [](float value) { return std::min(kBins - 1, static_cast<int>(2 * value)); };
  std::vector<float> smaller(kBins + 1, 0);
  for (int v = 0; v < size.rows; ++v)
    for (int u = 0; u < size.cols; ++u) ++smaller[static_cast<std::size_t>(bin(size.at<float>(v, u))) + 1];
  for (std::size_t i = 1; i < smaller.size(); ++i) smaller[i] += smaller[i - 1];
  const float total = static_cast<float>(size.total());
  for (int v = 0; v < size.rows; ++v)
    for (int u = 0; u < size.cols; ++u) {
      float& value = size.at<float>(v, u);
      value = smaller[static_cast<std::size_t>(bin(value))] / total;
    }
  return size;
}

bool is_before(float z, float other) {
  return is_known_depth(z) && is_known_depth(other) && other - z > kStep * z;
}

}  // namespace

std::vector<cv::Point> depth_edges(const cv::Mat& depth) {
  check_image("depth", depth, CV_32F);
  std::vector<cv::Point> edges;
  for (int v = 1; v + 1 < depth.rows; ++v)
    for (int u = 1; u + 1 < depth.cols; ++u) {
      const float z = depth.at<float>(v, u);
      if (is_before(z, depth.at<float>(v, u - 1)) || is_before(z, depth.at<float>(v, u + 1)) ||
          is_before(z, depth.at<float>(v - 1, u)) || is_before(z, depth.at<float>(v + 1, u)))
        edges.emplace_back(u, v);
    }
  return edges;
}

void EdgeAlignment::add(const cv::Mat& gray, const cv::Mat& depth) {
  check_image("gray", gray, CV_8U);
  check_image_size("depth", depth, gray.cols, gray.rows);
  if (!views_.empty()) check_image_size("gray", gray, size_.width, size_.height);
  size_ = gray.size();
  View view{gradient_rank(gray), {}};
  const auto edges = depth_edges(depth);
  const std::size_t every = edges.size() / kMostEdges + 1;
  for (std::size_t i = 0; i < edges.size(); i += every)
    view.edges.emplace_back(edges[i].x - 0.5f * size_.width, edges[i].y - 0.5f * size_.height);
  views_.push_back(std::move(view));
}

double EdgeAlignment::score(double zoom, int du, int dv) const {
  const float s = static_cast<float>(zoom), cu = 0.5f * size_.width + du + 0.5f,
              cv = 0.5f * size_.height + dv + 0.5f;  // to the nearest pixel
  double sum = 0;
  std::size_t count = 0;
  for (const View& view : views_)
    for (const cv::Point2f& edge : view.edges) {
      const int u = static_cast<int>(s * edge.x + cu), v = static_cast<int>(s * edge.y + cv);
      if (u < 0 || v < 0 || u >= size_.width || v >= size_.height) continue;
      sum += view.rank.at<float>(v, u);
      ++count;
    }
  return count > 0 ? sum / static_cast<double>(count) : 0;
}

std::optional<EdgeFit> EdgeAlignment::fit() const {
  EdgeFit best;
  for (const View& view : views_) best.edges += view.edges.size();
  if (best.edges < kFewestEdges) return std::nullopt;
  double sum = 0, sum_of_squares = 0, count = 0;
  for (int k = -kZooms; k <= kZooms; ++k)
    for (int dv = -kMost_dv; dv <= kMost_dv; dv += kStep_px)
      for (int du = -kMost_du; du <= kMost_du; du += kStep_px) {
        const double zoom = 1 + k * kZoomStep, found = score(zoom, du, dv);
        sum += found, sum_of_squares += found * found, ++count;
        if (k == 0 && std::abs(du) <= kStep_px && std::abs(dv) <= kStep_px)
          best.as_it_is = std::max(best.as_it_is, found);
        if (found > best.score) best.score = found, best.zoom = zoom, best.du = du, best.dv = dv;
      }
  best.spread = std::sqrt(std::max(0.0, sum_of_squares / count - sum * sum / (count * count)));
  return best;
}

}  // namespace framewise
