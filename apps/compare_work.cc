// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "compare_work.h"

#include <fmt/format.h>

#include <deque>
#include <fstream>

#include "compare_processes.h"
#include "framewise/io/output_file.h"
#include "progress.h"

namespace framewise::apps {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

fs::path unfinished(const PlannedJob& job) { return job.folder.string() + ".part"; }

Json read_json(const fs::path& path) {
  std::ifstream file(path);
  return Json::parse(file, nullptr, false);
}

void replace_all(std::string& text, const std::string& from, const std::string& to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
    text.replace(at, from.size(), to);
}

// The last line a process left on standard error, as it would read after the folder has its name.
std::string last_line(const fs::path& file, const PlannedJob& job, const fs::path& out) {
  std::ifstream stream(file);
  std::string last;
  for (std::string line; std::getline(stream, line);)
    if (line.find_first_not_of(" \r\t") != std::string::npos) last = line;
  if (last.starts_with("framewise: ")) last.erase(0, 11);
  replace_all(last, unfinished(job).string(), job.folder.string());
  replace_all(last, (out / "").string(), "");
  return last;
}

class Work {
 public:
  Work(const ComparePlan& plan, const fs::path& out, bool quiet)
      : plan_(plan), out_(out), progress_("compare", count_jobs(plan), quiet, "runs") {}

  std::map<fs::path, JobOutcome> run(std::size_t processes) {
    for (std::size_t i = 0; i < plan_.archives.size(); ++i) add_archive(i);
    ChildProcesses children;
    while (!queue_.empty() || children.running() > 0) {
      while (!queue_.empty() && children.running() < processes) {
        start(children, queue_.front());
        queue_.pop_front();
      }
      const auto ended = children.wait();
      if (!ended)
        throw std::runtime_error(
            fmt::format("stopped after {} of {} runs; the same command goes on from there", outcomes_.size(),
                        count_jobs(plan_)));
      finish(*ended);
    }
    return std::move(outcomes_);
  }

 private:
  static std::size_t count_jobs(const ComparePlan& plan) {
    std::size_t count = 0;
    for (const PlannedArchive& archive : plan.archives) count += !archive.is_given;
    for (const PlannedRow& row : plan.rows) count += row.runs.size();
    return count;
  }

  // Of the archive whose rows wait for it, else of a row.
  struct Task {
    const PlannedJob* job;
    const PlannedArchive* archive;
  };

  void add_archive(std::size_t index) {
    const PlannedArchive& archive = plan_.archives[index];
    if (archive.is_given) return add_rows(archive);
    if (const auto done = recorded(archive.job)) return archive_ended(archive, *done);
    queue_.push_back({&archive.job, &archive});
  }

  void add_rows(const PlannedArchive& archive) {
    for (const PlannedRow& row : plan_.rows) {
      if (&plan_.archives[row.archive] != &archive) continue;
      for (const PlannedJob& job : row.runs)
        if (const auto done = recorded(job))
          add_outcome(job, *done);
        else
          queue_.push_back({&job, nullptr});
    }
  }

  void archive_ended(const PlannedArchive& archive, const JobOutcome& outcome) {
    add_outcome(archive.job, outcome);
    if (outcome.is_whole) return add_rows(archive);
    const JobOutcome failed{false, outcome.exit_code, "no matches: " + outcome.message};
    for (const PlannedRow& row : plan_.rows)
      if (&plan_.archives[row.archive] == &archive)
        for (const PlannedJob& job : row.runs) add_outcome(job, failed);
  }

  void add_outcome(const PlannedJob& job, const JobOutcome& outcome) {
    outcomes_[job.folder] = outcome;
    progress_.advance();
  }

  // Empty where the job is still to be done.
  static std::optional<JobOutcome> recorded(const PlannedJob& job) {
    const Json record = read_json(job.folder / "record.json");
    if (!record.is_object() || record.value("key", Json()) != job.key) return std::nullopt;
    return JobOutcome{true, record.value("exit_code", 0), record.value("message", "")};
  }

  void start(ChildProcesses& children, const Task& task) {
    const fs::path folder = unfinished(*task.job);
    fs::remove_all(folder);
    make_output_folder(folder, "--out");
    std::vector<std::string> arguments = task.job->arguments;
    arguments.insert(arguments.end(), {"--threads", "1", "--quiet", "--no-report", "--out", folder.string()});
    if (task.archive)
      arguments.insert(arguments.end(), {"--archive", (folder / task.archive->file.filename()).string()});
    children.start(tasks_.size(), arguments, folder / "errors.txt");
    tasks_.push_back(task);
  }

  void finish(const ChildProcesses::Ended& ended) {
    const Task& task = tasks_[ended.id];
    const PlannedJob& job = *task.job;
    const fs::path folder = unfinished(job), errors = folder / "errors.txt";
    JobOutcome outcome{true, ended.exit_code, ""};
    if (ended.signal != 0)
      outcome = {false, -1, fmt::format("ended by signal {}", ended.signal)};
    else if (ended.exit_code != 0)
      outcome.message = fmt::format("exit code {}: {}", ended.exit_code, last_line(errors, job, out_));
    // A run in which no motion could be measured (exit code 1) has written all matches all the same.
    if (task.archive)
      outcome.is_whole = ended.signal == 0 && fs::exists(folder / task.archive->file.filename());

    if (outcome.is_whole) {
      std::error_code ignored;
      if (fs::file_size(errors, ignored) == 0) fs::remove(errors, ignored);
      const Json record = {{"key", job.key}, {"exit_code", outcome.exit_code}, {"message", outcome.message}};
      open_output_file(folder / "record.json", "--out") << record.dump(2) << '\n';
      fs::remove_all(job.folder);
      fs::rename(folder, job.folder);
    }
    if (task.archive)
      archive_ended(*task.archive, outcome);
    else
      add_outcome(job, outcome);
  }

  const ComparePlan& plan_;
  const fs::path& out_;
  Progress progress_;
  std::deque<Task> queue_;
  std::vector<Task> tasks_;  // by the number of the process
  std::map<fs::path, JobOutcome> outcomes_;
};

}  // namespace

std::map<fs::path, JobOutcome> do_compare_work(const ComparePlan& plan, const fs::path& out,
                                               std::size_t processes, bool quiet) {
  return Work(plan, out, quiet).run(processes);
}

}  // namespace framewise::apps
