// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
// How many RGB-D frames a second the simulator renders in every scene, without blur and with 8 samples of it,
// and how much memory it takes: each in a process of its own. Files are not written.
//   bench_simulation [frames] [width] [threads]
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>

#include "framewise/simulation/simulate.h"

namespace framewise {
namespace {

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// Prints the time to the first frame and the rate of those after it.
void measure(const SimulateOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  auto first = start;
  simulate(options, [&](const SimulatedFrame& simulated) {
    if (simulated.index == 0) first = std::chrono::steady_clock::now();
    return true;
  });
  std::printf("%-14s%6d%12.2f%12.1f", options.scene.c_str(),
              options.imaging.exposure_time > 0 ? options.imaging.blur_samples : 0,
              std::chrono::duration<double>(first - start).count(),
              (*options.frames - 1) / seconds_since(first));
  std::fflush(stdout);
}

// In a child, so that its memory is its own.
void measure_apart(const SimulateOptions& options) {
  std::fflush(stdout);
  const pid_t child = fork();
  if (child == 0) {
    measure(options);
    _exit(0);
  }
  rusage used{};
  int status = 0;
  wait4(child, &status, 0, &used);
  std::printf("%12.2f\n", static_cast<double>(used.ru_maxrss) / (1 << 20));
}

}  // namespace
}  // namespace framewise

int main(int count, char** words) {
  using namespace framewise;
  std::printf("%-14s%6s%12s%12s%12s\n", "scene", "blur", "first (s)", "frames/s", "GiB");
  for (const SceneKind& kind : scene_kinds()) {
    for (const bool blurred : {false, true}) {
      SimulateOptions options;
      options.scene = kind.name;
      options.frames = std::max(2, count > 1 ? std::atoi(words[1]) : 60);
      options.width = count > 2 ? std::atoi(words[2]) : 640;
      options.height = options.width * 3 / 4;
      options.threads = count > 3 ? std::atoi(words[3]) : 0;
      options.headlamp = kind.is_lit ? 0 : 12;
      if (blurred) options.imaging.exposure_time = 0.02;
      measure_apart(options);
    }
  }
}
