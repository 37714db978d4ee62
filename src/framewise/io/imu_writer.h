// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <span>

#include "framewise/geometry/imu_reading.h"

namespace framewise {

// Writes readings as EuRoC's imu0/data.csv has them: `timestamp [ns],w_RS_S_x,...,a_RS_S_x,...`, every digit
// of a double. Times are 0 or more. Throws std::runtime_error when the file cannot be written.
void write_imu(const std::filesystem::path& file, std::span<const ImuReading> readings);

}  // namespace framewise
