// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <memory>
#include <thread>

#include "commands.h"
#include "compare_presets.h"
#include "compare_results.h"
#include "compare_work.h"
#include "framewise/io/input_error.h"
#include "framewise/io/output_file.h"
#include "framewise/io/trajectory_files.h"
#include "framewise/report/comparison_csv.h"
#include "framewise/report/comparison_json.h"
#include "framewise/report/comparison_tables.h"
#include "report_files.h"

namespace framewise::apps {
namespace {

namespace fs = std::filesystem;

struct CompareCommand {
  std::vector<fs::path> paths;
  fs::path out, published, figures;
  std::string grid;
  DatasetOptions dataset;
  int repeats = 1, threads = 0;
  std::uint64_t seed = 0;
  bool quiet = false, json = false, no_report = false;

  void check() const {
    if (repeats < 1 || repeats > 10000)
      throw std::invalid_argument(fmt::format("repeats: found {}, expected 1 to 10000", repeats));
    if (threads < 0)
      throw std::invalid_argument(fmt::format("threads: found {}, expected 0 (all cores) or more", threads));
  }
  std::size_t processes() const {
    return static_cast<std::size_t>(threads > 0 ? threads
                                                : std::max(1u, std::thread::hardware_concurrency()));
  }
};

// Two comparisons that write the same folders would spoil each other's.
class FolderLock {
 public:
  explicit FolderLock(const fs::path& folder)
      : file_(open((folder / "lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666)) {
    if (file_ < 0)
      throw InputError(folder, 0, "", "a folder that cannot be written", "a folder to write to (--out)");
    if (flock(file_, LOCK_EX | LOCK_NB) == 0) return;
    close(file_);
    throw InputError(folder, 0, "", "another comparison at work", "a folder of its own (--out)");
  }
  ~FolderLock() { close(file_); }
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  int file_;
};

// The data set options that were typed, to be typed again.
std::vector<std::string> typed_dataset_options(const CLI::App& app) {
  DatasetOptions ignored;
  CLI::App known;
  add_dataset_options(known, ignored);
  std::vector<std::string> typed;
  for (const CLI::Option* option : known.get_options())
    if (const CLI::Option* given = app.get_option_no_throw(option->get_name()); given && given->count() > 0)
      for (const std::string& value : given->results()) typed.push_back(option->get_name() + "=" + value);
  return typed;
}

void write_truths(const ComparePlan& plan) {
  for (const PlannedDataset& dataset : plan.datasets) {
    if (!dataset.recording.has_truth()) continue;
    make_output_folder(dataset.folder, "--out");
    write_tum_trajectory(dataset.folder / "truth.tum", dataset.recording.true_trajectory());
  }
}

void write_results(const fs::path& out, const Comparison& comparison, const std::string& json) {
  write_whole(out / "table.csv", to_csv(comparison_csv_table(comparison)), "--out");
  write_whole(out / "table.md", comparison_markdown(comparison), "--out");
  write_whole(out / "table.tex", comparison_latex(comparison), "--out");
  write_whole(out / "results.json", json, "--out");
}

// What the report says of the work: apart from the results, which are the same wherever they are made.
void write_invocation(const fs::path& out, const Invocation& invocation) {
  const nlohmann::ordered_json json = {{"command", invocation.command}, {"machine", invocation.machine}};
  make_output_folder(out / kReportData, "--out");
  write_whole(out / kReportData / "invocation.json",
              json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n", "--out");
}

std::size_t count_failed(const Comparison& comparison) {
  return static_cast<std::size_t>(std::count_if(comparison.rows.begin(), comparison.rows.end(),
                                                [](const ComparisonRow& row) { return row.failed > 0; }));
}

int compare(const CompareCommand& command, const CLI::App& app, const Invocation& invocation) {
  command.check();
  const Grid grid = grid_from_name(command.grid);
  std::vector<PublishedFigures> published;
  if (!command.published.empty()) published = read_published_figures(command.published);
  const ComparePlan plan =
      make_compare_plan(command.paths, grid, command.dataset, typed_dataset_options(app),
                        {command.out, command.seed, static_cast<std::size_t>(command.repeats)});
  make_output_folder(command.out, "--out");
  const FolderLock lock(command.out);
  write_truths(plan);
  const auto outcomes = do_compare_work(plan, command.out, command.processes(), command.quiet);

  Comparison comparison;
  comparison.version = FRAMEWISE_VERSION;
  comparison.grid = grid.source.string();
  comparison.seed = command.seed;
  comparison.repeats = static_cast<std::size_t>(command.repeats);
  comparison.statistics.bootstrap.seed = command.seed;
  comparison.has_published = !published.empty();
  fill_comparison(comparison, plan, outcomes, published);
  const std::string json = to_json(comparison).dump(2) + "\n";
  write_results(command.out, comparison, json);
  remove_report(command.out);
  if (!command.no_report) {
    write_invocation(command.out, invocation);
    write_report(command.out, command.figures);
  }

  const std::size_t failed = count_failed(comparison);
  if (command.json)
    fmt::print("{}", json);
  else if (!command.quiet)
    fmt::print("{} rows, {} with failed repeats. Written: {}\n", comparison.rows.size(), failed,
               (command.out / "{table.md,table.csv,table.tex,results.json").string() +
                   (command.no_report ? "}" : ",report.html}"));
  for (const ComparisonRow& row : comparison.rows)
    if (row.failed < row.repeats) return 0;
  throw std::runtime_error("every row failed; the first: " + comparison.rows.front().failure);
}

}  // namespace

void add_compare(CLI::App& program, Action& action, const Invocation& invocation) {
  const auto command = std::make_shared<CompareCommand>();
  CLI::App* app =
      program.add_subcommand("compare", "Many methods on the same matches of recordings, in tables");
  app->add_option("DATASET", command->paths, "recordings as `run` takes them, or correspondence archives")
      ->required();
  app->add_option("--grid", command->grid,
                  "frame-to-frame, lab, dark, or a YAML file of methods and features")
      ->required();
  app->add_option("--out", command->out,
                  "folder for tables, results.json, matches and runs; what is there is kept")
      ->required();
  app->add_option("--repeats", command->repeats, "seeds for each row")->capture_default_str();
  app->add_option("--seed", command->seed, "the first of them")->capture_default_str();
  app->add_option("--threads", command->threads, "processes at once; 0: all cores; changes nothing but times")
      ->capture_default_str();
  app->add_option("--published", command->published, "CSV of figures that others published, put beside ours");
  add_dataset_options(*app, command->dataset);
  app->add_flag("--no-report", command->no_report, "no report.html");
  app->add_option("--figures", command->figures, "folder to write the report's plots to as SVG and PNG")
      ->excludes("--no-report");
  app->add_flag("--json", command->json, "print results.json on standard output");
  app->add_flag("--quiet", command->quiet, "print nothing but errors");
  app->footer(
      "Examples:\n"
      "  framewise compare rgbd_dataset_freiburg1_desk --grid frame-to-frame --repeats 5 --out out/desk\n"
      "  framewise compare desk room --grid my_methods.yaml --published tables.csv --out out/mine");
  app->callback([command, app, &action, &invocation] {
    action = [command, app, &invocation] { return compare(*command, *app, invocation); };
  });
}

}  // namespace framewise::apps
