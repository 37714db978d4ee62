// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/report/evaluation_text.h"

#include <iomanip>
#include <locale>
#include <optional>
#include <sstream>

namespace framewise {
namespace {

constexpr int label_width = 20, figure_width = 13;  // six digits, a point, an exponent and a gap

// Digits that a reader compares: six significant ones.
std::string figure(double value) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << std::setprecision(6) << value;
  return text.str();
}

std::string row(const std::string& label, const Statistics& s, const std::optional<double>& still) {
  std::ostringstream text;
  text << std::left << std::setw(label_width) << label << std::right;
  for (const double value : {s.rmse, s.mean, s.median, s.std, s.min, s.max})
    text << std::setw(figure_width) << figure(value);
  text << std::setw(figure_width) << (still ? figure(*still) : "-") << '\n';
  return text.str();
}

std::string heading() {
  std::ostringstream text;
  text << std::setw(label_width) << "" << std::right;
  for (const char* name : {"rmse", "mean", "median", "std", "min", "max", "static"})
    text << std::setw(figure_width) << name;
  return text.str() + "\n";
}

std::string alignment_text(const Evaluation& e) {
  std::string text = name_of(e.options.alignment) + ", scale " + figure(e.reference_from_estimate.scale);
  if (e.options.poses_to_align > 0) text += ", first " + std::to_string(e.options.poses_to_align) + " poses";
  if (e.options.estimate_scale != 1)
    text += ", after the estimate was scaled by " + figure(e.options.estimate_scale);
  if (e.options.plane) {
    const Plane plane = *e.options.plane;
    text += std::string(", projected to ") + (plane == Plane::kXy ? "xy" : plane == Plane::kXz ? "xz" : "yz");
  }
  return text;
}

std::string association_text(const AssociationOptions& association) {
  const std::string limit = " within " + figure(association.max_difference) + " s";
  std::string text;
  switch (association.method) {
    case AssociationMethod::kNearest:
      text = "nearest stamp" + limit;
      break;
    case AssociationMethod::kGreedy:
      text = "closest pairs of stamps" + limit;
      break;
    case AssociationMethod::kInterpolated:
      text = "reference interpolated between poses" + limit + " of the stamp";
      break;
    default:
      return "by index";
  }
  if (association.time_offset != 0) text += ", estimate shifted by " + figure(association.time_offset) + " s";
  return text;
}

std::string relative_text(const Evaluation& e) {
  const RelativeErrorOptions& relative = e.options.relative;
  const PairChoice pairs = relative.resolved_pairs();
  const bool has_tolerance = pairs == PairChoice::kAll && relative.unit != DeltaUnit::kFrames;
  return "delta " + figure(relative.delta) + " " + name_of(relative.unit) + ", " +
         std::to_string(e.motions.size()) +
         (pairs == PairChoice::kConsecutive ? " consecutive pairs"
          : pairs == PairChoice::kAll       ? " pairs, all of that delta"
                                            : " pairs, one from each pose as the TUM tools choose them") +
         (has_tolerance ? " within " + figure(100 * relative.tolerance) + " %" : "") +
         (relative.pairs_from_reference ? ", chosen on the reference" : "") + ", error " +
         (relative.resolved_order() == RelativeErrorOrder::kTum ? "A B^-1" : "B^-1 A");
}

// What a distance hides: which axis an error is along, and what it adds up to.
std::string axis_rows(const AxisErrors& axes) {
  std::ostringstream text;
  text << std::setw(label_width) << "" << std::right;
  for (const char* name : {"mean", "min", "max", "cumulative", "mean angle"})
    text << std::setw(figure_width) << name;
  text << '\n';
  constexpr const char* kLabels[] = {"|x| (m, deg)", "|y| (m, deg)", "|z| (m, deg)"};
  for (int axis = 0; axis < 3; ++axis) {
    const Statistics& s = axes.position[axis];
    text << std::left << std::setw(label_width) << kLabels[axis] << std::right;
    for (const double value : {s.mean, s.min, s.max, axes.cumulative[axis], axes.euler_deg[axis].mean})
      text << std::setw(figure_width) << figure(value);
    text << '\n';
  }
  return text.str();
}

std::string kitti_text(const SegmentErrors& kitti) {
  return figure(kitti.translation_percent) + " %, " + figure(kitti.rotation_deg_per_100m) +
         " deg/100 m over " + std::to_string(kitti.segments.size()) + " stretches of 100 to 800 m";
}

std::string line(const std::string& label, const std::string& value) {
  return label + std::string(label_width - label.size(), ' ') + value + "\n";
}

}  // namespace

std::string to_text(const Evaluation& e) {
  const StaticBaseline& still = e.static_baseline;
  std::string text = heading();
  text += row("ATE (m)", e.ate, still.ate);
  text += row("ATE rotation (deg)", e.ate_rotation_deg, std::nullopt);
  if (e.rpe) {
    text += row("RPE (m)", e.rpe->translation, still.rpe_translation);
    text += row("RPE rotation (deg)", e.rpe->rotation_deg, still.rpe_rotation_deg);
    text += row("RPE direction (0-2)", e.rpe->direction, std::nullopt);
  } else {
    text += line("RPE", "none: no two poses are delta apart");
  }
  text.append("\n").append(axis_rows(e.axes)).append("\n");
  if (e.kitti) text += line("KITTI segments", kitti_text(*e.kitti));
  text += line("alignment", alignment_text(e));
  text += line("RPE over", relative_text(e));
  text += line("matched", std::to_string(e.matched) + " of " + std::to_string(e.estimate_poses) +
                              " poses of the estimate, coverage " + figure(100 * e.coverage) + " %, " +
                              association_text(e.options.association));
  text += line("reference", std::to_string(e.reference_poses) + " poses, " + figure(100 * e.time_coverage) +
                                " % of its time between the first and the last match");
  text += line("path length", figure(e.path_length) + " m");
  text += line("static", "rmse of a camera that never moved, same matches, alignment and pairs");
  return text;
}

}  // namespace framewise
