#include "study/study_runner.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <list>
#include <nlohmann/json.hpp>
#include <optional>
#include <thread>

#include "base/error.hpp"
#include "base/printable.hpp"
#include "io/disk_file.hpp"
#include "study/child_process.hpp"
#include "study/recommendation.hpp"
#include "study/results_folder.hpp"

namespace ixos {
namespace {

using Json = nlohmann::json;

Json read_json(const std::string& path) {
  std::ifstream file = open_text(path);
  Json json = Json::parse(file, nullptr, false);
  return json.is_object() ? json : Json();
}

/// Returns a value of a record, or a default if the file has no value of that type there.
template <class T>
T entry(const Json& record, const char* name, T otherwise) {
  const auto found = record.find(name);
  if (found == record.end()) return otherwise;
  const bool fits = std::is_same_v<T, std::string> ? found->is_string()
                    : std::is_integral_v<T>        ? found->is_number_integer()
                                                   : found->is_number();
  return fits ? found->get<T>() : otherwise;
}

/// Returns a mark of a program's file that changes when the program is rebuilt.
std::string file_mark(const std::string& path) {
  std::error_code code;
  const auto size = std::filesystem::file_size(path, code);
  const auto time = std::filesystem::last_write_time(path, code).time_since_epoch().count();
  if (code) throw FileError(path + ": cannot be read: " + code.message());
  return fmt::format("{} bytes, {}", size, time);
}

class Runner {
 public:
  Runner(const Study& study, const RunnerOptions& options)
      : study_(study), options_(options), driver_(file_mark(options.driver)) {}

  StudyStatus run(std::vector<StudyResult>& results, ReferenceQuality& quality) {
    std::string reference = study_.reference_folder;
    if (reference.empty()) {
      StudyRun run{"reference", {}, study_.common};
      run.settings.insert(run.settings.end(), study_.reference.begin(), study_.reference.end());
      std::vector<StudyResult> found;
      if (!run_all({run}, 1, nullptr, found)) return StudyStatus::Interrupted;
      reference = folder(run);
      if (!found.front().reached_its_end()) {
        results = std::move(found);
        return StudyStatus::ReferenceFailed;
      }
    }
    StudyReference compared(reference, study_.errors);
    std::string unknown = study_.check.description;
    if (!study_.check.settings.empty() && !check(compared, unknown)) return StudyStatus::Interrupted;
    quality = compared.quality();
    if (quality.origin.empty() && quality.unknown.empty()) quality.unknown = unknown;
    return run_all(study_.runs, study_.jobs, &compared, results) ? StudyStatus::Done : StudyStatus::Interrupted;
  }

 private:
  struct Active {
    std::size_t number;
    std::string scene;  ///< its text
    ChildProcess process;
    bool timed_out = false;
  };

  std::string folder(const StudyRun& run) const { return options_.folder + "/runs/" + run.name; }

  /// Runs the check of the reference, and judges the reference by it, or says why not. Returns false if interrupted.
  bool check(StudyReference& compared, std::string& why_not) {
    StudyRun run{"reference-check", {}, study_.common};
    for (const Assignments* more : {&study_.reference, &study_.check.settings})
      run.settings.insert(run.settings.end(), more->begin(), more->end());
    std::vector<StudyResult> found;
    if (!run_all({run}, 1, nullptr, found)) return false;
    if (!found.front().reached_its_end()) {
      why_not = fmt::format("{} did not reach its end: {}", study_.check.description, found.front().reason);
      return true;
    }
    try {
      compared.judge(folder(run), study_.check.description);
    } catch (const InputError& error) {
      why_not = fmt::format("{} has {}", study_.check.description, error.what());
    }
    return true;
  }

