// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/features/spread.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace framewise {
namespace {

// Square cells over an image.
struct SpreadCells {
  int width;  // pixels
  int cols, rows;

  SpreadCells(const cv::Size& image, int width)
      : width(width), cols((image.width - 1) / width + 1), rows((image.height - 1) / width + 1) {}
  cv::Point of(const cv::Point2f& pixel) const {
    return {std::clamp(static_cast<int>(pixel.x) / width, 0, cols - 1),
            std::clamp(static_cast<int>(pixel.y) / width, 0, rows - 1)};
  }
};

std::vector<int> by_cell_ranks(const std::vector<cv::KeyPoint>& keypoints, const cv::Size& image, int count) {
  const double area = static_cast<double>(image.width) * image.height;
  const SpreadCells cells(image, std::max(1, static_cast<int>(std::sqrt(4 * area / count))));
  std::vector<int> kept_in_cell(static_cast<std::size_t>(cells.cols) * cells.rows, 0);
  std::vector<int> rank, order(keypoints.size());
  for (const cv::KeyPoint& keypoint : keypoints) {
    const cv::Point cell = cells.of(keypoint.pt);
    rank.push_back(kept_in_cell[static_cast<std::size_t>(cell.y) * cells.cols + cell.x]++);
  }
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return rank[a] < rank[b]; });
  order.resize(count);
  std::sort(order.begin(), order.end());
  return order;
}

// Keeps what no stronger one covers: a kept keypoint covers the cells within two of its own, so that the
// square around it has a side of about five cells.
std::vector<int> by_covering(const std::vector<cv::KeyPoint>& keypoints, const cv::Size& image,
                             int cell_width) {
  constexpr int kReach = 2;
  const SpreadCells cells(image, cell_width);
  cv::Mat covered(cells.rows, cells.cols, CV_8U, cv::Scalar(0));
  std::vector<int> kept;
  for (int i = 0; i < static_cast<int>(keypoints.size()); ++i) {
    const cv::Point cell = cells.of(keypoints[i].pt);
    if (covered.at<std::uint8_t>(cell) != 0) continue;
    kept.push_back(i);
    const cv::Rect around(cell.x - kReach, cell.y - kReach, 2 * kReach + 1, 2 * kReach + 1);
    covered(around & cv::Rect(0, 0, cells.cols, cells.rows)).setTo(1);
  }
  return kept;
}

// With the strongest of those left out, where fewer than `count` were kept (many at one place).
std::vector<int> filled_up(std::vector<int> kept, std::size_t size, int count) {
  std::vector<bool> is_kept(size, false);
  for (const int i : kept) is_kept[i] = true;
  for (int i = 0; static_cast<int>(kept.size()) < count; ++i)
    if (!is_kept[i]) kept.push_back(i);
  std::sort(kept.begin(), kept.end());
  return kept;
}

// The widest covering that keeps `count`, by bisection; the strongest of what it keeps.
std::vector<int> by_widest_covering(const std::vector<cv::KeyPoint>& keypoints, const cv::Size& image,
                                    int count) {
  int enough = 1, too_wide = std::max(image.width, image.height);
  std::vector<int> best = by_covering(keypoints, image, enough);
  while (too_wide - enough > 1) {
    const int width = (enough + too_wide) / 2;
    std::vector<int> kept = by_covering(keypoints, image, width);
    if (static_cast<int>(kept.size()) >= count)
      enough = width, best = std::move(kept);
    else
      too_wide = width;
  }
  if (static_cast<int>(best.size()) > count) best.resize(count);
  return filled_up(best, keypoints.size(), count);
}

}  // namespace

std::vector<int> spread_out(const std::vector<cv::KeyPoint>& keypoints, const cv::Size& image, int count,
                            Spread spread) {
  std::vector<int> first(std::min<std::size_t>(keypoints.size(), count));
  std::iota(first.begin(), first.end(), 0);
  if (spread == Spread::kNone || keypoints.size() == first.size()) return first;
  return spread == Spread::kGrid ? by_cell_ranks(keypoints, image, count)
                                 : by_widest_covering(keypoints, image, count);
}

}  // namespace framewise
