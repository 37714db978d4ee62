// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What evo 1.36.5, the TUM RGB-D benchmark's tools and the KITTI devkit printed, with the commands as typed.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "framewise/evaluation/kitti_segments.h"
#include "framewise/io/trajectory_files.h"
#include "framewise/report/evo_labels.h"
#include "golden_commands.h"

namespace framewise {
namespace {

using Json = nlohmann::json;
namespace fs = std::filesystem;

// Many records are made of the same few files.
const Trajectory& read_once(const fs::path& path) {
  static std::map<fs::path, Trajectory> files;
  if (!files.contains(path)) files[path] = read_trajectory(path).trajectory;
  return files.at(path);
}

double field(const Statistics& s, const std::string& name) {
  return testing::known<double>({{"rmse", s.rmse},
                                 {"mean", s.mean},
                                 {"median", s.median},
                                 {"std", s.std},
                                 {"min", s.min},
                                 {"max", s.max},
                                 {"sse", s.sse}},
                                name);
}

// A record that says more than is compared here is not understood.
void expect_keys(const Json& record, const std::set<std::string>& known) {
  for (const auto& item : record.items()) EXPECT_TRUE(known.contains(item.key())) << item.key();
}

// Figures below `floor` are rounding of the tool itself.
void expect_relative(double ours, double theirs, const std::string& what, double floor) {
  EXPECT_LE(std::abs(ours - theirs), 1e-9 * std::abs(theirs) + floor)
      << what << ": " << ours << " " << theirs;
}

// evo records the whole similarity, also where it corrects the scale alone.
void expect_similarity(const fs::path& folder, const testing::EvoCommand& command, const Json& expected) {
  EvaluationOptions options = command.options;
  if (options.alignment == Alignment::kScale) options.alignment = Alignment::kSim3;
  const Evaluation e =
      evaluate(read_once(folder / command.reference), read_once(folder / command.estimate), options);
  const Similarity& found = e.reference_from_estimate;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 4; ++j)
      expect_relative(j < 3 ? found.scale * found.pose.R(i, j) : found.pose.t[i], expected[i][j], "alignment",
                      1e-9);
}

void expect_evo(const fs::path& folder, const Json& record) {
  const std::string line = record.at("command");
  SCOPED_TRACE(line);
  expect_keys(record, {"command", "stats", "title", "label", "count", "first3", "last", "alignment_sim3"});
  const testing::EvoCommand command = testing::evo_command(line);
  const Evaluation e =
      evaluate(read_once(folder / command.reference), read_once(folder / command.estimate), command.options);
  std::vector<double> errors = errors_of(e, command.metric).values;
  if (command.radians)
    for (double& error : errors) error *= M_PI / 180;

  ASSERT_EQ(errors.size(), record.at("count").get<std::size_t>());
  const Statistics s = statistics(errors);
  ASSERT_EQ(record.at("stats").size(), 7u);
  for (const auto& [name, value] : record.at("stats").items())
    expect_relative(field(s, name), value, name, 1e-12);
  ASSERT_EQ(record.at("first3").size(), std::min<std::size_t>(errors.size(), 3));
  for (std::size_t i = 0; i < record.at("first3").size(); ++i)
    expect_relative(errors[i], record["first3"][i], "error " + std::to_string(i), 1e-12);
  expect_relative(errors.back(), record.at("last"), "last error", 1e-12);
  if (record.contains("alignment_sim3")) expect_similarity(folder, command, record["alignment_sim3"]);
  // Our results are in degrees, and their titles say so. Records of another program's making have no titles.
  if (command.radians || !record.contains("title")) return;
  EXPECT_EQ(evo_labels(e, command.metric).title, record["title"].get<std::string>());
  EXPECT_EQ(evo_labels(e, command.metric).label, record.at("label").get<std::string>());
}

// The tools print six digits after the point.
void expect_printed(double ours, double theirs, const std::string& what) {
  EXPECT_LE(std::abs(ours - theirs), 0.5000001e-6) << what << ": " << ours << " " << theirs;
}

void expect_tum(const fs::path& folder, const Json& record) {
  const std::string line = record.at("command");
  SCOPED_TRACE(line);
  expect_keys(record, {"command", "output"});
  const testing::TumCommand command = testing::tum_command(line);
  ASSERT_FALSE(command.random_pairs);
  const Evaluation e =
      evaluate(read_once(folder / command.reference), read_once(folder / command.estimate), command.options);
  ASSERT_TRUE(e.rpe);
  ASSERT_EQ(record.at("output").size(), command.relative ? 13u : 7u);
  for (const auto& [name, value] : record.at("output").items()) {
    const std::string what = name.substr(0, name.find('.')), figure = name.substr(name.find('.') + 1);
    if (name == "compared_pose_pairs")
      EXPECT_EQ(command.relative ? e.motions.size() : e.matched, value.get<std::size_t>());
    else if (what == "absolute_translational_error")
      expect_printed(field(e.ate, figure), value, name);
    else if (what == "translational_error")
      expect_printed(field(e.rpe->translation, figure), value, name);
    else if (what == "rotational_error")
      expect_printed(field(e.rpe->rotation_deg, figure), value, name);
    else
      FAIL() << name;
  }
}

// The devkit prints nine digits: half of the last one, and what a double adds.
void expect_nine_digits(double ours, const Json& expected, const std::string& what) {
  const double theirs = expected.get<double>();
  const double last_digit = std::pow(10, std::floor(std::log10(std::abs(theirs))) - 8);
  EXPECT_LE(std::abs(ours - theirs), 0.500001 * last_digit) << what << ": " << ours << " " << theirs;
}

void expect_kitti(const fs::path& folder, const Json& record) {
  expect_keys(record, {"segments", "t_err_percent", "r_err_deg_per_m", "r_err_deg_per_100m", "by_length"});
  const TrajectoryPair pair = {read_once(folder / "kitti_gt.txt"), read_once(folder / "kitti_est.txt")};
  const SegmentErrors e = kitti_segment_errors(pair);
  EXPECT_EQ(e.segments.size(), record.at("segments").get<std::size_t>());
  expect_nine_digits(e.translation_percent, record.at("t_err_percent"), "translation");
  expect_nine_digits(e.rotation_deg_per_100m, record.at("r_err_deg_per_100m"), "rotation");
  expect_nine_digits(e.rotation_deg_per_100m / 100, record.at("r_err_deg_per_m"), "rotation by metre");
  ASSERT_EQ(record.at("by_length").size(), 8u);
  for (const auto& [length, expected] : record.at("by_length").items()) {
    expect_keys(expected, {"n", "t_percent", "r_deg_per_m"});
    std::vector<double> translations, rotations;
    for (const SegmentError& s : e.segments) {
      if (s.length != std::stod(length)) continue;
      translations.push_back(100 * s.translation);
      rotations.push_back(s.rotation * 180 / M_PI);
    }
    ASSERT_EQ(translations.size(), expected.at("n").get<std::size_t>()) << length;
    expect_nine_digits(statistics(translations).mean, expected.at("t_percent"), length);
    expect_nine_digits(statistics(rotations).mean, expected.at("r_deg_per_m"), length);
  }
}

Json read_json(const fs::path& path) {
  std::ifstream file(path);
  return Json::parse(file);
}

fs::path golden_folder() {
  if (const char* folder = std::getenv("FRAMEWISE_GOLDEN")) return folder;
  return fs::path(FRAMEWISE_SOURCE_DIR) / ".." / "shared" / "golden";
}

struct Counts {
  std::size_t evo = 0, tum = 0;
  std::vector<std::string> excepted;  // commands whose record holds no figure
};

// A record that is a Python traceback (the tool broke off) or was made of random pairs is no figure.
Counts expect_records(const fs::path& folder, const Json& evo, const Json& tum) {
  Counts counts;
  for (const Json& record : evo) expect_evo(folder, record), ++counts.evo;
  for (const Json& record : tum) {
    const std::string line = record.at("command");
    const bool no_figure = record.at("output").is_string() || testing::tum_command(line).random_pairs;
    if (no_figure)
      counts.excepted.push_back(line);
    else
      expect_tum(folder, record), ++counts.tum;
  }
  return counts;
}

TEST(Golden, EvaluationOfTheSmallTrajectoriesIsThatOfTheFieldsTools) {
  const fs::path folder = fs::path(FRAMEWISE_SOURCE_DIR) / "tests" / "data" / "golden_synthetic";
  const Json golden = read_json(folder / "golden.json");
  const Counts counts = expect_records(folder, golden.at("evo"), golden.at("tum_tools"));
  EXPECT_EQ(counts.evo, 58u);
  EXPECT_EQ(counts.tum, 22u);
  EXPECT_TRUE(counts.excepted.empty());
}

TEST(Golden, EvaluationOfEveryRecordIsThatOfTheFieldsTools) {
  const fs::path folder = golden_folder();
  if (!fs::exists(folder / "golden.json"))
    GTEST_SKIP() << "no golden.json in " << folder << "; FRAMEWISE_GOLDEN names its folder";
  const Json golden = read_json(folder / "golden.json");
  expect_keys(golden, {"how", "evo", "tum_tools", "synthetic"});
  const Counts desk = expect_records(folder / "fr2_desk", golden.at("evo"), golden.at("tum_tools"));
  EXPECT_EQ(desk.evo, 65u);
  EXPECT_EQ(desk.tum, 15u);
  // The TUM tool does not know metres under Python 3: two records are its traceback.
  EXPECT_EQ(
      desk.excepted,
      std::vector<std::string>(
          {"evaluate_rpe.py fr2_desk_groundtruth.txt fr2_desk_ORB.txt --verbose --fixed_delta --delta 1 "
           "--delta_unit m",
           "evaluate_rpe.py fr2_desk_groundtruth.txt fr2_desk_ORB_kf_mono.txt --verbose --fixed_delta "
           "--delta 1 --delta_unit m"}));
  const Json& synthetic = golden.at("synthetic");
  expect_keys(synthetic, {"files", "evo", "tum_tools", "kitti_devkit"});
  const Counts made = expect_records(folder / "synthetic", synthetic.at("evo"), synthetic.at("tum_tools"));
  EXPECT_EQ(made.evo, 71u);
  EXPECT_EQ(made.tum, 22u);
  EXPECT_TRUE(made.excepted.empty());
  expect_kitti(folder / "synthetic", synthetic.at("kitti_devkit"));
}

TEST(Golden, ACommandThatIsNotUnderstoodIsRefused) {
  EXPECT_THROW(testing::evo_command("evo_ape tum a.txt b.txt --new_option"), std::invalid_argument);
  EXPECT_THROW(testing::evo_command("evo_ape bag a.bag b.txt"), std::invalid_argument);
  EXPECT_THROW(testing::evo_command("evo_rpe tum a.txt b.txt -u furlongs"), std::invalid_argument);
  EXPECT_THROW(testing::evo_command("evo_rpe tum a.txt b.txt -d"), std::invalid_argument);
  EXPECT_THROW(testing::tum_command("evaluate_all.py a.txt b.txt"), std::invalid_argument);
  EXPECT_TRUE(testing::tum_command("evaluate_rpe.py a.txt b.txt --verbose").random_pairs);
}

}  // namespace
}  // namespace framewise
