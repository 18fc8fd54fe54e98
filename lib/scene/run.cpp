#include "scene/run.hpp"

#include <Teuchos_CommHelpers.hpp>
#include <Teuchos_Time.hpp>
#include <cmath>
#include <filesystem>

#include "base/agreement.hpp"
#include "base/error.hpp"
#include "scene/field_recorder.hpp"
#include "scene/history.hpp"
#include "scene/scene_file.hpp"
#include "scene/summary.hpp"

namespace ixos {
namespace {

/// Makes the results folder and effective.xml on rank 0; throws on all ranks alike.
void open_folder(const Simulation& simulation, const std::string& folder) {
  const Comm& comm = simulation.model().space().comm();
  together(comm, [&] {
    if (comm->getRank() != 0) return;
    std::error_code code;
    std::filesystem::create_directories(folder, code);
    if (code) throw FileError("the results folder cannot be used: " + folder + ": " + code.message());
    // What an earlier run left is not this one's.
    std::filesystem::remove(folder + "/summary.json");
    for (const auto& entry : std::filesystem::directory_iterator(folder))
      if (entry.path().filename().string().rfind("fields.e", 0) == 0) std::filesystem::remove(entry.path());
    write_scene_file(simulation.parameters(), folder + "/effective.xml");
  });
}

bool asked_to_stop(const RunOptions& options, const Comm& comm) {
  if (!options.interrupted) return false;
  int stop = options.interrupted() ? 1 : 0;
  if (comm->getSize() == 1) return stop != 0;
  int any = 0;
  Teuchos::reduceAll(*comm, Teuchos::REDUCE_MAX, 1, &stop, &any);
  return any != 0;
}

}  // namespace

RunResult run(Simulation& simulation, const RunOptions& options) {
  const Comm& comm = simulation.model().space().comm();
  Integrator& integrator = simulation.integrator();
  const Teuchos::ParameterList& output = simulation.parameters().sublist("Output");
  open_folder(simulation, options.folder);
  History history(simulation,
                  {output.get<bool>("Energies"), output.get<bool>("Momenta"), output.get<bool>("Interaction")},
                  options.folder + "/history.csv");
  const long interval = output.get<int>("History Interval");
  const double final_time = simulation.final_time();
  const double start = Teuchos::Time::wallTime();
  const auto phases_before = phase_seconds();

  const long field_interval = output.get<int>("Fields Interval");
  std::unique_ptr<FieldRecorder> fields;
  if (field_interval > 0) {
    fields = std::make_unique<FieldRecorder>(simulation, options.folder + "/fields.e");
    fields->record();
  }

  RunResult result;
  RowCounts counts;
  history.record(counts);
  // A remainder below a thousandth of a step is rounding, not a step.
  while (final_time - integrator.time() > 1e-3 * simulation.time_step()) {
    if (asked_to_stop(options, comm)) {
      result.status = RunStatus::Interrupted;
      result.reason = "interrupted by a signal";
      break;
    }
    const double dt = std::min(simulation.time_step(), final_time - integrator.time());
    const StepResult step = integrator.step(dt);
    counts.newton_iterations += step.newton_iterations;
    counts.linear_iterations += step.linear_iterations;
    result.linear_iterations += step.linear_iterations;
    result.newton_iterations += step.newton_iterations;
    counts.wall_seconds = Teuchos::Time::wallTime() - start;
    if (!step.converged) {
      result.status = RunStatus::Diverged;
      result.reason = step.reason;
      break;
    }
    ++result.steps;
    counts.step = result.steps;
    counts.time_step = dt;
    const bool last = !(final_time - integrator.time() > 1e-3 * simulation.time_step());
    if (result.steps % interval == 0 || last) {
      history.record(counts);
      counts.newton_iterations = 0;
      counts.linear_iterations = 0;
    }
    if (fields && (result.steps % field_interval == 0 || last)) fields->record();
    if (options.watch && comm->getRank() == 0)
      options.watch({integrator.time(), final_time, result.steps, result.newton_iterations, counts.wall_seconds});
  }
  if (result.status != RunStatus::Completed && result.steps % interval != 0) history.record(counts);
  if (result.status != RunStatus::Completed && fields && result.steps % field_interval != 0) fields->record();
  history.flush();
  result.end_time = integrator.time();
  result.wall_seconds = Teuchos::Time::wallTime() - start;
  result.max_energy_error = history.max_energy_error();
  const auto phases_now = phase_seconds();
  for (std::size_t i = 0; i < phases_now.size(); ++i) result.phase_seconds[i] = phases_now[i] - phases_before[i];
  write_summary(simulation, result, options.folder + "/summary.json");
  return result;
}

}  // namespace ixos
