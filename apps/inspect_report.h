// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "inspect_checks.h"

namespace framewise::apps {

// What `inspect --json` prints.
nlohmann::ordered_json inspection_json(const Inspection& inspection, const std::vector<Check>& checks);

// What `inspect` prints: facts, then warnings; with warnings_only no facts.
std::string inspection_text(const Inspection& inspection, const std::vector<Check>& checks,
                            bool warnings_only);

}  // namespace framewise::apps
