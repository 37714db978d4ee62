// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/io/imu_writer.h"

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <stdexcept>

namespace framewise {

void write_imu(const std::filesystem::path& file, std::span<const ImuReading> readings) {
  std::string text =
      "#timestamp [ns],w_RS_S_x [rad s^-1],w_RS_S_y [rad s^-1],w_RS_S_z [rad s^-1],"
      "a_RS_S_x [m s^-2],a_RS_S_y [m s^-2],a_RS_S_z [m s^-2]\n";
  for (const ImuReading& reading : readings) {
    const Eigen::Vector3d &w = reading.angular_rate, &a = reading.specific_force;
    text += fmt::format("{},{},{},{},{},{},{}\n", std::llround(reading.time * 1e9), w.x(), w.y(), w.z(),
                        a.x(), a.y(), a.z());
  }
  std::ofstream stream(file, std::ios::binary);
  stream << text;
  stream.close();
  if (!stream) throw std::runtime_error(fmt::format("{}: cannot be written", file.string()));
}

}  // namespace framewise
