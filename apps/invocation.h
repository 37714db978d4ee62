// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace framewise::apps {

// How the program was called and where: what a report says so that the work can be done again.
struct Invocation {
  std::string command;  // as a shell takes it
  std::string machine;  // processor, its threads, and the system; no names of hosts or people
};
Invocation invocation_of(int argc, const char* const* argv);

}  // namespace framewise::apps
