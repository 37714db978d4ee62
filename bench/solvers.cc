// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <cstdlib>
#include <string>

#include "solver_bench.h"
#include "solvers_essential.h"
#if __has_include("solvers_minimal.h")
#include "solvers_minimal.h"
#define FRAMEWISE_BENCH_MINIMAL
#endif

// Every solver and every peer on the same noise-free problems: time, failures, errors.
//   bench_solvers [--problems N] [--timed N] [--repetitions N] [--seed S] [--only TEXT]
namespace framewise::bench {
namespace {

struct Options {
  std::size_t problems = 20000;  // judged, in each of two kinds of motion
  std::size_t timed = 1000;      // of them, in each
  int repetitions = 21;
  std::uint64_t seed = 1;
  std::string only;  // tasks whose name contains it
};

Options parse(int argc, char** argv) {
  Options options;
  for (int i = 1; i < argc; i += 2) {
    const std::string key = argv[i];
    const char* value = i + 1 < argc ? argv[i + 1] : nullptr;
    if (key == "--problems" && value) {
      options.problems = std::strtoull(value, nullptr, 10);
    } else if (key == "--timed" && value) {
      options.timed = std::strtoull(value, nullptr, 10);
    } else if (key == "--repetitions" && value) {
      options.repetitions = std::atoi(value);
    } else if (key == "--seed" && value) {
      options.seed = std::strtoull(value, nullptr, 10);
    } else if (key == "--only" && value) {
      options.only = value;
    } else {
      std::fprintf(stderr,
                   "bench_solvers: %s not understood; expected [--problems N] [--timed N] [--repetitions N] "
                   "[--seed S] [--only TEXT]\n",
                   argv[i]);
      std::exit(2);
    }
  }
  options.timed = std::max<std::size_t>(50, std::min(options.timed, options.problems));
  options.problems = std::max(options.problems, options.timed);
  return options;
}

bool is_ours(const Entry& entry) { return entry.who.rfind("Framewise", 0) == 0; }

void measure(const std::vector<Entry>& entries, const Options& options) {
  constexpr Scene kMotions[] = {Scene::kRandom, Scene::kOdometry};
  std::vector<Row> rows[2];
  for (int m = 0; m < 2; ++m) {
    testing::Random random(options.seed);
    std::vector<TwoViewProblem> problems;
    for (std::size_t i = 0; i < options.problems; ++i) {
      problems.push_back(make_problem(kMotions[m], entries[0].points, random));
    }
    for (const Entry& entry : entries) entry.contestant->load(problems);
    const std::vector<double> times = time_all(entries, options.timed, options.repetitions);
    for (std::size_t k = 0; k < entries.size(); ++k) {
      Row row;
      row.microseconds = times[k];
      judge(entries[k], problems, row);
      rows[m].push_back(row);
    }
    for (const Entry& entry : entries) entry.contestant->load({});
  }
  double fastest_peer = 0;
  for (std::size_t k = 0; k < entries.size(); ++k) {
    const double t = rows[0][k].microseconds;
    if (!is_ours(entries[k]) && (fastest_peer == 0 || t < fastest_peer)) fastest_peer = t;
  }
  for (std::size_t k = 0; k < entries.size(); ++k) {
    const Row &wide = rows[0][k], &odometry = rows[1][k];
    std::printf("| %s | %s | %.2f / %.2f | ", entries[k].task.c_str(), entries[k].who.c_str(),
                wide.microseconds, odometry.microseconds);
    if (fastest_peer > 0) std::printf("%.2f", wide.microseconds / fastest_peer);
    std::printf(" | %.3f / %.3f | %.0e / %.0e | %.0e / %.0e |\n", 100 * wide.failures,
                100 * odometry.failures, wide.median_error, odometry.median_error, wide.max_error,
                odometry.max_error);
    std::fflush(stdout);
  }
}

void run(int argc, char** argv) {
  const Options options = parse(argc, argv);
  Registry registry;
  register_essential(registry);
#ifdef FRAMEWISE_BENCH_MINIMAL
  register_minimal(registry);
#endif
  std::printf("bench_solvers --problems %zu --timed %zu --repetitions %d --seed %llu\n", options.problems,
              options.timed, options.repetitions, static_cast<unsigned long long>(options.seed));
  std::printf(
      "Noise-free; wide / odometry motion; failure: best rotation further than %g rad from the truth.\n\n",
      kFailure);
  std::printf(
      "| task | solver | us a call | time / fastest peer | failures %% | median error (rad) | max error |\n");
  std::printf("|---|---|---|---|---|---|---|\n");
  std::vector<std::string> tasks;
  for (const Entry& entry : registry.entries()) {
    if (std::find(tasks.begin(), tasks.end(), entry.task) == tasks.end()) tasks.push_back(entry.task);
  }
  for (const std::string& task : tasks) {
    if (task.find(options.only) == std::string::npos) continue;
    std::vector<Entry> entries;
    for (const Entry& entry : registry.entries()) {
      if (entry.task == task) entries.push_back(entry);
    }
    measure(entries, options);
  }
}

}  // namespace
}  // namespace framewise::bench

int main(int argc, char** argv) {
  framewise::bench::run(argc, argv);
  return 0;
}
