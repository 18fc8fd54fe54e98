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
#include "study/child_process.hpp"

namespace ixos {
namespace {

using Json = nlohmann::json;

Json read_json(const std::string& path) {
  std::ifstream file(path);
  Json json = Json::parse(file, nullptr, false);
  return json.is_object() ? json : Json();
}

std::string last_line(const std::string& path) {
  std::ifstream file(path);
  std::string last;
  for (std::string line; std::getline(file, line);)
    if (!line.empty()) last = line;
  return last.substr(0, 400);
}

class Runner {
 public:
  Runner(const Study& study, const RunnerOptions& options) : study_(study), options_(options) {}

  StudyStatus run(std::vector<StudyResult>& results) {
    std::string reference = study_.reference_folder;
    if (reference.empty()) {
      StudyRun run{"reference", {}, study_.common};
      run.settings.insert(run.settings.end(), study_.reference.begin(), study_.reference.end());
      std::vector<StudyResult> found;
      if (!run_all({run}, 1, "", found)) return StudyStatus::Interrupted;
      reference = folder(run);
      if (!found.front().reached_its_end()) {
        results = std::move(found);
        return StudyStatus::ReferenceFailed;
      }
    }
    return run_all(study_.runs, study_.jobs, reference, results) ? StudyStatus::Done : StudyStatus::Interrupted;
  }

 private:
  struct Active {
    std::size_t number;
    std::string scene;  ///< its text
    ChildProcess process;
    bool timed_out = false;
  };

  std::string folder(const StudyRun& run) const { return options_.folder + "/runs/" + run.name; }

  /// False where interrupted. Results in the order of the runs, without those that did not end.
  bool run_all(const std::vector<StudyRun>& runs, int jobs, const std::string& reference,
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
    if (code) throw FileError(folder(run) + ": cannot be made: " + code.message());
    std::filesystem::remove(folder(run) + "/run.json");
    std::filesystem::remove(folder(run) + "/summary.json");
    std::vector<std::string> command{options_.driver, study_.scene, "--quiet", "--output", folder(run)};
    for (const std::string& assignment : run.settings) command.insert(command.end(), {"--set", assignment});
    return {command, folder(run) + "/log.txt"};
  }

  /// The run's number once it has ended; its record is then written.
  std::optional<std::size_t> ended(Active& child, const std::vector<StudyRun>& runs) const {
    ChildOutcome outcome;
    if (!child.process.ended(outcome)) {
      if (study_.time_limit > 0 && child.process.age() > study_.time_limit) {
        child.timed_out = true;
        child.process.send(SIGKILL);
      }
      return std::nullopt;
    }
    // A child that was told to end has no result.
    if (outcome.exit_status == 5 || (outcome.exit_status > 128 && !child.timed_out)) return child.number;
    Json record;
    record["scene"] = child.scene;
    record["version"] = options_.version;
    record["exit_status"] = outcome.exit_status;
    record["cpu_seconds"] = outcome.cpu_seconds;
    record["time_limit"] = child.timed_out ? study_.time_limit : 0;
    const std::string path = folder(runs[child.number]) + "/run.json";
    std::ofstream file(path + ".new");
    file << record.dump(2) << '\n';
    file.close();
    std::error_code code;
    if (file) std::filesystem::rename(path + ".new", path, code);
    if (!file || code) throw FileError(path + ": cannot be written");
    return child.number;
  }

  /// Is there a result of this scene, by this version? One cut off by a time limit counts as long as that is no longer.
  bool is_done(const StudyRun& run, const std::string& scene) const {
    const Json record = read_json(folder(run) + "/run.json");
    if (record.is_null() || record.value("scene", "") != scene || record.value("version", "") != options_.version)
      return false;
    const int status = record.value("exit_status", -1);
    const double limit = record.value("time_limit", 0.0);
    return status == 0 || status == 3 || (limit > 0 && study_.time_limit > 0 && study_.time_limit <= limit);
  }

  StudyResult result(const StudyRun& run, const std::string& reference) const {
    StudyResult result;
    result.run = run;
    const Json record = read_json(folder(run) + "/run.json"), summary = read_json(folder(run) + "/summary.json");
    if (record.is_null()) {
      result.status = "interrupted";
      result.reason = "ended by a signal";
      return result;
    }
    result.cpu_seconds = record.value("cpu_seconds", 0.0);
    const int status = record.value("exit_status", -1);
    if (const double limit = record.value("time_limit", 0.0); limit > 0 || (status != 0 && status != 3)) {
      result.status = "failed";
      result.reason = limit > 0 ? fmt::format("not done after {} s", limit) : last_line(folder(run) + "/log.txt");
      result.wall_seconds = limit;
      return result;
    }
    result.status = summary.value("status", "failed");
    result.reason = summary.value("reason", "");
    result.wall_seconds = summary.value("wall_seconds", 0.0);
    result.steps = summary.value("steps", 0L);
    result.rejected_steps = summary.value("rejected_steps", 0L);
    result.newton_iterations = summary.value("newton_iterations", 0L);
    result.linear_iterations = summary.value("linear_iterations", 0L);
    result.peak_memory_bytes = summary.value("peak_memory_bytes", 0.0);
    result.end_time = summary.value("end_time", 0.0);
    if (result.reached_its_end() && !reference.empty())
      result.errors = study_errors(folder(run), reference, study_.errors);
    return result;
  }

  const Study& study_;
  const RunnerOptions& options_;
};

}  // namespace

StudyStatus run_study(const Study& study, const RunnerOptions& options, std::vector<StudyResult>& results) {
  return Runner(study, options).run(results);
}

}  // namespace ixos
