// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdio>
#include <functional>
#include <string>
#include <utility>
#include <vector>

// Rivals timed in turns, so that whatever else the machine does meets all of them alike.
namespace framewise::bench {

struct Rival {
  std::string name;
  std::function<double(std::size_t)> call;  // solves problem i, returns something of the answer
};

// Lower-quartile time of one call (us) of each rival: `rounds` rounds in which every rival takes one batch.
inline std::vector<double> lower_quartile_us(const std::vector<Rival>& rivals, std::size_t batch,
                                             std::size_t rounds) {
  using Clock = std::chrono::steady_clock;
  std::vector<std::vector<double>> times(rivals.size());
  volatile double sink = 0;
  for (std::size_t round = 0; round < rounds; ++round)
    for (std::size_t k = 0; k < rivals.size(); ++k) {
      const auto begin = Clock::now();
      for (std::size_t i = 0; i < batch; ++i) sink = sink + rivals[k].call(i);
      times[k].push_back(std::chrono::duration<double, std::micro>(Clock::now() - begin).count() / batch);
    }
  std::vector<double> result;
  for (auto& t : times) {
    std::nth_element(t.begin(), t.begin() + t.size() / 4, t.end());
    result.push_back(t[t.size() / 4]);
  }
  return result;
}

inline void print_race(const std::string& title, const std::vector<Rival>& rivals, std::size_t batch,
                       std::size_t rounds) {
  const std::vector<double> us = lower_quartile_us(rivals, batch, rounds);
  std::printf("%s\n", title.c_str());
  for (std::size_t k = 0; k < rivals.size(); ++k)
    std::printf("  %-44s %9.3f us\n", rivals[k].name.c_str(), us[k]);
}

}  // namespace framewise::bench
