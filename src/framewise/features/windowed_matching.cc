// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/features/windowed_matching.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "framewise/features/matching_exact.h"

namespace framewise {
namespace {

bool is_finite(const cv::Point2f& p) { return std::isfinite(p.x) && std::isfinite(p.y); }

// Points sorted into square cells, so that those near a place are found without looking at all.
class PointGrid {
 public:
  PointGrid(const std::vector<cv::Point2f>& points, double radius) : points_(points), radius_(radius) {
    measure();
    begins_.assign(static_cast<std::size_t>(columns_) * rows_ + 1, 0);
    for (const cv::Point2f& p : points)
      if (is_finite(p)) ++begins_[cell_of(p) + 1];
    for (std::size_t c = 1; c < begins_.size(); ++c) begins_[c] += begins_[c - 1];
    sorted_.resize(begins_.back());
    std::vector<int> next(begins_.begin(), begins_.end() - 1);
    for (std::size_t i = 0; i < points.size(); ++i)
      if (is_finite(points[i])) sorted_[next[cell_of(points[i])]++] = static_cast<int>(i);
  }

  // The points that are anywhere, cell by cell.
  const std::vector<int>& sorted() const { return sorted_; }

  // Hands over pieces [begin, end) of sorted() that hold all points near a place, and others.
  template <class Use>
  void pieces_near(const cv::Point2f& place, Use use) const {
    if (sorted_.empty() || !is_finite(place)) return;
    const int from = column(place.x - radius_), to = column(place.x + radius_), last = row(place.y + radius_);
    for (int r = row(place.y - radius_); r <= last; ++r) {
      const int begin = begins_[r * columns_ + from], end = begins_[r * columns_ + to + 1];
      if (begin < end) use(begin, end);
    }
  }

  bool is_near(const cv::Point2f& place, int point) const {
    const double dx = points_[point].x - static_cast<double>(place.x);
    const double dy = points_[point].y - static_cast<double>(place.y);
    return dx * dx + dy * dy <= radius_ * radius_;
  }

 private:
  static constexpr int kMaxCells = 64;  // along an edge

  // The box around all points, cut into cells no smaller than the radius.
  void measure() {
    double right = -INFINITY, bottom = -INFINITY;
    left_ = top_ = INFINITY;
    for (const cv::Point2f& p : points_) {
      if (!is_finite(p)) continue;
      left_ = std::min<double>(left_, p.x), right = std::max<double>(right, p.x);
      top_ = std::min<double>(top_, p.y), bottom = std::max<double>(bottom, p.y);
    }
    if (!(left_ <= right)) return;
    cell_ = std::max(radius_, std::max(right - left_, bottom - top_) / (kMaxCells - 1));
    columns_ = static_cast<int>((right - left_) / cell_) + 1;
    rows_ = static_cast<int>((bottom - top_) / cell_) + 1;
  }

  int column(double x) const {
    return static_cast<int>(std::clamp((x - left_) / cell_, 0.0, columns_ - 1.0));
  }
  int row(double y) const { return static_cast<int>(std::clamp((y - top_) / cell_, 0.0, rows_ - 1.0)); }
  int cell_of(const cv::Point2f& p) const { return row(p.y) * columns_ + column(p.x); }

  const std::vector<cv::Point2f>& points_;
  double radius_, cell_ = 1, left_ = 0, top_ = 0;
  int columns_ = 1, rows_ = 1;
  std::vector<int> begins_, sorted_;
};

void check_sizes(const char* name, int rows, std::size_t found) {
  if (static_cast<std::size_t>(rows) == found) return;
  throw std::invalid_argument(std::string(name) + ": found " + std::to_string(found) + " positions for " +
                              std::to_string(rows) + " descriptors, expected as many");
}

cv::Mat rows_of(const cv::Mat& descriptors, const std::vector<int>& listed) {
  cv::Mat rows(static_cast<int>(listed.size()), descriptors.cols, descriptors.type());
  for (int i = 0; i < rows.rows; ++i) descriptors.row(listed[i]).copyTo(rows.row(i));
  return rows;
}

// The second set is laid out as the grid has it, so that those near a place are few blocks, which are
// compared whole.
Neighbours neighbours_near(const DescriptorPair& pair, const std::vector<cv::Point2f>& predicted2,
                           const std::vector<cv::Point2f>& pixels2, double window_px) {
  const PointGrid grid(pixels2, window_px);
  const std::vector<int>& sorted = grid.sorted();
  Neighbours neighbours{std::vector<Nearest>(pair.set1.rows), std::vector<int>(pair.set2.rows, -1)};
  if (sorted.empty()) return neighbours;
  const BlockDistances distances({pair.set1, rows_of(pair.set2, sorted)}, best_instructions());
  std::vector<Key> best2(pair.set2.rows, INT_MAX), keys(sorted.size() + 2 * kBlockRows);
  for (int i = 0; i < pair.set1.rows; ++i)
    grid.pieces_near(predicted2[i], [&](int begin, int end) {
      const int first = begin / kBlockRows;
      distances.to_blocks(i, first, (end - 1) / kBlockRows - first + 1, keys.data());
      for (int k = begin; k < end; ++k) {
        const int j = sorted[k];
        const Key key = keys[k - first * kBlockRows];
        if (!grid.is_near(predicted2[i], j)) continue;
        neighbours.of_set1[i].see(j, key);
        if (key < best2[j]) best2[j] = key, neighbours.of_set2[j] = i;
      }
    });
  return neighbours;
}

}  // namespace

std::vector<FeatureMatch> match_windowed(const cv::Mat& descriptors1,
                                         const std::vector<cv::Point2f>& predicted2,
                                         const cv::Mat& descriptors2, const std::vector<cv::Point2f>& pixels2,
                                         const MatchOptions& options) {
  options.check();
  check_sizes("predicted2", descriptors1.rows, predicted2.size());
  check_sizes("pixels2", descriptors2.rows, pixels2.size());
  if (descriptors1.empty() || descriptors2.empty()) return {};
  const DescriptorPair pair(descriptors1, descriptors2);
  return select_matches(pair.metric, neighbours_near(pair, predicted2, pixels2, options.window_px), options);
}

}  // namespace framewise
