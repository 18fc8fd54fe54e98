#include "study/restart/restart_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <thread>

#include "base/error.hpp"
#include "io/child_process.hpp"
#include "io/disk_file.hpp"
#include "study/restart/compare_results.hpp"

namespace ixos {
namespace {

constexpr int killed = 128 + SIGKILL, bad_input = 2, diverged = 3, lost = 4, interrupted = 5;

long steps_of(const std::string& folder) {
  std::ifstream file = open_text(folder + "/summary.json");
  const nlohmann::json summary = nlohmann::json::parse(file, nullptr, false);
  if (!summary.is_object() || !summary.contains("steps") || !summary["steps"].is_number_integer())
    throw FileError(folder + "/summary.json: cannot be read");
  return summary["steps"].get<long>();
}

/// Returns whether a run of that exit status has results up to its end, or up to where the solution cannot be
/// continued. When memory runs out the status is that of divergence, but there is no summary.
bool has_results(int status, const std::string& folder) {
  if (status != diverged) return status == 0;
  std::ifstream file(folder + "/summary.json");
  const nlohmann::json summary = nlohmann::json::parse(file, nullptr, false);
  return summary.is_object() && summary.contains("status") && summary["status"] == "diverged";
}

/// Returns the last message of ixos in a log, without the name of the program; it may have several lines, but is no
/// warning. Without one, returns the first line that mpirun wrote below a line of dashes, or else the last line of the
/// log that is no warning.
std::string last_message(const std::string& log) {
  const auto begins = [](const std::string& line, const std::string& start) { return line.rfind(start, 0) == 0; };
  enum class Part { Other, Message, Launcher } part = Part::Other;  // to which a line belongs that begins none
  std::ifstream file = open_text(log);
  std::string message, launcher, other;
  for (std::string line; std::getline(file, line);) {
    if (begins(line, "ixos: warning: ")) {
      part = Part::Other;  // a warning has one line
    } else if (begins(line, "ixos: ")) {
      part = Part::Message;
      message = line.substr(6);
    } else if (begins(line, "---")) {
      part = Part::Launcher;
    } else if (part == Part::Message) {
      message += '\n' + line;
    } else if (part == Part::Launcher && launcher.empty()) {
      launcher = line;
    } else if (part == Part::Other && !line.empty()) {
      other = line;
    }
  }
  if (!message.empty()) return message;
  return launcher.empty() ? other.substr(0, 400) : launcher;
}

/// Returns the steps to resume from.
std::vector<long> chosen_steps(const RestartCheck& check, long total) {
  if (total < 2) throw InputError(fmt::format("a run of {} step(s) is too short to be killed and resumed", total));
  if (!check.steps.empty()) {
    if (check.steps.back() >= total)
      throw InputError(fmt::format("--kill-steps: {}: the run has {} steps; allowed are 1 to {}", check.steps.back(),
                                   total, total - 1));
    return check.steps;
  }
  const long kills = std::min<long>(check.kills, total - 1);
  std::vector<long> steps;
  for (long i = 1; i <= kills; ++i) steps.push_back(i * total / (kills + 1));
  return steps;
}

class Checker {
 public:
  explicit Checker(const RestartCheck& check)
      : check_(check), whole_(check.folder + "/undisturbed"), parts_(check.folder + "/killed") {}

  RestartCheckResult run() {
    std::error_code code;
    std::filesystem::create_directories(check_.folder, code);
    if (code) throw FileError(check_.folder + ": cannot be created: " + code.message());
    report(fmt::format("Runs {} without kills, then with kills. Results and messages go to {}", check_.scene,
                       check_.folder));
    const int end = process(whole_, "undisturbed.log", check_.overwrite ? Words{"--overwrite"} : Words{});
    if (stopped_) return {RestartCheckStatus::Interrupted, "", interrupted};
    if (end == bad_input) return refused();
    if (!has_results(end, whole_)) return failed(end, "undisturbed.log");
    const long total = steps_of(whole_);
    report(fmt::format("Undisturbed: {} steps{}", total,
                       end == diverged ? ", then the solution cannot be continued" : ""));
    const std::vector<long> steps = chosen_steps(check_, total);
    long before = 0;
    for (const long step : steps) {
      if (!part(before, step)) return result_;
      before = step;
    }
    return last_part(before, end);
  }

 private:
  using Words = std::vector<std::string>;

