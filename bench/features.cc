// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Detectors and descriptors: how fast beside OpenCV's own, how often right, how often the same place again.
//   build/release/bench/bench_features [time | precision | pairs | repeatability | pose | all] [folder of
//   recordings]
// Judged on the simulated room and, where the folder has them, on tum_fr1_rpy_000_080 and
// 7scenes_redkitchen_000_150.
#include "framewise/features/features.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <functional>
#include <map>
#include <opencv2/features2d.hpp>
#include <thread>

#include "feature_views.h"
#include "framewise/features/feature_names.h"
#include "framewise/features/matching.h"
#include "framewise/features/patch_alignment.h"
#include "framewise/geometry/depth_noise.h"
#include "framewise/robust/registration.h"
#include "framewise/solvers/refine_registration.h"

namespace framewise::bench {
namespace {

constexpr int kCount = 1000;

double median(std::vector<double> values) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
  return values[values.size() / 2];
}

FeatureOptions options_of(const std::string& detector, const std::string& descriptor) {
  FeatureOptions options;
  options.detector = detector;
  options.descriptor = descriptor;
  options.count = kCount;
  return options;
}

std::vector<FeatureMatch> cross_checked(const Features& f1, const Features& f2) {
  return match_brute_force(f1.descriptors, f2.descriptors);
}

// ---- time ----

// Of the calling thread (ms): others at work on the machine hardly change it.
double cpu_ms() {
  timespec t;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return 1e3 * static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_nsec);
}

struct Contender {
  const char* name;
  std::function<double(std::size_t)> call;  // on image i
};

// Lower quartile of the CPU time (ms) of one call of each contender: they take turns on each image.
std::vector<double> cpu_ms_of(const std::vector<Contender>& contenders, std::size_t images, int rounds) {
  std::vector<double> sums(contenders.size(), 0);
  volatile double sink = 0;
  for (std::size_t i = 0; i < images; ++i) {
    std::vector<std::vector<double>> times(contenders.size());
    for (int round = 0; round < rounds; ++round)
      for (std::size_t k = 0; k < contenders.size(); ++k) {
        const double begin = cpu_ms();
        sink = sink + contenders[k].call(i);
        times[k].push_back(cpu_ms() - begin);
      }
    for (std::size_t k = 0; k < contenders.size(); ++k) {
      std::nth_element(times[k].begin(), times[k].begin() + rounds / 4, times[k].end());
      sums[k] += times[k][rounds / 4] / static_cast<double>(images);
    }
  }
  return sums;
}

// OpenCV's own, at the threshold that finds kCount in this image: what a user would tune by hand.
cv::Ptr<cv::Feature2D> tuned_peer(const std::string& name, const cv::Mat& gray) {
  if (name == "orb") return cv::ORB::create(kCount);
  const auto make = [&](double threshold) -> cv::Ptr<cv::Feature2D> {
    if (name == "sift") return cv::SIFT::create(kCount, 3, threshold);
    return cv::AKAZE::create(cv::AKAZE::DESCRIPTOR_MLDB, 0, 3, static_cast<float>(threshold));
  };
  double low = 1e-6, high = 0.1;
  for (int i = 0; i < 12; ++i) {
    const double middle = std::sqrt(low * high);
    std::vector<cv::KeyPoint> keypoints;
    make(middle)->detect(gray, keypoints);
    (keypoints.size() >= kCount ? low : high) = middle;
  }
  return make(low);
}

// Frames a second of OpenCV's own detection and description, one frame after the other on two threads.
double peer_rate(const std::vector<cv::Mat>& images, const std::vector<cv::Ptr<cv::Feature2D>>& peers) {
  cv::setNumThreads(2);
  double best = 0;
  for (int round = 0; round < 3; ++round) {
    const auto begin = std::chrono::steady_clock::now();
    for (std::size_t i = 0; i < images.size(); ++i) {
      std::vector<cv::KeyPoint> keypoints;
      cv::Mat descriptors;
      peers[i]->detectAndCompute(images[i], cv::noArray(), keypoints, descriptors);
    }
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    best = std::max(best, static_cast<double>(images.size()) / seconds);
  }
  cv::setNumThreads(1);
  return best;
}

