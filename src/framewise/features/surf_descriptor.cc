// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/features/surf_descriptor.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "framewise/features/fast_hessian.h"

namespace framewise {
namespace {

// A position between the columns (or rows) of the sums: `whole` and the next, `part` of the way.
struct Edge {
  int whole;
  float part;
};

// at: distance from the image's first edge, so that pixel x spans [x, x + 1); length: of the image.
Edge edge_at(float at, int length) {
  const float inside = std::clamp(at, 0.0f, static_cast<float>(length));
  const int whole = std::min(static_cast<int>(inside), length - 1);
  return {whole, inside - static_cast<float>(whole)};
}

struct SummedImage {
  Sums sums;
  int width, height;

  // Sum over the rows [top, bottom), from left to right. Whole rows differ before they become float: the sums
  // of a large image have more digits than a float.
  float strip(int top, int bottom, const Edge& left, const Edge& right) const {
    const std::uint32_t *t = sums.data + top * sums.stride, *b = sums.data + bottom * sums.stride;
    const auto above = [&](int column) { return b[column] - t[column]; };
    const auto between = [&](int column1, int column2) {
      return static_cast<float>(static_cast<std::int32_t>(above(column2) - above(column1)));
    };
    return between(left.whole, right.whole) + right.part * between(right.whole, right.whole + 1) -
           left.part * between(left.whole, left.whole + 1);
  }

  // Sum from a whole corner to between pixels.
  float sum_from(const cv::Point& corner, const Edge& right, const Edge& bottom) const {
    const std::uint32_t *t = sums.data + corner.y * sums.stride, *b = sums.data + bottom.whole * sums.stride;
    const std::uint32_t* next = b + sums.stride;
    const auto above = [&](const std::uint32_t* row, int column) {
      return static_cast<float>(
          static_cast<std::int32_t>((row[column] - t[column]) - (row[corner.x] - t[corner.x])));
    };
    const auto between = [&](const std::uint32_t* row) {
      const float whole = above(row, right.whole);
      return whole + right.part * (above(row, right.whole + 1) - whole);
    };
    const float whole = between(b);
    return whole + bottom.part * (between(next) - whole);
  }

  float box(const Edge& left, const Edge& right, const Edge& top, const Edge& bottom) const {
    const float to_bottom = strip(top.whole, bottom.whole, left, right);
    return to_bottom + bottom.part * strip(bottom.whole, bottom.whole + 1, left, right) -
           top.part * strip(top.whole, top.whole + 1, left, right);
  }
};

SummedImage summed_image(const cv::Mat& integral) {
  return {sums_of(integral), integral.cols - 1, integral.rows - 1};
}

float scale_of(const cv::KeyPoint& keypoint) { return keypoint.size * (1.2f / 9); }

float gaussian(double squared_distance, double sigma) {
  return static_cast<float>(std::exp(-squared_distance / (2 * sigma * sigma)));
}

constexpr int kReach = 6;                          // of the orientation, in scales
constexpr int kArm = 2;                            // half the side of its wavelets, in scales
constexpr int kLattice = 2 * (kReach + kArm) + 1;  // edges of its wavelets along an axis
constexpr int kDirections = 72, kWindow = 12;      // 5 degrees each; the window is pi / 3

// The sums from a corner to every scale around a keypoint, but for terms of x or of y alone, which wavelets
// do not see; and which of these edges are in the image.
struct SumsAround {
  std::array<std::array<float, kLattice>, kLattice> sums;
  std::array<bool, kLattice> has_column, has_row;
};

SumsAround sums_around(const SummedImage& image, const cv::KeyPoint& keypoint) {
  SumsAround around;
  std::array<Edge, kLattice> xs, ys;
  for (int k = 0; k < kLattice; ++k) {
    const float offset = 0.5f + scale_of(keypoint) * static_cast<float>(k - kLattice / 2);
    const float x = keypoint.pt.x + offset, y = keypoint.pt.y + offset;
    around.has_column[k] = x >= 0 && x <= static_cast<float>(image.width);
    around.has_row[k] = y >= 0 && y <= static_cast<float>(image.height);
    xs[k] = edge_at(x, image.width);
    ys[k] = edge_at(y, image.height);
  }
  for (int j = 0; j < kLattice; ++j)
    for (int i = 0; i < kLattice; ++i)
      around.sums[j][i] = image.sum_from({xs[0].whole, ys[0].whole}, xs[i], ys[j]);
  return around;
}

// Weighted wavelet responses, summed by their direction.
struct Directions {
  std::array<cv::Point2f, kDirections> sums{};

  void add(float dx, float dy) {
    const int direction = static_cast<int>(cv::fastAtan2(dy, dx) * (kDirections / 360.0f));
    sums[direction % kDirections] += cv::Point2f(dx, dy);
  }

