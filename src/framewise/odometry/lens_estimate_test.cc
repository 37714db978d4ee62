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
    const auto learned = lens.take_in(window(correction, 0), camera, true);
    ASSERT_TRUE(learned);
    camera = *learned;
  }
  EXPECT_NEAR(lens.correction(), -0.008, 1e-15);
  EXPECT_NEAR(camera.distortion[0], 0.1 - 0.008, 1e-15);
  EXPECT_EQ(camera.distortion[1], kCamera.distortion[1]);
}

TEST(LensEstimate, WhatNoPixelShowsLeavesTheCamera) {
  LensEstimate lens;
  EXPECT_FALSE(lens.take_in(window(1e-5, 0), kCamera, true));
  EXPECT_FALSE(lens.take_in(window(0, 0), kCamera, true));
  EXPECT_EQ(lens.correction(), 0);
}

TEST(LensEstimate, GetsSurerButNeverSoSureThatItLearnsNoMore) {
  LensEstimate lens;
  const double first = lens.information_for_window(true);
  lens.take_in(window(0, 3 * first), kCamera, true);
  const double later = lens.information_for_window(true);
  EXPECT_NEAR(later, 3 * first, 1e-6 * first);
  lens.take_in(window(0, first), kCamera, true);  // a poorer window takes nothing away
  EXPECT_EQ(lens.information_for_window(true), later);
  lens.take_in(window(0, 1e30), kCamera, true);
  EXPECT_LT(lens.information_for_window(true), 1e4 * first);
}

constexpr double kHeld = 1e11;  // more than any window tells

// A window without depth that tells so much.
void hear(LensEstimate& lens, double told) {
  lens.take_in(window(0, lens.information_for_window(false) + told), kCamera, false);
}

// How many windows that tell so much move the lens before it is held.
int windows_that_move_it(LensEstimate& lens, double told) {
  constexpr int kMost = 10000;
  int count = 0;
  for (; count < kMost && lens.information_for_window(false) < kHeld; ++count) hear(lens, told);
  return count;
}

TEST(LensEstimate, WithoutDepthWindowsThatTellLittleDoNotAddUpAndOneThatTellsMoreIsHeard) {
  LensEstimate lens;
  EXPECT_LT(windows_that_move_it(lens, 1e5), 100);
  hear(lens, 1e5);
  EXPECT_GT(lens.information_for_window(false), kHeld);
  EXPECT_LT(lens.information_for_window(true), kHeld);
  hear(lens, 1e7);
  EXPECT_LT(lens.information_for_window(false), kHeld);
  EXPECT_LT(windows_that_move_it(lens, 1e7), 100);
}

}  // namespace
}  // namespace framewise