// Frames a second with two frames in flight, each matched with the one before.
template <typename Extract>
double pipelined_rate(const std::vector<cv::Mat>& images, const Extract& extract) {
  constexpr int kThreads = 2, kRounds = 3;
  std::vector<Features> before;
  for (const cv::Mat& image : images) before.push_back(extract(image));
  double best = 0;
  for (int round = 0; round < kRounds; ++round) {
    const auto begin = std::chrono::steady_clock::now();
    std::vector<std::thread> threads;
    for (int t = 0; t < kThreads; ++t)
      threads.emplace_back([&, t] {
        for (std::size_t i = t; i < 2 * images.size(); i += kThreads) {
          const std::size_t k = i % images.size();
          cross_checked(before[(k + images.size() - 1) % images.size()], extract(images[k]));
        }
      });
    for (std::thread& thread : threads) thread.join();
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    best = std::max(best, 2 * images.size() / seconds);
  }
  return best;
}

void time_detector(const std::string& name, const std::vector<cv::Mat>& images) {
  const FeatureOptions options = options_of(name, name);
  const auto extract = [&](const cv::Mat& image) { return extract_features(image, options); };
  std::vector<Features> features;
  for (const cv::Mat& image : images) features.push_back(extract(image));
  std::size_t found = 0;
  for (const Features& f : features) found += f.keypoints.size();

  std::vector<Contender> contenders{
      {"detect + describe", [&](std::size_t i) { return extract(images[i]).keypoints.size() * 1.0; }},
      {"match", [&](std::size_t i) {
         return cross_checked(features[i], features[(i + 1) % features.size()]).size() * 1.0;
       }}};
  std::vector<cv::Ptr<cv::Feature2D>> peers;
  std::size_t peers_found = 0;
  if (name != "surf") {
    for (const cv::Mat& image : images) peers.push_back(tuned_peer(name, image));
    contenders.push_back({"OpenCV", [&](std::size_t i) {
                            std::vector<cv::KeyPoint> keypoints;
                            cv::Mat descriptors;
                            peers[i]->detectAndCompute(images[i], cv::noArray(), keypoints, descriptors);
                            peers_found += keypoints.size();
                            return static_cast<double>(descriptors.rows);
                          }});
  }
  constexpr int kRounds = 9;
  const auto ms = cpu_ms_of(contenders, images.size(), kRounds);
  std::printf("%-6s %5zu %9.2f %9.2f", name.c_str(), found / images.size(), ms[0], ms[1]);
  if (peers.empty())
    std::printf(" %9s %9s %9s %9s", "-", "-", "-", "-");
  else
    std::printf(" %9zu %9.2f %9.3f %9.3f", peers_found / (images.size() * kRounds), ms[2], ms[0] / ms[2],
                (ms[0] + ms[1]) / ms[2]);
  std::printf(" %9.0f", pipelined_rate(images, extract));
  if (!peers.empty()) std::printf(" %9.0f", peer_rate(images, peers));
  std::printf("\n");
}

void time_all(const std::vector<Views>& sets) {
  cv::setNumThreads(1);
  for (const Views& set : sets) {
    std::vector<cv::Mat> images;
    for (std::size_t i = 0; i < 6; ++i) images.push_back(set.views[i * (set.views.size() - 1) / 5].gray);
    std::printf("\n%s, %dx%d, %d keypoints asked for; CPU ms a frame, lower quartile, in turns\n",
                set.name.c_str(), images[0].cols, images[0].rows, kCount);
    std::printf("%-6s %5s %9s %9s %9s %9s %9s %9s %9s %9s\n", "", "found", "features", "match", "OpenCV's",
                "OpenCV", "ratio", "+ match", "frames/s", "OpenCV");
    for (const std::string& name : detector_names()) time_detector(name, images);
  }
  std::printf(
      "features: detect + describe; OpenCV: the same at a threshold tuned by hand for each image; ratio: "
      "features\n"
      "to OpenCV, without and with match; frames/s: all three, two frames in flight on two threads;\n"
      "OpenCV frames/s: detect + describe alone, one frame at a time on two threads\n");
  cv::setNumThreads(-1);
}

// ---- precision ----

struct Judged {
  int right = 0, judged = 0;
  std::vector<std::pair<double, double>> errors_by_scale;  // scale, error (px) of right ones

  double precision() const { return 100.0 * right / std::max(1, judged); }
};

void judge(const Views& set, std::size_t i1, std::size_t i2, const Features& f1, const Features& f2,
           Judged& judged) {
  constexpr double kRight = 3;  // pixels
  for (const FeatureMatch& match : cross_checked(f1, f2)) {
    const auto expected = set.seen_in(i1, f1.keypoints[match.index1].pt, i2);
    if (!expected) continue;
    const cv::Point2f found = f2.keypoints[match.index2].pt;
    const double error = (Eigen::Vector2d(found.x, found.y) - *expected).norm();
    ++judged.judged;
    if (error >= kRight) continue;
    ++judged.right;
    judged.errors_by_scale.emplace_back(f1.scale(match.index1), error);
  }
}

