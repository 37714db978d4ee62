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
  return json;
}

}  // namespace framewise
