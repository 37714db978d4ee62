// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <cstddef>
#include <string>

namespace framewise::apps {

// Says on standard error how far the work is: a bar with rate and time left on a terminal, else a line every
// 10 %.
class Progress {
 public:
  // things: what is counted.
  Progress(std::string what, std::size_t total, bool quiet, std::string things = "frames");
  ~Progress();

  void advance();
  double seconds() const;

 private:
  void draw_bar() const;

  std::string what_, things_;
  std::size_t total_, done_ = 0;
  int next_percent_ = 10;
  bool quiet_, terminal_;
  std::chrono::steady_clock::time_point start_, drawn_;
};

}  // namespace framewise::apps
