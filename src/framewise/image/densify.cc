// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/image/densify.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include "framewise/image/depth.h"
#include "framewise/image/image_check.h"

namespace framewise {
namespace {

struct Sample {
  int du, dv;
  float inverse;
};

// The samples of every row from left to right, and a place in each row that moves along with the pixel.
class SampleRows {
 public:
  SampleRows(const cv::Mat& depth, int reach) : reach_(reach), rows_(depth.rows), start_(depth.rows) {
    for (int v = 0; v < depth.rows; ++v)
      for (int u = 0; u < depth.cols; ++u)
        if (const float z = depth.at<float>(v, u); is_known_depth(z)) rows_[v].push_back({u, v, 1 / z});
  }

  void begin_row() { std::fill(start_.begin(), start_.end(), 0); }

  // All within the reach of pixel (u, v), as a disc; u grows from call to call since begin_row.
  void around(int u, int v, std::vector<Sample>& found) {
    found.clear();
    const int last = std::min(v + reach_, static_cast<int>(rows_.size()) - 1);
    for (int row = std::max(v - reach_, 0); row <= last; ++row) {
      const std::vector<Sample>& samples = rows_[row];
      std::size_t& i = start_[row];
      while (i < samples.size() && samples[i].du < u - reach_) ++i;
      const int dv = row - v;
      for (std::size_t k = i; k < samples.size() && samples[k].du <= u + reach_; ++k) {
        const int du = samples[k].du - u;
        if (du * du + dv * dv <= reach_ * reach_) found.push_back({du, dv, samples[k].inverse});
      }
    }
  }

 private:
  int reach_;
  std::vector<std::vector<Sample>> rows_;  // du, dv are the samples' own pixels here
  std::vector<std::size_t> start_;
};

// Weighted sums of 1, u, v and w: the normal equations of the plane.
struct PlaneSums {
  double n = 0, u = 0, v = 0, uu = 0, uv = 0, vv = 0, w = 0, uw = 0, vw = 0;

  void add(double weight, double du, double dv, double inverse) {
    n += weight;
    u += weight * du;
    v += weight * dv;
    uu += weight * du * du;
    uv += weight * du * dv;
    vv += weight * dv * dv;
    w += weight * inverse;
    uw += weight * du * inverse;
    vw += weight * dv * inverse;
  }

  // The plane at (0, 0), by its moments about the mean. A little stiffness (in squared pixels) lets samples
  // on a line fix the slope along it and none across.
  double at_pixel() const {
    constexpr double kStiffness = 0.05;
    const double mu = u / n, mv = v / n, mw = w / n;
    const double cuu = uu / n - mu * mu + kStiffness, cvv = vv / n - mv * mv + kStiffness,
                 cuv = uv / n - mu * mv;
    const double cuw = uw / n - mu * mw, cvw = vw / n - mv * mw;
    const double determinant = cuu * cvv - cuv * cuv;
    const double b = (cuw * cvv - cvw * cuv) / determinant, c = (cvw * cuu - cuw * cuv) / determinant;
    return mw - b * mu - c * mv;
  }
};

class Interpolation {
 public:
  explicit Interpolation(const DensifyOptions& options) : options_(options) {
    const int reach = options.max_reach_px;
    for (int r2 = 0; r2 <= reach * reach; ++r2)
      weight_.push_back(std::exp(-r2 / (2 * options.sigma_px * options.sigma_px)));
  }

  float operator()(const std::vector<Sample>& samples) const {
    if (static_cast<int>(samples.size()) < options_.min_samples) return kUnknownDepth;
    const auto r2 = [](const Sample& s) { return s.du * s.du + s.dv * s.dv; };
    const Sample& nearest = *std::min_element(
        samples.begin(), samples.end(), [&](const Sample& a, const Sample& b) { return r2(a) < r2(b); });
    const double per_step = 1 / (options_.max_step * nearest.inverse);
    PlaneSums sums;
    float least = nearest.inverse, most = nearest.inverse;
    for (const Sample& s : samples) {
      const double step = (s.inverse - nearest.inverse) * per_step, step2 = step * step;
      if (step2 > 9) continue;
      sums.add(weight_[r2(s)] / (1 + step2 * step2), s.du, s.dv, s.inverse);
      least = std::min(least, s.inverse);
      most = std::max(most, s.inverse);
    }
    return 1 / std::clamp(static_cast<float>(sums.at_pixel()), least, most);
  }

 private:
  DensifyOptions options_;
  std::vector<double> weight_;  // by squared distance
};

}  // namespace

void DensifyOptions::check() const {
  const auto require = [](bool holds, const char* name, double found, const char* expected) {
    if (!holds)
      throw std::invalid_argument(std::string(name) + ": found " + std::to_string(found) + ", expected " +
                                  expected);
  };
  require(max_reach_px >= 1 && max_reach_px <= 100, "max_reach_px", max_reach_px, "1 to 100");
  require(sigma_px > 0 && std::isfinite(sigma_px), "sigma_px", sigma_px, "more than 0");
  require(max_step > 0 && std::isfinite(max_step), "max_step", max_step, "more than 0");
  require(min_samples >= 1, "min_samples", min_samples, "at least 1");
}

DenseDepth densify(const cv::Mat& depth, const DensifyOptions& options) {
  check_image("depth", depth, CV_32F);
  options.check();
  SampleRows rows(depth, options.max_reach_px);
  const Interpolation interpolate(options);
  DenseDepth dense{cv::Mat(depth.size(), CV_32F), cv::Mat(depth.size(), CV_8U)};
  std::vector<Sample> samples;
  for (int v = 0; v < depth.rows; ++v) {
    rows.begin_row();
    for (int u = 0; u < depth.cols; ++u) {
      float z = depth.at<float>(v, u);
      DepthSource source = DepthSource::kMeasured;
      if (!is_known_depth(z)) {
        rows.around(u, v, samples);
        z = interpolate(samples);
        source = is_known_depth(z) ? DepthSource::kInterpolated : DepthSource::kUnknown;
      }
      dense.depth.at<float>(v, u) = z;
      dense.mask.at<std::uint8_t>(v, u) = static_cast<std::uint8_t>(source);
    }
  }
  return dense;
}

}  // namespace framewise
