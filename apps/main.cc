// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
// The command-line program: parses, calls the library, prints. Exit codes: 0 done, 1 the work failed, 2 wrong
// usage or bad input.
#include <fmt/format.h>

#include <exception>
#include <opencv2/core.hpp>
#include <opencv2/core/utils/logger.hpp>

#include "commands.h"
#include "framewise/io/input_error.h"

namespace {

constexpr int kWorkFailed = 1, kBadInput = 2;

int complain(const std::exception& error, int code) {
  fmt::print(stderr, "framewise: {}\n", error.what());
  return code;
}

}  // namespace

int main(int argc, char** argv) {
  // The frames are what runs side by side here; threads inside an image would only compete with them.
  cv::setNumThreads(1);
  cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);

  CLI::App program("Frame-to-frame visual odometry you can trust", "framewise");
  program.set_version_flag("--version", "framewise " FRAMEWISE_VERSION);
  program.require_subcommand(1);
  framewise::apps::Action action;
  const framewise::apps::Invocation invocation = framewise::apps::invocation_of(argc, argv);
  framewise::apps::add_run(program, action, invocation);
  framewise::apps::add_evaluate(program, action);
  framewise::apps::add_compare(program, action, invocation);
  framewise::apps::add_relpose(program, action);
  framewise::apps::add_simulate(program, action);
  framewise::apps::add_flexion(program, action);
  framewise::apps::add_inspect(program, action);
  framewise::apps::add_report(program, action);
  program.footer("framewise COMMAND --help explains a command and gives examples.");

  try {
    program.parse(argc, argv);
    return action();
  } catch (const CLI::Success& success) {  // --help, --version
    return program.exit(success);
  } catch (const CLI::ParseError& error) {
    return complain(error, kBadInput);
  } catch (const framewise::InputError& error) {
    return complain(error, kBadInput);
  } catch (const std::invalid_argument& error) {
    return complain(error, kBadInput);
  } catch (const std::exception& error) {
    return complain(error, kWorkFailed);
  }
}
