// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "compare_plan.h"

namespace framewise::apps {

// How a job's process ended.
struct JobOutcome {
  bool is_whole = false;  // the job's folder is there, with all that the process wrote
  int exit_code = 0;
  std::string message;  // "exit code 2: ..." with its one line of standard error; empty for exit code 0
};

// Does what is not done yet of a plan, `processes` at once: archives, and rows as soon as theirs is there. A
// job writes into a folder of another name, which gets its own when all is in it, with record.json that has
// its key: whatever kills this process, a folder of a job's name is whole, and the next time is left as it
// is. Jobs that a signal ended and archives that failed are done again. Outcomes go by folder; rows whose
// archive failed have its. Throws std::runtime_error when a signal asks to stop, after all processes ended.
std::map<std::filesystem::path, JobOutcome> do_compare_work(const ComparePlan& plan,
                                                            const std::filesystem::path& out,
                                                            std::size_t processes, bool quiet);

}  // namespace framewise::apps
