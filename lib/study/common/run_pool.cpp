#include "study/common/run_pool.hpp"

#include <fmt/format.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <list>
#include <nlohmann/json.hpp>
#include <thread>
#include <type_traits>

#include "base/error.hpp"
#include "io/disk_file.hpp"

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

}  // namespace

/// A run that has begun.
struct RunPool::Active {
  std::size_t number;
  std::string scene;  ///< its text
  ChildProcess process;
  bool timed_out = false;
};

RunPool::RunPool(PoolOptions options) : options_(std::move(options)), driver_(file_mark(options_.driver)) {}

bool RunPool::carry_out(const std::vector<StudyRun>& runs, int jobs, const Finished& finished) const {
  std::list<Active> active;
  std::size_t next = 0, done = 0;
  bool stopping = false;
  const auto finish = [&](std::size_t number, bool reused) {
    ++done;
    if (finished) finished(number, reused);
  };
  while (done < runs.size()) {
    while (!stopping && next < runs.size() && active.size() < static_cast<std::size_t>(jobs)) {
      const std::size_t number = next++;
      std::string scene = changed_scene_text(options_.scene, runs[number].settings);
      if (is_done(runs[number], scene))
        finish(number, true);
      else
        active.push_back(start(runs[number], number, std::move(scene)));
    }
    if (active.empty() && (stopping || next == runs.size())) break;
    for (auto child = active.begin(); child != active.end();) {
      if (const std::size_t number = child->number; ended(*child, runs[number])) {
        child = active.erase(child);
        if (!stopping) finish(number, false);
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
  return !stopping;
}

void RunPool::make_folder(const StudyRun& run) const {
  std::error_code code;
  std::filesystem::create_directories(folder(run), code);
  if (code) throw FileError(folder(run) + ": cannot be created: " + code.message());
}

/// Starts the program with the run's scene and settings, and with these options before the settings.
ChildProcess RunPool::begin(const StudyRun& run, std::vector<std::string> options) const {
  options.insert(options.begin(), {options_.driver, options_.scene});
  for (const std::string& assignment : run.settings) options.insert(options.end(), {"--set", assignment});
  return {options, log(run)};
}

RunPool::Active RunPool::start(const StudyRun& run, std::size_t number, std::string scene) const {
  make_folder(run);
  std::filesystem::remove(folder(run) + "/run.json");
  std::filesystem::remove(folder(run) + "/summary.json");
  // A run that did not end is run again: it needs no checkpoints, unless the study sets some. The study may have
  // changed since the results in its folder were written.
  return {number, std::move(scene),
          begin(run, {"--quiet", "--output", folder(run), "--overwrite", "--set", "Output/Checkpoint/Keep=0"})};
}

int RunPool::check(const StudyRun& run, const std::string& setting) const {
  make_folder(run);
  StudyRun changed = run;
  changed.settings.push_back(setting);
  return begin(changed, {"--check"}).wait().exit_status;
}

/// Returns whether the run has ended, after writing its record. Ends a run that exceeds the time limit.
bool RunPool::ended(Active& child, const StudyRun& run) const {
  ChildOutcome outcome;
  if (!child.process.ended(outcome)) {
    const double spent = options_.limits_processor_time ? child.process.processor_seconds() : child.process.age();
    if (options_.time_limit > 0 && spent > options_.time_limit) {
      child.timed_out = true;
      child.process.send(SIGKILL);
    }
    return false;
  }
  // A child that was terminated has no result. One that crashed has: it would crash again.
  if (outcome.exit_status == 5 || outcome.exit_status == 128 + SIGTERM || outcome.exit_status == 128 + SIGINT)
    return true;
  child.timed_out = child.timed_out && outcome.exit_status == 128 + SIGKILL;
  Json record;
  record["scene"] = child.scene;
  record["version"] = options_.version;
  record["driver"] = driver_;
  record["exit_status"] = outcome.exit_status;
  record["cpu_seconds"] = outcome.cpu_seconds;
  record["time_limit"] = child.timed_out ? options_.time_limit : 0;
  write_whole_file(folder(run) + "/run.json", record.dump(2, ' ', false, Json::error_handler_t::replace) + '\n');
  return true;
}

bool RunPool::is_done(const StudyRun& run) const {
  return is_done(run, changed_scene_text(options_.scene, run.settings));
}

bool RunPool::is_done(const StudyRun& run, const std::string& scene) const {
  const Json record = read_json(folder(run) + "/run.json");
  if (record.is_null() || entry<std::string>(record, "scene", "") != scene ||
      entry<std::string>(record, "version", "") != options_.version ||
      entry<std::string>(record, "driver", "") != driver_)
    return false;
  const int status = entry(record, "exit_status", -1);
  for (const char* file : {"/summary.json", "/history.csv", "/effective.xml"})
    if (status == 0 && !std::filesystem::exists(folder(run) + file)) return false;
  const double limit = entry(record, "time_limit", 0.0);
  return status == 0 || status == 3 || (limit > 0 && options_.time_limit > 0 && options_.time_limit <= limit);
}

RunRecord RunPool::record(const StudyRun& run) const {
  RunRecord record;
  record.run = run;
  const Json file = read_json(folder(run) + "/run.json"), summary = read_json(folder(run) + "/summary.json");
  if (file.is_null()) {
    record.status = "interrupted";
    record.reason = "ended by a signal";
    return record;
  }
  record.cpu_seconds = entry(file, "cpu_seconds", 0.0);
  const int status = entry(file, "exit_status", -1);
  if (const double limit = entry(file, "time_limit", 0.0); limit > 0 || (status != 0 && status != 3)) {
    record.status = "failed";
    record.refused = status == 2;
    record.reason =
        limit > 0 ? fmt::format("not finished after the time limit of {:.3g} s", limit) : last_line(log(run));
    if (limit == 0 && status > 128) record.reason = fmt::format("ended by signal {}", status - 128);
    record.wall_seconds = limit;
    return record;
  }
  record.status = entry<std::string>(summary, "status", "failed");
  record.reason = entry<std::string>(summary, "reason", "");
  record.wall_seconds = entry(summary, "wall_seconds", 0.0);
  record.steps = entry(summary, "steps", 0L);
  record.rejected_steps = entry(summary, "rejected_steps", 0L);
  record.newton_iterations = entry(summary, "newton_iterations", 0L);
  record.linear_iterations = entry(summary, "linear_iterations", 0L);
  record.dofs = entry(summary, "dofs", 0L);
  record.peak_memory_bytes = entry(summary, "peak_memory_bytes", 0.0);
  record.end_time = entry(summary, "end_time", 0.0);
  return record;
}

}  // namespace ixos
