// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/simulation/blur.h"

#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>
#include <optional>

#include "framewise/simulation/color_pass.h"

namespace framewise {
namespace {

using Eigen::Vector3f;

// Share of the distance within which two places on a ray are the same, and neighbours are of one surface.
constexpr float kNear = 0.02f;
// Where things move farther than this between views (pixels), every ray is traced.
constexpr float kFarthestShift = 24;

// Pixels that differ in depth from a neighbour to the right or below, and those neighbours.
cv::Mat jumps_of_depth(const cv::Mat& distance) {
  cv::Mat jumps(distance.size(), CV_8U, cv::Scalar(0));
  const auto compare = [&](cv::Point a, cv::Point b) {
    const float za = distance.at<float>(a), zb = distance.at<float>(b);
    if (std::min(za, zb) > 0 && std::abs(za - zb) <= kNear * std::min(za, zb)) return;
    jumps.at<std::uint8_t>(a) = jumps.at<std::uint8_t>(b) = 1;
  };
  for (int v = 0; v < distance.rows; ++v)
    for (int u = 0; u < distance.cols; ++u) {
      if (u + 1 < distance.cols) compare({u, v}, {u + 1, v});
      if (v + 1 < distance.rows) compare({u, v}, {u, v + 1});
    }
  return jumps;
}

// Pixels beside another texture.
cv::Mat borders_of_textures(const View& view, const cv::Mat& triangle) {
  cv::Mat borders(triangle.size(), CV_8U, cv::Scalar(0));
  const auto compare = [&](cv::Point a, cv::Point b) {
    if (!view.is_one_surface(triangle.at<int>(a), triangle.at<int>(b)))
      borders.at<std::uint8_t>(a) = borders.at<std::uint8_t>(b) = 1;
  };
  for (int v = 0; v < triangle.rows; ++v)
    for (int u = 0; u < triangle.cols; ++u) {
      if (u + 1 < triangle.cols) compare({u, v}, {u + 1, v});
      if (v + 1 < triangle.rows) compare({u, v}, {u, v + 1});
    }
  return borders;
}

cv::Mat grown(const cv::Mat& mask, int pixels) {
  cv::Mat result;
  cv::dilate(mask, result, cv::getStructuringElement(cv::MORPH_RECT, {2 * pixels + 1, 2 * pixels + 1}));
  return result;
}

// Rays of a row of a view, in the camera of the middle.
struct RowInMiddle {
  Eigen::Matrix3f turn;
  Vector3f origin;
};

std::vector<RowInMiddle> rows_in_middle(const View& view, const RowPose& middle) {
  std::vector<RowInMiddle> rows;
  for (const RowPose& row : view.rows)
    rows.push_back(
        {middle.turn.transpose() * row.turn,
         middle.turn.transpose() * (row.world_from_cam.t - middle.world_from_cam.t).cast<float>()});
  return rows;
}

// What an undistorted camera sees in the middle of an exposure.
class Middle {
 public:
  Middle(const View& view, const std::vector<std::vector<RowInMiddle>>& rows_of_views)
      : view_(view),
        centres_(trace_centres(view, true, false)),
        must_trace_(centres_.distance.size(), CV_8U, cv::Scalar(1)) {
    const float shift = farthest_shift(rows_of_views);
    if (!(shift <= kFarthestShift)) return;
    const int margin = static_cast<int>(std::ceil(shift)) + 1;
    cv::Mat jumps = jumps_of_depth(centres_.distance);
    // What is beyond the border of the image is not known.
    cv::rectangle(jumps, {0, 0}, {jumps.cols - 1, jumps.rows - 1}, cv::Scalar(1));
    must_trace_ = grown(jumps, margin) | grown(borders_of_textures(view, centres_.triangle), 1);
  }

  // The light of a ray (of this camera) that needs no tracing: no depth jumps as near to what it meets as
  // anything moves between the views, so nothing can have come before it.
  const cv::Vec3f* light_along(const Vector3f& origin, const Vector3f& direction) const {
    if (direction.z() < 0.1f) return nullptr;
    Vector3f x = direction;
    for (int iteration = 0; iteration < 4; ++iteration) {
      const auto pixel = pixel_of(x);
      if (!pixel || must_trace_.at<std::uint8_t>(*pixel)) return nullptr;
      const float z = centres_.distance.at<float>(*pixel);
      if (iteration > 0 && std::abs(z - x.z()) <= 0.5f * kNear * z)
        return &centres_.radiance.at<cv::Vec3f>(*pixel);
      x = origin + (z - origin.z()) / direction.z() * direction;
    }
    return nullptr;
  }

  // The light it sees at a place on a triangle, if it sees that place.
  const cv::Vec3f* light_at(const Vector3f& place, std::uint32_t triangle) const {
    const RowPose& pose = view_.rows.front();
    const Vector3f x = pose.turn.transpose() * (place - pose.origin);
    const auto pixel = pixel_of(x);
    if (!pixel || !view_.is_one_surface(centres_.triangle.at<int>(*pixel), static_cast<int>(triangle)) ||
        std::abs(centres_.distance.at<float>(*pixel) - x.z()) > kNear * x.z())
      return nullptr;
    return &centres_.radiance.at<cv::Vec3f>(*pixel);
  }

