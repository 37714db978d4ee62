// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Odometry from depth images alone, on recordings with truth: aligned surfaces frame to frame and against a
// keyframe's surface, and OpenCV's ICPOdometry (contrib, rgbd) on the same frames in turns. All begin at
// identity or at the last motion; no colour is read. bench/depth_odometry_peers.py runs small_gicp and
// Open3D.
//   bench_depth_odometry RECORDING...
#include <chrono>
#include <cstdio>
#include <functional>
#include <memory>
#include <opencv2/imgproc.hpp>
#include <string>
#include <vector>

#include "framewise/evaluation/evaluation.h"
#include "framewise/io/dataset.h"
#include "framewise/registration/surface_model.h"

#ifdef FRAMEWISE_BENCH_RGBD
#include <opencv2/rgbd.hpp>
#endif

namespace {

using namespace framewise;
using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

Pose renewed(const Pose& pose) { return Pose::from_quaternion(pose.quaternion(), pose.t); }

// One way of turning depth images into a trajectory: the pose of each frame in the world of the first.
struct Method {
  std::string name;
  std::function<Pose(const cv::Mat& depth)> next;
  Trajectory trajectory = {};
  double seconds = 0;
};

Method frame_to_frame(const Camera& camera) {
  struct State {
    SurfaceMaker maker;
    SurfacePyramid previous = {};
    Pose world_from_cam = {};
  };
  const auto state = std::make_shared<State>(State{SurfaceMaker(camera, {})});
  return {"surfaces, frame to frame", [state](const cv::Mat& depth) {
            SurfacePyramid surface = state->maker(depth);
            if (const auto found = align_surfaces(state->previous, surface, Pose(), {}))
              state->world_from_cam = renewed(state->world_from_cam * found->cam2_from_cam1.inverse());
            state->previous = std::move(surface);
            return state->world_from_cam;
          }};
}

Method keyframe_model(const Camera& camera) {
  struct State {
    explicit State(const Camera& camera) : maker(camera, {}), model(maker, {}, {}) {}
    SurfaceMaker maker;
    SurfaceModel model;
    Pose world_from_cam, motion;
  };
  const auto state = std::make_shared<State>(camera);
  return {"surfaces, keyframe model", [state](const cv::Mat& depth) {
            const SurfacePyramid surface = state->maker(depth);
            if (!state->model.is_started()) {
              state->model.start(surface, Pose());
              return Pose();
            }
            const Pose before = state->world_from_cam;
            if (const auto found = state->model.align(surface, before * state->motion)) {
              state->world_from_cam =
                  renewed(state->model.world_from_keyframe() * found->cam2_from_cam1.inverse());
              state->motion = renewed(before.inverse() * state->world_from_cam);
              state->model.add(surface, state->world_from_cam, found->overlap);
            }
            return state->world_from_cam;
          }};
}

#ifdef FRAMEWISE_BENCH_RGBD
Method opencv_icp(const Camera& camera, int decimation) {
  struct State {
    cv::Ptr<cv::rgbd::ICPOdometry> odometry;
    cv::Ptr<cv::rgbd::OdometryFrame> previous;
    Pose world_from_cam;
  };
  const auto state = std::make_shared<State>();
  const double d = decimation;
  const cv::Matx33f K(static_cast<float>(camera.fx / d), 0, static_cast<float>((camera.cx + 0.5) / d - 0.5),
                      0, static_cast<float>(camera.fy / d), static_cast<float>((camera.cy + 0.5) / d - 0.5),
                      0, 0, 1);
  state->odometry = cv::rgbd::ICPOdometry::create(cv::Mat(K), 0.1f, 10.f);
  const std::string name = "OpenCV ICPOdometry " + std::to_string(camera.width / decimation) + " wide";
  return {name, [state, decimation](const cv::Mat& depth) {
            cv::Mat used = depth;
            if (decimation > 1)
              cv::resize(depth, used, {}, 1.0 / decimation, 1.0 / decimation, cv::INTER_NEAREST);
            auto frame = cv::rgbd::OdometryFrame::create(cv::Mat(), used.clone());
            cv::Mat motion;
            if (state->previous && state->odometry->compute(state->previous, frame, motion)) {
              Pose current_from_previous;
              for (int i = 0; i < 3; ++i) {
                for (int j = 0; j < 3; ++j) current_from_previous.R(i, j) = motion.at<double>(i, j);
                current_from_previous.t[i] = motion.at<double>(i, 3);
              }
              state->world_from_cam =
                  renewed(state->world_from_cam * renewed(current_from_previous).inverse());
            }
            state->previous = frame;
            return state->world_from_cam;
          }};
}
#endif

void race(const std::string& path) {
  Dataset data = open_dataset(path, {});
  for (FrameFiles& frame : data.frames) frame.color.clear();
  const Camera& camera = data.calibration.camera;
  std::vector<Method> methods = {frame_to_frame(camera), keyframe_model(camera)};
#ifdef FRAMEWISE_BENCH_RGBD
  methods.push_back(opencv_icp(camera, 1));
  methods.push_back(opencv_icp(camera, 2));
#endif
  double loading = 0;
  for (std::size_t i = 0; i < data.frames.size(); ++i) {
    if (data.frames[i].depth.empty()) continue;
    auto start = Clock::now();
    const Frame frame = load_frame(data, i);
    loading += seconds_since(start);
    for (Method& method : methods) {
      start = Clock::now();
      const Pose pose = method.next(frame.depth);
      method.seconds += seconds_since(start);
      method.trajectory.add(data.frames[i].time, pose);
    }
  }
  const double frames = static_cast<double>(methods[0].trajectory.size());
  std::printf("%s: %.0f frames, decoding %.1f ms\n", data.name.c_str(), frames, 1e3 * loading / frames);
  std::printf("  %-32s %10s %10s %8s %8s\n", "", "RPE mm", "RPE deg", "ATE m", "ms");
  for (const Method& method : methods) {
    EvaluationOptions options;
    options.association.max_difference = 0.02;
    const Evaluation found = evaluate(truth_at_frames(data, 0.1), method.trajectory, options);
    std::printf("  %-32s %10.2f %10.3f %8.4f %8.1f\n", method.name.c_str(), 1e3 * found.rpe->translation.rmse,
                found.rpe->rotation_deg.rmse, found.ate.rmse, 1e3 * method.seconds / frames);
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) return std::fprintf(stderr, "usage: bench_depth_odometry RECORDING...\n"), 2;
  for (int i = 1; i < argc; ++i) race(argv[i]);
  return 0;
}
