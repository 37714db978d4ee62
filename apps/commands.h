// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <functional>

#include "invocation.h"

namespace framewise::apps {

// Each adds its subcommand to the program. The action runs after parsing; its value is the exit code.
using Action = std::function<int()>;
void add_run(CLI::App& program, Action& action, const Invocation& invocation);
void add_evaluate(CLI::App& program, Action& action);
void add_compare(CLI::App& program, Action& action, const Invocation& invocation);
void add_relpose(CLI::App& program, Action& action);
void add_simulate(CLI::App& program, Action& action);
void add_flexion(CLI::App& program, Action& action);
void add_inspect(CLI::App& program, Action& action);
void add_report(CLI::App& program, Action& action);

}  // namespace framewise::apps
