// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "framewise/evaluation/metric.h"
#include "framewise/evaluation/presets.h"

// Command lines of other tools, as typed, in our terms. Whatever is not understood throws: a record must not
// pass because a word of it was overlooked.
namespace framewise::testing {

// Words, and options with the word after them.
struct Command {
  std::vector<std::string> words;  // the program and its files
  std::map<std::string, std::string> options;
  bool has(const std::string& name) const { return options.contains(name); }
  std::string text(const std::string& name, const std::string& otherwise) const {
    return has(name) ? options.at(name) : otherwise;
  }
  double value(const std::string& name, double otherwise) const {
    return has(name) ? std::stod(options.at(name)) : otherwise;
  }
};

inline Command parse(const std::string& line, const std::set<std::string>& flags,
                     const std::set<std::string>& with_value) {
  std::istringstream stream(line);
  Command command;
  for (std::string word; stream >> word;) {
    if (flags.contains(word)) {
      command.options[word] = "";
    } else if (with_value.contains(word)) {
      if (!(stream >> command.options[word])) throw std::invalid_argument(word + " has no value: " + line);
    } else if (word[0] == '-') {
      throw std::invalid_argument(word + " is not known: " + line);
    } else {
      command.words.push_back(word);
    }
  }
  return command;
}

template <class T>
const T& known(const std::map<std::string, T>& values, const std::string& name) {
  if (const auto value = values.find(name); value != values.end()) return value->second;
  throw std::invalid_argument("'" + name + "' is not known");
}

inline DeltaUnit unit_of(const std::string& letter) {
  return known<DeltaUnit>({{"f", DeltaUnit::kFrames},
                           {"s", DeltaUnit::kSeconds},
                           {"m", DeltaUnit::kMetres},
                           {"d", DeltaUnit::kDegrees},
                           {"r", DeltaUnit::kRadians}},
                          letter);
}

// What evo_ape and evo_rpe were asked for.
struct EvoCommand {
  std::string reference, estimate;  // files
  EvaluationOptions options;
  Metric metric;
  bool radians = false;  // angles, instead of degrees
};

inline Alignment evo_alignment(const Command& command) {
  return command.has("-a")               ? Alignment::kSe3
         : command.has("-as")            ? Alignment::kSim3
         : command.has("-s")             ? Alignment::kScale
         : command.has("--align_origin") ? Alignment::kOrigin
                                         : Alignment::kNone;
}

inline RelativeErrorOptions evo_pairs(const Command& command, RelativeErrorOptions options) {
  options.delta = command.value("-d", 1);
  options.unit = unit_of(command.text("-u", "f"));
  options.tolerance = command.value("-t", 0.1);
  options.pairs = command.has("--all_pairs") ? PairChoice::kAll : PairChoice::kConsecutive;
  options.pairs_from_reference = command.has("--pairs_from_reference");
  return options;
}

inline Metric evo_metric(const Command& command, bool relative) {
  return {relative, known<PoseRelation>({{"trans_part", PoseRelation::kTranslation},
                                         {"angle_deg", PoseRelation::kRotationAngle},
                                         {"angle_rad", PoseRelation::kRotationAngle},
                                         {"rot_part", PoseRelation::kRotationPart},
                                         {"full", PoseRelation::kFull},
                                         {"point_distance", PoseRelation::kPointDistance},
                                         {"point_distance_error_ratio", PoseRelation::kPointDistanceRatio}},
                                        command.text("-r", "trans_part"))};
}

inline EvoCommand evo_command(const std::string& line) {
  const Command command =
      parse(line, {"-a", "-as", "-s", "--align_origin", "--all_pairs", "--pairs_from_reference"},
            {"-r", "-d", "-u", "-t", "--t_max_diff", "--t_offset", "--t_start", "--t_end", "--n_to_align",
             "--project_to_plane"});
  if (command.words.size() != 4)
    throw std::invalid_argument("expected a program, a format and two files: " + line);
  const bool relative = known<bool>({{"evo_ape", false}, {"evo_rpe", true}}, command.words[0]);
  EvoCommand evo{command.words[2], command.words[3], evaluation_preset("evo"), evo_metric(command, relative),
                 command.text("-r", "") == "angle_rad"};
  EvaluationOptions& options = evo.options;
  options.association.method = known<AssociationMethod>({{"tum", AssociationMethod::kNearest},
                                                         {"euroc", AssociationMethod::kNearest},
                                                         {"kitti", AssociationMethod::kIndex}},
                                                        command.words[1]);
  options.association.max_difference = command.value("--t_max_diff", options.association.max_difference);
  options.association.time_offset = command.value("--t_offset", 0);
  options.from_time = command.value("--t_start", options.from_time);
  options.to_time = command.value("--t_end", options.to_time);
  options.alignment = evo_alignment(command);
  options.poses_to_align = static_cast<std::size_t>(command.value("--n_to_align", 0));
  if (command.has("--project_to_plane"))
    options.plane = known<Plane>({{"xy", Plane::kXy}, {"xz", Plane::kXz}, {"yz", Plane::kYz}},
                                 command.text("--project_to_plane", ""));
  options.relative = evo_pairs(command, options.relative);
  return evo;
}

// What evaluate_ate.py and evaluate_rpe.py of the TUM RGB-D benchmark were asked for.
struct TumCommand {
  std::string reference, estimate;
  EvaluationOptions options;
  bool relative = false;
  bool random_pairs = false;  // evaluate_rpe without --fixed_delta draws them
};

inline TumCommand tum_command(const std::string& line) {
  // --max_pairs thins out randomly chosen pairs and does nothing to those of --fixed_delta.
  const Command command =
      parse(line, {"--verbose", "--fixed_delta"},
            {"--max_difference", "--offset", "--scale", "--delta", "--delta_unit", "--max_pairs"});
  if (command.words.size() != 3) throw std::invalid_argument("expected a program and two files: " + line);
  TumCommand tum{command.words[1], command.words[2], evaluation_preset("tum"),
                 known<bool>({{"evaluate_ate.py", false}, {"evaluate_rpe.py", true}}, command.words[0])};
  tum.random_pairs = tum.relative && !command.has("--fixed_delta");
  EvaluationOptions& options = tum.options;
  options.association.max_difference = command.value("--max_difference", options.association.max_difference);
  options.association.time_offset = command.value("--offset", 0);
  options.estimate_scale = command.value("--scale", 1);
  options.relative.delta = command.value("--delta", 1);
  options.relative.unit = unit_of(command.text("--delta_unit", "s"));
  return tum;
}

}  // namespace framewise::testing
