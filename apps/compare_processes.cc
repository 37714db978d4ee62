// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "compare_processes.h"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>

namespace framewise::apps {
namespace {

// Between fork and exec; calls nothing that may allocate.
[[noreturn]] void become(char* const* arguments, int errors, const sigset_t& signals, pid_t parent) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(127);  // it died before the line above
  const int nowhere = open("/dev/null", O_RDWR);
  dup2(nowhere, STDIN_FILENO);
  dup2(nowhere, STDOUT_FILENO);
  dup2(errors, STDERR_FILENO);
  sigprocmask(SIG_SETMASK, &signals, nullptr);
  execv("/proc/self/exe", arguments);
  _exit(127);
}

}  // namespace

ChildProcesses::ChildProcesses() {
  sigemptyset(&awaited_);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGCHLD}) sigaddset(&awaited_, signal);
  sigprocmask(SIG_BLOCK, &awaited_, &before_);
}

ChildProcesses::~ChildProcesses() {
  for (const auto& [pid, id] : ids_) kill(pid, SIGKILL);
  for (const auto& [pid, id] : ids_) waitpid(pid, nullptr, 0);
  const timespec at_once{0, 0};  // what was reported is not acted upon later
  while (sigtimedwait(&awaited_, nullptr, &at_once) > 0) {
  }
  sigprocmask(SIG_SETMASK, &before_, nullptr);
}

void ChildProcesses::start(std::size_t id, const std::vector<std::string>& arguments,
                           const std::filesystem::path& errors) {
  std::vector<char*> argv{const_cast<char*>("framewise")};
  for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
  argv.push_back(nullptr);
  const int file = open(errors.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (file < 0)
    throw std::runtime_error(errors.string() + ": cannot be written (" + std::strerror(errno) + ")");
  const pid_t parent = getpid(), pid = fork();
  if (pid == 0) become(argv.data(), file, before_, parent);
  close(file);
  if (pid < 0) throw std::runtime_error(std::string("no process can be started: ") + std::strerror(errno));
  ids_[pid] = id;
}

std::optional<ChildProcesses::Ended> ChildProcesses::reap() {
  for (const auto& [pid, id] : ids_) {
    int status = 0;
    if (waitpid(pid, &status, WNOHANG) != pid) continue;
    Ended ended{id, WIFEXITED(status) ? WEXITSTATUS(status) : -1, WIFSIGNALED(status) ? WTERMSIG(status) : 0};
    ids_.erase(pid);
    return ended;
  }
  return std::nullopt;
}

std::optional<ChildProcesses::Ended> ChildProcesses::wait() {
  for (;;) {
    if (auto ended = reap()) return ended;
    const timespec a_second{1, 0};
    const int signal = sigtimedwait(&awaited_, nullptr, &a_second);
    if (signal > 0 && signal != SIGCHLD) return std::nullopt;
  }
}

}  // namespace framewise::apps
