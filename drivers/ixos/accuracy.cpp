#include "ixos/accuracy.hpp"

#include <Teuchos_CommHelpers.hpp>

#include "base/agreement.hpp"
#include "base/printable.hpp"
#include "console.hpp"
#include "ixos/scene_run.hpp"
#include "scene/read/parameters.hpp"
#include "scene/scene_file.hpp"
#include "study/accuracy/accuracy_report.hpp"
#include "study/common/named_quantities.hpp"

namespace ixos {
namespace {

/// Fills in the values of a run that has reached its end, as the first rank reads them, or why there are none.
void read_values(const std::vector<AskedQuantity>& quantities, const std::string& folder, const Comm& comm,
                 AccuracyRun& run) {
  std::vector<double> values(quantities.size());
  std::string problem;
  on_first_rank(comm, [&] {
    const RunHistory history(folder);
    try {
      for (std::size_t q = 0; q < values.size(); ++q) values[q] = quantities[q].value(history);
    } catch (const InputError& error) {
      problem = error.what();
    }
  });
  run.problem = from_first_rank(comm, problem);
  Teuchos::broadcast(*comm, 0, static_cast<int>(values.size()), values.data());
  if (run.problem.empty())
    run.values = values;
  else
    run.outcome = AccuracyOutcome::NoValue;
}

/// Returns whether a failed run decides the quantities, as the first rank reads it.
bool is_decided(const std::vector<AskedQuantity>& quantities, const std::string& folder, const Comm& comm) {
  int decided = 0;
  on_first_rank(comm, [&] { decided = are_decided(quantities, RunHistory(folder)) ? 1 : 0; });
  Teuchos::broadcast(*comm, 0, &decided);
  return decided != 0;
}

/// The runs of one command.
class AccuracyRuns {
 public:
  AccuracyRuns(const PlacedScene& scene, const AccuracyTask& task, const Arguments& arguments, const Comm& comm)
      : scene_(scene), task_(task), asked_(arguments), arguments_(arguments), comm_(comm) {}

  AccuracyRun run(const AccuracySettings& settings);
  int report(const AccuracyResult& result) const;

 private:
  void allow_replacement(const Simulation& simulation);

  const PlacedScene& scene_;
  const AccuracyTask& task_;
  const Arguments& asked_;
  Arguments arguments_;  ///< of the present run, as a plain one
  const Comm& comm_;
  std::size_t number_ = 0;
  RunResult last_;
  std::vector<Warning> warnings_;  ///< of the last run
};

/// Lets the first run replace the last run of an earlier command like this one.
void AccuracyRuns::allow_replacement(const Simulation& simulation) {
  int earlier = 0;
  on_first_rank(comm_, [&] { earlier = holds_accuracy(results_folder(asked_), simulation.parameters()) ? 1 : 0; });
  Teuchos::broadcast(*comm_, 0, &earlier);
  if (earlier == 0 || asked_.overwrite) return;
  arguments_.overwrite = true;
  if (speaks(asked_, comm_))
    console::say("{}: these runs replace the results of an earlier --accuracy of the same scene.\n",
                 printable(results_folder(asked_)));
}

AccuracyRun AccuracyRuns::run(const AccuracySettings& settings) {
  const PlacedScene scene = with_settings(scene_, settings);
  Simulation simulation(scene.list, comm_, scene.folder);
  if (++number_ == 1) {
    if (speaks(asked_, comm_)) introduce(simulation);
    allow_replacement(simulation);
  }
  arguments_.assignments = asked_.assignments;
  for (const std::string& assignment : assignments(settings)) arguments_.assignments.push_back(assignment);
  last_ = carry_out(simulation, arguments_, number_ == 1 && arguments_.overwrite == asked_.overwrite);
  arguments_.overwrite = true;  // what the next run replaces is this command's own
  warnings_ = simulation.warnings();
  for (const std::vector<Warning>* further : {&last_.warnings, &last_.findings})
    warnings_.insert(warnings_.end(), further->begin(), further->end());

  AccuracyRun run;
  run.settings = settings;
  run.steps = last_.steps;
  run.end_time = last_.end_time;
  run.mean_step =
      (last_.end_time - simulation.step_control().initial_time) / static_cast<double>(std::max(last_.steps, 1L));
  run.seconds = last_.wall_seconds + simulation.setup_seconds();
  run.problem = last_.reason;
  if (last_.status == RunStatus::Interrupted)
    run.outcome = AccuracyOutcome::Interrupted;
  else if (last_.status == RunStatus::Diverged && !is_decided(task_.question.quantities, results_folder(asked_), comm_))
    run.outcome = AccuracyOutcome::Failed;
  else
    read_values(task_.question.quantities, results_folder(asked_), comm_, run);
  if (run.outcome == AccuracyOutcome::Good && last_.status == RunStatus::Diverged) run.problem = last_.reason;
  if (speaks(asked_, comm_)) {
    console::say("{}", printable(run_text(task_.question, run, number_)));
    console::flush();
  }
  return run;
}

/// Tells how the last run ended and what the runs achieve. Returns the exit status.
int AccuracyRuns::report(const AccuracyResult& result) const {
  on_first_rank(comm_, [&] { add_accuracy(task_.question, result, results_folder(asked_)); });
  const int ended = report_end(last_, arguments_, comm_);
  if (speaks(asked_, comm_)) warn(warnings_);
  if (result.status == AccuracyStatus::Interrupted) return ended;
  const std::string text = printable(accuracy_text(task_.question, result));
  if (result.status == AccuracyStatus::Kept) {
    if (speaks(asked_, comm_)) console::say("{}", text);
    return 0;
  }
  if (comm_->getRank() == 0) {
    console::flush();
    console::complain("ixos: {}", text);
  }
  const bool no_value = result.runs.back().outcome == AccuracyOutcome::NoValue;
  return result.status == AccuracyStatus::NoRun && no_value ? 2 : 3;
}

}  // namespace

AccuracyTask accuracy_task(const PlacedScene& scene, double accuracy, const Comm& comm) {
  const Simulation simulation(scene.list, comm, scene.folder);
  AccuracyTask task{{named_quantities(simulation), accuracy}, {}};
  if (task.question.quantities.empty())
    throw InputError(
        "Output/Quantities: --accuracy needs quantities; name them in the scene, or by --set "
        "\"Output/Quantities={FORM, ...}\". Forms are:\n" +
        quantity_forms());
  check_times(task.question.quantities, simulation);
  task.first = first_settings(simulation, accuracy);
  return task;
}

PlacedScene with_settings(PlacedScene scene, const AccuracySettings& settings) {
  for (const std::string& assignment : assignments(settings)) set_parameter(scene.list, scene_parameters(), assignment);
  return scene;
}

int reach_accuracy(const PlacedScene& scene, const AccuracyTask& task, const Arguments& arguments, const Comm& comm) {
  AccuracyRuns runs(scene, task, arguments, comm);
  return runs.report(
      run_to_accuracy(task.question, task.first, [&](const AccuracySettings& settings) { return runs.run(settings); }));
}

}  // namespace ixos
