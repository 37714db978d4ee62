// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Dense depth from a 64-line laser scanner on a car, as in KITTI (1242 x 375, f 721; the scanner 8 cm above
// and 27 cm behind the camera, so that it sees behind edges; 2 cm of noise): a street with walls, cars, poles
// and a tree line. Error at the tenth of the points that was held out, and at all pixels against the camera's
// own exact depth.
//   bench_densify
#include "framewise/image/densify.h"

#include <Eigen/Core>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <limits>
#include <opencv2/imgproc.hpp>
#include <random>
#include <string>
#include <vector>

#include "framewise/image/hole_filling.h"

namespace {

using namespace framewise;
using Eigen::Vector3d;

constexpr int kWidth = 1242, kHeight = 375;
constexpr double kFocal = 721, kCx = 610, kCy = 173;
constexpr float kNoDepth = std::numeric_limits<float>::quiet_NaN();

struct Box {
  Vector3d least, most;
};

const std::vector<Box>& street() {
  static const std::vector<Box> boxes = [] {
    std::vector<Box> made = {
        {{-9, -8, 5}, {-8.5, 2, 90}}, {{8, -6, 0}, {8.5, 2, 60}}, {{-60, -20, 88}, {60, 2, 90}}};
    for (int k = 0; k < 6; ++k) {  // parked cars and, between them, poles
      const double z = 6 + 9 * k;
      made.push_back({{3.2, 0.2, z}, {5.0, 1.65, z + 4.2}});
      made.push_back({{-6.4, 0.2, z + 4}, {-4.6, 1.65, z + 8.2}});
      made.push_back({{-3.6, -4, z + 2}, {-3.45, 1.65, z + 2.15}});
    }
    return made;
  }();
  return boxes;
}

// Distance along a ray to the street or the ground, 1.65 m below the camera; infinite where there is none.
double cast(const Vector3d& from, const Vector3d& ray) {
  double nearest = ray.y() > 0 ? (1.65 - from.y()) / ray.y() : std::numeric_limits<double>::infinity();
  for (const Box& box : street()) {
    double enter = 0, leave = nearest;
    for (int i = 0; i < 3; ++i) {
      const double a = (box.least[i] - from[i]) / ray[i], b = (box.most[i] - from[i]) / ray[i];
      enter = std::max(enter, std::min(a, b));
      leave = std::min(leave, std::max(a, b));
    }
    if (enter < leave && enter > 1e-6) nearest = std::min(nearest, enter);
  }
  return nearest;
}

cv::Mat exact_depth() {
  cv::Mat depth(kHeight, kWidth, CV_32F);
  for (int v = 0; v < kHeight; ++v)
    for (int u = 0; u < kWidth; ++u) {
      const double z = cast({0, 0, 0}, {(u - kCx) / kFocal, (v - kCy) / kFocal, 1});
      depth.at<float>(v, u) = z < 100 ? static_cast<float>(z) : kNoDepth;
    }
  return depth;
}

// 26.8 degrees in 64 lines, 0.17 degrees from point to point, to 1/256 m as KITTI's files have it.
cv::Mat scan() {
  cv::Mat depth(kHeight, kWidth, CV_32F, cv::Scalar(kNoDepth));
  const Vector3d scanner(0, -0.08, -0.27);
  std::mt19937 random(1);
  for (int line = 0; line < 64; ++line)
    for (int step = -265; step <= 265; ++step) {
      const double down = (-2 + 26.8 * line / 63) * M_PI / 180, right = 0.17 * step * M_PI / 180;
      const Vector3d ray(std::cos(down) * std::sin(right), std::sin(down), std::cos(down) * std::cos(right));
      double noise = -6;
      for (int k = 0; k < 12; ++k) noise += random() / 4294967296.0;
      const double range = cast(scanner, ray) + 0.02 * noise;
      if (!(range < 100)) continue;
      const Vector3d point = scanner + range * ray;
      const int u = static_cast<int>(std::lround(kFocal * point.x() / point.z() + kCx));
      const int v = static_cast<int>(std::lround(kFocal * point.y() / point.z() + kCy));
      if (u < 0 || v < 0 || u >= kWidth || v >= kHeight) continue;
      float& pixel = depth.at<float>(v, u);
      const float z = static_cast<float>(std::round(point.z() * 256) / 256);
      if (!(pixel < z)) pixel = z;
    }
  return depth;
}

// Rivals fill everything below the scan's upper end; nothing is counted above.
struct Error {
  double mae = 0, rmse = 0, inverse_mae = 0, share = 0;
};
Error error_of(const cv::Mat& dense, const cv::Mat& truth) {
  Error error;
  int known = 0, all = 0;
  for (int v = 0; v < kHeight; ++v)
    for (int u = 0; u < kWidth; ++u) {
      const double z = truth.at<float>(v, u), found = dense.at<float>(v, u);
      if (!(z > 0)) continue;
      ++all;
      if (!(found > 0)) continue;
      ++known;
      error.mae += std::abs(found - z);
      error.rmse += (found - z) * (found - z);
      error.inverse_mae += std::abs(1 / found - 1 / z);
    }
  return {error.mae / known, std::sqrt(error.rmse / known), error.inverse_mae / known, known / double(all)};
}

// The morphology of Ku, Harakeh, Waslander, In defense of classical image processing, CRV 2018, section III:
// depths are turned round (100 m - z), dilated by a 5 x 5 diamond, closed by 5 x 5, holes dilated by 7 x 7,
// then a median and a Gaussian of 5 x 5.
cv::Mat by_morphology(const cv::Mat& sparse) {
  cv::Mat turned(sparse.size(), CV_32F);
  for (int v = 0; v < kHeight; ++v)
    for (int u = 0; u < kWidth; ++u) {
      const float z = sparse.at<float>(v, u);
      turned.at<float>(v, u) = z > 0 ? 100 - z : 0;
    }
  const cv::Mat diamond = (cv::Mat_<std::uint8_t>(5, 5) << 0, 0, 1, 0, 0, 0, 1, 1, 1, 0, 1, 1, 1, 1, 1, 0, 1,
                           1, 1, 0, 0, 0, 1, 0, 0);
  const cv::Mat full5 = cv::Mat::ones(5, 5, CV_8U), full7 = cv::Mat::ones(7, 7, CV_8U);
  cv::dilate(turned, turned, diamond);
  cv::morphologyEx(turned, turned, cv::MORPH_CLOSE, full5);
  cv::Mat grown;
  cv::dilate(turned, grown, full7);
  grown.copyTo(turned, turned < 0.1);
  cv::Mat calm;
  cv::medianBlur(turned, calm, 5);
  calm.copyTo(turned, turned > 0.1);
  cv::GaussianBlur(turned, calm, cv::Size(5, 5), 0);
  calm.copyTo(turned, turned > 0.1);
  cv::Mat depth = 100 - turned;
  return depth.setTo(kNoDepth, turned < 0.1);
}

}  // namespace

