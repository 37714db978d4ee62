// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "frame_keeper.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <sstream>

#include "framewise/evaluation/statistics.h"
#include "framewise/geometry/triangulation.h"
#include "framewise/io/input_error.h"
#include "framewise/io/output_file.h"
#include "framewise/io/trajectory_files.h"

namespace framewise::apps {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr int kImageWidth = 320, kJpegQuality = 70;
constexpr std::size_t kMostMatches = 250;  // of a frame; more are a carpet in so small an image
constexpr double kFarDepth = 5;            // white in images of depth alone (m)

cv::Mat image_of(const Frame& frame) {
  if (!frame.color.empty()) return frame.color;
  if (!frame.gray.empty() || frame.depth.empty()) return frame.gray;
  cv::Mat depth;
  frame.depth.convertTo(depth, CV_8U, 255 / kFarDepth);
  return depth;
}

std::string small_jpeg(const cv::Mat& image) {
  cv::Mat small = image;
  if (image.cols > kImageWidth)
    cv::resize(image, small, {kImageWidth, std::max(1, image.rows * kImageWidth / image.cols)}, 0, 0,
               cv::INTER_AREA);
  std::vector<unsigned char> bytes;
  cv::imencode(".jpg", small, bytes, {cv::IMWRITE_JPEG_QUALITY, kJpegQuality});
  return {bytes.begin(), bytes.end()};
}

// Evenly of all, so that the share of inliers stays.
std::vector<DrawnMatch> drawn_matches(const Step& step, const Correspondences& shared) {
  std::vector<DrawnMatch> drawn;
  const std::size_t count = std::min(shared.pixels1.size(), kMostMatches);
  const bool is_judged = step.inlier_mask.size() == shared.size();
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t i = k * shared.pixels1.size() / count;
    const auto from = shared.pixels1[i].cast<float>(), to = shared.pixels2[i].cast<float>();
    drawn.push_back({from.x(), from.y(), to.x(), to.y(), is_judged && step.inlier_mask[i] != 0});
  }
  return drawn;
}

std::string jpeg_name(std::size_t index) { return fmt::format("{:06}.jpg", index); }

}  // namespace

void PairsInFlight::see(std::size_t index2, const Correspondences& shared) {
  const std::lock_guard lock(mutex_);
  pairs_[index2].push_back(shared);
}

// After a loss a frame has a second pair, with the last good one: then its step is of the second.
Correspondences PairsInFlight::take(const FrameResult& result) {
  const std::lock_guard lock(mutex_);
  Correspondences taken;
  if (const auto found = pairs_.find(result.index); found != pairs_.end()) {
    for (Correspondences& shared : found->second)
      if (taken.size() == 0 || shared.size() == static_cast<std::size_t>(result.step.matches))
        taken = std::move(shared);
  }
  pairs_.erase(pairs_.begin(), pairs_.upper_bound(result.index));
  return taken;
}

double parallax_deg(const Step& step, const Correspondences& shared) {
  std::vector<double> angles;
  if (is_measured(step.status) && step.inlier_mask.size() == shared.size())
    for (std::size_t i = 0; i < shared.size(); ++i)
      if (step.inlier_mask[i] != 0)
        angles.push_back(parallax(step.cam2_from_cam1.R, shared.x1[i], shared.x2[i]));
  if (angles.empty()) return std::numeric_limits<double>::quiet_NaN();
  return median(angles) * 180 / CV_PI;
}

FrameKeeper::FrameKeeper(const fs::path& folder, std::size_t frames) : folder_(folder), frames_(frames) {
  make_output_folder(folder, "--out");
}

bool FrameKeeper::is_kept(std::size_t index) const {
  if (frames_ <= kKept) return true;
  // Kept are the frames k (frames - 1) / (kKept - 1), rounded down.
  const std::size_t k = (index * (kKept - 1) + frames_ - 2) / (frames_ - 1);
  return k * (frames_ - 1) / (kKept - 1) == index;
}

void FrameKeeper::see_image(std::size_t index, const Frame& frame) {
  if (!is_kept(index)) return;
  const cv::Mat image = image_of(frame);
  if (image.empty()) return;
  std::string jpeg = small_jpeg(image);
  const std::lock_guard lock(mutex_);
  jpegs_[index] = std::move(jpeg);
}

void FrameKeeper::add(const FrameResult& result, const Correspondences& shared) {
  if (!is_kept(result.index)) return;
  kept_.push_back({result.index, "", drawn_matches(result.step, shared)});
  const std::lock_guard lock(mutex_);
  const auto jpeg = jpegs_.find(result.index);
  has_jpeg_.push_back(jpeg != jpegs_.end());
  if (jpeg == jpegs_.end()) return;
  open_output_file(folder_ / jpeg_name(result.index), "--out") << jpeg->second;
  jpegs_.erase(jpeg);
}

void FrameKeeper::finish(int width, int height, const Trajectory& truth) const {
  if (!truth.empty()) write_tum_trajectory(folder_ / "truth.tum", truth);
  Json frames = Json::array();
  const auto tenths = [](float value) { return std::round(value * 10.0) / 10; };
  for (std::size_t i = 0; i < kept_.size(); ++i) {
    Json matches = Json::array();
    for (const DrawnMatch& m : kept_[i].matches)
      matches.push_back({tenths(m.x1), tenths(m.y1), tenths(m.x2), tenths(m.y2), m.is_inlier ? 1 : 0});
    frames.push_back({{"index", kept_[i].index},
                      {"image", has_jpeg_[i] ? Json(jpeg_name(kept_[i].index)) : Json(nullptr)},
                      {"matches", std::move(matches)}});
  }
  const Json all = {{"width", width}, {"height", height}, {"frames", std::move(frames)}};
  open_output_file(folder_ / "frames.json", "--out") << all.dump() << '\n';
}

namespace {

std::string bytes_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw InputError(path, 0, "", "no file that can be read", "the image that frames.json names");
  std::ostringstream bytes;
  bytes << file.rdbuf();
  return bytes.str();
}

MatchImage kept_frame(const Json& frame, const fs::path& folder) {
  MatchImage image;
  image.index = frame.at("index").get<std::size_t>();
  // A name alone: nothing outside the folder is read.
  if (!frame.at("image").is_null())
    image.jpeg = bytes_of(folder / fs::path(frame.at("image").get<std::string>()).filename());
  for (const Json& m : frame.at("matches"))
    image.matches.push_back({m.at(0).get<float>(), m.at(1).get<float>(), m.at(2).get<float>(),
                             m.at(3).get<float>(), m.at(4).get<int>() != 0});
  return image;
}

}  // namespace

void read_kept_frames(const fs::path& folder, RunReport& report) {
  const fs::path path = folder / "frames.json";
  if (!fs::exists(path)) return;
  try {
    const Json all = Json::parse(bytes_of(path));
    report.image_width = all.at("width").get<int>();
    report.image_height = all.at("height").get<int>();
    for (const Json& frame : all.at("frames")) report.images.push_back(kept_frame(frame, folder));
  } catch (const Json::exception& error) {
    throw InputError(path, 0, "", error.what(), "what `run` wrote there");
  }
}

}  // namespace framewise::apps
