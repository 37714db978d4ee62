// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "progress.h"

#include <fmt/format.h>
#include <unistd.h>

namespace framewise::apps {

namespace {

double seconds_between(std::chrono::steady_clock::time_point a, std::chrono::steady_clock::time_point b) {
  return std::chrono::duration<double>(b - a).count();
}

}  // namespace

Progress::Progress(std::string what, std::size_t total, bool quiet, std::string things)
    : what_(std::move(what)),
      things_(std::move(things)),
      total_(total),
      quiet_(quiet),
      terminal_(isatty(STDERR_FILENO)) {
  start_ = drawn_ = std::chrono::steady_clock::now();
}

Progress::~Progress() {
  if (!quiet_ && terminal_ && done_ > 0) fmt::print(stderr, "\n");
}

double Progress::seconds() const { return seconds_between(start_, std::chrono::steady_clock::now()); }

void Progress::advance() {
  ++done_;
  if (quiet_) return;
  if (terminal_) {
    const auto now = std::chrono::steady_clock::now();
    if (done_ < total_ && seconds_between(drawn_, now) < 0.1) return;
    drawn_ = now;
    draw_bar();
  } else if (100 * done_ >= static_cast<std::size_t>(next_percent_) * total_) {
    next_percent_ = static_cast<int>(100 * done_ / total_) / 10 * 10 + 10;
    fmt::print(stderr, "{}: {} of {} {}, {:.1f} a second\n", what_, done_, total_, things_,
               done_ / seconds());
  }
}

void Progress::draw_bar() const {
  constexpr int kWidth = 30;
  const int filled = static_cast<int>(kWidth * done_ / total_);
  const double rate = done_ / seconds();
  fmt::print(stderr, "\r{} [{:=<{}}{: <{}}] {}/{}  {:.1f} {}/s  {:.0f} s left ", what_, "", filled, "",
             kWidth - filled, done_, total_, rate, things_, (total_ - done_) / rate);
  std::fflush(stderr);
}

}  // namespace framewise::apps