 private:
  std::optional<cv::Point> pixel_of(const Vector3f& x) const {
    const Camera& camera = view_.options.camera;
    if (camera.model != CameraModel::kPinhole || x.z() < 1e-3f) return std::nullopt;
    const float u = static_cast<float>(camera.fx) * x.x() / x.z() + static_cast<float>(camera.cx) + 0.5f,
                v = static_cast<float>(camera.fy) * x.y() / x.z() + static_cast<float>(camera.cy) + 0.5f;
    if (!(u >= 0 && v >= 0 && u < static_cast<float>(camera.width) && v < static_cast<float>(camera.height)))
      return std::nullopt;
    return cv::Point(static_cast<int>(u), static_cast<int>(v));
  }

  // By which the nearest thing moves against the farthest, from the middle to any row of any view (pixels).
  float farthest_shift(const std::vector<std::vector<RowInMiddle>>& rows_of_views) const {
    float way = 0, nearest = std::numeric_limits<float>::max();
    for (const auto& rows : rows_of_views)
      for (const RowInMiddle& row : rows) way = std::max(way, row.origin.norm());
    for (int v = 0; v < centres_.distance.rows; ++v)
      for (int u = 0; u < centres_.distance.cols; ++u)
        if (const float z = centres_.distance.at<float>(v, u); z > 0) nearest = std::min(nearest, z);
    // A camera that comes nearer by dz moves what is at the border by its distance from the middle.
    constexpr float kOblique = 1.5f;
    const Camera& camera = view_.options.camera;
    const float zoom = static_cast<float>(std::max({camera.fx, camera.fy, 0.5 * camera.width}));
    return kOblique * zoom * way / std::max(1e-6f, nearest - way);
  }

  const View& view_;
  Centres centres_;
  cv::Mat must_trace_;  // CV_8U
};

// Adds the light of a view to a tile. Rays that must be traced wait until there are eight.
class TileOfView {
 public:
  TileOfView(const View& view, const std::vector<RowInMiddle>& rows, const Middle& middle, cv::Mat& sum)
      : view_(view), rows_(rows), middle_(middle), sum_(sum) {}

  void look_at(cv::Point pixel) {
    const Vector3f ray = view_.ray_in_cam(pixel.x, pixel.y, view_.offset);
    const RowInMiddle& row = rows_[pixel.y];
    if (const cv::Vec3f* known = middle_.light_along(row.origin, row.turn * ray)) {
      sum_.at<cv::Vec3f>(pixel) += *known;
      return;
    }
    packet_.aim(count_, view_, pixel, view_.offset);
    if (++count_ == 8) finish();
  }

  void finish() {
    if (count_ == 0) return;
    for (int i = count_; i < 8; ++i) packet_.rays.switch_off(i);
    Hits8 hits;
    view_.tracer.intersect(packet_.rays, true, hits);
    for (int i = 0; i < count_; ++i)
      if (hits.triangle[i] != kNoHit) add(hits[i], i);
    count_ = 0;
  }

 private:
  void add(const Hit& hit, int i) {
    const Vector3f &direction = packet_.directions[i], &origin = view_.rows[packet_.pixels[i].y].origin;
    cv::Vec3f& light = sum_.at<cv::Vec3f>(packet_.pixels[i]);
    if (const cv::Vec3f* known = middle_.light_at(origin + hit.t * direction, hit.triangle)) {
      light += *known;
      return;
    }
    const Color shaded = shade(view_, hit, packet_.rays_in_cam[i], direction, 1);
    light += cv::Vec3f(shaded.b, shaded.g, shaded.r);
  }

  const View& view_;
  const std::vector<RowInMiddle>& rows_;
  const Middle& middle_;
  cv::Mat& sum_;
  Packet packet_;
  int count_ = 0;
};

}  // namespace

cv::Mat mean_of_views(const View& middle_view, std::span<const View> views) {
  const int width = middle_view.options.camera.width, height = middle_view.options.camera.height;
  std::vector<std::vector<RowInMiddle>> rows;
  for (const View& view : views) rows.push_back(rows_in_middle(view, middle_view.rows.front()));
  const Middle middle(middle_view, rows);
  cv::Mat sum(height, width, CV_32FC3, cv::Scalar::all(0));
  for_each_tile(width, height, [&](const cv::Rect& tile) {
    for (std::size_t k = 0; k < views.size(); ++k) {
      TileOfView part(views[k], rows[k], middle, sum);
      for (int v0 = tile.y; v0 < tile.y + tile.height; v0 += 2)
        for (int u0 = tile.x; u0 < tile.x + tile.width; u0 += 4)
          for (int i = 0; i < 8; ++i)
            if (const cv::Point pixel(u0 + i % 4, v0 + i / 4); tile.contains(pixel)) part.look_at(pixel);
      part.finish();
    }
  });
  return sum * (1.0 / static_cast<double>(views.size()));
}

}  // namespace framewise
