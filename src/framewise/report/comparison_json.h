// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "framewise/report/comparison.h"

namespace framewise {

// results.json: version, grid, seed, repeats, statistics, datasets, rows. Figures over the repeats are
// {median, q1, q3, count}. Where there is no figure there is null, and the row's reason says why. What is
// measured with a clock stands under `times`; all else repeats itself.
nlohmann::ordered_json to_json(const Comparison& comparison);

// The same back. Throws nlohmann::json::exception where the JSON is not of that form.
Comparison comparison_from_json(const nlohmann::ordered_json& json);

}  // namespace framewise
