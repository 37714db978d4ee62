// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/simulation/simulate.h"

#include <fmt/format.h>

#include <csignal>
#include <memory>

#include "commands.h"
#include "framewise/io/recording_writer.h"
#include "progress.h"
#include "simulate_options.h"

namespace framewise::apps {
namespace {

constexpr int kEndedEarly = 1;

struct SimulateCommand {
  std::filesystem::path out;
  SimulateChoice choice;
  bool quiet = false, json = false;
};

volatile std::sig_atomic_t interrupted = 0;

// While it lives, Ctrl-C is taken note of and nothing more; a second one ends the program.
class InterruptNote {
 public:
  InterruptNote() {
    interrupted = 0;
    before_ = std::signal(SIGINT, [](int) {
      interrupted = 1;
      std::signal(SIGINT, SIG_DFL);
    });
  }
  ~InterruptNote() { std::signal(SIGINT, before_); }

 private:
  void (*before_)(int);
};

// How many frames were written.
int write_frames(const SimulateOptions& options, bool quiet, RecordingWriter& writer) {
  const InterruptNote note;
  Progress progress("simulate", frame_count(options), quiet);
  int written = 0;
  simulate(options, [&](const SimulatedFrame& simulated) {
    writer.add(simulated.frame, simulated.true_depth);
    progress.advance();
    ++written;
    return !interrupted;
  });
  return written;
}

int run(const SimulateCommand& command) {
  const SimulateOptions options = resolved(command.choice);
  const DepthStorage storage = depth_storage(options, command.choice);
  const auto writer = recording_writer(command.choice.layout, command.out, sensor_of(options).camera, storage,
                                       options.rate_hz);
  if (!scene_of(options).is_lit && options.headlamp == 0 && !command.quiet)
    fmt::print(stderr, "{} has no light of its own: colour is black without --headlamp\n", options.scene);
  const int written = write_frames(options, command.quiet, *writer);
  writer->finish(true_trajectory(options, written));
  if (options.imu) {
    const ImuRecording imu = imu_recording(options, written);
    writer->write_imu(imu.readings, imu.truth, options.imu->rate_hz);
  }
  nlohmann::ordered_json record = record_of(options, command.choice, storage);
  record["frames"] = written;
  const std::string text = record.dump(2) + "\n";
  writer->write_text("simulation.json", text);
  const bool whole = written == frame_count(options);
  if (command.json)
    fmt::print("{}", text);
  else if (!command.quiet)
    fmt::print("Written: {} ({} frames{})\n", command.out.string(), written, whole ? "" : ", ended early");
  return whole ? 0 : kEndedEarly;
}

}  // namespace

void add_simulate(CLI::App& program, Action& action) {
  const auto command = std::make_shared<SimulateCommand>();
  CLI::App* app = program.add_subcommand("simulate", "A ray-traced recording with exact truth");
  app->add_option("--out", command->out, "folder to create")->required();
  add_simulate_options(*app, command->choice);
  app->add_flag("--json", command->json, "print simulation.json on standard output");
  app->add_flag("--quiet", command->quiet, "print nothing but errors");
  app->footer(
      "Examples:\n  framewise simulate room --frames 300 --out data/room\n"
      "  framewise simulate room --path drone-race --exposure-time 0.01 --imu-rate 500 --out data/fast\n"
      "  framewise simulate --mesh model.glb --mesh-up y --path poses.txt --out data/model\n"
      "  framewise simulate mine --headlamp 12 --depth lidar --layout kitti-depth --out data/mine\n"
      "  framewise simulate room --depth kinect --photons 200 --exposure 0.3 --out data/dusk");
  app->callback([command, &action] { action = [command] { return run(*command); }; });
}

}  // namespace framewise::apps