  // The longest sum over a window of directions (section 4.1).
  cv::Point2f longest() const {
    cv::Point2f longest(0, 0);
    for (int first = 0; first < kDirections; ++first) {
      cv::Point2f sum(0, 0);
      for (int k = 0; k < kWindow; ++k) sum += sums[(first + k) % kDirections];
      if (sum.dot(sum) > longest.dot(longest)) longest = sum;
    }
    return longest;
  }
};

void add_wavelet(const SumsAround& around, int x, int y, float weight, Directions& directions) {
  const int left = x - kArm, right = x + kArm, top = y - kArm, bottom = y + kArm;
  if (!around.has_column[left] || !around.has_column[right] || !around.has_row[top] ||
      !around.has_row[bottom])
    return;
  const auto &t = around.sums[top], &m = around.sums[y], &b = around.sums[bottom];
  const float dx = (b[right] - 2 * b[x] + b[left]) - (t[right] - 2 * t[x] + t[left]);
  const float dy = (b[right] - b[left]) - 2 * (m[right] - m[left]) + (t[right] - t[left]);
  directions.add(weight * dx, weight * dy);
}

float orientation(const SummedImage& image, const cv::KeyPoint& keypoint) {
  static const auto weights = [] {
    std::array<float, kReach * kReach + 1> by_squared_distance;
    for (int r2 = 0; r2 <= kReach * kReach; ++r2) by_squared_distance[r2] = gaussian(r2, 2.0);
    return by_squared_distance;
  }();
  const SumsAround around = sums_around(image, keypoint);
  Directions directions;
  for (int j = -kReach; j <= kReach; ++j)
    for (int i = -kReach; i <= kReach; ++i)
      if (i * i + j * j <= kReach * kReach)
        add_wavelet(around, i + kLattice / 2, j + kLattice / 2, weights[i * i + j * j], directions);
  const cv::Point2f longest = directions.longest();
  return std::fmod(cv::fastAtan2(longest.y, longest.x), 360.0f);
}

constexpr int kSamples = 20;  // wavelets along an axis of the window, a scale apart
constexpr int kParts = 4;
constexpr int kBoxes = kSamples + 1;
using BoxSums = std::array<std::array<float, kBoxes>, kBoxes>;

// Sums over boxes with sides of one scale, a scale apart along the window's axes: a wavelet is the difference
// of two such boxes and two others.
BoxSums box_sums_around(const SummedImage& image, const cv::KeyPoint& keypoint, bool upright) {
  const float s = scale_of(keypoint);
  const float angle = upright ? 0.0f : keypoint.angle * static_cast<float>(CV_PI / 180);
  const cv::Point2f x_axis(s * std::cos(angle), s * std::sin(angle)), y_axis(-x_axis.y, x_axis.x);
  const cv::Point2f center = keypoint.pt + cv::Point2f(0.5f, 0.5f);
  const float width = static_cast<float>(image.width), height = static_cast<float>(image.height);
  const float half = std::min({s, width, height}) / 2;
  BoxSums boxes;
  for (int j = 0; j < kBoxes; ++j)
    for (int i = 0; i < kBoxes; ++i) {
      const cv::Point2f at =
          center + static_cast<float>(i - kBoxes / 2) * x_axis + static_cast<float>(j - kBoxes / 2) * y_axis;
      const float x = std::clamp(at.x, half, width - half), y = std::clamp(at.y, half, height - half);
      boxes[j][i] = image.box(edge_at(x - half, image.width), edge_at(x + half, image.width),
                              edge_at(y - half, image.height), edge_at(y + half, image.height));
    }
  return boxes;
}

// The Gaussian around the keypoint, sigma 3.3 s (section 4.2).
const std::array<std::array<float, kSamples>, kSamples>& window_weights() {
  static const auto weights = [] {
    std::array<std::array<float, kSamples>, kSamples> w;
    constexpr double kMiddle = (kSamples - 1) / 2.0;
    for (int j = 0; j < kSamples; ++j)
      for (int i = 0; i < kSamples; ++i)
        w[j][i] = gaussian((i - kMiddle) * (i - kMiddle) + (j - kMiddle) * (j - kMiddle), 3.3);
    return w;
  }();
  return weights;
}

void add_to_part(float dx, float dy, bool extended, float* part) {
  float* x = part + (extended && dy >= 0 ? 4 : 0);
  float* y = part + (extended && dx >= 0 ? 4 : 0);
  x[0] += dx;
  y[1] += dy;
  x[2] += std::abs(dx);
  y[3] += std::abs(dy);
}

void describe(const SummedImage& image, const cv::KeyPoint& keypoint, const SurfDescriptorOptions& options,
              float* row) {
  const BoxSums boxes = box_sums_around(image, keypoint, options.upright);
  const auto& weights = window_weights();
  const int values = options.extended ? 8 : 4, length = values * kParts * kParts;
  std::fill(row, row + length, 0.0f);
  for (int j = 0; j < kSamples; ++j)
    for (int i = 0; i < kSamples; ++i) {
      const float falling = boxes[j + 1][i + 1] - boxes[j][i], rising = boxes[j][i + 1] - boxes[j + 1][i];
      const int part = j * kParts / kSamples * kParts + i * kParts / kSamples;
      add_to_part(weights[j][i] * (falling + rising), weights[j][i] * (falling - rising), options.extended,
                  row + part * values);
    }
  float squared = 0;
  for (int k = 0; k < length; ++k) squared += row[k] * row[k];
  if (squared > 0)
    for (int k = 0; k < length; ++k) row[k] /= std::sqrt(squared);
}

}  // namespace

void orient_surf(const cv::Mat& integral, std::vector<cv::KeyPoint>& keypoints) {
  const SummedImage image = summed_image(integral);
  cv::parallel_for_(cv::Range(0, static_cast<int>(keypoints.size())), [&](const cv::Range& range) {
    for (int i = range.start; i < range.end; ++i) keypoints[i].angle = orientation(image, keypoints[i]);
  });
}

cv::Mat describe_surf(const cv::Mat& integral, const std::vector<cv::KeyPoint>& keypoints,
                      const SurfDescriptorOptions& options) {
  const SummedImage image = summed_image(integral);
  cv::Mat descriptors(static_cast<int>(keypoints.size()), options.extended ? 128 : 64, CV_32F);
  cv::parallel_for_(cv::Range(0, descriptors.rows), [&](const cv::Range& range) {
    for (int i = range.start; i < range.end; ++i)
      describe(image, keypoints[i], options, descriptors.ptr<float>(i));
  });
  return descriptors;
}

}  // namespace framewise
