// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/report/evaluation_json.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace framewise {
namespace {

std::vector<std::string> keys(const nlohmann::ordered_json& json) {
  std::vector<std::string> names;
  for (const auto& item : json.items()) names.push_back(item.key());
  return names;
}

Evaluation quarter_turn(double delta) {
  Trajectory reference, estimate;
  for (int i = 0; i < 5; ++i) {
    reference.add(i, {Eigen::Matrix3d::Identity(), Eigen::Vector3d(i, i * i, 0)});
    estimate.add(i, {Eigen::Matrix3d::Identity(), Eigen::Vector3d(i, i * i, 1.0 / 3 * (i % 2))});
  }
  EvaluationOptions options;
  options.alignment = Alignment::kNone;
  options.relative.delta = delta;
  return evaluate(reference, estimate, options);
}

TEST(EvaluationJson, HasTheKeysThatScriptsRelyOn) {
  using testing::ElementsAre;
  const auto json = to_json(quarter_turn(1));
  EXPECT_THAT(keys(json), ElementsAre("ate", "rpe", "alignment", "scale", "delta", "unit", "matched",
                                      "coverage", "path_length", "static_baseline", "ate_rotation_deg",
                                      "rpe_direction", "axes", "kitti"));
  EXPECT_THAT(keys(json["axes"]), ElementsAre("x", "y", "z"));
  EXPECT_THAT(keys(json["axes"]["x"]), ElementsAre("min", "max", "mean", "cumulative", "euler_deg"));
  EXPECT_TRUE(json["kitti"].is_null());  // the path is shorter than 100 m
  EXPECT_THAT(keys(json["ate"]), ElementsAre("rmse", "mean", "median", "std", "min", "max"));
  EXPECT_THAT(keys(json["rpe"]), ElementsAre("translation", "rotation_deg"));
  EXPECT_THAT(keys(json["rpe"]["translation"]), ElementsAre("rmse", "mean", "median", "std", "min", "max"));
  EXPECT_THAT(keys(json["static_baseline"]), ElementsAre("ate", "rpe_translation", "rpe_rotation_deg"));
  EXPECT_EQ(json["alignment"], "none");
  EXPECT_EQ(json["unit"], "frames");
}

TEST(EvaluationJson, NumbersComeBackExactly) {
  const Evaluation e = quarter_turn(1);
  const auto json = nlohmann::ordered_json::parse(to_json(e).dump());
  EXPECT_EQ(json["ate"]["rmse"].get<double>(), e.ate.rmse);
  EXPECT_EQ(json["rpe"]["translation"]["std"].get<double>(), e.rpe->translation.std);
  EXPECT_EQ(json["static_baseline"]["ate"].get<double>(), e.static_baseline.ate);
}

TEST(EvaluationJson, RelativeErrorsThatDoNotExistAreNull) {
  const auto json = to_json(quarter_turn(10));
  EXPECT_TRUE(json["rpe"]["translation"].is_null());
  EXPECT_TRUE(json["static_baseline"]["rpe_translation"].is_null());
}

}  // namespace
}  // namespace framewise
