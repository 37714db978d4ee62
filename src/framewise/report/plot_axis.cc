// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/report/plot_axis.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace framewise {
namespace {

constexpr double kTicks = 5;   // about so many
constexpr double kAir = 0.03;  // of the axis, at either end

// The round number (1, 2 or 5 times a power of ten) not below the value.
double round_up(double value) {
  const double power = std::pow(10, std::floor(std::log10(value)));
  for (const double digit : {1., 2., 5.})
    if (value <= digit * power * (1 + 1e-9)) return digit * power;
  return 10 * power;
}

std::vector<double> linear_ticks(double low, double high) {
  std::vector<double> ticks;
  const double step = round_up((high - low) / kTicks);
  for (double i = std::ceil(low / step - 1e-9); i * step <= high + 1e-9 * step; ++i)
    ticks.push_back(i == 0 ? 0 : i * step);
  return ticks;
}

std::vector<double> log_ticks(double low, double high) {
  std::vector<double> ticks;
  const double decades = std::log10(high / low), every = std::ceil(decades / 6);
  for (double power = std::floor(std::log10(low)); power <= std::log10(high); power += every)
    for (const double digit : {1., 2., 5.}) {
      const double tick = digit * std::pow(10, power);
      if ((digit == 1 || decades < 2) && tick >= low && tick <= high) ticks.push_back(tick);
    }
  return ticks.size() < 3 ? linear_ticks(low, high) : ticks;  // of a narrow axis
}

}  // namespace

double PlotAxis::at(double value) const {
  if (!std::isfinite(value) || (is_log && value <= 0)) return std::numeric_limits<double>::quiet_NaN();
  const double share = is_log ? std::log(value / low) / std::log(high / low) : (value - low) / (high - low);
  return start + share * length;
}

std::vector<double> PlotAxis::ticks() const {
  return is_log ? log_ticks(low, high) : linear_ticks(low, high);
}

PlotAxis axis_of(std::span<const double> values, bool is_log, bool from_zero) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const double value : values) {
    if (!std::isfinite(value) || (is_log && value <= 0)) continue;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  PlotAxis axis;
  axis.is_log = is_log;
  if (low > high) {
    axis.low = is_log ? 1 : 0;
    axis.high = is_log ? 10 : 1;
  } else if (is_log) {
    const double air = std::max(std::pow(high / low, kAir), 1.2);
    axis.low = low / air;
    axis.high = high * air;
  } else {
    if (from_zero) low = std::min(low, 0.), high = std::max(high, 0.);
    const double size = std::max({high - low, 1e-9 * std::max(std::abs(low), std::abs(high)), 1e-12});
    axis.low = from_zero && low == 0 ? 0 : low - kAir * size;
    axis.high = from_zero && high == 0 && low < 0 ? 0 : high + kAir * size;
  }
  return axis;
}

std::string tick_text(double value) { return fmt::format("{:.6g}", value); }

}  // namespace framewise
