// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/odometry/taken_places.h"

#include <gtest/gtest.h>

#include <limits>

namespace framewise {
namespace {

TEST(TakenPlaces, AreFreeAsFarAsWasAsked) {
  TakenPlaces places({100, 80}, 6);
  places.take({50, 40});
  EXPECT_FALSE(places.is_free({50, 40}));
  EXPECT_FALSE(places.is_free({56, 34}));
  EXPECT_TRUE(places.is_free({57, 40}));
  EXPECT_TRUE(places.is_free({50, 47}));
}

TEST(TakenPlaces, ReachInFromOutsideTheImage) {
  TakenPlaces places({100, 80}, 6);
  places.take({-3, -3});
  EXPECT_FALSE(places.is_free({3, 3}));
  EXPECT_TRUE(places.is_free({4, 0}));
}

TEST(TakenPlaces, WhatIsNowhereTakesNothing) {
  TakenPlaces places({100, 80}, 6);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double far : {-1e300, 1e9, nan}) places.take({far, 10});
  for (int v = 0; v < 80; ++v)
    for (int u = 0; u < 100; ++u) ASSERT_TRUE(places.is_free(Eigen::Vector2d(u, v)));
}

}  // namespace
}  // namespace framewise
