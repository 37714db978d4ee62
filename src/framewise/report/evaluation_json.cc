// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/report/evaluation_json.h"

#include <nlohmann/json.hpp>

namespace framewise {
namespace {

using Json = nlohmann::ordered_json;

Json to_json(const Statistics& s) {
  return {{"rmse", s.rmse}, {"mean", s.mean}, {"median", s.median},
          {"std", s.std},   {"min", s.min},   {"max", s.max}};
}

Json to_json(const AxisErrors& axes) {
  constexpr const char* kNames[] = {"x", "y", "z"};
  Json json;
  for (int axis = 0; axis < 3; ++axis) {
    const Statistics& s = axes.position[axis];
    json[kNames[axis]] = {{"min", s.min},
                          {"max", s.max},
                          {"mean", s.mean},
                          {"cumulative", axes.cumulative[axis]},
                          {"euler_deg", to_json(axes.euler_deg[axis])}};
  }
  return json;
}

Json to_json(const SegmentErrors& kitti) {
  return {{"segments", kitti.segments.size()},
          {"translation_percent", kitti.translation_percent},
          {"rotation_deg_per_100m", kitti.rotation_deg_per_100m}};
}

Json or_null(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }

}  // namespace

nlohmann::ordered_json to_json(const Evaluation& evaluation) {
  const auto& e = evaluation;
  Json json;
  json["ate"] = to_json(e.ate);
  json["rpe"]["translation"] = e.rpe ? to_json(e.rpe->translation) : Json(nullptr);
  json["rpe"]["rotation_deg"] = e.rpe ? to_json(e.rpe->rotation_deg) : Json(nullptr);
  json["alignment"] = name_of(e.options.alignment);
  json["scale"] = e.reference_from_estimate.scale;
  json["delta"] = e.options.relative.delta;
  json["unit"] = name_of(e.options.relative.unit);
  json["matched"] = e.matched;
  json["coverage"] = e.coverage;
  json["path_length"] = e.path_length;
  json["static_baseline"]["ate"] = e.static_baseline.ate;
  json["static_baseline"]["rpe_translation"] = or_null(e.static_baseline.rpe_translation);
  json["static_baseline"]["rpe_rotation_deg"] = or_null(e.static_baseline.rpe_rotation_deg);
  json["ate_rotation_deg"] = to_json(e.ate_rotation_deg);
  json["rpe_direction"] = e.rpe ? to_json(e.rpe->direction) : Json(nullptr);
  json["axes"] = to_json(e.axes);
  json["kitti"] = e.kitti ? to_json(*e.kitti) : Json(nullptr);
  return json;
}

}  // namespace framewise
