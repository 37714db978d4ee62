// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "robust_problems.h"

#ifdef FRAMEWISE_BENCH_POSELIB
#include <PoseLib/poselib.h>
#endif
#ifdef FRAMEWISE_BENCH_OPENCV
#include <opencv2/calib3d.hpp>
#endif

// Peers behind one signature. Thresholds are 2 px throughout.
namespace framewise::bench {

struct Method {
  std::string name;
  std::function<std::optional<Pose>(const RobustProblem&)> solve;
};

#ifdef FRAMEWISE_BENCH_POSELIB
inline poselib::RansacOptions poselib_ransac(bool tuned) {
  poselib::RansacOptions options;
  if (tuned) options.min_iterations = 20, options.success_prob = 0.99;
  return options;
}

inline Method poselib_relative(bool tuned) {
  return {tuned ? "PoseLib tuned" : "PoseLib 2 px", [tuned](const RobustProblem& p) -> std::optional<Pose> {
            const poselib::Camera camera("PINHOLE", {kFocal, kFocal, kCx, kCy}, 640, 480);
            poselib::RelativePoseOptions options;
            options.max_error = 2;
            options.ransac = poselib_ransac(tuned);
            poselib::CameraPose pose;
            std::vector<char> inliers;
            const auto stats =
                poselib::estimate_relative_pose(p.px1, p.px2, camera, camera, options, &pose, &inliers);
            if (stats.num_inliers < 5) return std::nullopt;
            return Pose{pose.R(), pose.t};
          }};
}

inline Method poselib_absolute(bool tuned) {
  return {tuned ? "PoseLib absolute tuned" : "PoseLib absolute",
          [tuned](const RobustProblem& p) -> std::optional<Pose> {
            poselib::AbsolutePoseOptions options;
            options.max_error = 2;
            options.ransac = poselib_ransac(tuned);
            poselib::Image image;
            image.camera = poselib::Camera("PINHOLE", {kFocal, kFocal, kCx, kCy}, 640, 480);
            std::vector<char> inliers;
            const auto stats = poselib::estimate_absolute_pose(p.px2, p.X1, options, &image, &inliers);
            if (stats.num_inliers < 4) return std::nullopt;
            return Pose{image.pose.R(), image.pose.t};
          }};
}
#endif

#ifdef FRAMEWISE_BENCH_OPENCV
inline cv::Matx33d opencv_camera() { return {kFocal, 0, kCx, 0, kFocal, kCy, 0, 0, 1}; }

inline std::vector<cv::Point2d> opencv_points(const std::vector<Eigen::Vector2d>& px) {
  std::vector<cv::Point2d> points;
  for (const auto& p : px) points.emplace_back(p.x(), p.y());
  return points;
}

inline Pose from_opencv(const cv::Matx33d& R, const cv::Matx31d& t) {
  Pose pose;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) pose.R(i, j) = R(i, j);
    pose.t[i] = t(i);
  }
  return pose;
}

inline Method opencv_essential(const std::string& name, int method) {
  return {name, [method](const RobustProblem& p) -> std::optional<Pose> {
            const auto points1 = opencv_points(p.px1), points2 = opencv_points(p.px2);
            cv::Mat mask;
            const cv::Mat E =
                cv::findEssentialMat(points1, points2, cv::Mat(opencv_camera()), method, 0.99, 2.0, mask);
            if (E.rows != 3) return std::nullopt;
            cv::Matx33d R;
            cv::Matx31d t;
            cv::recoverPose(E, points1, points2, cv::Mat(opencv_camera()), R, t, mask);
            return from_opencv(R, t);
          }};
}

inline Method opencv_pnp() {
  return {"OpenCV solvePnPRansac", [](const RobustProblem& p) -> std::optional<Pose> {
            std::vector<cv::Point3d> points;
            for (const auto& X : p.X1) points.emplace_back(X.x(), X.y(), X.z());
            cv::Matx31d rotation, t;
            std::vector<int> inliers;
            if (!cv::solvePnPRansac(points, opencv_points(p.px2), cv::Mat(opencv_camera()), cv::noArray(),
                                    rotation, t, false, 100, 2.0, 0.99, inliers)) {
              return std::nullopt;
            }
            cv::Matx33d R;
            cv::Rodrigues(rotation, R);
            return from_opencv(R, t);
          }};
}
#endif

}  // namespace framewise::bench
