// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/simulation/color_pass.h"

#include "framewise/image/depth.h"

namespace framewise {
namespace {

using Eigen::Vector3f;

// Neighbours that differ by more than this (of 255) are drawn with more rays: at the border of two surfaces,
// and within one, where the texture is filtered already.
constexpr int kContrastOfSurfaces = 12, kContrastOfTexture = 40;
// A grid of four samples turned so that no two share a row or column (pixels from the centre).
constexpr std::array<float, 2> kSamples[4] = {
    {-0.125f, -0.375f}, {0.375f, -0.125f}, {-0.375f, 0.125f}, {0.125f, 0.375f}};
// Side of the part of a pixel that some of its four samples stand for (pixels).
constexpr float kPartOfPixel[5] = {0, 0.6f, 0.75f, 0.9f, 1};

constexpr std::array<int, 2> kNeighbours[] = {{-1, 0}, {1, 0}, {0, -1}, {0, 1}};

cv::Vec3b to_bytes(const Color& display) {
  const auto byte = [](float x) { return static_cast<std::uint8_t>(x + 0.5f); };
  return {byte(display.b), byte(display.g), byte(display.r)};
}

// Of each byte of a tile: how far its pixel and the four beside it lie apart.
class TileContrast {
 public:
  TileContrast(const cv::Mat& color, const cv::Rect& tile) : tile_(tile) {
    for (int v = tile.y; v < tile.y + tile.height; ++v) {
      const std::uint8_t* row = color.ptr(v) + 3 * tile.x;
      const std::uint8_t* above = color.ptr(std::max(v - 1, 0)) + 3 * tile.x;
      const std::uint8_t* below = color.ptr(std::min(v + 1, color.rows - 1)) + 3 * tile.x;
      // The row and the pixel before and after it, which are its own at the border of the image.
      std::array<std::uint8_t, 3 * (kTile + 2)> here;
      std::copy_n(row, 3 * tile.width, here.data() + 3);
      std::copy_n(row - (tile.x > 0 ? 3 : 0), 3, here.data());
      const int last = 3 * tile.width - (tile.x + tile.width < color.cols ? 0 : 3);
      std::copy_n(row + last, 3, here.data() + 3 * tile.width + 3);
      std::uint8_t* contrast = contrast_[v - tile.y].data();
      for (int i = 0; i < 3 * tile.width; ++i) {
        const std::uint8_t low = std::min({above[i], below[i], here[i], here[i + 3], here[i + 6]});
        const std::uint8_t high = std::max({above[i], below[i], here[i], here[i + 3], here[i + 6]});
        contrast[i] = static_cast<std::uint8_t>(high - low);
      }
    }
  }

  int at(cv::Point pixel) const {
    const std::uint8_t* c = &contrast_[pixel.y - tile_.y][3 * (pixel.x - tile_.x)];
    return std::max({c[0], c[1], c[2]});
  }

 private:
  cv::Rect tile_;
  std::array<std::array<std::uint8_t, 3 * kTile>, kTile> contrast_;
};

// What the samples of a pixel add up to.
struct PixelSum {
  Color display, light;

  void add(const Color& sample, int count) {
    const float part = 0.25f * static_cast<float>(count);
    display += displayed(sample) * part;
    light += sample * part;
  }
  void store(cv::Point pixel, cv::Mat& color, cv::Mat& radiance) const {
    color.at<cv::Vec3b>(pixel) = to_bytes(display);
    if (!radiance.empty()) radiance.at<cv::Vec3f>(pixel) = {light.b, light.g, light.r};
  }
};

// Of samples i to i + 3. If they may be merged, those that meet the same triangle are shaded once, in their
// middle: at the border of two surfaces it is the shares that count, and within one the texture.
PixelSum sum_of_samples(const View& view, const Packet& packet, const Hits8& hits, int i, bool merge) {
  PixelSum sum;
  std::array<bool, 4> done = {};
  for (int j = 0; j < 4; ++j) {
    if (done[j] || hits.triangle[i + j] == kNoHit) continue;
    Hit mean = hits[i + j];
    Vector3f ray = packet.rays_in_cam[i + j], direction = packet.directions[i + j];
    int count = 1;
    for (int k = j + 1; merge && k < 4; ++k) {
      if (hits.triangle[i + k] != mean.triangle) continue;
      const Hit other = hits[i + k];
      done[k] = true;
      ++count;
      mean.t += other.t;
      mean.weight1 += other.weight1;
      mean.weight2 += other.weight2;
      ray += packet.rays_in_cam[i + k];
      direction += packet.directions[i + k];
    }
    const float share = 1 / static_cast<float>(count);
    mean = {mean.triangle, share * mean.t, share * mean.weight1, share * mean.weight2};
    sum.add(shade(view, mean, share * ray, share * direction, kPartOfPixel[count]), count);
  }
  return sum;
}

// Samples of a pixel that sees one triangle and nothing else.
PixelSum sum_on_triangle(const View& view, cv::Point pixel, std::uint32_t triangle) {
  const RowPose& row = view.rows[pixel.y];
  PixelSum sum;
  for (const auto& offset : kSamples) {
    const Vector3f ray = view.ray_in_cam(pixel.x, pixel.y, offset), direction = row.turn * ray;
    const Hit hit = view.tracer.meet_plane(triangle, row.origin, direction);
    sum.add(shade(view, hit, ray, direction, kPartOfPixel[1]), 1);
  }
  return sum;
}

// Looks at pixels two at a time.
class Refiner {
 public:
  Refiner(const View& view, const Centres& centres, cv::Mat& color, cv::Mat& radiance)
      : view_(view), centres_(centres), color_(color), radiance_(radiance) {}

