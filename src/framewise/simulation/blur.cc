// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/simulation/blur.h"

#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>
#include <optional>

#include "framewise/simulation/color_pass.h"
#include "framewise/simulation/edge_pass.h"

namespace framewise {
namespace {

using Eigen::Vector3f;

// Share of the distance within which two places on a ray are the same, and neighbours are of one surface.
constexpr float kNear = 0.02f;
// How far beside a jump of depth rays are traced (pixels), on top of what moves there.
constexpr int kMargin = 1;
// Things move at most this far between views (pixels), or every ray is traced.
constexpr float kFarthestShift = 64;
// Where the sides of a jump move less against each other (pixels), one view shows what all see.
constexpr float kLeastShift = 0.25f;
// Sides of the blocks whose corners alone are looked for in the middle view (pixels).
constexpr int kBlock = 8, kSmallBlock = 4;

// How far the two sides of each jump of depth may move against each other, of pixels beside it (pixels, 0 for
// those beside none), when what is at a distance z moves by `shift` / z.
cv::Mat shifts_at_jumps(const cv::Mat& distance, float shift) {
  cv::Mat shifts(distance.size(), CV_8U, cv::Scalar(0));
  const auto compare = [&](cv::Point a, cv::Point b) {
    const float za = distance.at<float>(a), zb = distance.at<float>(b);
    if (za == zb || (std::min(za, zb) > 0 && std::abs(za - zb) <= kNear * std::min(za, zb))) return;
    const float against = shift * std::abs((za > 0 ? 1 / za : 0) - (zb > 0 ? 1 / zb : 0));
    if (against < kLeastShift) return;
    const auto pixels = static_cast<std::uint8_t>(kMargin + std::ceil(std::min(against, kFarthestShift)));
    for (const cv::Point& at : {a, b})
      shifts.at<std::uint8_t>(at) = std::max(shifts.at<std::uint8_t>(at), pixels);
  };
  for (int v = 0; v < distance.rows; ++v)
    for (int u = 0; u < distance.cols; ++u) {
      if (u + 1 < distance.cols) compare({u, v}, {u + 1, v});
      if (v + 1 < distance.rows) compare({u, v}, {u, v + 1});
    }
  return shifts;
}

// Every pixel as near to a marked one as the mark says.
cv::Mat grown(const cv::Mat& pixels) {
  cv::Mat all(pixels.size(), CV_8U, cv::Scalar(0)), left = pixels.clone();
  // From the largest on; those within a third of it grow together.
  for (double most = 0; cv::minMaxLoc(left, nullptr, &most), most > 0;) {
    const cv::Mat some = left > 0.75 * most - 1;
    left.setTo(0, some);
    const int side = 2 * static_cast<int>(most) + 1;
    cv::Mat region;
    cv::dilate(some, region, cv::getStructuringElement(cv::MORPH_RECT, {side, side}));
    all |= region;
  }
  return all;
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
      : view_(view), centres_(trace_centres(view, true, false)) {
    centres_.radiance = with_smooth_edges(view, centres_, centres_.radiance);
    const float shift = shift_at_1_m(rows_of_views);
    float nearest = std::numeric_limits<float>::max();
    for (int v = 0; v < centres_.distance.rows; ++v)
      for (int u = 0; u < centres_.distance.cols; ++u)
        if (const float z = centres_.distance.at<float>(v, u); z > 0) nearest = std::min(nearest, z);
    if (shift <= kFarthestShift * nearest) {
      cv::Mat shifts = shifts_at_jumps(centres_.distance, shift);
      // What is beyond the border of the image may be as near as anything.
      cv::rectangle(shifts, {0, 0}, {shifts.cols - 1, shifts.rows - 1},
                    cv::Scalar(kMargin + std::ceil(shift / nearest)));
      must_trace_ = grown(shifts);
    } else {
      must_trace_ = cv::Mat(centres_.distance.size(), CV_8U, cv::Scalar(255));
    }
    cv::integral(must_trace_ & 1, traced_before_, CV_32S);
  }

  // Where a ray (of this camera) sees what needs no tracing: no depth jumps so near that anything could have
  // come before it. In pixels, the centre of the first at 0.5.
  std::optional<cv::Point2f> place_along(const Vector3f& origin, const Vector3f& direction) const {
    if (direction.z() < 0.1f) return std::nullopt;
    Vector3f x = direction;
    for (int iteration = 0; iteration < 4; ++iteration) {
      const auto place = place_of(x);
      if (!place) return std::nullopt;
      const cv::Point pixel(static_cast<int>(place->x), static_cast<int>(place->y));
      if (must_trace_.at<std::uint8_t>(pixel)) return std::nullopt;
      const float z = centres_.distance.at<float>(pixel);
      if (iteration > 0 && std::abs(z - x.z()) <= 0.5f * kNear * z) return place;
      x = origin + (z - origin.z()) / direction.z() * direction;
    }
    return std::nullopt;
  }

  // Whether no pixel between the places must be traced.
  bool is_free(const std::array<cv::Point2f, 4>& places) const {
    const auto [left, right] = std::minmax({places[0].x, places[1].x, places[2].x, places[3].x});
    const auto [top, bottom] = std::minmax({places[0].y, places[1].y, places[2].y, places[3].y});
    const int u0 = static_cast<int>(left), u1 = static_cast<int>(right) + 1, v0 = static_cast<int>(top),
              v1 = static_cast<int>(bottom) + 1;
    const auto before = [&](int u, int v) { return traced_before_.at<int>(v, u); };
    return before(u1, v1) - before(u0, v1) - before(u1, v0) + before(u0, v0) == 0;
  }

  const cv::Vec3f& light_at(const cv::Point2f& place) const {
    return centres_.radiance.at<cv::Vec3f>(static_cast<int>(place.y), static_cast<int>(place.x));
  }

  // The light it sees at a place on a triangle, if it sees that place.
  const cv::Vec3f* light_at(const Vector3f& place_in_world, std::uint32_t triangle) const {
    const RowPose& pose = view_.rows.front();
    const Vector3f x = pose.turn.transpose() * (place_in_world - pose.origin);
    const auto place = place_of(x);
    if (!place) return nullptr;
    const cv::Point pixel(static_cast<int>(place->x), static_cast<int>(place->y));
    if (!view_.is_one_surface(centres_.triangle.at<int>(pixel), static_cast<int>(triangle)) ||
        std::abs(centres_.distance.at<float>(pixel) - x.z()) > kNear * x.z())
      return nullptr;
    return &centres_.radiance.at<cv::Vec3f>(pixel);
  }

 private:
  std::optional<cv::Point2f> place_of(const Vector3f& x) const {
    const Camera& camera = view_.options.camera;
    if (camera.model != CameraModel::kPinhole || x.z() < 1e-3f) return std::nullopt;
    const float inverse = 1 / x.z();
    const float u = static_cast<float>(camera.fx) * x.x() * inverse + static_cast<float>(camera.cx) + 0.5f,
                v = static_cast<float>(camera.fy) * x.y() * inverse + static_cast<float>(camera.cy) + 0.5f;
    if (!(u >= 0 && v >= 0 && u < static_cast<float>(camera.width) && v < static_cast<float>(camera.height)))
      return std::nullopt;
    return cv::Point2f(u, v);
  }

  // By which a thing 1 m away moves at most, from the middle to any row of any view (pixels).
  float shift_at_1_m(const std::vector<std::vector<RowInMiddle>>& rows_of_views) const {
    float way = 0;
    for (const auto& rows : rows_of_views)
      for (const RowInMiddle& row : rows) way = std::max(way, row.origin.norm());
    // A camera that comes nearer by dz moves what is at the border by its distance from the middle.
    constexpr float kOblique = 1.5f;
    const Camera& camera = view_.options.camera;
    return kOblique * static_cast<float>(std::max({camera.fx, camera.fy, 0.5 * camera.width})) * way;
  }

  const View& view_;
  Centres centres_;
  cv::Mat must_trace_;     // CV_8U
  cv::Mat traced_before_;  // CV_32S, how many must be in the rows and columns before
};

// Adds the light of a view to a tile. Rays that must be traced wait until there are eight.
class TileOfView {
 public:
  TileOfView(const View& view, const std::vector<RowInMiddle>& rows, const Middle& middle, cv::Mat& sum)
      : view_(view), rows_(rows), middle_(middle), sum_(sum) {}

