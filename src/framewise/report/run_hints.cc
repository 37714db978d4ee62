// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cmath>

#include "framewise/report/html.h"
#include "framewise/report/record_fields.h"
#include "framewise/report/run_report.h"

namespace framewise {
namespace {

constexpr double kScaleNear = 1.1;    // sim3 scales up to this, or its inverse, are near 1
constexpr double kPoorShare = 0.5;    // of the static baseline's error
constexpr double kSceneDepth = 1;     // where the scene of a room is thought to be (m)
constexpr double kTurnsAbove = 5;     // images move so many times more from turning than from moving
constexpr double kUnsureShare = 0.2;  // of the frames, with little or no parallax

double radians(double degrees) { return degrees * 3.14159265358979323846 / 180; }

class Hints {
 public:
  template <typename... Values>
  void warn(fmt::format_string<Values...> text, Values&&... values) {
    hints_.push_back({true, fmt::format(text, std::forward<Values>(values)...)});
  }
  template <typename... Values>
  void note(fmt::format_string<Values...> text, Values&&... values) {
    hints_.push_back({false, fmt::format(text, std::forward<Values>(values)...)});
  }
  std::vector<Hint> take() { return std::move(hints_); }

 private:
  std::vector<Hint> hints_;
};

void say_options(const RunReport& report, Hints& hints) {
  if (record_text(report.record, "/options/scale") == "truth")
    hints.warn(
        "The length of every step was taken from the truth (scale truth): the errors judge rotations and "
        "directions, "
        "and the same method alone would not know how far it went.");
  if (record_text(report.record, "/options/rotation") == "truth")
    hints.warn(
        "Rotations were taken from the truth (rotation truth): the rotation error says nothing about the "
        "method.");
}

void say_statuses(const RunReport& report, Hints& hints) {
  std::size_t unmeasured = 0, unsure = 0;
  for (const ReportedFrame& frame : report.frames) {
    unsure += frame.status == "low-parallax" || frame.status == "rotation-only";
    unmeasured += frame.status == "lost" || frame.status == "no-depth" || frame.status == "predicted";
  }
  if (unmeasured > 0)
    hints.warn(
        "{} of {} frames have no measured motion; they repeat or foretell the last pose, and are judged as "
        "that.",
        unmeasured, report.frames.size());
  if (static_cast<double>(unsure) > kUnsureShare * static_cast<double>(report.frames.size()))
    hints.warn("{} of {} steps had little or no parallax: their translations' directions are uncertain.",
               unsure, report.frames.size());
}

void say_scale(const Evaluation& e, Hints& hints) {
  const double scale = e.reference_from_estimate.scale;
  if (e.options.alignment != Alignment::kSim3 && e.options.alignment != Alignment::kScale) return;
  if (scale > kScaleNear || scale < 1 / kScaleNear)
    hints.warn(
        "The estimate was made {:.4g} times as large before it was judged (alignment {}): its own scale is "
        "not the truth's.",
        scale, name_of(e.options.alignment));
  else
    hints.note(
        "Alignment {} forgives the scale (found: {:.4g}); compare with figures under the same alignment "
        "only.",
        name_of(e.options.alignment), scale);
}

void say_still(const char* what, double error, const std::optional<double>& still, const char* unit,
               Hints& hints) {
  if (!still || *still <= 0) return;
  if (error >= *still)
    hints.warn("{}: {:.4g} {} is above the {:.4g} {} of a camera that never moved.", what, error, unit,
               *still, unit);
  else if (error > kPoorShare * *still)
    hints.warn("{}: {:.4g} {} is only {:.0f} % below the {:.4g} {} of a camera that never moved.", what,
               error, unit, 100 * (1 - error / *still), *still, unit);
  else
    hints.note("{}: {:.4g} {} is below the {:.4g} {} of a camera that never moved.", what, error, unit,
               *still, unit);
}

void say_turning(const StaticBaseline& still, Hints& hints) {
  if (!still.rpe_translation || !still.rpe_rotation_deg) return;
  const double turned = kSceneDepth * radians(*still.rpe_rotation_deg);
  if (turned > kTurnsAbove * *still.rpe_translation)
    hints.warn(
        "The camera almost only turned ({:.3g} deg and {:.3g} mm between poses): a translation found from "
        "images alone "
        "means little here.",
        *still.rpe_rotation_deg, 1e3 * *still.rpe_translation);
}

void say_evaluation(const Evaluation& e, Hints& hints) {
  if (e.coverage < 1)
    hints.warn("Only {} of {} poses ({:.1f} %) were judged; the truth says nothing of the others.", e.matched,
               e.estimate_poses, 100 * e.coverage);
  say_scale(e, hints);
  say_still("Absolute error", e.ate.rmse, e.static_baseline.ate, "m", hints);
  if (e.rpe) {
    say_still("Relative translation error", e.rpe->translation.rmse, e.static_baseline.rpe_translation, "m",
              hints);
    say_still("Relative rotation error", e.rpe->rotation_deg.rmse, e.static_baseline.rpe_rotation_deg, "deg",
              hints);
  }
  say_turning(e.static_baseline, hints);
}

}  // namespace

std::vector<Hint> run_hints(const RunReport& report) {
  Hints hints;
  for (const std::string& what : report.missing) hints.warn("{}", what);
  say_options(report, hints);
  say_statuses(report, hints);
  if (report.evaluation) say_evaluation(*report.evaluation, hints);
  return hints.take();
}

}  // namespace framewise
