// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <map>
#include <mutex>
#include <vector>

#include "framewise/geometry/correspondences.h"
#include "framewise/image/frame.h"
#include "framewise/odometry/odometer.h"
#include "framewise/report/run_report.h"
#include "report_files.h"

namespace framewise::apps {

// The matches of frames on their way, until their results come.
class PairsInFlight {
 public:
  void see(std::size_t index2, const Correspondences& shared);  // from any thread
  // Those that the frame's step judged, forgotten then. Empty where there are none.
  Correspondences take(const FrameResult& result);

 private:
  std::mutex mutex_;
  std::map<std::size_t, std::vector<Correspondences>> pairs_;
};

// Median over the inliers of the angle between R x1 and x2 (degrees); NaN without a motion.
double parallax_deg(const Step& step, const Correspondences& shared);

// Keeps images and matches of at most kKept frames, spread evenly over the recording, however long it is.
class FrameKeeper {
 public:
  // Makes the folder.
  FrameKeeper(const std::filesystem::path& folder, std::size_t frames);

  void see_image(std::size_t index, const Frame& frame);  // from any thread, before the frame's result
  void add(const FrameResult& result, const Correspondences& shared);
  void finish(int width, int height, const Trajectory& truth) const;  // width, height: of the camera

 private:
  static constexpr std::size_t kKept = 48;
  bool is_kept(std::size_t index) const;

  std::filesystem::path folder_;
  std::size_t frames_;
  std::mutex mutex_;
  std::map<std::size_t, std::string> jpegs_;  // of frames on their way
  std::vector<MatchImage> kept_;              // without their JPEGs
  std::vector<bool> has_jpeg_;
};

// What a run kept; without it, nothing. Throws InputError for a file that cannot be read.
void read_kept_frames(const std::filesystem::path& folder, RunReport& report);

}  // namespace framewise::apps
