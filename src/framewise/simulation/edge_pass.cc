// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/simulation/edge_pass.h"

#include <cmath>
#include <vector>

namespace framewise {
namespace {

// Neighbours that differ by more than this (of 255) and see two surfaces, or one at distances that differ by
// more than this share, have a border between them. Within a surface the texture is filtered already.
constexpr int kContrast = 4;
constexpr float kJump = 0.03f;

// In which part of the way from a pixel's centre to that of the next the border lies: 1 to kParts, 0 for
// none.
constexpr int kParts = 8;
struct Borders {
  cv::Mat right, below;  // CV_8U
};

bool differ(const cv::Vec3b& a, const cv::Vec3b& b) {
  return std::max({std::abs(a[0] - b[0]), std::abs(a[1] - b[1]), std::abs(a[2] - b[2])}) > kContrast;
}

bool is_border(const View& view, const Centres& centres, cv::Point a, cv::Point b) {
  const int triangle_a = centres.triangle.at<int>(a), triangle_b = centres.triangle.at<int>(b);
  if (triangle_a == triangle_b) return false;
  if (view.is_one_surface(triangle_a, triangle_b)) {
    const float za = centres.distance.at<float>(a), zb = centres.distance.at<float>(b);
    if (std::abs(za - zb) <= kJump * std::min(za, zb)) return false;
  }
  return differ(centres.color.at<cv::Vec3b>(a), centres.color.at<cv::Vec3b>(b));
}

// The borders to the right of the pixels of a tile and below them.
class TileBorders {
 public:
  TileBorders(const View& view, const Centres& centres, const cv::Rect& tile, Borders& borders)
      : view_(view), centres_(centres), borders_(borders) {
    const cv::Rect image({0, 0}, centres.triangle.size());
    for (int v = tile.y; v < tile.y + tile.height; ++v)
      for (int u = tile.x; u < tile.x + tile.width; ++u)
        for (const cv::Point& step : {cv::Point(1, 0), cv::Point(0, 1)}) {
          const cv::Point pixel(u, v);
          if (image.contains(pixel + step) && is_border(view, centres, pixel, pixel + step))
            pairs_.push_back({pixel, step, 0.5f, Side::kNeither});
        }
  }

  // Halves the way again and again.
  void find() {
    look();
    std::erase_if(pairs_, [](const Pair& pair) { return pair.side == Side::kNeither; });
    for (float step = 0.25f; step >= 1.0f / kParts; step *= 0.5f) {
      for (Pair& pair : pairs_) pair.at += pair.side == Side::kFirst ? step : -step;
      look();
    }
    for (const Pair& pair : pairs_) {
      const int part = static_cast<int>(kParts * pair.at) + (pair.side == Side::kFirst ? 1 : 0);
      cv::Mat& borders = pair.step.x ? borders_.right : borders_.below;
      borders.at<std::uint8_t>(pair.pixel) = static_cast<std::uint8_t>(part);
    }
  }

 private:
  enum class Side { kFirst, kSecond, kNeither };
  struct Pair {
    cv::Point pixel, step;
    float at;  // share of the way
    Side side;
  };

  // What is seen on the way of each pair.
  void look() {
    for (std::size_t first = 0; first < pairs_.size(); first += 8) {
      const int count = static_cast<int>(std::min<std::size_t>(8, pairs_.size() - first));
      Packet packet;
      for (int i = 0; i < 8; ++i) {
        if (i >= count) {
          packet.rays.switch_off(i);
          continue;
        }
        const Pair& pair = pairs_[first + i];
        packet.aim(i, view_, pair.pixel,
                   {pair.at * static_cast<float>(pair.step.x), pair.at * static_cast<float>(pair.step.y)});
      }
      Hits8 hits;
      view_.tracer.intersect(packet.rays, true, hits);
      for (int i = 0; i < count; ++i)
        pairs_[first + i].side = side_of(pairs_[first + i], hits.triangle[i], hits.t[i] * packet.z_in_cam[i]);
    }
  }

  Side side_of(const Pair& pair, std::uint32_t met, float distance) const {
    const int triangle = met == kNoHit ? -1 : static_cast<int>(met);
    const bool first = view_.is_one_surface(triangle, centres_.triangle.at<int>(pair.pixel));
    const bool second = view_.is_one_surface(triangle, centres_.triangle.at<int>(pair.pixel + pair.step));
    if (first && second) {
      const float to_first = std::abs(distance - centres_.distance.at<float>(pair.pixel)),
                  to_second = std::abs(distance - centres_.distance.at<float>(pair.pixel + pair.step));
      return to_first <= to_second ? Side::kFirst : Side::kSecond;
    }
    return first ? Side::kFirst : (second ? Side::kSecond : Side::kNeither);
  }

  const View& view_;
  const Centres& centres_;
  Borders& borders_;
  std::vector<Pair> pairs_;
};

// How much of a pixel lies beyond a border in the middle of a part of the way to the next, 0 for none.
float share_beyond(int part) {
  return part == 0 ? 0 : std::max(0.0f, 0.5f - (static_cast<float>(part) - 0.5f) / kParts);
}

// A pixel and its neighbours by their shares of it.
template <typename Pixel>
Pixel mixture(const cv::Mat& image, const Borders& borders, cv::Point pixel) {
  const auto beyond = [&](const cv::Mat& borders_there, cv::Point first, bool from_second) {
    const int part = borders_there.at<std::uint8_t>(first);
    return share_beyond(from_second && part > 0 ? kParts + 1 - part : part);
  };
  const float right = beyond(borders.right, pixel, false), below = beyond(borders.below, pixel, false),
              left = pixel.x > 0 ? beyond(borders.right, {pixel.x - 1, pixel.y}, true) : 0,
              above = pixel.y > 0 ? beyond(borders.below, {pixel.x, pixel.y - 1}, true) : 0;
  const float aside = left + right, along = above + below;
  if (aside + along == 0) return image.at<Pixel>(pixel);
  // What is beyond both a side and an end of the pixel counts once.
  const float share = 1 - aside * along / (aside + along);
  cv::Vec3f sum = (1 - share * (aside + along)) * cv::Vec3f(image.at<Pixel>(pixel));
  const auto add = [&](float part, int du, int dv) {
    if (part > 0) sum += share * part * cv::Vec3f(image.at<Pixel>(pixel.y + dv, pixel.x + du));
  };
  add(left, -1, 0);
  add(right, 1, 0);
  add(above, 0, -1);
  add(below, 0, 1);
  return Pixel(sum);
}

template <typename Pixel>
cv::Mat mixed(const cv::Mat& image, const Borders& borders) {
  cv::Mat result(image.size(), image.type());
  for_each_tile(image.cols, image.rows, [&](const cv::Rect& tile) {
    for (int v = tile.y; v < tile.y + tile.height; ++v)
      for (int u = tile.x; u < tile.x + tile.width; ++u)
        result.at<Pixel>(v, u) = mixture<Pixel>(image, borders, {u, v});
  });
  return result;
}

}  // namespace

cv::Mat with_smooth_edges(const View& view, const Centres& centres, const cv::Mat& image) {
  if (view.options.edge_samples == 1) return image;
  const cv::Mat none(image.size(), CV_8U, cv::Scalar(0));
  Borders borders{none, none.clone()};
  for_each_tile(image.cols, image.rows,
                [&](const cv::Rect& tile) { TileBorders(view, centres, tile, borders).find(); });
  return image.type() == CV_8UC3 ? mixed<cv::Vec3b>(image, borders) : mixed<cv::Vec3f>(image, borders);
}

}  // namespace framewise
