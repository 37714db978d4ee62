// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/report/evo_labels.h"

#include <fmt/format.h>

namespace framewise {
namespace {

struct Wording {
  const char* relation;
  const char* unit;
};

Wording wording(PoseRelation relation) {
  switch (relation) {
    case PoseRelation::kRotationAngle:
      return {"rotation angle in degrees", "deg"};
    case PoseRelation::kRotationPart:
      return {"rotation part", "unit-less"};
    case PoseRelation::kFull:
      return {"full transformation", "unit-less"};
    case PoseRelation::kPointDistance:
      return {"point distance", "m"};
    case PoseRelation::kPointDistanceRatio:
      return {"point distance error ratio", "%"};
    case PoseRelation::kDirection:
      return {"direction", "unit-less"};
    default:
      return {"translation part", "m"};
  }
}

const char* evo_unit(DeltaUnit unit) {
  switch (unit) {
    case DeltaUnit::kFrames:
      return "frames";
    case DeltaUnit::kSeconds:
      return "s";
    case DeltaUnit::kMetres:
      return "m";
    case DeltaUnit::kDegrees:
      return "deg";
    default:
      return "rad";
  }
}

std::string pairs_title(const RelativeErrorOptions& relative) {
  // Frames are whole numbers; everything else has a point, as Python prints a float.
  std::string delta = fmt::format("{}", relative.delta);
  const bool has_point = delta.find_first_of(".e") != std::string::npos;
  if (relative.unit != DeltaUnit::kFrames && !has_point) delta += ".0";
  const PairChoice pairs = relative.resolved_pairs();
  return fmt::format("\nfor delta = {} ({}) using {} pairs", delta, evo_unit(relative.unit),
                     pairs == PairChoice::kAll           ? "all"
                     : pairs == PairChoice::kConsecutive ? "consecutive"
                                                         : "the TUM tools'");
}

std::string alignment_title(const Evaluation& e) {
  const auto count = e.options.poses_to_align;
  const std::string some = count > 0 ? fmt::format(" (aligned poses: {})", count) : "";
  switch (e.options.alignment) {
    case Alignment::kNone:
      return "\n(not aligned)";
    case Alignment::kSe3:
      return "\n(with SE(3) Umeyama alignment)" + some;
    case Alignment::kSim3:
      return "\n(with Sim(3) Umeyama alignment)" + some;
    case Alignment::kScale:
      return "\n(scale corrected)" + some;
    case Alignment::kYaw:
      return "\n(with yaw alignment)" + some;
    default:
      return "\n(with origin alignment)";
  }
}

std::string plane_title(const std::optional<Plane>& plane) {
  if (!plane) return "";
  return fmt::format("\n(projected to {} plane)", *plane == Plane::kXy   ? "xy"
                                                  : *plane == Plane::kXz ? "xz"
                                                                         : "yz");
}

}  // namespace

EvoLabels evo_labels(const Evaluation& evaluation, const Metric& metric) {
  const auto [relation, unit] = wording(metric.relation);
  const char* name = metric.relative ? "RPE" : "APE";
  return {fmt::format("{} w.r.t. {} ({})", name, relation, unit) +
              (metric.relative ? pairs_title(evaluation.options.relative) : "") +
              alignment_title(evaluation) + plane_title(evaluation.options.plane),
          fmt::format("{} ({})", name, unit)};
}

}  // namespace framewise
