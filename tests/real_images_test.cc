// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Every detector with every descriptor and matcher on neighbouring frames of a real recording, and wide
// baselines of surveyed views. Skipped where the folder of recordings is absent.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>

#include "framewise/features/feature_names.h"
#include "framewise/geometry/so3.h"
#include "framewise/io/dataset.h"
#include "framewise/io/image_files.h"
#include "framewise/odometry/correspond.h"
#include "framewise/odometry/step.h"

namespace framewise {
namespace {

namespace fs = std::filesystem;

constexpr double kDegree = M_PI / 180;

fs::path data_folder(const char* name) {
  const char* given = std::getenv("FRAMEWISE_DATA");
  return (given ? fs::path(given) : fs::path(FRAMEWISE_SOURCE_DIR) / ".." / "shared" / "data") / name;
}

TEST(RealImages, EveryDetectorWithEveryDescriptorAndMatcherFindsTheMotion) {
  const fs::path folder = data_folder("tum_fr1_rpy_000_080");
  if (!fs::exists(folder))
    GTEST_SKIP() << "no recording in " << folder << "; FRAMEWISE_DATA names its folder";
  const Dataset recording = open_dataset(folder, {});
  const Trajectory truth = truth_at_frames(recording, 0.02);
  const Pose cam2_from_cam1 = truth.world_from_cam[21].inverse() * truth.world_from_cam[20];
  const Frame frame1 = load_frame(recording, 20), frame2 = load_frame(recording, 21);
  const Camera& camera = recording.calibration.camera;
  ASSERT_EQ(truth.size(), recording.frames.size());

  for (const std::string& detector : detector_names())
    for (const std::string& descriptor : descriptor_names())
      for (const char* matcher : {"brute-force", "flann", "klt"}) {
        SCOPED_TRACE(detector + " " + descriptor + " " + matcher);
        OdometryOptions options;
        options.features.detector = detector;
        options.features.descriptor = descriptor;
        options.features.count = 500;
        options.matcher = matcher;
        if (options.tracks() && descriptor != "orb") continue;  // it describes nothing
        const Observation view1 = observe(frame1, camera, options), view2 = observe(frame2, camera, options);
        const Step step = estimate_step(correspond(view1, view2, camera, options), camera, options, 0);
        ASSERT_EQ(step.status, Status::kOk);
        EXPECT_LT(rotation_angle(step.cam2_from_cam1.R.transpose() * cam2_from_cam1.R),
                  1 * kDegree);  // the truth itself is uncertain by 0.4
        EXPECT_LT((step.cam2_from_cam1.t - cam2_from_cam1.t).norm(), 0.02);
      }
}

// A surveyed view at a quarter of the size its calibration is written for.
struct SurveyedView {
  Frame frame;
  Camera camera;
  Pose world_from_cam;
};

SurveyedView read_view(const fs::path& folder, int index) {
  const std::string name = std::string(index < 10 ? "000" : "00") + std::to_string(index) + ".jpg";
  SurveyedView view;
  view.frame.gray = read_gray(folder / name);
  std::ifstream file(folder / (name + ".camera"));
  const auto read = [&file](auto& M) {
    for (int i = 0; i < M.rows(); ++i)
      for (int j = 0; j < M.cols(); ++j) file >> M(i, j);
  };
  Eigen::Matrix3d K;
  Eigen::RowVector3d zeros;
  read(K), read(zeros), read(view.world_from_cam.R), read(view.world_from_cam.t);
  const double quarter = 0.25;
  view.camera.width = view.frame.gray.cols, view.camera.height = view.frame.gray.rows;
  view.camera.fx = quarter * K(0, 0), view.camera.fy = quarter * K(1, 1);
  // The corner of the image stays where it is: pixel (0, 0) is half a pixel inside it.
  view.camera.cx = quarter * (K(0, 2) + 0.5) - 0.5, view.camera.cy = quarter * (K(1, 2) + 0.5) - 0.5;
  return view;
}

TEST(RealImages, SiftFindsTheMotionBetweenNeighbouringSurveyedViews) {
  const fs::path folder = data_folder("strecha_fountain-P11_quarter");
  if (!fs::exists(folder)) GTEST_SKIP() << "no views in " << folder << "; FRAMEWISE_DATA names its folder";
  OdometryOptions options;
  options.solver = "nister-5pt";
  options.scale = "none";
  options.features.detector = options.features.descriptor = "sift";
  SurveyedView view1 = read_view(folder, 0);
  Observation seen1 = observe(view1.frame, view1.camera, options);
  for (int i = 1; i <= 10; ++i) {
    SCOPED_TRACE(i);
    const SurveyedView view2 = read_view(folder, i);
    const Observation seen2 = observe(view2.frame, view2.camera, options);
    const Step step =
        estimate_step(correspond(seen1, seen2, view2.camera, options), view2.camera, options, 0);
    const Pose truth = view2.world_from_cam.inverse() * view1.world_from_cam;
    ASSERT_EQ(step.status, Status::kOk);
    EXPECT_LT(rotation_angle(step.cam2_from_cam1.R.transpose() * truth.R), 0.5 * kDegree);
    EXPECT_GT(step.cam2_from_cam1.t.normalized().dot(truth.t.normalized()), std::cos(2 * kDegree));
    view1 = view2;
    seen1 = seen2;
  }
}

}  // namespace
}  // namespace framewise
