// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/report/run_page_data.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "framewise/report/html.h"
#include "framewise/report/page.h"

namespace framewise {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMostFrames = 1500;

// Evenly, from the first to the last.
std::vector<std::size_t> chosen_frames(const RunReport& report) {
  const std::size_t size = report.frames.size(), count = std::min(size, kMostFrames);
  std::set<std::size_t> chosen;
  for (std::size_t i = 0; i < count; ++i) chosen.insert(count > 1 ? i * (size - 1) / (count - 1) : 0);
  for (const MatchImage& image : report.images)
    if (image.index < size) chosen.insert(image.index);
  return {chosen.begin(), chosen.end()};
}

// Position, and quaternion x y z w; null where there is no pose of this time.
class Poses {
 public:
  explicit Poses(const Trajectory& trajectory) : trajectory_(trajectory) {}

  Json at(double time) {
    const auto& times = trajectory_.times;
    const auto found = std::lower_bound(times.begin(), times.end(), time - 1e-6);
    if (found == times.end() || *found > time + 1e-6) return nullptr;
    const Pose& pose = trajectory_.world_from_cam[static_cast<std::size_t>(found - times.begin())];
    const Eigen::Quaterniond q = pose.quaternion();
    Json numbers = Json::array();
    for (const double value : {pose.t.x(), pose.t.y(), pose.t.z()}) numbers.push_back(brief(value, 4));
    for (const double value : {q.x(), q.y(), q.z(), q.w()}) numbers.push_back(brief(value, 4));
    return numbers;
  }

 private:
  const Trajectory& trajectory_;
};

Json frames_json(const RunReport& report, const std::vector<std::size_t>& chosen) {
  Json frames = Json::array();
  const double start = first_time(report);
  Trajectory estimate = report.estimate;
  if (report.evaluation) estimate = transformed(report.evaluation->reference_from_estimate, estimate);
  Poses estimated(estimate), true_poses(report.truth);
  for (const std::size_t i : chosen) {
    const ReportedFrame& frame = report.frames[i];
    frames.push_back({{"index", i},
                      {"time", brief(frame.time - start, 4)},
                      {"status", frame.status},
                      {"matches", brief(frame.matches, 0)},
                      {"inliers", brief(frame.inliers, 0)},
                      {"parallax", brief(frame.parallax_deg, 3)},
                      {"estimate", estimated.at(frame.time)},
                      {"truth", true_poses.at(frame.time)}});
  }
  return frames;
}

// Five numbers a match: from, to (pixels), and whether it is an inlier.
Json images_json(const RunReport& report) {
  Json images = Json::array();
  for (const MatchImage& image : report.images) {
    Json matches = Json::array();
    for (const DrawnMatch& match : image.matches) {
      for (const float value : {match.x1, match.y1, match.x2, match.y2}) matches.push_back(brief(value, 0));
      matches.push_back(match.is_inlier ? 1 : 0);
    }
    images.push_back(
        {{"index", image.index},
         {"source", image.jpeg.empty() ? Json(nullptr) : Json(data_uri("image/jpeg", image.jpeg))},
         {"matches", std::move(matches)}});
  }
  return images;
}

}  // namespace

Json run_page_data(const RunReport& report) {
  return {{"kind", "run"},
          {"frames", frames_json(report, chosen_frames(report))},
          {"width", report.image_width},
          {"height", report.image_height},
          {"images", images_json(report)}};
}

}  // namespace framewise