// Pairs of views so many frames apart, evenly over the recording.
std::vector<std::pair<std::size_t, std::size_t>> pairs_apart(const Views& set, std::size_t apart, int count) {
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  const std::size_t last = set.views.size() - 1 - apart;
  for (int k = 0; k < count; ++k) {
    const std::size_t i = k * last / std::max(1, count - 1);
    pairs.emplace_back(i, i + apart);
  }
  return pairs;
}

Judged judge_all(const Views& set, std::size_t apart, int pairs, const FeatureOptions& options) {
  Judged judged;
  std::map<std::size_t, Features> features;
  const auto of = [&](std::size_t i) -> const Features& {
    if (!features.count(i)) features[i] = extract_features(set.views[i].gray, options);
    return features[i];
  };
  for (const auto& [i1, i2] : pairs_apart(set, apart, pairs)) judge(set, i1, i2, of(i1), of(i2), judged);
  return judged;
}

void precision_all(const std::vector<Views>& sets) {
  constexpr int kPairs = 20;
  struct Row {
    const char *detector, *descriptor;
    bool upright;
  };
  for (const Views& set : sets)
    for (const std::size_t apart : {5, 15, 30}) {
      std::printf("\n%s, %d pairs %zu frames apart: matches within 3 px of the truth\n", set.name.c_str(),
                  kPairs, apart);
      for (const Row& row :
           {Row{"sift", "sift", false}, Row{"surf", "surf", false}, Row{"surf", "surf-128", false},
            Row{"surf", "surf", true}, Row{"orb", "orb", false}, Row{"akaze", "akaze", false}}) {
        FeatureOptions options = options_of(row.detector, row.descriptor);
        options.upright = row.upright;
        const Judged judged = judge_all(set, apart, kPairs, options);
        std::vector<double> fine, coarse;
        for (const auto& [scale, error] : judged.errors_by_scale)
          (scale < 1.5 ? fine : coarse).push_back(error);
        std::printf(
            "  %-6s %-9s%-8s precision %5.1f %%  right %5.0f a pair  median error %.2f px, coarse %.2f\n",
            row.detector, row.descriptor, row.upright ? " upright" : "", judged.precision(),
            judged.right / static_cast<double>(kPairs), median(fine), median(coarse));
      }
    }
}

void pairs_all(const std::vector<Views>& sets) {
  for (const Views& set : sets) {
    std::printf("\n%s, 10 pairs 5 frames apart: precision (%%) / right matches a pair\n%-10s",
                set.name.c_str(), "detector");
    for (const std::string& descriptor : descriptor_names()) std::printf(" %14s", descriptor.c_str());
    for (const std::string& detector : detector_names()) {
      std::printf("\n%-10s", detector.c_str());
      for (const std::string& descriptor : descriptor_names()) {
        const Judged judged = judge_all(set, 5, 10, options_of(detector, descriptor));
        std::printf("   %5.1f / %4.0f", judged.precision(), judged.right / 10.0);
        std::fflush(stdout);
      }
    }
    std::printf("\n");
  }
}

// ---- repeatability ----

// image 2 = image 1 turned about its centre and shrunk.
struct Warp {
  cv::Matx23d to_2;
  cv::Mat image;

  cv::Point2d operator()(const cv::Point2f& p) const {
    return {to_2(0, 0) * p.x + to_2(0, 1) * p.y + to_2(0, 2),
            to_2(1, 0) * p.x + to_2(1, 1) * p.y + to_2(1, 2)};
  }
};

Warp warped(const cv::Mat& gray, double shrink, double degrees) {
  const cv::Point2f center((gray.cols - 1) / 2.0f, (gray.rows - 1) / 2.0f);
  cv::Mat to_2 = cv::getRotationMatrix2D(center, degrees, 1 / shrink), blurred = gray;
  // What the smaller image cannot show goes first.
  if (shrink > 1) cv::GaussianBlur(gray, blurred, cv::Size(), 0.5 * std::sqrt(shrink * shrink - 1));
  Warp warp{cv::Matx23d(to_2.ptr<double>()), {}};
  cv::warpAffine(blurred, warp.image, to_2, gray.size(), cv::INTER_CUBIC, cv::BORDER_REFLECT_101);
  return warp;
}

struct Repeated {
  double repeatability, precision;
};

