// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/image/inverse_depth_smoothing.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "framewise/image/image_check.h"
#include "framewise/image/smoothing_kernels.h"

namespace framewise {
namespace {

constexpr int kWidestBox = 39;

std::int32_t half_of_all_weight(const std::array<int, 3>& boxes) {
  const std::int32_t along_row = boxes[0] * boxes[1] * boxes[2];
  return (along_row * along_row + 1) / 2;
}

}  // namespace

std::array<int, 3> gaussian_boxes(double sigma_px) {
  if (!(sigma_px >= kLeastSmoothing && sigma_px <= kMostSmoothing))
    throw std::invalid_argument("sigma_px: found " + std::to_string(sigma_px) + ", expected " +
                                std::to_string(kLeastSmoothing) + " to " + std::to_string(kMostSmoothing));
  std::array<int, 3> best{1, 1, 1};
  const auto error = [&](const std::array<int, 3>& boxes) {
    return std::abs(sigma_of_boxes(boxes) - sigma_px);
  };
  for (int width = 1; width + 2 <= kWidestBox; width += 2)
    for (int wider = 0; wider < 3; ++wider) {
      const std::array<int, 3> boxes{width, wider > 1 ? width + 2 : width, wider > 0 ? width + 2 : width};
      if (error(boxes) < error(best)) best = boxes;
    }
  return best;
}

double sigma_of_boxes(const std::array<int, 3>& widths) {
  double variance = 0;
  for (const int width : widths) variance += (width * width - 1) / 12.0;
  return std::sqrt(variance);
}

template <typename T>
void InverseDepthSmoothing::WindowSum<T>::push(T* sum) {
  const int width = static_cast<int>(prefix_.size());
  const std::size_t count = block_.size() - 1;
  grow_window(block_[place_].data(), block_[place_ + 1].data(), place_ == 0, width, prefix_.data(), sum);
  if (++place_ < count) return;
  for (std::size_t k = count - 1; k-- > 0;) add_row(block_[k + 1].data(), width, block_[k].data());
  place_ = 0;
}

InverseDepthSmoothing::InverseDepthSmoothing(int width, double sigma_px)
    : boxes_(gaussian_boxes(sigma_px)),
      width_(width),
      reach_((boxes_[0] + boxes_[1] + boxes_[2] - 3) / 2),
      enough_(half_of_all_weight(boxes_)),
      value_sum_(width),
      weight_sum_(width),
      centres_(reach_ + 1, std::vector<float>(width)) {
  for (int k = 0; k < 2; ++k) {
    padded_[k].resize(width + 2 * reach_);
    padded_weight_[k].resize(width + 2 * reach_);
  }
  for (const int box : boxes_) {
    values_.emplace_back(box, width);
    weights_.emplace_back(box, width);
  }
}

// The three boxes along the row; each leaves box - 1 columns less, and the padding is used up by the last.
void InverseDepthSmoothing::along_row(const float* depth, float* values, std::int32_t* weights) {
  const auto clear_padding = [&](auto& row) {
    std::fill_n(row.begin(), reach_, 0);
    std::fill_n(row.end() - reach_, reach_, 0);
  };
  clear_padding(padded_[0]);
  clear_padding(padded_weight_[0]);
  invert_depths(depth, width_, padded_[0].data() + reach_, centres_[pushed_ % centres_.size()].data(),
                padded_weight_[0].data() + reach_);

  std::array<const float*, kWidestBox> shifted;
  std::array<const std::uint16_t*, kWidestBox> shifted_weight;
  int columns = width_ + 2 * reach_;
  for (int i = 0; i < 3; ++i) {
    columns -= boxes_[i] - 1;
    for (int k = 0; k < boxes_[i]; ++k) {
      shifted[k] = padded_[i % 2].data() + k;
      shifted_weight[k] = padded_weight_[i % 2].data() + k;
    }
    sum_rows(shifted.data(), boxes_[i], columns, i < 2 ? padded_[(i + 1) % 2].data() : values);
    sum_rows(shifted_weight.data(), boxes_[i], columns, padded_weight_[(i + 1) % 2].data());
  }
  widen(padded_weight_[1].data(), width_, weights);
}

void InverseDepthSmoothing::push(const float* depth, float* smoothed_inverse) {
  float* value = values_[0].next_row();
  std::int32_t* weight = weights_[0].next_row();
  if (depth) {
    along_row(depth, value, weight);
  } else {
    std::fill_n(value, width_, 0.0f);
    std::fill_n(weight, width_, 0);
  }
  for (int i = 0; i < 3; ++i) {
    values_[i].push(i < 2 ? values_[i + 1].next_row() : value_sum_.data());
    weights_[i].push(i < 2 ? weights_[i + 1].next_row() : weight_sum_.data());
  }
  ++pushed_;
  normalise(value_sum_.data(), weight_sum_.data(), centres_[pushed_ % centres_.size()].data(), enough_,
            width_, smoothed_inverse);
}

cv::Mat smooth_inverse_depth(const cv::Mat& depth, double sigma_px) {
  check_image("depth", depth, CV_32F);
  InverseDepthSmoothing smoothing(depth.cols, sigma_px);
  cv::Mat smoothed(depth.size(), CV_32F);
  std::vector<float> too_early(depth.cols);
  for (int v = 0; v < depth.rows + smoothing.latency(); ++v) {
    const int done = v - smoothing.latency();
    float* out = done < 0 ? too_early.data() : smoothed.ptr<float>(done);
    smoothing.push(v < depth.rows ? depth.ptr<float>(v) : nullptr, out);
    for (int u = 0; u < depth.cols; ++u) out[u] = 1 / out[u];
  }
  return smoothed;
}

}  // namespace framewise
