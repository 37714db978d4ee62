// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/io/feature_files.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "framewise/io/input_error.h"
#include "framewise/io/test_files_for_tests.h"

namespace framewise {
namespace {

namespace fs = std::filesystem;

std::string written(const std::vector<cv::KeyPoint>& keypoints, const cv::Mat& descriptors) {
  const fs::path file = test_file("features.txt");
  write_features(file, "a.png", keypoints, descriptors);
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  fs::remove(file);
  return text.str();
}

TEST(WriteFeatures, WritesALineAKeypointAfterALineThatNamesTheColumns) {
  const std::vector<cv::KeyPoint> keypoints = {{1.5f, 2, 31, 90, 0.25f, 1}, {3, 4, 7, -1, 1e-9f, 0}};
  EXPECT_EQ(written(keypoints, (cv::Mat_<std::uint8_t>(2, 3) << 0, 128, 255, 1, 2, 3)),
            "# a.png: x y size angle_deg response octave, 3 bytes of the descriptor\n"
            "1.5 2 31 90 0.25 1 0 128 255\n"
            "3 4 7 -1 1e-09 0 1 2 3\n");
  EXPECT_EQ(written({keypoints[0]}, (cv::Mat_<float>(1, 2) << 0.1f, -3)),
            "# a.png: x y size angle_deg response octave, 2 floats of the descriptor\n"
            "1.5 2 31 90 0.25 1 0.1 -3\n");
}

TEST(WriteFeatures, AnImageWithoutFeaturesHasItsComment) {
  EXPECT_EQ(written({}, {}).find('\n'), written({}, {}).size() - 1);
}

TEST(WriteFeatures, KeypointsThatAreOnlyTrackedHaveLinesWithoutADescriptor) {
  const std::string text = written({{1, 2, 3}, {4, 5, 6}}, {});
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 3);
  EXPECT_NE(text.find("\n4 5 6"), std::string::npos);
}

TEST(WriteFeatures, RefusesWhatDoesNotFitTogether) {
  EXPECT_THROW(written({{1, 2, 3}, {4, 5, 6}}, cv::Mat_<float>(1, 4, 0.0f)), std::invalid_argument);
  EXPECT_THROW(written({{1, 2, 3}}, cv::Mat_<double>(1, 4, 0.0)), std::invalid_argument);
  EXPECT_THROW(write_features("/no/such/folder/a.txt", "a.png", {}, {}), InputError);
}

}  // namespace
}  // namespace framewise
