// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "framewise/report/run_report.h"

namespace framewise {

// What the page's script needs of a run: the frames the slider goes through (kMostFrames at most, and every
// one with an image), their poses and the images.
nlohmann::ordered_json run_page_data(const RunReport& report);

}  // namespace framewise
