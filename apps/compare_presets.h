// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "framewise/io/grid_file.h"

namespace framewise::apps {

// The grid that --grid names: frame-to-frame, lab or dark, else a file. Throws InputError.
Grid grid_from_name(const std::string& name);

}  // namespace framewise::apps
