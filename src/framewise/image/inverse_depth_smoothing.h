// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <opencv2/core.hpp>
#include <vector>

namespace framewise {

// Widths (odd, pixels) of the three boxes whose convolution is nearest to a Gaussian of this sigma.
//   Kovesi, Fast almost-Gaussian filtering, DICTA 2010.
// sigma: 0.6 ... kMostSmoothing pixels; their own sigma, below, is within 0.2 px.
std::array<int, 3> gaussian_boxes(double sigma_px);
double sigma_of_boxes(const std::array<int, 3>& widths);
constexpr double kLeastSmoothing = 0.6, kMostSmoothing = 16;  // beyond, the weights leave 32 bits

// Inverse depth smoothed by (nearly) a Gaussian, the mean over the known pixels alone:
//   w(x) = sum_y G(x - y) / depth(y) / sum_y G(x - y),  y the pixels with a depth.
//   Knutsson, Westin, Normalized and differential convolution, CVPR 1993.
// Inverse depth, because a plane's is linear in the pixels and a depth camera's noise in it is about even.
// An unknown pixel stays unknown unless half of the weight around it is known, so that specks heal and holes
// do not. Rows go in and come out, `latency()` rows later, so that a caller's next step finds them in the
// cache.
class InverseDepthSmoothing {
 public:
  InverseDepthSmoothing(int width, double sigma_px);

  int latency() const { return reach_; }

  // Takes the depths of the next row (m, or any unit; not above 0, infinite or NaN: unknown), or null after
  // the last. Writes the smoothed inverse depths of the row `latency()` rows before it, NaN where
  // they are unknown.
  void push(const float* depth, float* smoothed_inverse);

 private:
  // The sum of the last `count` rows that were pushed. Rows are counted off in blocks: the sum is that of the
  // rows of this block so far and of the last rows of the block before, whose sums are made when it ends.
  // Three additions a row whatever the count, and none is ever taken back, so nothing drifts.
  template <typename T>
  class WindowSum {
   public:
    WindowSum(int count, int width) : block_(count + 1, std::vector<T>(width)), prefix_(width) {}
    T* next_row() { return block_[place_].data(); }  // where the next row is to be written
    void push(T* sum);                               // takes it

   private:
    // Before place_: rows of this block. From place_: sums of a row of the block before and all after it; one
    // more row is zero for ever.
    std::vector<std::vector<T>> block_;
    std::vector<T> prefix_;
    std::size_t place_ = 0;
  };

  void along_row(const float* depth, float* values, std::int32_t* weights);

  std::array<int, 3> boxes_;
  int width_, reach_;
  std::int32_t enough_;           // half of the weight of a neighbourhood that is known throughout
  std::vector<float> padded_[2];  // a row with what lies outside, which weighs nothing
  std::vector<std::uint16_t> padded_weight_[2];
  std::vector<float> value_sum_;
  std::vector<std::int32_t> weight_sum_;
  std::vector<WindowSum<float>> values_;  // one for each vertical box
  std::vector<WindowSum<std::int32_t>> weights_;
  std::vector<std::vector<float>> centres_;  // inverse depths of the rows still on their way
  std::size_t pushed_ = 0;
};

// The same for a whole image: depth CV_32F -> smoothed depth (the inverse of w), NaN where unknown.
cv::Mat smooth_inverse_depth(const cv::Mat& depth, double sigma_px);

}  // namespace framewise
