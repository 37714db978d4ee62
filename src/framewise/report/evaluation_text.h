// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "framewise/evaluation/evaluation.h"

namespace framewise {

// The evaluation as a table for a terminal, lines ended by '\n'. Beside the errors it says what they are
// worth nothing without: alignment and its scale, matches and coverage, path length, delta with its unit and
// pairs, and what a camera that never moved would have scored.
std::string to_text(const Evaluation& evaluation);

}  // namespace framewise