  /// Carries out the runs. Returns false if interrupted. Results come in the order of the runs, without those that did
  /// not end.
  bool run_all(const std::vector<StudyRun>& runs, int jobs, const StudyReference* reference,
               std::vector<StudyResult>& results) {
    std::vector<std::optional<StudyResult>> found(runs.size());
    std::list<Active> active;
    std::size_t next = 0, done = 0;
    bool stopping = false;
    const auto finish = [&](std::size_t number, bool reused) {
      found[number] = result(runs[number], reference);
      ++done;
      if (options_.watch) options_.watch(*found[number], done, reused);
    };
    while (done < runs.size()) {
      while (!stopping && next < runs.size() && active.size() < static_cast<std::size_t>(jobs)) {
        const std::size_t number = next++;
        std::string scene = scene_text(study_, runs[number].settings);
        if (is_done(runs[number], scene))
          finish(number, true);
        else
          active.push_back({number, std::move(scene), start(runs[number])});
      }
      if (active.empty() && (stopping || next == runs.size())) break;
      for (auto child = active.begin(); child != active.end();) {
        if (const auto number = ended(*child, runs)) {
          child = active.erase(child);
          if (!stopping) finish(*number, false);
        } else {
          ++child;
        }
      }
      if (!stopping && options_.interrupted && options_.interrupted()) {
        stopping = true;
        for (const Active& child : active) child.process.send(SIGTERM);
      }
      if (!active.empty()) std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    for (std::optional<StudyResult>& result : found)
      if (result) results.push_back(std::move(*result));
    return !stopping;
  }

  ChildProcess start(const StudyRun& run) const {
    std::error_code code;
    std::filesystem::create_directories(folder(run), code);
    if (code) throw FileError(folder(run) + ": cannot be created: " + code.message());
    std::filesystem::remove(folder(run) + "/run.json");
    std::filesystem::remove(folder(run) + "/summary.json");
    // A run that did not end is run again: it needs no checkpoints, unless the study sets some. The study may have
    // changed since the results in its folder were written.
    std::vector<std::string> command{options_.driver, study_.scene,  "--quiet", "--output",
                                     folder(run),     "--overwrite", "--set",   "Output/Checkpoint/Keep=0"};
    for (const std::string& assignment : run.settings) command.insert(command.end(), {"--set", assignment});
    return {command, folder(run) + "/log.txt"};
  }

  /// Returns the run's number if it has ended, after writing its record; otherwise nothing.
  std::optional<std::size_t> ended(Active& child, const std::vector<StudyRun>& runs) const {
    ChildOutcome outcome;
    if (!child.process.ended(outcome)) {
      if (study_.time_limit > 0 && child.process.age() > study_.time_limit) {
        child.timed_out = true;
        child.process.send(SIGKILL);
      }
      return std::nullopt;
    }
    // A child that was terminated has no result. One that crashed has: it would crash again.
    if (outcome.exit_status == 5 || outcome.exit_status == 128 + SIGTERM || outcome.exit_status == 128 + SIGINT)
      return child.number;
    child.timed_out = child.timed_out && outcome.exit_status == 128 + SIGKILL;
    Json record;
    record["scene"] = child.scene;
    record["version"] = options_.version;
    record["driver"] = driver_;
    record["exit_status"] = outcome.exit_status;
    record["cpu_seconds"] = outcome.cpu_seconds;
    record["time_limit"] = child.timed_out ? study_.time_limit : 0;
    write_whole_file(folder(runs[child.number]) + "/run.json",
                     record.dump(2, ' ', false, Json::error_handler_t::replace) + '\n');
    return child.number;
  }

  /// Returns whether this version has a result of this scene. A result cut off by a time limit counts if the present
  /// limit is not longer.
  bool is_done(const StudyRun& run, const std::string& scene) const {
    const Json record = read_json(folder(run) + "/run.json");
    if (record.is_null() || entry<std::string>(record, "scene", "") != scene ||
        entry<std::string>(record, "version", "") != options_.version ||
        entry<std::string>(record, "driver", "") != driver_)
      return false;
    for (const char* file : {"/summary.json", "/history.csv", "/effective.xml"})
      if (entry(record, "exit_status", -1) == 0 && !std::filesystem::exists(folder(run) + file)) return false;
    const int status = entry(record, "exit_status", -1);
    const double limit = entry(record, "time_limit", 0.0);
    return status == 0 || status == 3 || (limit > 0 && study_.time_limit > 0 && study_.time_limit <= limit);
  }

  StudyResult result(const StudyRun& run, const StudyReference* reference) const {
    StudyResult result;
    result.run = run;
    const Json record = read_json(folder(run) + "/run.json"), summary = read_json(folder(run) + "/summary.json");
    if (record.is_null()) {
      result.status = "interrupted";
      result.reason = "ended by a signal";
      return result;
    }
    result.cpu_seconds = entry(record, "cpu_seconds", 0.0);
    const int status = entry(record, "exit_status", -1);
    if (const double limit = entry(record, "time_limit", 0.0); limit > 0 || (status != 0 && status != 3)) {
      result.status = "failed";
      result.reason = limit > 0 ? fmt::format("not finished after the time limit of {} s", limit)
                                : last_line(folder(run) + "/log.txt");
      if (limit == 0 && status > 128) result.reason = fmt::format("ended by signal {}", status - 128);
      result.wall_seconds = limit;
      return result;
    }
    result.status = entry<std::string>(summary, "status", "failed");
    result.reason = entry<std::string>(summary, "reason", "");
    result.wall_seconds = entry(summary, "wall_seconds", 0.0);
    result.steps = entry(summary, "steps", 0L);
    result.rejected_steps = entry(summary, "rejected_steps", 0L);
    result.newton_iterations = entry(summary, "newton_iterations", 0L);
    result.linear_iterations = entry(summary, "linear_iterations", 0L);
    result.peak_memory_bytes = entry(summary, "peak_memory_bytes", 0.0);
    result.end_time = entry(summary, "end_time", 0.0);
    if (!result.reached_its_end() || reference == nullptr) return result;
    try {
      result.errors = reference->errors(folder(run));
    } catch (const InputError& error) {
      result.reason = error.what();  // a result without errors; the others have theirs
    }
    return result;
  }

  const Study& study_;
  const RunnerOptions& options_;
  std::string driver_;  ///< results of another build are not reused
};

}  // namespace

StudyOutcome run_study(const Study& study, const RunnerOptions& options) {
  std::error_code code;
  std::filesystem::create_directories(options.folder, code);
  if (code) throw FileError("the results folder cannot be used: " + options.folder + ": " + code.message());
  const std::string scene = std::filesystem::absolute(study.scene).lexically_normal().string();
  const std::string owner = printable(fmt::format("the study \"{}\" of {}", study.name, scene));
  const ResultsFolder held(options.folder, owner, options.overwrite);
  StudyOutcome outcome;
  ReferenceQuality quality;
  outcome.status = Runner(study, options).run(outcome.results, quality);
  if (outcome.status != StudyStatus::Done) return outcome;
  write_study(study, outcome.results, quality, options.folder, options.command, options.version);
  outcome.recommendation = recommend(study, outcome.results, quality).sentence;
  return outcome;
}

}  // namespace ixos
