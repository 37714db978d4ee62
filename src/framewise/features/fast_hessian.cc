// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/features/fast_hessian.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <tuple>

namespace framewise {
namespace {

// The filters of Bay et al. 2008, Figure 8, each once: octaves share filters, and a blob whose scale lies
// where two octaves overlap is to be found once. A filter is computed at every `step` pixels and searched for
// maxima at every `search_step`; the neighbours in scale are the filters before and after it.
struct Filter {
  int size, step, search_step, octave;
};
constexpr std::array<Filter, 10> kFilters{{{9, 1, 0, 0},
                                           {15, 1, 1, 0},
                                           {21, 1, 1, 0},
                                           {27, 1, 2, 1},
                                           {39, 2, 2, 1},
                                           {51, 2, 4, 2},
                                           {75, 4, 4, 2},
                                           {99, 4, 8, 3},
                                           {147, 8, 8, 3},
                                           {195, 8, 0, 3}}};

// Determinants of one filter over the image; 0 where the filter leaves the image.
struct Responses {
  Filter filter;
  int rows = 0, cols = 0;
  std::vector<float> values;

  // (x, y): a pixel of the image at a multiple of the filter's step.
  const float* at(int x, int y) const {
    return values.data() + static_cast<std::size_t>(y / filter.step) * cols + x / filter.step;
  }
};

Responses empty_responses(const Filter& filter, const cv::Size& image) {
  Responses responses{filter, (image.height - 1) / filter.step + 1, (image.width - 1) / filter.step + 1, {}};
  responses.values.assign(static_cast<std::size_t>(responses.rows) * responses.cols, 0.0f);
  return responses;
}

void fill_row(Sums sums, const cv::Size& image, int row, Responses& responses) {
  const auto [size, step, search_step, octave] = responses.filter;
  const int half = size / 2, y = row * step, first = (half + step - 1) / step * step;
  if (y < half || y >= image.height - half || first >= image.width - half) return;
  const int n = (image.width - half - 1 - first) / step + 1;
  box_hessian_row(sums, size, first, y, step, n,
                  responses.values.data() + static_cast<std::size_t>(row) * responses.cols + first / step);
}

std::vector<Responses> all_responses(Sums sums, const cv::Size& image) {
  std::vector<Responses> responses;
  std::vector<std::pair<int, int>> rows;  // of all filters
  for (const Filter& filter : kFilters) {
    if (filter.size > std::min(image.width, image.height)) break;
    for (int row = 0; row <= (image.height - 1) / filter.step; ++row)
      rows.emplace_back(static_cast<int>(responses.size()), row);
    responses.push_back(empty_responses(filter, image));
  }
  cv::parallel_for_(cv::Range(0, static_cast<int>(rows.size())), [&](const cv::Range& range) {
    for (int i = range.start; i < range.end; ++i)
      fill_row(sums, image, rows[i].second, responses[rows[i].first]);
  });
  return responses;
}

// The 3 x 3 x 3 determinants around a place: [scale][row][column].
using Cube = std::array<std::array<std::array<float, 3>, 3>, 3>;

Cube cube_at(const Responses* middle, int x, int y) {
  const int step = middle->filter.search_step;
  Cube cube;
  for (int s = 0; s < 3; ++s)
    for (int j = 0; j < 3; ++j)
      for (int i = 0; i < 3; ++i) cube[s][j][i] = *middle[s - 1].at(x + (i - 1) * step, y + (j - 1) * step);
  return cube;
}

// Of equal neighbours the first is the maximum.
bool is_maximum(const Cube& cube) {
  const float* values = &cube[0][0][0];
  const float middle = values[13];
  return std::all_of(values, values + 13, [&](float v) { return middle > v; }) &&
         std::all_of(values + 14, values + 27, [&](float v) { return middle >= v; });
}

// Where the quadratic through the cube has its peak, from the middle: in search steps, and in pixels of
// filter size. The filters are not evenly spaced: `below` and `above` are the distances to the neighbours.
//   Brown, Lowe, Invariant features from interest point groups, BMVC 2002.
cv::Vec3f peak_of(const Cube& cube, float below, float above) {
  const auto scale_slope = [&](int j, int i) {
    const float up = (cube[2][j][i] - cube[1][j][i]) / above, down = (cube[1][j][i] - cube[0][j][i]) / below;
    return (up * below + down * above) / (below + above);
  };
  const auto& m = cube[1];
  const float scale_curvature =
      2 * ((cube[2][1][1] - m[1][1]) / above - (m[1][1] - cube[0][1][1]) / below) / (below + above);
  const cv::Vec3f slope((m[1][2] - m[1][0]) / 2, (m[2][1] - m[0][1]) / 2, scale_slope(1, 1));
  const float xx = m[1][2] - 2 * m[1][1] + m[1][0], yy = m[2][1] - 2 * m[1][1] + m[0][1];
  const float xy = (m[2][2] - m[2][0] - m[0][2] + m[0][0]) / 4;
  const float xs = (scale_slope(1, 2) - scale_slope(1, 0)) / 2;
  const float ys = (scale_slope(2, 1) - scale_slope(0, 1)) / 2;
  const cv::Matx33f curvature(xx, xy, xs, xy, yy, ys, xs, ys, scale_curvature);
  const cv::Matx31f peak = curvature.solve(cv::Matx31f(-slope[0], -slope[1], -slope[2]), cv::DECOMP_LU);
  return {peak(0), peak(1), peak(2)};
}

void find_in_row(Sums sums, const Responses* middle, int y, float threshold, int first, int last,
                 std::vector<cv::KeyPoint>& found) {
  const int step = middle->filter.search_step;
  const float below = static_cast<float>(middle->filter.size - middle[-1].filter.size);
  const float above = static_cast<float>(middle[1].filter.size - middle->filter.size);
  const int stride = step / middle->filter.step;
  const float* value = middle->at(first, y);
  for (int x = first; x <= last; x += step, value += stride) {
    if (!(*value > threshold) || *value <= value[-stride] || *value < value[stride]) continue;
    const Cube cube = cube_at(middle, x, y);
    if (!is_maximum(cube)) continue;
    const cv::Vec3f peak = peak_of(cube, below, above);
    if (!(std::abs(peak[0]) <= 1 && std::abs(peak[1]) <= 1 && peak[2] >= -below && peak[2] <= above))
      continue;
    const BoxDerivatives d = box_derivatives(sums, middle->filter.size, x, y);
    found.emplace_back(static_cast<float>(x) + peak[0] * step, static_cast<float>(y) + peak[1] * step,
                       static_cast<float>(middle->filter.size) + peak[2], -1.0f, *value,
                       middle->filter.octave, d.xx + d.yy < 0 ? 1 : -1);
  }
}

std::vector<cv::KeyPoint> maxima(Sums sums, const cv::Size& image, const Responses* middle, float threshold) {
  const int step = middle->filter.search_step;
  // Where the larger neighbour fits, and with it the eight around.
  const int first = (middle[1].filter.size / 2 + step - 1) / step * step + step;
  const auto last = [&](int side) { return side - 1 - middle[1].filter.size / 2 - step; };
  const int rows = (last(image.height) - first) / step + 1;
  if (last(image.height) < first || last(image.width) < first) return {};
  std::vector<std::vector<cv::KeyPoint>> by_row(rows);
  cv::parallel_for_(cv::Range(0, rows), [&](const cv::Range& range) {
    for (int row = range.start; row < range.end; ++row)
      find_in_row(sums, middle, first + row * step, threshold, first, last(image.width), by_row[row]);
  });
  std::vector<cv::KeyPoint> found;
  for (const auto& row : by_row) found.insert(found.end(), row.begin(), row.end());
  return found;
}

}  // namespace

cv::Mat integral_image(const cv::Mat& gray) {
  cv::Mat sums;
  cv::integral(gray, sums, CV_32S);
  return sums;
}

Sums sums_of(const cv::Mat& integral) {
  return {reinterpret_cast<const std::uint32_t*>(integral.data),
          static_cast<std::ptrdiff_t>(integral.step / sizeof(std::uint32_t))};
}

std::vector<cv::KeyPoint> detect_fast_hessian(const cv::Mat& integral, float threshold) {
  const cv::Size image(integral.cols - 1, integral.rows - 1);
  const Sums sums = sums_of(integral);
  const std::vector<Responses> responses = all_responses(sums, image);
  std::vector<cv::KeyPoint> found;
  for (std::size_t i = 1; i + 1 < responses.size(); ++i) {
    const auto more = maxima(sums, image, &responses[i], threshold);
    found.insert(found.end(), more.begin(), more.end());
  }
  std::stable_sort(found.begin(), found.end(), [](const cv::KeyPoint& a, const cv::KeyPoint& b) {
    return std::tie(b.response, a.pt.y, a.pt.x, a.size) < std::tie(a.response, b.pt.y, b.pt.x, b.size);
  });
  return found;
}

}  // namespace framewise
