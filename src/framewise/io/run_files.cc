// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/io/run_files.h"

#include <fmt/format.h>

#include <cmath>

#include "framewise/io/output_file.h"

namespace framewise {
namespace {

namespace fs = std::filesystem;

// x y z and the quaternion x y z w, shortest decimals that read back as the same numbers.
std::string numbers(const Pose& pose, char separator) {
  const Eigen::Quaterniond q = pose.quaternion();
  return fmt::format("{1}{0}{2}{0}{3}{0}{4}{0}{5}{0}{6}{0}{7}", separator, pose.t.x(), pose.t.y(), pose.t.z(),
                     q.x(), q.y(), q.z(), q.w());
}

constexpr const char* kTangent[] = {"rx", "ry", "rz", "tx", "ty", "tz"};

// cov_rx_rx, cov_rx_ry, ... cov_tz_tz: the upper triangle, row by row.
std::string covariance_header() {
  std::string header;
  for (int i = 0; i < 6; ++i)
    for (int j = i; j < 6; ++j) header += fmt::format(",cov_{}_{}", kTangent[i], kTangent[j]);
  return header;
}

// Empty fields where a number is not known.
std::string covariance_fields(const Matrix6d& covariance) {
  std::string fields;
  for (int i = 0; i < 6; ++i)
    for (int j = i; j < 6; ++j)
      fields += std::isfinite(covariance(i, j)) ? fmt::format(",{:.6g}", covariance(i, j)) : ",";
  return fields;
}

}  // namespace

RunFiles::RunFiles(const fs::path& folder) : folder_(folder) {
  make_output_folder(folder, "--out");
  trajectory_ = open_output_file(folder / "trajectory.tum", "--out");
  frames_ = open_output_file(folder / "frames.csv", "--out");
  trajectory_ << "# time tx ty tz qx qy qz qw (s, m; world_from_camera, world = the first camera)\n";
  frames_ << "index,time,status,matches,inliers,step_tx,step_ty,step_tz,step_qx,step_qy,step_qz,step_qw,"
             "load_ms,features_ms,match_ms,step_ms,parallax_deg,refine_ms,overlap,free_directions,input"
          << covariance_header() << '\n';
}

void RunFiles::add(const FrameLine& line) {
  trajectory_ << fmt::format("{} {}\n", line.time, numbers(line.world_from_cam, ' '));
  frames_ << fmt::format("{},{},{},{},{},{},{:.3f},{:.3f},{:.3f},{:.3f},{},{:.3f},{},{},{}{}\n", line.index,
                         line.time, line.status, line.matches, line.inliers,
                         line.has_step ? numbers(line.cam1_from_cam2, ',') : ",,,,,,", line.load_ms,
                         line.features_ms, line.match_ms, line.step_ms,
                         std::isfinite(line.parallax_deg) ? fmt::format("{:.6g}", line.parallax_deg) : "",
                         line.refine_ms, std::isnan(line.overlap) ? "" : fmt::format("{:.3f}", line.overlap),
                         line.free_directions.empty() ? "" : '"' + line.free_directions + '"', line.input,
                         covariance_fields(line.covariance));
  if (!trajectory_ || !frames_)
    throw std::runtime_error(folder_.string() + ": writing failed (is the disk full?)");
}

void RunFiles::write_record(const std::string& json) {
  trajectory_.flush();
  frames_.flush();
  const fs::path path = folder_ / "run.json", unfinished = folder_ / "run.json.part";
  open_output_file(unfinished, "--out") << json << '\n';
  fs::rename(unfinished, path);
}

}  // namespace framewise
