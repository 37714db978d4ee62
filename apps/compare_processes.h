// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <signal.h>
#include <sys/types.h>

#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace framewise::apps {

// Runs this very program with other arguments, several at once. A child dies with this process, however it
// ends. While there is a pool, SIGINT, SIGTERM and SIGHUP are not acted upon but reported by wait(). To be
// used from one thread.
class ChildProcesses {
 public:
  struct Ended {
    std::size_t id = 0;
    int exit_code = -1;  // -1: ended by the signal
    int signal = 0;
  };

  ChildProcesses();
  ~ChildProcesses();  // ends the children
  ChildProcesses(const ChildProcesses&) = delete;
  ChildProcesses& operator=(const ChildProcesses&) = delete;

  // Its standard error goes to the file, its standard output nowhere. Throws std::runtime_error.
  void start(std::size_t id, const std::vector<std::string>& arguments, const std::filesystem::path& errors);

  std::size_t running() const { return ids_.size(); }

  // The next that ends; empty when a signal asks this process to stop. There must be one running.
  std::optional<Ended> wait();

 private:
  std::optional<Ended> reap();

  sigset_t awaited_, before_;
  std::map<pid_t, std::size_t> ids_;
};

}  // namespace framewise::apps
