// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/odometry/lens_estimate.h"

#include <gtest/gtest.h>

namespace framewise {
namespace {

const Camera kCamera{CameraModel::kPinhole, 320, 240, 250, 250, 159.5, 119.5, {0.1, -0.2, 0, 0, 0}};

WindowSummary window(double correction, double information) {
  WindowSummary summary;
  summary.lens_correction = correction, summary.lens_information = information;
  return summary;
}

TEST(LensEstimate, CorrectionsAddUpInTheCameraAndInWhatWasLearned) {
  LensEstimate lens;
  Camera camera = kCamera;
  for (const double correction : {-0.01, 0.002}) {
    const auto learned = lens.take_in(window(correction, 0), camera);
    ASSERT_TRUE(learned);
    camera = *learned;
  }
  EXPECT_NEAR(lens.correction(), -0.008, 1e-15);
  EXPECT_NEAR(camera.distortion[0], 0.1 - 0.008, 1e-15);
  EXPECT_EQ(camera.distortion[1], kCamera.distortion[1]);
}

TEST(LensEstimate, WhatNoPixelShowsLeavesTheCamera) {
  LensEstimate lens;
  EXPECT_FALSE(lens.take_in(window(1e-5, 0), kCamera));
  EXPECT_FALSE(lens.take_in(window(0, 0), kCamera));
  EXPECT_EQ(lens.correction(), 0);
}

TEST(LensEstimate, GetsSurerButNeverSoSureThatItLearnsNoMore) {
  LensEstimate lens;
  const double first = lens.information_for_window();
  lens.take_in(window(0, 30 * first), kCamera);
  const double later = lens.information_for_window();
  EXPECT_NEAR(later, 30 * first, 1e-6 * first);
  lens.take_in(window(0, 1e30), kCamera);
  EXPECT_LT(lens.information_for_window(), 1e4 * first);
}

constexpr double kHeld = 1e11;  // more than any window tells

// A window that tells so much.
void hear(LensEstimate& lens, double told) {
  lens.take_in(window(0, lens.information_for_window() + told), kCamera);
}

// How many windows that tell so much move the lens before it is held.
int windows_that_move_it(LensEstimate& lens, double told) {
  constexpr int kMost = 10000;
  int count = 0;
  for (; count < kMost && lens.information_for_window() < kHeld; ++count) hear(lens, told);
  return count;
}

TEST(LensEstimate, WindowsThatTellLittleDoNotAddUpAndOneThatTellsMoreIsHeard) {
  LensEstimate lens;
  EXPECT_LT(windows_that_move_it(lens, 1e5), 100);
  hear(lens, 1e5);
  EXPECT_GT(lens.information_for_window(), kHeld);
  hear(lens, 1e7);
  EXPECT_LT(lens.information_for_window(), kHeld);
  EXPECT_LT(windows_that_move_it(lens, 1e7), 100);
}

}  // namespace
}  // namespace framewise
