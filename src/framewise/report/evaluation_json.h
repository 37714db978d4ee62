// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "framewise/evaluation/evaluation.h"

namespace framewise {

// The object that `framewise evaluate --json` prints: ate.{rmse,mean,median,std,min,max} (m),
// rpe.translation.{...} (m), rpe.rotation_deg.{...}, alignment, scale, delta, unit, matched, coverage,
// path_length (m), static_baseline.{ate,rpe_translation,rpe_rotation_deg} (RMSE). Without two poses that are
// delta apart the relative errors are null.
nlohmann::ordered_json to_json(const Evaluation& evaluation);

}  // namespace framewise