int main() {
  cv::setNumThreads(1);
  const cv::Mat truth = exact_depth(), sparse = scan();
  cv::Mat kept = sparse.clone(), held_out(sparse.size(), CV_32F, cv::Scalar(kNoDepth));
  std::mt19937 random(2);
  int points = 0;
  for (int v = 0; v < kHeight; ++v)
    for (int u = 0; u < kWidth; ++u)
      if (sparse.at<float>(v, u) > 0) {
        ++points;
        if (random() % 10 != 0) continue;
        std::swap(held_out.at<float>(v, u), kept.at<float>(v, u));
      }
  std::printf("%d points, %.1f %% of the pixels\n", points, 100.0 * points / truth.total());

  struct Way {
    std::string name;
    std::function<cv::Mat(const cv::Mat&)> dense;
  };
  std::vector<Way> ways = {
      {"densify (planes of inverse depth)", [](const cv::Mat& d) { return densify(d, {}).depth; }},
      {"nearest point",
       [](const cv::Mat& d) {
         return fill_holes(d, {FillMethod::kNearest, 10});
       }},
      {"pull-push of inverse depth",
       [](const cv::Mat& d) {
         return fill_holes(d, {FillMethod::kSmooth, 10});
       }},
      {"morphology (Ku et al. 2018)", by_morphology},
  };
  std::printf("%-36s | held out: MAE  RMSE m  1/km  share | all: MAE  RMSE m  1/km  share |   ms\n", "");
  for (const Way& way : ways) {
    const Error at_points = error_of(way.dense(kept), held_out);
    const auto begin = std::chrono::steady_clock::now();
    const cv::Mat dense = way.dense(sparse);
    const double ms =
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
    const Error everywhere = error_of(dense, truth);
    std::printf("%-36s | %13.3f %7.3f %5.2f %6.3f | %8.3f %7.3f %5.2f %6.3f | %5.1f\n", way.name.c_str(),
                at_points.mae, at_points.rmse, 1e3 * at_points.inverse_mae, at_points.share, everywhere.mae,
                everywhere.rmse, 1e3 * everywhere.inverse_mae, everywhere.share, ms);
  }
  return 0;
}
