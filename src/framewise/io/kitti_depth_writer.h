// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "framewise/io/recording_writer.h"

namespace framewise {

// KITTI: a sequence of the odometry benchmark with depth where the depth benchmark has it, which is a
// recording by itself too. Names are numbers of ten digits.
//   image_2/*.png, calib.txt (P0 to P3), times.txt, poses.txt     colour; world_from_cam, 3 x 4, row by row
//   proj_depth/velodyne_raw/image_02/*.png                        16-bit z, 1/256 m, 0 unknown
//   proj_depth/groundtruth/image_02/*.png                         where it is given: without the sensor's
//   faults groundtruth.txt, imu.csv, imu_true.csv                        as beside TUM's: truth at its full
//   rate Geiger, Lenz, Urtasun, Are we ready for autonomous driving?, CVPR 2012; Uhrig et al., Sparsity
//   invariant CNNs, 3DV 2017.
class KittiDepthWriter final : public RecordingWriter {
 public:
  // A pinhole without distortion, and z with 256 units a metre.
  KittiDepthWriter(const std::filesystem::path& folder, const Camera& camera, const DepthStorage& storage);

  void finish(const Trajectory& truth) override;
  void write_imu(std::span<const ImuReading> readings, std::span<const ImuReading> truth,
                 double rate_hz) override;

 private:
  std::vector<double> times_;
  bool has_true_depth_ = false;

  void write_frame(const Frame& frame, const cv::Mat& true_depth) override;
  std::vector<std::filesystem::path> depth_folders() const;
};

}  // namespace framewise
