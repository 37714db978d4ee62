// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Matching two frames' descriptors: Framewise against OpenCV, in turns on one thread, and how many matches
// agree.
//   bench_matching [DATA [ROUNDS]]     DATA: a folder that holds tum_fr1_rpy_000_080 (default ../shared/data)
// Without DATA the descriptors are simulated: random ones, and copies of them with noise.
#include "framewise/features/matching.h"

#include <filesystem>
#include <memory>
#include <opencv2/features2d.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "framewise/features/matching_exact.h"
#include "framewise/features/tracking.h"
#include "framewise/features/tracking_corners.h"
#include "framewise/features/windowed_matching.h"
#include "interleaved.h"

namespace framewise::bench {
namespace {

struct Problem {
  std::string name;
  cv::Mat descriptors1, descriptors2;
  std::vector<cv::Point2f> pixels1, pixels2;

  bool is_binary() const { return descriptors1.type() == CV_8U; }
  int norm() const { return is_binary() ? cv::NORM_HAMMING : cv::NORM_L2; }
};

Problem simulated_bits(int rows, int bytes) {
  cv::RNG rng(1);
  Problem problem{"simulated bits, " + std::to_string(bytes) + " bytes", {}, {}, {}, {}};
  problem.descriptors1.create(rows, bytes, CV_8U);
  rng.fill(problem.descriptors1, cv::RNG::UNIFORM, 0, 256);
  cv::Mat noise1(rows, bytes, CV_8U), noise2(rows, bytes, CV_8U);
  rng.fill(noise1, cv::RNG::UNIFORM, 0, 256);
  rng.fill(noise2, cv::RNG::UNIFORM, 0, 256);
  problem.descriptors2 = problem.descriptors1 ^ (noise1 & noise2);
  cv::flip(problem.descriptors2, problem.descriptors2, 0);
  return problem;
}

// Unit vectors, as SURF's are.
Problem simulated_floats(int rows, int components) {
  cv::RNG rng(2);
  Problem problem{"simulated floats, " + std::to_string(components) + " components", {}, {}, {}, {}};
  cv::Mat d1(rows, components, CV_32F), noise(rows, components, CV_32F);
  rng.fill(d1, cv::RNG::NORMAL, 0, 1);
  rng.fill(noise, cv::RNG::NORMAL, 0, 0.3);
  cv::Mat d2 = d1 + noise;
  for (int i = 0; i < rows; ++i) {
    cv::normalize(d1.row(i), d1.row(i));
    cv::normalize(d2.row(i), d2.row(i));
  }
  cv::flip(d2, problem.descriptors2, 0);
  problem.descriptors1 = d1;
  return problem;
}

std::vector<cv::Point2f> pixels_of(const std::vector<cv::KeyPoint>& keypoints) {
  std::vector<cv::Point2f> pixels;
  cv::KeyPoint::convert(keypoints, pixels);
  return pixels;
}

Problem real(const std::string& name, cv::Ptr<cv::Feature2D> feature, const cv::Mat& gray1,
             const cv::Mat& gray2, int count) {
  Problem problem{name, {}, {}, {}, {}};
  const auto extract = [&](const cv::Mat& gray, cv::Mat& descriptors) {
    std::vector<cv::KeyPoint> keypoints;
    feature->detect(gray, keypoints);
    cv::KeyPointsFilter::retainBest(keypoints, count);
    feature->compute(gray, keypoints, descriptors);
    return pixels_of(keypoints);
  };
  problem.pixels1 = extract(gray1, problem.descriptors1);
  problem.pixels2 = extract(gray2, problem.descriptors2);
  return problem;
}

std::vector<FeatureMatch> exact(const Problem& p, Instructions instructions) {
  const DescriptorPair pair(p.descriptors1, p.descriptors2);
  return select_matches(pair.metric, exact_neighbours(pair, true, instructions), {});
}

std::vector<cv::DMatch> opencv_exact(const Problem& p) {
  std::vector<cv::DMatch> matches;
  cv::BFMatcher(p.norm(), true).match(p.descriptors1, p.descriptors2, matches);
  return matches;
}

std::vector<cv::DMatch> opencv_flann(const Problem& p) {
  cv::Ptr<cv::flann::IndexParams> index;
  if (p.is_binary())
    index = cv::makePtr<cv::flann::LshIndexParams>(6, 12, 1);
  else
    index = cv::makePtr<cv::flann::KDTreeIndexParams>(4);
  std::vector<std::vector<cv::DMatch>> two;
  cv::FlannBasedMatcher(index, cv::makePtr<cv::flann::SearchParams>(64))
      .knnMatch(p.descriptors1, p.descriptors2, two, 2);
  std::vector<cv::DMatch> matches;
  for (const auto& m : two)
    if (m.size() == 2 && m[0].distance < 0.8f * m[1].distance) matches.push_back(m[0]);
  return matches;
}

MatchOptions with_ratio(const std::string& matcher) {
  MatchOptions options;
  options.matcher = matcher;
  options.cross_check = false;
  options.max_ratio = 0.8;
  return options;
}

// Nearest neighbours that are not the only ones at their distance, seen from either side.
int count_ties(const cv::Mat& from, const cv::Mat& to, int norm) {
  std::vector<std::vector<cv::DMatch>> two;
  cv::BFMatcher(norm).knnMatch(from, to, two, 2);
  int ties = 0;
  for (const auto& m : two) ties += m.size() == 2 && m[0].distance == m[1].distance;
  return ties;
}

void print_agreement(const Problem& p) {
  const auto ours = exact(p, best_instructions()), plain = exact(p, Instructions::kPortable);
  const auto theirs = opencv_exact(p);
  std::size_t same = 0, same_plain = 0;
  for (const FeatureMatch& m : ours) {
    for (const cv::DMatch& o : theirs) same += o.queryIdx == m.index1 && o.trainIdx == m.index2;
    for (const FeatureMatch& o : plain)
      same_plain += o.index1 == m.index1 && o.index2 == m.index2 && o.distance == m.distance;
  }
  std::printf(
      "  matches: Framewise %zu, OpenCV %zu, both %zu; portable instructions %zu, same %zu; ties %d and %d\n",
      ours.size(), theirs.size(), same, plain.size(), same_plain,
      count_ties(p.descriptors1, p.descriptors2, p.norm()),
      count_ties(p.descriptors2, p.descriptors1, p.norm()));

  const auto all = match_features(p.descriptors1, p.descriptors2, with_ratio("brute-force"));
  const auto found = match_features(p.descriptors1, p.descriptors2, with_ratio("flann"));
  std::size_t right = 0;
  for (const FeatureMatch& m : found)
    for (const FeatureMatch& o : all) right += o.index1 == m.index1 && o.index2 == m.index2;
  std::printf("  ratio 0.8: exact %zu, FLANN %zu, of them exact ones %zu\n", all.size(), found.size(), right);
}

void race(const Problem& p, std::size_t rounds) {
  std::vector<Rival> rivals{
      {"Framewise, exact, cross-check",
       [&](std::size_t) { return match_brute_force(p.descriptors1, p.descriptors2).size(); }},
      {"Framewise, the same, portable instructions",
       [&](std::size_t) { return exact(p, Instructions::kPortable).size(); }},
      {"OpenCV BFMatcher, cross-check", [&](std::size_t) { return opencv_exact(p).size(); }},
      {"Framewise, exact, ratio 0.8",
       [&](std::size_t) {
         return match_features(p.descriptors1, p.descriptors2, with_ratio("brute-force")).size();
       }},
      {"Framewise, FLANN, ratio 0.8",
       [&](std::size_t) {
         return match_features(p.descriptors1, p.descriptors2, with_ratio("flann")).size();
       }},
      {"OpenCV FlannBasedMatcher, ratio 0.8", [&](std::size_t) { return opencv_flann(p).size(); }}};
  if (!p.pixels1.empty())
    rivals.push_back({"Framewise, windowed 40 px, cross-check", [&](std::size_t) {
                        return match_windowed(p.descriptors1, p.pixels1, p.descriptors2, p.pixels2).size();
                      }});
  print_race(
      p.name + ": " + std::to_string(p.descriptors1.rows) + " x " + std::to_string(p.descriptors2.rows),
      rivals, 1, rounds);
  print_agreement(p);
}

void race_tracking(const cv::Mat& gray1, const cv::Mat& gray2, std::size_t rounds) {
  const auto corners = detect_corners(gray1);
  const TrackedImage image1 = tracked_image(gray1), image2 = tracked_image(gray2);
  const Tracks tracks = track_points(image1, image2, corners);
  const std::vector<Rival> rivals{
      {"corners", [&](std::size_t) { return detect_corners(gray1).size(); }},
      {"one image's scales", [&](std::size_t) { return tracked_image(gray2).levels.size(); }},
      {"there and back, scales given",
       [&](std::size_t) { return track_points(image1, image2, corners).pixels.size(); }}};
  print_race("tracking, " + std::to_string(corners.size()) + " corners", rivals, 1, rounds);
  std::printf("  found: %zu\n", tracked_matches(corners, tracks).pixels1.size());
}

void race_real(const std::filesystem::path& data, std::size_t rounds) {
  std::vector<std::filesystem::path> images;
  for (const auto& entry : std::filesystem::directory_iterator(data / "tum_fr1_rpy_000_080" / "rgb"))
    images.push_back(entry.path());
  std::sort(images.begin(), images.end());
  const cv::Mat gray1 = cv::imread(images.at(30).string(), cv::IMREAD_GRAYSCALE);
  const cv::Mat gray2 = cv::imread(images.at(31).string(), cv::IMREAD_GRAYSCALE);
  race(real("ORB", cv::ORB::create(1000), gray1, gray2, 1000), rounds);
  race(real("AKAZE (61 bytes)", cv::AKAZE::create(cv::AKAZE::DESCRIPTOR_MLDB, 0, 3, 0.0003f), gray1, gray2,
            1000),
       rounds);
  race(real("SIFT (128 whole numbers)", cv::SIFT::create(0, 3, 0.01), gray1, gray2, 1000), rounds);
  race_tracking(gray1, gray2, rounds);
}

}  // namespace
}  // namespace framewise::bench

int main(int argc, char** argv) {
  using namespace framewise::bench;
  cv::setNumThreads(1);
  const std::filesystem::path data = argc > 1 ? argv[1] : "../shared/data";
  const std::size_t rounds = argc > 2 ? std::stoul(argv[2]) : 41;
  for (const int bytes : {32, 61}) race(simulated_bits(1000, bytes), rounds);
  for (const int components : {64, 128}) race(simulated_floats(1000, components), rounds);
  if (std::filesystem::exists(data / "tum_fr1_rpy_000_080"))
    race_real(data, rounds);
  else
    std::printf("No recording in %s: only simulated descriptors.\n", data.string().c_str());
}
