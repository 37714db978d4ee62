// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/report/evaluation_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace framewise {
namespace {

using testing::HasSubstr;

// A metre a second along x; the estimate is 1 mm off in y at every other pose.
Evaluation zigzag(const EvaluationOptions& options) {
  Trajectory reference, estimate;
  for (int i = 0; i < 5; ++i) {
    reference.add(i, {Eigen::Matrix3d::Identity(), Eigen::Vector3d(i, 0, 0)});
    estimate.add(i, {Eigen::Matrix3d::Identity(), Eigen::Vector3d(i, 1e-3 * (i % 2), 0)});
  }
  return evaluate(reference, estimate, options);
}

TEST(EvaluationText, SaysWhatAFigureIsWorthNothingWithout) {
  EvaluationOptions options;
  options.alignment = Alignment::kNone;
  const std::string text = to_text(zigzag(options));
  EXPECT_THAT(text, HasSubstr("alignment           none, scale 1"));
  EXPECT_THAT(text, HasSubstr("delta 1 frames, 4 consecutive pairs, error B^-1 A"));
  EXPECT_THAT(text, HasSubstr("5 of 5 poses of the estimate, coverage 100 %, nearest stamp within 0.01 s"));
  EXPECT_THAT(text, HasSubstr("path length         4 m"));
  EXPECT_THAT(text, HasSubstr("static"));
  // A camera left at the first pose: distances 0 to 4 m, rmse sqrt(30 / 5); 1 m a frame.
  EXPECT_THAT(text, HasSubstr("2.44949\n"));
  EXPECT_THAT(text, HasSubstr("RPE (m)                     0.001 "));
}

TEST(EvaluationText, ColumnsStandUnderTheirHeadings) {
  const std::string text = to_text(zigzag({}));
  std::vector<std::size_t> ends;
  std::size_t begin = 0;
  for (int i = 0; i < 5; ++i) {
    const std::size_t end = text.find('\n', begin);
    ends.push_back(end - begin);
    begin = end + 1;
  }
  EXPECT_THAT(ends, testing::Each(ends[0]));
}

TEST(EvaluationText, FiguresNeverTouch) {
  Evaluation e = zigzag({});
  e.ate.mean = 1.23456e-100;
  e.ate.rmse = e.ate.median = 0.000123456789;
  EXPECT_THAT(to_text(e), HasSubstr(" 0.000123457 1.23456e-100  0.000123457 "));
}

TEST(EvaluationText, ARecordingShorterThanDeltaSaysSo) {
  EvaluationOptions options;
  options.relative.delta = 100;
  EXPECT_THAT(to_text(zigzag(options)), HasSubstr("no two poses are delta apart"));
}

}  // namespace
}  // namespace framewise
