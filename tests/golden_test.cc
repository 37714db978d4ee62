// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What evo 1.36.5, the TUM RGB-D benchmark's tools and the KITTI devkit printed, with the commands as typed.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "framewise/evaluation/evaluation.h"
#include "framewise/evaluation/kitti_segments.h"
#include "framewise/evaluation/presets.h"
#include "framewise/io/trajectory_files.h"

namespace framewise {
namespace {

using Json = nlohmann::json;
namespace fs = std::filesystem;

// A command line as typed: words, and options with the word after them.
struct Command {
  std::vector<std::string> files;
  std::map<std::string, std::string> options;
  bool has(const std::string& name) const { return options.contains(name); }
  std::string text(const std::string& name, const std::string& otherwise) const {
    return has(name) ? options.at(name) : otherwise;
  }
  double value(const std::string& name, double otherwise) const {
    return has(name) ? std::stod(options.at(name)) : otherwise;
  }
};

Command parse(const std::string& line) {
  std::istringstream words(line);
  std::string word, last;
  Command command;
  words >> word;
  while (words >> word) {
    const bool number = word.find_first_not_of("-.0123456789") == std::string::npos;
    if (word[0] == '-' && !number) {
      command.options[last = word] = "";
    } else if (!last.empty()) {
      command.options[last] = word;
      last.clear();
    } else {
      command.files.push_back(word);
    }
  }
  return command;
}

const std::map<std::string, std::pair<PoseRelation, double>> relations = {
    {"trans_part", {PoseRelation::kTranslation, 1}},
    {"angle_deg", {PoseRelation::kRotationAngle, 180 / M_PI}},
    {"angle_rad", {PoseRelation::kRotationAngle, 1}},
    {"rot_part", {PoseRelation::kRotationPart, 1}},
    {"full", {PoseRelation::kFull, 1}},
    {"point_distance", {PoseRelation::kPointDistance, 1}},
    {"point_distance_error_ratio", {PoseRelation::kPointDistanceRatio, 100}}};

DeltaUnit unit_of(const std::string& letter) {
  return letter == "s"   ? DeltaUnit::kSeconds
         : letter == "m" ? DeltaUnit::kMetres
         : letter == "d" ? DeltaUnit::kDegrees
         : letter == "r" ? DeltaUnit::kRadians
                         : DeltaUnit::kFrames;
}

EvaluationOptions evo_options(const Command& command) {
  EvaluationOptions options = evaluation_preset("evo");
  if (command.has("--t_max_diff")) options.association.max_difference = command.value("--t_max_diff", 0);
  options.association.time_offset = command.value("--t_offset", 0);
  if (command.files[0] == "kitti") options.association.method = AssociationMethod::kIndex;
  options.from_time = command.value("--t_start", options.from_time);
  options.to_time = command.value("--t_end", options.to_time);
  options.alignment = command.has("-a")               ? Alignment::kSe3
                      : command.has("-as")            ? Alignment::kSim3
                      : command.has("-s")             ? Alignment::kScale
                      : command.has("--align_origin") ? Alignment::kOrigin
                                                      : Alignment::kNone;
  options.poses_to_align = static_cast<std::size_t>(command.value("--n_to_align", 0));
  const std::string plane = command.text("--project_to_plane", "");
  if (plane == "xy") options.plane = Plane::kXy;
  if (plane == "xz") options.plane = Plane::kXz;
  options.relative.delta = command.value("-d", 1);
  options.relative.unit = unit_of(command.text("-u", "f"));
  options.relative.tolerance = command.value("-t", 0.1);
  options.relative.pairs = command.has("--all_pairs") ? PairChoice::kAll : PairChoice::kConsecutive;
  options.relative.pairs_from_reference = command.has("--pairs_from_reference");
  return options;
}

EvaluationOptions tum_options(const Command& command) {
  EvaluationOptions options = evaluation_preset("tum");
  if (command.has("--max_difference"))
    options.association.max_difference = command.value("--max_difference", 0);
  options.association.time_offset = command.value("--offset", 0);
  options.estimate_scale = command.value("--scale", 1);
  options.relative.delta = command.value("--delta", 1);
  options.relative.unit = unit_of(command.text("--delta_unit", "s"));
  return options;
}

// Many records are made of the same few files.
const Trajectory& read_once(const fs::path& path) {
  static std::map<fs::path, Trajectory> files;
  if (!files.contains(path)) files[path] = read_trajectory(path).trajectory;
  return files.at(path);
}

double field(const Statistics& s, const std::string& name) {
  const std::map<std::string, double> fields = {{"rmse", s.rmse}, {"mean", s.mean}, {"median", s.median},
                                                {"std", s.std},   {"min", s.min},   {"max", s.max},
                                                {"sse", s.sse}};
  return fields.at(name);
}

// Figures below `floor` are rounding of the tool itself.
void expect_relative(double ours, double theirs, const std::string& what, double floor) {
  EXPECT_LE(std::abs(ours - theirs), 1e-9 * std::abs(theirs) + floor)
      << what << ": " << ours << " " << theirs;
}

void expect_evo(const fs::path& folder, const Json& record) {
  const std::string line = record.at("command");
  SCOPED_TRACE(line);
  const Command command = parse(line);
  const EvaluationOptions options = evo_options(command);
  const Evaluation e =
      evaluate(read_once(folder / command.files.at(1)), read_once(folder / command.files.at(2)), options);
  const auto [relation, unit] = relations.at(command.text("-r", "trans_part"));
  auto errors = line.starts_with("evo_ape")
                    ? absolute_errors(e.poses, relation)
                    : relative_errors(e.motions, relation, options.relative.resolved_order());
  for (double& error : errors) error *= unit;

  ASSERT_EQ(errors.size(), record.at("count").get<std::size_t>());
  const Statistics s = statistics(errors);
  for (const auto& [name, value] : record.at("stats").items())
    expect_relative(field(s, name), value, name, 1e-12);
  for (std::size_t i = 0; i < record.at("first3").size(); ++i)
    expect_relative(errors[i], record["first3"][i], "error " + std::to_string(i), 1e-12);
  expect_relative(errors.back(), record.at("last"), "last error", 1e-12);
  if (!record.contains("alignment_sim3") || options.alignment == Alignment::kScale) return;
  const Similarity& found = e.reference_from_estimate;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 4; ++j)
      expect_relative(j < 3 ? found.scale * found.pose.R(i, j) : found.pose.t[i],
                      record["alignment_sim3"][i][j], "alignment", 1e-9);
}

// The tools print six digits after the point.
void expect_printed(double ours, double theirs, const std::string& what) {
  EXPECT_LE(std::abs(ours - theirs), 0.5000001e-6) << what << ": " << ours << " " << theirs;
}

void expect_tum(const fs::path& folder, const Json& record) {
  const std::string line = record.at("command");
  SCOPED_TRACE(line);
  const Command command = parse(line);
  const Evaluation e = evaluate(read_once(folder / command.files.at(0)),
                                read_once(folder / command.files.at(1)), tum_options(command));
  ASSERT_TRUE(e.rpe);
  for (const auto& [name, value] : record.at("output").items()) {
    const std::string what = name.substr(0, name.find('.')), figure = name.substr(name.find('.') + 1);
    if (name == "compared_pose_pairs")
      EXPECT_EQ(line.starts_with("evaluate_ate") ? e.matched : e.motions.size(), value.get<std::size_t>());
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

// The devkit prints nine digits.
void expect_nine_digits(double ours, const Json& theirs, const std::string& what) {
  EXPECT_LE(std::abs(ours - theirs.get<double>()), 5e-9 * theirs.get<double>()) << what << ": " << ours;
}

void expect_kitti(const fs::path& folder, const Json& record) {
  const TrajectoryPair pair = {read_once(folder / "kitti_gt.txt"), read_once(folder / "kitti_est.txt")};
  const SegmentErrors e = kitti_segment_errors(pair);
  EXPECT_EQ(e.segments.size(), record.at("segments").get<std::size_t>());
  expect_nine_digits(e.translation_percent, record.at("t_err_percent"), "translation");
  expect_nine_digits(e.rotation_deg_per_100m, record.at("r_err_deg_per_100m"), "rotation");
  for (const auto& [length, expected] : record.at("by_length").items()) {
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

// A record that is a Python traceback is no figure.
void expect_records(const fs::path& folder, const Json& evo, const Json& tum) {
  for (const Json& record : evo) expect_evo(folder, record);
  for (const Json& record : tum)
    if (record.at("output").is_object()) expect_tum(folder, record);
}

TEST(Golden, EvaluationOfTheSmallTrajectoriesIsThatOfTheFieldsTools) {
  const fs::path folder = fs::path(FRAMEWISE_SOURCE_DIR) / "tests" / "data" / "golden_synthetic";
  const Json golden = read_json(folder / "golden.json");
  EXPECT_EQ(golden.at("evo").size(), 58u);
  EXPECT_EQ(golden.at("tum_tools").size(), 22u);
  expect_records(folder, golden.at("evo"), golden.at("tum_tools"));
}

TEST(Golden, EvaluationOfEveryRecordIsThatOfTheFieldsTools) {
  const fs::path folder = golden_folder();
  if (!fs::exists(folder / "golden.json"))
    GTEST_SKIP() << "no golden.json in " << folder << "; FRAMEWISE_GOLDEN names its folder";
  const Json golden = read_json(folder / "golden.json");
  expect_records(folder / "fr2_desk", golden.at("evo"), golden.at("tum_tools"));
  const Json& synthetic = golden.at("synthetic");
  expect_records(folder / "synthetic", synthetic.at("evo"), synthetic.at("tum_tools"));
  expect_kitti(folder / "synthetic", synthetic.at("kitti_devkit"));
}

}  // namespace
}  // namespace framewise
