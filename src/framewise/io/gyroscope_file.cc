// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/io/gyroscope_file.h"

#include <algorithm>
#include <array>

#include "framewise/io/input_error.h"
#include "framewise/io/number_rows.h"

namespace framewise {
namespace {

constexpr double kMostRate = 100;  // rad/s; sensors of phones and robots end at 35 (2000 deg/s)

bool is_whole_number(std::string_view field) {
  return std::all_of(field.begin(), field.end(), [](char c) { return c >= '0' && c <= '9'; });
}

double read_stamp(const NumberRows& rows, const NumberRow& row) {
  const double stamp = rows.number(row, 0, "timestamp");
  if (!is_whole_number(row.fields[0]))
    throw InputError(rows.path(), row.line, "timestamp", "'" + std::string(row.fields[0]) + "'",
                     "a whole number of nanoseconds");
  return stamp / 1e9;
}

Eigen::Vector3d read_rate(const NumberRows& rows, const NumberRow& row) {
  static const std::array<std::string, 3> names = {"w_RS_S_x", "w_RS_S_y", "w_RS_S_z"};
  Eigen::Vector3d rate;
  for (int i = 0; i < 3; ++i) {
    rate[i] = rows.number(row, static_cast<std::size_t>(i) + 1, names[i]);
    if (std::abs(rate[i]) > kMostRate)
      throw InputError(rows.path(), row.line, names[i], shortest_text(rate[i]), "a rate in rad/s");
  }
  return rate;
}

void expect_nanoseconds(const std::filesystem::path& path, const Gyroscope& gyroscope) {
  const double span = gyroscope.times.back() - gyroscope.times.front();
  const double step = span / static_cast<double>(std::max<std::size_t>(1, gyroscope.size() - 1));
  if (gyroscope.size() > 1 && (step >= 1 || step < 1e-6))
    throw InputError(path, 0, "timestamp", "samples " + shortest_text(step) + " s apart",
                     "nanoseconds (samples 0.001 to 0.1 s apart, say)");
}

}  // namespace

Gyroscope read_gyroscope(const std::filesystem::path& path) {
  const std::string expected = "4 or 7 (timestamp in ns, three rates in rad/s, perhaps three accelerations)";
  const NumberRows rows(path, "an inertial unit's data.csv");
  if (rows.empty()) throw InputError(path, 0, "", "no rates", "one or more lines of numbers");
  Gyroscope gyroscope;
  for (const NumberRow& row : rows) {
    rows.expect_columns(row, row.fields.size() == 4 || row.fields.size() == 7, expected);
    const double time = read_stamp(rows, row);
    if (!gyroscope.empty() && !(time > gyroscope.times.back()))
      throw InputError(path, row.line, "timestamp",
                       "'" + std::string(row.fields[0]) + "', not after the one before",
                       "stamps that increase");
    gyroscope.times.push_back(time);
    gyroscope.rates.push_back(read_rate(rows, row));
  }
  expect_nanoseconds(path, gyroscope);
  return gyroscope;
}

}  // namespace framewise
