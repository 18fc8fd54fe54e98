#include "ixos/trial.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "base/agreement.hpp"
#include "base/error.hpp"
#include "base/printable.hpp"
#include "console.hpp"
#include "ixos/scene_run.hpp"
#include "scene/output/output_options.hpp"
#include "scene/read/scene_units.hpp"
#include "scene/read/stages.hpp"
#include "scene/read/time_integrator_options.hpp"

namespace ixos {
namespace {

constexpr long most_steps = 20;
constexpr double most_seconds = 20;
const char* const tried = "tried";

/// A new folder, which goes with its object. Collective.
class OwnFolder {
 public:
  OwnFolder(const Comm& comm, std::string path) : comm_(comm), path_(std::move(path)) {
    on_first_rank(comm, [&] {
      std::error_code code;
      if (std::filesystem::exists(std::filesystem::symlink_status(path_, code)))
        throw InputError("--try: " + path_ + " exists, where the steps would be written; remove it");
    });
  }
  /// Does not wait for the other ranks, of which one may have failed.
  ~OwnFolder() {
    std::error_code code;  // what is left of a trial does no harm
    if (comm_->getRank() == 0) std::filesystem::remove_all(path_, code);
  }
  OwnFolder(const OwnFolder&) = delete;
  OwnFolder& operator=(const OwnFolder&) = delete;

 private:
  const Comm& comm_;
  std::string path_;
};

/// Returns seconds in words: "4.2 s", "13 min", "7.5 h".
std::string duration(double seconds) {
  if (seconds < 99.5) return fmt::format("{:.2g} s", seconds);
  if (seconds < 6000) return fmt::format("{:.0f} min", seconds / 60);
  if (seconds < 2 * 86400) return fmt::format("{:.1f} h", seconds / 3600);
  return fmt::format("{:.1f} days", seconds / 86400);
}

/// Returns the number of steps of the whole run: what the steps so far make likely, or the number of the stages' fixed
/// steps; 0 if a stage chooses its steps itself.
double planned_steps(const Simulation& simulation, const RunResult& result) {
  const double begin = simulation.step_control().initial_time;
  const Stages& stages = simulation.stages();
  if (!stages.any())
    return std::ceil((simulation.planned_end() - begin) / (result.end_time - begin) *
                     static_cast<double>(result.steps));
  std::vector<double> begins;
  double steps = 0, from = begin;
  for (const double end : stages.planned_ends()) {
    const Teuchos::ParameterList list = complete_scene(stages.scene(begins));
    const SceneNode scene(list, "");
    const TimeIntegratorOptions own =
        read_time_integrator(scene.sublist("Time Integrator"), read_output(scene.sublist("Output")));
    if (own.step_control.adaptive.on || own.scheme == "Central Difference") return 0;
    steps += std::ceil((end - from) / own.step_control.time_step - 1e-9);  // a step that is too short is none
    begins.push_back(from = end);
  }
  return std::max(steps, static_cast<double>(result.steps));
}

/// Returns what the steps say of the whole run.
std::string forecast(const Simulation& simulation, const RunResult& result) {
  const std::string steps =
      fmt::format("{} step{} to t = {:.6g} T0 took {}, after {} of set-up", result.steps, result.steps == 1 ? "" : "s",
                  result.end_time, duration(result.wall_seconds), duration(simulation.setup_seconds()));
  if (result.status == RunStatus::Completed) return steps + ": that is the whole run.";
  const double all = planned_steps(simulation, result);
  if (all == 0) return steps + ". A stage chooses its steps itself, so their number to the end is unknown.";
  return fmt::format(
      "{}. At this rate the {:.0f} steps to t = {:.6g} T0 take {}. Steps take longer where a front moves or a "
      "body snaps.",
      steps, all, simulation.planned_end(), duration(all / static_cast<double>(result.steps) * result.wall_seconds));
}

}  // namespace

int try_scene(Simulation& simulation, const Arguments& arguments) {
  const Comm& comm = simulation.model().space().comm();
  Arguments own = arguments;
  own.output = std::filesystem::path(results_folder(arguments) + "/").parent_path().string() + ".try";
  const OwnFolder folder(comm, own.output);
  const RunResult result = carry_out(simulation, own, true, [](const Progress& progress) -> std::string {
    return progress.step >= most_steps || progress.wall_seconds >= most_seconds ? tried : "";
  });
  comm->barrier();  // all files are closed
  const bool failed = result.status == RunStatus::Diverged || result.status == RunStatus::Interrupted;
  if (failed) return tell_failure(result, comm);
  if (!speaks(arguments, comm)) return 0;
  if (result.status == RunStatus::Completed || result.reason == tried)
    console::say("{}\n", forecast(simulation, result));
  else
    console::say("The run stops after {} step{}: {}\n", result.steps, result.steps == 1 ? "" : "s",
                 printable(result.reason));
  warn(result.findings);
  return 0;
}

}  // namespace ixos
