#include "ixos/scene_run.hpp"

#include <unistd.h>

#include <csignal>

#include "base/printable.hpp"
#include "console.hpp"
#include "progress_line.hpp"
#include "shell_word.hpp"
#include "signals.hpp"
#include "solve/choice/linear_solver_defaults.hpp"

namespace ixos {
namespace {

/// Returns the command that resumes from a checkpoint, perhaps with another setting.
std::string restart_command(const Arguments& arguments, const std::string& checkpoint, const std::string& other = "") {
  std::string command = "ixos " + shell_word(arguments.scene);
  const std::string path = other.substr(0, other.find('=') + 1);
  for (const std::string& assignment : arguments.assignments)
    if (path.empty() || assignment.rfind(path, 0) != 0) command += " --set " + shell_word(assignment);
  if (!other.empty()) command += " --set " + shell_word(other);
  if (!arguments.output.empty()) command += " --output " + shell_word(arguments.output);
  return command + " --restart " + shell_word(checkpoint);
}

/// Tells of other settings where there is nothing to resume from.
void offer(const std::vector<Remedy>& remedies) {
  for (const Remedy& remedy : remedies)
    console::complain("ixos: {}{} may help: --set {}\n", remedy.what,
                      remedy.what.find(',') < std::string::npos ? "," : "", printable(shell_word(remedy.assignment)));
}

int exit_status_of_failure(const RunResult& result) { return result.status == RunStatus::Diverged ? 3 : 5; }

}  // namespace

bool speaks(const Arguments& arguments, const Comm& comm) { return comm->getRank() == 0 && !arguments.quiet; }

void introduce(const Simulation& simulation) {
  const Model& model = simulation.model();
  const auto& linear = simulation.parameters().sublist("Linear Solver");
  console::say("{}: {} cells, {} degrees of freedom, {} rank(s); {}, time step {} T0 to {} T0; linear solver {}\n",
               simulation.parameters().name(), model.mesh().global_cells, model.space().global(),
               model.space().comm()->getSize(), simulation.time_integrator().scheme,
               simulation.step_control().time_step, simulation.step_control().final_time,
               linear_solver_in_words(linear));
  const Stages& stages = simulation.stages();
  if (stages.any())
    console::say("Stage 1 of {}: {}; the last one ends at {} T0\n", stages.count(), printable(stages.name(0)),
                 simulation.planned_end());
  console::flush();
  for (const std::string& note : simulation.notes()) console::say("Note: {}\n", printable(note));
}

void tell_sets_and_hints(const Simulation& simulation) {
  for (const SetSize& size : simulation.set_sizes())
    console::say("{}\n", printable(in_words(size, simulation.model().mesh().body_dimension())));
  for (const std::string& hint : simulation.hints()) console::say("Note: {}\n", printable(hint));
}

void warn(const std::vector<Warning>& warnings) {
  console::flush();
  for (const Warning& warning : warnings) console::complain("ixos: warning: {}\n", printable(warning.message));
}

RunResult carry_out(Simulation& simulation, const Arguments& arguments, bool tells,
                    const std::function<std::string(const Progress&)>& observe) {
  std::signal(SIGXFSZ, SIG_IGN);  // a limit to the size of files is an error of writing
  catch_signals();
  const bool heard = speaks(arguments, simulation.model().space().comm());
  ProgressLine line(isatty(STDERR_FILENO) != 0);
  RunOptions options;
  options.folder = results_folder(arguments);
  options.scene_file = arguments.scene;
  options.restart = arguments.restart;
  options.overwrite = arguments.overwrite;
  if (heard && tells) {
    options.log = [&line](const std::string& text) {
      line.clear();
      console::say("{}\n", printable(text));
    };
    options.warn = [&line](const std::string& text) {
      line.clear();
      console::complain("ixos: warning: {}\n", printable(text));
    };
  }
  options.interrupted = signalled;
  options.observe = observe;
  if (heard || arguments.kill_after_step > 0)
    options.watch = [&](const Progress& p) {
      if (heard) line.show(p);
      if (p.step == arguments.kill_after_step) std::raise(SIGKILL);
    };
  if (heard) options.iterate = [&](const Progress& p) { line.show(p); };
  RunResult result = run(simulation, options);
  line.clear();
  return result;
}

int tell_failure(const RunResult& result, const Comm& comm) {
  if (comm->getRank() == 0) {
    console::complain("ixos: the run ended at t = {:.6g} T0, after {} steps: {}\n", result.end_time, result.steps,
                      printable(result.reason));
    offer(result.remedies);
  }
  return exit_status_of_failure(result);
}

int report_end(const RunResult& result, const Arguments& arguments, const Comm& comm) {
  const std::string folder = printable(results_folder(arguments));
  if (result.status == RunStatus::Completed || result.status == RunStatus::Stopped) {
    if (speaks(arguments, comm))
      console::say("Reached t = {:.6g} T0 in {} steps{}{}. Results are in {}\n", result.end_time, result.steps,
                   result.reason.empty() ? "" : ", ", result.reason, folder);
    return 0;
  }
  if (comm->getRank() == 0) {
    console::complain("ixos: the run ended at t = {:.6g} T0, after {} steps: {}. Results up to there are in {}\n",
                      result.end_time, result.steps, result.reason, folder);
    if (result.checkpoint.empty()) {
      offer(result.remedies);
    } else if (result.remedies.empty()) {
      console::complain("ixos: to resume: {}\n", printable(restart_command(arguments, result.checkpoint)));
    } else {
      for (const Remedy& remedy : result.remedies)
        console::complain("ixos: to resume with {}: {}\n", remedy.what,
                          printable(restart_command(arguments, result.checkpoint, remedy.assignment)));
    }
  }
  return exit_status_of_failure(result);
}

}  // namespace ixos