  void look_at(cv::Point pixel, int contrast) {
    if (contrast <= kContrastOfSurfaces) return;
    const int triangle = centres_.triangle.at<int>(pixel);
    bool one_surface = true, one_triangle = triangle >= 0;
    for (const auto& [du, dv] : kNeighbours) {
      const int x = std::clamp(pixel.x + du, 0, color_.cols - 1),
                y = std::clamp(pixel.y + dv, 0, color_.rows - 1);
      const int other = centres_.triangle.at<int>(y, x);
      one_triangle &= other == triangle;
      one_surface &= view_.is_one_surface(triangle, other);
    }
    if (one_surface && contrast <= kContrastOfTexture) return;
    // A triangle in the neighbours' centres is in all between them.
    if (one_triangle)
      sum_on_triangle(view_, pixel, static_cast<std::uint32_t>(triangle)).store(pixel, color_, radiance_);
    else
      trace(pixel, !one_surface);
  }

  void finish() {
    if (count_ == 0) return;
    for (int i = 4 * count_; i < 8; ++i) packet_.rays.switch_off(i);
    Hits8 hits;
    view_.tracer.intersect(packet_.rays, true, hits);
    for (int i = 0; i < 4 * count_; i += 4)
      sum_of_samples(view_, packet_, hits, i, merge_[i / 4]).store(packet_.pixels[i], color_, radiance_);
    count_ = 0;
  }

 private:
  void trace(cv::Point pixel, bool merge) {
    merge_[count_] = merge;
    for (int k = 0; k < 4; ++k) packet_.aim(4 * count_ + k, view_, pixel, kSamples[k]);
    if (++count_ == 2) finish();
  }

  const View& view_;
  const Centres& centres_;
  cv::Mat &color_, &radiance_;
  Packet packet_;
  std::array<bool, 2> merge_ = {};
  int count_ = 0;
};

// In blocks of 4 x 4, so that pixels that wait for each other are near each other.
void refine_tile(const View& view, const cv::Rect& tile, const Centres& centres, cv::Mat& color,
                 cv::Mat& radiance) {
  constexpr int kBlock = 4;
  const TileContrast contrast(centres.color, tile);
  Refiner refiner(view, centres, color, radiance);
  for (int v0 = tile.y; v0 < tile.y + tile.height; v0 += kBlock)
    for (int u0 = tile.x; u0 < tile.x + tile.width; u0 += kBlock)
      for (int i = 0; i < kBlock * kBlock; ++i)
        if (const cv::Point pixel(u0 + i % kBlock, v0 + i / kBlock); tile.contains(pixel))
          refiner.look_at(pixel, contrast.at(pixel));
  refiner.finish();
}

}  // namespace

Centres trace_centres(const View& view, bool with_radiance, bool with_depth) {
  const int width = view.options.camera.width, height = view.options.camera.height;
  Centres centres{cv::Mat(height, width, CV_8UC3, cv::Scalar::all(0)),
                  cv::Mat(height, width, CV_32S, cv::Scalar(-1)),
                  {},
                  {},
                  {}};
  if (with_radiance) {
    centres.radiance = cv::Mat(height, width, CV_32FC3, cv::Scalar::all(0));
    centres.distance = cv::Mat(height, width, CV_32F, cv::Scalar(0));
  }
  if (with_depth) centres.depth = cv::Mat(height, width, CV_32F, cv::Scalar(kUnknownDepth));
  const auto keep = [&](const Hit& hit, const Packet& packet, int i) {
    const cv::Point pixel = packet.pixels[i];
    const Color light = shade(view, hit, packet.rays_in_cam[i], packet.directions[i], 1);
    centres.color.at<cv::Vec3b>(pixel) = to_bytes(displayed(light));
    centres.triangle.at<int>(pixel) = static_cast<int>(hit.triangle);
    if (with_radiance) {
      centres.radiance.at<cv::Vec3f>(pixel) = {light.b, light.g, light.r};
      centres.distance.at<float>(pixel) = hit.t * packet.rays_in_cam[i].z();
    }
    if (!with_depth) return;
    const double z = view.exact_z(pixel.x, pixel.y, hit.triangle);
    if (z <= view.options.max_depth) centres.depth.at<float>(pixel) = static_cast<float>(z);
  };
  for_each_tile(width, height, [&](const cv::Rect& tile) { trace_tile(view, tile, keep); });
  return centres;
}

void refine_edges(const View& view, const Centres& centres, cv::Mat& color, cv::Mat& radiance) {
  if (view.options.edge_samples == 1) return;
  for_each_tile(color.cols, color.rows,
                [&](const cv::Rect& tile) { refine_tile(view, tile, centres, color, radiance); });
}

}  // namespace framewise
