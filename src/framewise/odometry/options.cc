// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/odometry/options.h"

#include <initializer_list>
#include <stdexcept>
#include <utility>
#include <vector>

#include "framewise/odometry/input_image.h"

namespace framewise {
namespace {

constexpr std::pair<const char*, RelativePoseSolver> kBearingSolvers[] = {
    {"eight-point", RelativePoseSolver::kEightPoint},
    {"seven-point", RelativePoseSolver::kSevenPoint},
    {"nister-5pt", RelativePoseSolver::kNister5pt},
    {"stewenius-5pt", RelativePoseSolver::kStewenius5pt},
    {"kneip-5pt-rotation", RelativePoseSolver::kKneip5ptRotation},
    {"eigensolver", RelativePoseSolver::kEigensolver},
    {"two-point", RelativePoseSolver::kTwoPoint}};

template <typename Names>
void require_one_of(const char* option, const std::string& found, const Names& known) {
  std::string expected;
  for (const char* name : known) {
    if (found == name) return;
    expected += (expected.empty() ? "" : ", ") + std::string(name);
  }
  throw std::invalid_argument(std::string(option) + ": found '" + found + "', expected one of " + expected);
}

void require_one_of(const char* option, const std::string& found, std::initializer_list<const char*> known) {
  require_one_of<std::initializer_list<const char*>>(option, found, known);
}

void require(bool holds, const char* option, double found, const char* expected) {
  if (!holds)
    throw std::invalid_argument(std::string(option) + ": found " + std::to_string(found) + ", expected " +
                                expected);
}

}  // namespace

RelativePoseSolver OdometryOptions::relative_pose_solver() const {
  for (const auto& [name, relative_pose_solver] : kBearingSolvers)
    if (solver == name) return relative_pose_solver;
  throw std::invalid_argument("solver: found '" + solver + "', expected one that uses bearings");
}

InlierMeasure OdometryOptions::inlier_measure() const {
  if (error == "reprojection") return InlierMeasure::kReprojection;
  if (error == "bearing-euclidean") return InlierMeasure::kBearingEuclidean;
  return InlierMeasure::kSampson;
}

bool OdometryOptions::uses_surface_model() const {
  return geometry == "model" || (geometry == "auto" && is_made_of_depth(input) && is_metric());
}

bool OdometryOptions::uses_surfaces() const { return geometry == "frame" || uses_surface_model(); }

std::string OdometryOptions::matcher_for(const std::string& input_name) const {
  if (matcher != "auto" || input_name == "auto") return matcher;
  return is_made_of_depth(input_name) ? "windowed" : "brute-force";
}

void OdometryOptions::check_method() const {
  std::vector<const char*> solvers{"kabsch", "p3p"};
  for (const auto& [name, relative_pose_solver] : kBearingSolvers) solvers.push_back(name);
  solvers.push_back("opencv-essential");
  require_one_of("solver", solver, solvers);
  if (solver == "kabsch")
    require_one_of("error (with solver kabsch)", error, {"default", "point-to-point"});
  else if (solver == "p3p")
    require_one_of("error (with solver p3p)", error, {"default", "reprojection"});
  else if (solver == "opencv-essential")
    require_one_of("error (with solver opencv-essential)", error, {"default", "sampson"});
  else if (solver == "two-point")
    require_one_of("error (with solver two-point)", error, {"default", "sampson"});
  else
    require_one_of("error (with a solver that uses bearings)", error,
                   {"default", "sampson", "reprojection", "bearing-euclidean"});
  if (is_metric())
    require_one_of("scale (with a solver that uses depth)", scale, {"depth"});
  else
    require_one_of("scale", scale, {"depth", "centroid", "first-pair", "truth", "none"});
  if (solver == "opencv-essential")
    require_one_of("ransac (with solver opencv-essential)", ransac_scheme, {"on"});
  require_one_of("ransac", ransac_scheme, {"on", "two-stage", "off"});
  require_one_of("geometry", geometry, {"auto", "none", "frame", "model"});
  if (uses_surfaces() && !is_metric())
    throw std::invalid_argument("geometry: found '" + geometry + "' with solver " + solver +
                                ", expected none, or a solver that uses depth (kabsch, p3p)");
  require_one_of("refine", refine, {"covariance", "none"});
}

void OdometryOptions::check() const {
  require_one_of("reference", reference, {"frame", "map"});
  if (reference == "map")
    require_one_of("scale (with reference map)", scale, {"depth", "truth", "none"});
  else
    check_method();
  InputImage::check(input);
  require(keypoint_sigma_px > 0, "keypoint-sigma-px", keypoint_sigma_px, "more than 0");
  depth_noise.check();
  require_one_of("matcher", matcher, {"auto", "brute-force", "flann", "windowed", "klt"});
  require_one_of("subpixel", subpixel, {"align", "none"});
  require(max_error_m > 0, "max-error-m", max_error_m, "more than 0");
  require(max_error_px > 0, "max-error-px", max_error_px, "more than 0");
  require(max_error_rad > 0, "max-error-rad", max_error_rad, "more than 0");
  require(min_inliers >= 8, "min-inliers", min_inliers, "at least 8");
  require(max_bridge >= 0, "max-bridge", max_bridge, "at least 0");
  require(threads >= 0, "threads", threads, "0 (all cores) or more");
  features.check();
  match.check();
  track.check();
  depth.check();
  ransac.check();
  map.check();
}

}  // namespace framewise