Repeated repeated(const cv::Mat& gray, const Warp& warp, const FeatureOptions& options) {
  constexpr double kNear = 2;  // pixels of image 2
  const Features f1 = extract_features(gray, options), f2 = extract_features(warp.image, options);
  const cv::Rect2d inside(20, 20, gray.cols - 40, gray.rows - 40);
  const cv::Matx33d to_2(warp.to_2(0, 0), warp.to_2(0, 1), warp.to_2(0, 2), warp.to_2(1, 0), warp.to_2(1, 1),
                         warp.to_2(1, 2), 0, 0, 1);
  const cv::Matx33d to_1 = to_2.inv();
  std::vector<cv::Point2d> seen1, seen2;  // in image 2, what both images show
  for (const cv::KeyPoint& k1 : f1.keypoints)
    if (inside.contains(warp(k1.pt))) seen1.push_back(warp(k1.pt));
  for (const cv::KeyPoint& k2 : f2.keypoints) {
    const cv::Vec3d back = to_1 * cv::Vec3d(k2.pt.x, k2.pt.y, 1);
    if (inside.contains(cv::Point2d(back[0], back[1]))) seen2.push_back(k2.pt);
  }
  const auto nearest = [](const cv::Point2d& p, const std::vector<cv::Point2d>& points) {
    return std::min_element(points.begin(), points.end(),
                            [&](const cv::Point2d& a, const cv::Point2d& b) {
                              return cv::norm(a - p) < cv::norm(b - p);
                            }) -
           points.begin();
  };
  // Each is the other's nearest.
  int again = 0, right = 0, judged = 0;
  for (const cv::Point2d& p1 : seen1) {
    if (seen2.empty()) break;
    const cv::Point2d& p2 = seen2[nearest(p1, seen2)];
    again += cv::norm(p1 - p2) <= kNear && seen1[nearest(p2, seen1)] == p1;
  }
  for (const FeatureMatch& match : cross_checked(f1, f2)) {
    const cv::Point2d there = warp(f1.keypoints[match.index1].pt);
    if (!inside.contains(there)) continue;
    ++judged;
    right += cv::norm(cv::Point2d(f2.keypoints[match.index2].pt) - there) <= 3;
  }
  const std::size_t possible = std::max<std::size_t>(1, std::min(seen1.size(), seen2.size()));
  return {100.0 * again / static_cast<double>(possible), 100.0 * right / std::max(1, judged)};
}

void repeatability_all(const std::vector<Views>& sets) {
  const std::vector<double> scales{1, 1.25, 1.5, 1.75, 2}, turns{0, 15, 30, 45, 90, 135, 180};
  for (const Views& set : sets) {
    const cv::Mat& gray = set.views.front().gray;
    std::printf(
        "\n%s, first image: repeatability within 2 px (%%) / precision of matches within 3 px (%%)\n%-8s",
        set.name.c_str(), "");
    for (const double scale : scales) std::printf("   x %-8.2f", scale);
    for (const double turn : turns) std::printf("   %3.0f deg    ", turn);
    for (const std::string& name : detector_names()) {
      std::printf("\n%-8s", name.c_str());
      const FeatureOptions options = options_of(name, name);
      const auto show = [&](double shrink, double degrees) {
        const Repeated r = repeated(gray, warped(gray, shrink, degrees), options);
        std::printf(" %5.1f /%5.1f", r.repeatability, r.precision);
      };
      for (const double scale : scales) show(scale, 20);
      for (const double turn : turns) show(1.1, turn);
    }
    std::printf("\nscales are turned by 20 degrees, turns shrunk by 1.1\n");
  }
}

// ---- pose ----

struct PoseErrors {
  std::vector<double> rotation_deg, translation_mm;
  int lost = 0;
};

struct Clouds {
  std::vector<Eigen::Vector3d> X1, X2;
  std::vector<Eigen::Matrix3d> S1, S2;
};