  // Between its corners places run evenly.
  void look_at_block(const cv::Rect& block) {
    const int right = block.width - 1, down = block.height - 1;
    std::array<cv::Point2f, 4> corners;
    for (int k = 0; k < 4; ++k) {
      const auto place = place_of(block.tl() + cv::Point(k % 2 ? right : 0, k / 2 ? down : 0));
      if (!place) return look_closer(block);
      corners[k] = *place;
    }
    if (!middle_.is_free(corners)) return look_closer(block);
    const float across = 1.0f / static_cast<float>(std::max(1, right)),
                along = 1.0f / static_cast<float>(std::max(1, down));
    for (int j = 0; j <= down; ++j) {
      const float t = along * static_cast<float>(j);
      const cv::Point2f first = corners[0] + t * (corners[2] - corners[0]),
                        last = corners[1] + t * (corners[3] - corners[1]), step = across * (last - first);
      cv::Vec3f* sums = sum_.ptr<cv::Vec3f>(block.y + j) + block.x;
      for (int i = 0; i <= right; ++i) sums[i] += middle_.light_at(first + static_cast<float>(i) * step);
    }
  }

  void look_closer(const cv::Rect& block) {
    if (block.width <= kSmallBlock && block.height <= kSmallBlock) return look_at_each(block);
    for (int v0 = block.y; v0 < block.y + block.height; v0 += kSmallBlock)
      for (int u0 = block.x; u0 < block.x + block.width; u0 += kSmallBlock)
        look_at_block(cv::Rect(u0, v0, kSmallBlock, kSmallBlock) & block);
  }

