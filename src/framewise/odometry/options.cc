// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/odometry/options.h"

#include <initializer_list>
#include <stdexcept>

namespace framewise {
namespace {

void require_one_of(const char* option, const std::string& found, std::initializer_list<const char*> known) {
  std::string expected;
  for (const char* name : known) {
    if (found == name) return;
    expected += (expected.empty() ? "" : ", ") + std::string(name);
  }
  throw std::invalid_argument(std::string(option) + ": found '" + found + "', expected one of " + expected);
}

void require(bool holds, const char* option, double found, const char* expected) {
  if (!holds)
    throw std::invalid_argument(std::string(option) + ": found " + std::to_string(found) + ", expected " +
                                expected);
}

}  // namespace

void OdometryOptions::check() const {
  require_one_of("solver", solver, {"kabsch", "eight-point"});
  if (solver == "kabsch")
    require_one_of("error (with solver kabsch)", error, {"default", "point-to-point"});
  else
    require_one_of("error (with solver eight-point)", error, {"default", "sampson"});
  if (solver == "kabsch")
    require_one_of("scale (with solver kabsch, which is metric)", scale, {"depth"});
  else
    require_one_of("scale", scale, {"depth", "truth", "none"});
  require_one_of("refine", refine, {"covariance", "none"});
  require(keypoint_sigma_px > 0, "keypoint-sigma-px", keypoint_sigma_px, "more than 0");
  depth_noise.check();
  require_one_of("matcher", matcher, {"brute-force"});
  require(max_error_m > 0, "max-error-m", max_error_m, "more than 0");
  require(max_error_px > 0, "max-error-px", max_error_px, "more than 0");
  require(min_inliers >= 8, "min-inliers", min_inliers, "at least 8");
  require(max_bridge >= 0, "max-bridge", max_bridge, "at least 0");
  require(threads >= 0, "threads", threads, "0 (all cores) or more");
  features.check();
  depth.check();
  ransac.check();
}

}  // namespace framewise