// Matches with depth in both views, as the odometry weighs them.
Clouds clouds_of(const Views& set, std::size_t i1, std::size_t i2, const Features& f1, const Features& f2,
                 bool align) {
  constexpr double kSigmaPx = 0.25;
  const DepthNoise noise;
  std::vector<cv::Point2f> pixels1, pixels2;
  const auto matches = cross_checked(f1, f2);
  for (const FeatureMatch& m : matches) {
    pixels1.push_back(f1.keypoints[m.index1].pt);
    pixels2.push_back(f2.keypoints[m.index2].pt);
  }
  if (align) align_patches(set.views[i1].gray, set.views[i2].gray, pixels1, pixels2);

  Clouds clouds;
  const auto point = [&](std::size_t view, const cv::Point2f& pixel) -> std::optional<Eigen::Vector3d> {
    const Eigen::Vector2d p(pixel.x, pixel.y);
    const auto bearing = set.camera.bearing(p);
    const auto z = depth_at(set.views[view].depth, p, {});
    if (!bearing || !z) return std::nullopt;
    return point_at_depth(*bearing, *z);
  };
  for (std::size_t k = 0; k < matches.size(); ++k) {
    const auto X1 = point(i1, pixels1[k]), X2 = point(i2, pixels2[k]);
    if (!X1 || !X2) continue;
    const double sigma = kSigmaPx / set.camera.fx;
    clouds.X1.push_back(*X1), clouds.X2.push_back(*X2);
    clouds.S1.push_back(
        point_covariance(*X1, X1->z(), sigma * f1.scale(matches[k].index1), noise.sigma(X1->z())));
    clouds.S2.push_back(
        point_covariance(*X2, X2->z(), sigma * f2.scale(matches[k].index2), noise.sigma(X2->z())));
  }
  return clouds;
}

std::optional<Pose> pose_of(const Clouds& clouds) {
  if (clouds.X1.size() < 12) return std::nullopt;
  RegistrationOptions options;
  options.max_error = 0.08;
  const auto estimate = estimate_registration(clouds.X1, clouds.X2, options);
  if (!estimate) return std::nullopt;
  Clouds inliers;
  for (std::size_t i = 0; i < clouds.X1.size(); ++i)
    if (estimate->inliers[i]) {
      inliers.X1.push_back(clouds.X1[i]), inliers.X2.push_back(clouds.X2[i]);
      inliers.S1.push_back(clouds.S1[i]), inliers.S2.push_back(clouds.S2[i]);
    }
  RefineOptions refine;
  refine.loss = {Loss::kCauchy, 2.0};
  return refine_registration(estimate->cam2_from_cam1, inliers.X1, inliers.S1, inliers.X2, inliers.S2, refine)
      .pose;
}

PoseErrors pose_errors(const Views& set, const FeatureOptions& options, bool align) {
  constexpr int kPairs = 30;
  PoseErrors errors;
  for (const auto& [i1, i2] : pairs_apart(set, 1, kPairs)) {
    const Features f1 = extract_features(set.views[i1].gray, options);
    const Features f2 = extract_features(set.views[i2].gray, options);
    const auto pose = pose_of(clouds_of(set, i1, i2, f1, f2, align));
    if (!pose) {
      ++errors.lost;
      continue;
    }
    const Pose truth = set.cam2_from_cam1(i1, i2);
    errors.rotation_deg.push_back(Eigen::AngleAxisd(pose->R * truth.R.transpose()).angle() * 180 / M_PI);
    errors.translation_mm.push_back(1e3 * (pose->t - truth.t).norm());
  }
  return errors;
}

void pose_all(const std::vector<Views>& sets) {
  struct Row {
    const char *detector, *spread;
    bool align;
  };
  for (const Views& set : sets) {
    std::printf("\n%s, neighbours: error of the pose by depth (3D-3D), median\n", set.name.c_str());
    for (const Row& row :
         {Row{"orb", "none", false}, Row{"orb", "none", true}, Row{"orb", "grid", true},
          Row{"orb", "anms", true}, Row{"akaze", "none", false}, Row{"akaze", "none", true},
          Row{"sift", "none", false}, Row{"surf", "none", false}, Row{"surf", "none", true}}) {
      FeatureOptions options = options_of(row.detector, row.detector);
      options.spread = row.spread;
      const PoseErrors errors = pose_errors(set, options, row.align);
      std::printf("  %-6s spread %-5s %-8s %.4f deg  %.3f mm  %d lost\n", row.detector, row.spread,
                  row.align ? "aligned" : "as found", median(errors.rotation_deg),
                  median(errors.translation_mm), errors.lost);
    }
  }
}

}  // namespace
}  // namespace framewise::bench

int main(int argc, char** argv) {
  using namespace framewise::bench;
  std::setvbuf(stdout, nullptr, _IOLBF, 0);
  const std::string mode = argc > 1 ? argv[1] : "all";
  const auto sets = all_views(argc > 2 ? argv[2] : "../shared/data");
  const auto wanted = [&](const char* name) { return mode == name || mode == "all"; };
  if (wanted("time")) time_all(sets);
  if (wanted("precision")) precision_all(sets);
  if (wanted("pairs")) pairs_all(sets);
  if (wanted("repeatability")) repeatability_all(sets);
  if (wanted("pose")) pose_all(sets);
}
