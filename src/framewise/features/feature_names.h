// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace framewise {

enum class Detector { kSift, kSurf, kOrb, kAkaze };
enum class Descriptor { kSift, kSurf, kSurf128, kOrb, kAkaze };
enum class Spread { kNone, kGrid, kAnms };

// The names of the command line that this build knows: surf only with FRAMEWISE_WITH_SURF.
const std::vector<std::string>& detector_names();
const std::vector<std::string>& descriptor_names();

// Of a name. Throws std::invalid_argument naming the option, what was found and what was expected.
Detector detector_of(const std::string& name);
Descriptor descriptor_of(const std::string& name);
Spread spread_of(const std::string& name);

}  // namespace framewise
