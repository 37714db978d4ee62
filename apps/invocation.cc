// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "invocation.h"

#include <fmt/format.h>
#include <sys/utsname.h>

#include <algorithm>
#include <fstream>
#include <string_view>
#include <thread>

namespace framewise::apps {
namespace {

bool is_plain(char c) {
  return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
         std::string_view("-_./=:,+@%").find(c) != std::string_view::npos;
}

std::string shell_word(const std::string& word) {
  if (!word.empty() && std::all_of(word.begin(), word.end(), is_plain)) return word;
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

std::string processor() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
    if (const auto colon = line.find(": "); line.starts_with("model name") && colon != std::string::npos)
      return line.substr(colon + 2);
  return "unknown processor";
}

}  // namespace

Invocation invocation_of(int argc, const char* const* argv) {
  Invocation invocation;
  invocation.command = "framewise";
  for (int i = 1; i < argc; ++i) invocation.command += " " + shell_word(argv[i]);
  utsname system{};
  uname(&system);
  invocation.machine =
      fmt::format("{}, {} threads, {} {} {}", processor(), std::thread::hardware_concurrency(),
                  system.sysname, system.release, system.machine);
  return invocation;
}

}  // namespace framewise::apps
