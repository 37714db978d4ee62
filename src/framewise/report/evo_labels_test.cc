// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/report/evo_labels.h"

#include <gtest/gtest.h>

namespace framewise {
namespace {

EvoLabels labels(const EvaluationOptions& options, const std::string& metric) {
  Evaluation e;
  e.options = options;
  return evo_labels(e, metric_from_name(metric));
}

TEST(EvoLabels, AreEvosWords) {
  EvaluationOptions options;
  EXPECT_EQ(labels(options, "ate").title, "APE w.r.t. translation part (m)\n(with SE(3) Umeyama alignment)");
  EXPECT_EQ(labels(options, "ate").label, "APE (m)");
  options.alignment = Alignment::kNone;
  EXPECT_EQ(labels(options, "rpe-rotation").title,
            "RPE w.r.t. rotation angle in degrees (deg)\nfor delta = 1 (frames) using consecutive pairs\n"
            "(not aligned)");
  EXPECT_EQ(labels(options, "rpe-distance-ratio").label, "RPE (%)");
}

TEST(EvoLabels, DeltasThatAreNoFramesHaveAPoint) {
  EvaluationOptions options;
  options.relative.unit = DeltaUnit::kMetres;
  options.relative.delta = 100;
  options.relative.pairs = PairChoice::kAll;
  EXPECT_NE(labels(options, "rpe-full").title.find("delta = 100.0 (m) using all pairs"), std::string::npos);
  options.relative.delta = 0.25;
  EXPECT_NE(labels(options, "rpe-full").title.find("delta = 0.25 (m)"), std::string::npos);
}

TEST(EvoLabels, WhatEvoDoesNotKnowIsSaidToo) {
  EvaluationOptions options;
  options.alignment = Alignment::kYaw;
  options.plane = Plane::kXz;
  options.relative.unit = DeltaUnit::kSeconds;
  EXPECT_EQ(labels(options, "rpe-direction").title,
            "RPE w.r.t. direction (unit-less)\nfor delta = 1.0 (s) using the TUM tools' pairs\n"
            "(with yaw alignment)\n(projected to xz plane)");
}

}  // namespace
}  // namespace framewise