  void look_at_each(const cv::Rect& block) {
    for (int v0 = block.y; v0 < block.y + block.height; v0 += 2)
      for (int u0 = block.x; u0 < block.x + block.width; u0 += 4)
        for (int i = 0; i < 8; ++i)
          if (const cv::Point pixel(u0 + i % 4, v0 + i / 4); block.contains(pixel)) look_at(pixel);
  }

  void look_at(cv::Point pixel) {
    if (const auto place = place_of(pixel)) {
      sum_.at<cv::Vec3f>(pixel) += middle_.light_at(*place);
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
  std::optional<cv::Point2f> place_of(cv::Point pixel) const {
    const RowInMiddle& row = rows_[pixel.y];
    return middle_.place_along(row.origin, row.turn * view_.ray_in_cam(pixel.x, pixel.y, view_.offset));
  }

  void add(const Hit& hit, int i) {
    const Vector3f direction = packet_.direction(i), &origin = view_.rows[packet_.pixels[i].y].origin;
    cv::Vec3f& light = sum_.at<cv::Vec3f>(packet_.pixels[i]);
    if (const cv::Vec3f* known = middle_.light_at(origin + hit.t * direction, hit.triangle)) {
      light += *known;
      return;
    }
    const Color shaded = shade(view_, hit, packet_.ray_in_cam(i), direction, 1);
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
      for (int v0 = tile.y; v0 < tile.y + tile.height; v0 += kBlock)
        for (int u0 = tile.x; u0 < tile.x + tile.width; u0 += kBlock)
          part.look_at_block(cv::Rect(u0, v0, kBlock, kBlock) & tile);
      part.finish();
    }
  });
  return sum * (1.0 / static_cast<double>(views.size()));
}

}  // namespace framewise