  /// Runs up to the kill after the checkpoint of that step. Returns false if the check ends here.
  bool part(long before, long step) {
    const std::string log = fmt::format("killed-{}.log", step);
    Words words = beginning(before);
    // No multiple of the step lies between: this is the part's only checkpoint.
    const std::string interval = "Interval=" + std::to_string(step);
    for (const std::string& setting : {interval, std::string("Wall-Clock Interval=0"), std::string("Keep=2")})
      words.insert(words.end(), {"--set", "Output/Checkpoint/" + setting});
    words.insert(words.end(), {"--kill-after-step", std::to_string(step + 1)});
    const int status = process(parts_, log, words);
    if (stopped_) {
      result_ = {RestartCheckStatus::Interrupted, "", interrupted};
    } else if (has_results(status, parts_)) {
      differs(fmt::format("the run ends before step {}", step + 1));
    } else if (status != killed) {
      result_ = failed(status, log);
    } else if (const std::string d = history_difference(whole_ + "/history.csv", parts_ + "/history.csv", step);
               !d.empty()) {
      differs("history.csv: " + d);
    } else {
      report(fmt::format("{}, killed after step {}: the same up to step {}", name(before), step + 1, step));
      return true;
    }
    if (result_.status == RestartCheckStatus::Different) report(name(before) + ": DIFFERENT: " + result_.message);
    if (result_.status == RestartCheckStatus::Different && before == 0)
      result_.status = RestartCheckStatus::Unrepeatable;
    return false;
  }

  /// Resumes after the last kill and compares the complete results.
  RestartCheckResult last_part(long before, int expected) {
    const int status = process(parts_, "end.log", beginning(before));
    if (stopped_) return {RestartCheckStatus::Interrupted, "", interrupted};
    if (!has_results(status, parts_)) return failed(status, "end.log");
    if (status != expected) differs(fmt::format("exit status {} and {}", expected, status));
    if (const std::string d = results_difference(whole_, parts_); !d.empty()) differs(d);
    report(name(before) + (result_.message.empty() ? ": the same up to the end" : ": DIFFERENT: " + result_.message));
    return result_;
  }

  /// Returns the options that begin a part after the checkpoint of a step, or from the initial state.
  Words beginning(long step) const {
    if (step > 0) return {"--restart", fmt::format("{}/checkpoint-{}.h5", parts_, step)};
    return check_.overwrite ? Words{"--overwrite"} : Words{};
  }

  static std::string name(long before) {
    return before == 0 ? "From the beginning" : fmt::format("Resumed from step {}", before);
  }

  /// Runs a process to its end. Returns its exit status.
  int process(const std::string& folder, const std::string& log, const Words& more) {
    Words command = check_.driver;
    command.insert(command.end(), {check_.scene, "--output", folder});
    for (const std::string& setting : check_.settings) command.insert(command.end(), {"--set", setting});
    command.insert(command.end(), more.begin(), more.end());
    ChildProcess child(command, check_.folder + '/' + log);
    ChildOutcome outcome;
    while (!child.ended(outcome)) {
      if (!stopped_ && check_.interrupted && check_.interrupted()) {
        stopped_ = true;
        child.send(SIGTERM);
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    stopped_ = stopped_ || outcome.exit_status == interrupted;
    return outcome.exit_status;
  }

  /// Bad input leaves nothing behind.
  RestartCheckResult refused() const {
    const std::string log = check_.folder + "/undisturbed.log";
    const std::string message = last_message(log);
    std::error_code code;
    std::filesystem::remove(log, code);
    std::filesystem::remove(check_.folder, code);  // unless it has other files
    return {RestartCheckStatus::Refused, message, bad_input};
  }
  RestartCheckResult failed(int status, const std::string& log) const {
    const std::string path = check_.folder + '/' + log;
    return {
        RestartCheckStatus::RunFailed,
        fmt::format("a run ended with exit status {}: {} (all messages are in {})", status, last_message(path), path),
        status > interrupted ? lost : status};
  }
  void differs(const std::string& difference) {
    if (result_.message.empty()) result_ = {RestartCheckStatus::Different, difference, 0};
  }
  void report(const std::string& line) const {
    if (check_.log) check_.log(line);
  }

  const RestartCheck& check_;
  std::string whole_, parts_;
  bool stopped_ = false;
  RestartCheckResult result_;
};

}  // namespace

RestartCheckResult check_restarts(const RestartCheck& check) { return Checker(check).run(); }

}  // namespace ixos
