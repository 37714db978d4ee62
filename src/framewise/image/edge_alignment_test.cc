// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/image/edge_alignment.h"

#include <gtest/gtest.h>

#include <random>
#include <stdexcept>

#include "framewise/image/depth_images_for_tests.h"

namespace framewise {
namespace {

// Boxes of their own gray before a wall, seen by both cameras; depth moved by (du, dv) and zoomed about the
// middle.
struct Scene {
  cv::Mat gray, depth;
};
Scene boxes(unsigned seed, double zoom, int du, int dv) {
  std::mt19937 random(seed);
  Scene scene{cv::Mat(240, 320, CV_8U, cv::Scalar(100)), cv::Mat(240, 320, CV_32F, cv::Scalar(4))};
  for (int i = 0; i < 12; ++i) {
    const int u = static_cast<int>(random() % 260), v = static_cast<int>(random() % 190),
              w = 25 + static_cast<int>(random() % 40), h = 20 + static_cast<int>(random() % 40),
              level = 20 + static_cast<int>(random() % 200);
    const cv::Rect box = cv::Rect(u, v, w, h) & cv::Rect(0, 0, 320, 240);
    scene.gray(box).setTo(level);
    const auto moved = [&](double x, double middle, int shift) {
      return static_cast<int>(std::lround((x - middle) * zoom + middle + shift));
    };
    const cv::Rect moved_box =
        cv::Rect(cv::Point(moved(box.x, 160, du), moved(box.y, 120, dv)),
                 cv::Point(moved(box.x + box.width, 160, du), moved(box.y + box.height, 120, dv))) &
        cv::Rect(0, 0, 320, 240);
    scene.depth(moved_box).setTo(1.5 + 0.15 * i);
  }
  for (int v = 0; v < 240; ++v)
    for (int u = 0; u < 320; ++u)
      scene.gray.at<std::uint8_t>(v, u) += static_cast<std::uint8_t>(random() % 5);
  return scene;
}

EdgeFit fit_of(double zoom, int du, int dv) {
  EdgeAlignment alignment;
  for (unsigned seed = 1; seed <= 4; ++seed) {
    const Scene scene = boxes(seed, zoom, du, dv);
    alignment.add(scene.gray, scene.depth);
  }
  const auto fit = alignment.fit();
  EXPECT_TRUE(fit);
  return fit.value_or(EdgeFit());
}

TEST(EdgeAlignment, RegisteredDepthStaysWhereItIs) {
  EXPECT_FALSE(fit_of(1, 0, 0).is_elsewhere());
  EXPECT_FALSE(fit_of(1, 1, -1).is_elsewhere());
}

TEST(EdgeAlignment, FindsTheShiftAndTheZoom) {
  const EdgeFit shifted = fit_of(1, 12, -6);
  EXPECT_TRUE(shifted.is_elsewhere());
  EXPECT_NEAR(shifted.du, -12, 2);
  EXPECT_NEAR(shifted.dv, 6, 2);
  EXPECT_NEAR(shifted.zoom, 1, 0.021);
  const EdgeFit zoomed = fit_of(1 / 0.9, 4, 0);
  EXPECT_TRUE(zoomed.is_elsewhere());
  EXPECT_NEAR(zoomed.zoom, 0.9, 0.021);
}

TEST(EdgeAlignment, ImagesOfDifferentThingsFitNowhere) {
  EdgeAlignment alignment;
  for (unsigned seed = 1; seed <= 4; ++seed)
    alignment.add(boxes(seed, 1, 0, 0).gray, boxes(seed + 50, 1, 0, 0).depth);
  EXPECT_FALSE(alignment.fit()->is_elsewhere());
}

TEST(EdgeAlignment, SaysNothingWithoutEdges) {
  EdgeAlignment alignment;
  EXPECT_FALSE(alignment.fit());
  alignment.add(cv::Mat(240, 320, CV_8U, cv::Scalar(9)), cv::Mat(240, 320, CV_32F, cv::Scalar(2)));
  alignment.add(cv::Mat(240, 320, CV_8U, cv::Scalar(9)), cv::Mat(240, 320, CV_32F, cv::Scalar(kNoDepth)));
  EXPECT_FALSE(alignment.fit());
  EXPECT_THROW(alignment.add(cv::Mat(24, 32, CV_8U), cv::Mat(24, 32, CV_32F)), std::invalid_argument);
  EXPECT_THROW(alignment.add(cv::Mat(240, 320, CV_8U), cv::Mat(24, 32, CV_32F)), std::invalid_argument);
}

TEST(DepthEdges, LieOnTheNearerSide) {
  cv::Mat depth(5, 8, CV_32F, cv::Scalar(2));
  depth.colRange(4, 8) = 3;
  depth.at<float>(2, 6) = kNoDepth;
  const auto edges = depth_edges(depth);
  ASSERT_EQ(edges.size(), 3u);
  for (const cv::Point& edge : edges) EXPECT_EQ(edge.x, 3);
}

}  // namespace
}  // namespace framewise
