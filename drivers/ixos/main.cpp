// ixos: runs a scene. Exit status: 0 done; 1 a defect of ours; 2 bad input; 3 the solution could not be continued, or
// memory ran out; 4 input, output or communication failed; 5 interrupted.
#include <fmt/format.h>
#include <malloc.h>
#include <mpi.h>
#include <unistd.h>

#include <Teuchos_CommHelpers.hpp>
#include <Tpetra_Core.hpp>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "base/agreement.hpp"
#include "base/error.hpp"
#include "base/memory.hpp"
#include "base/printable.hpp"
#include "console.hpp"
#include "io/exodus_mesh.hpp"
#include "io/hdf5_file.hpp"
#include "ixos/answers.hpp"
#include "ixos/arguments.hpp"
#include "ixos/mpi_errors.hpp"
#include "ixos/verify_restart.hpp"
#include "progress_line.hpp"
#include "run/restart.hpp"
#include "run/run.hpp"
#include "scene/documentation.hpp"
#include "scene/explanation.hpp"
#include "scene/parameters.hpp"
#include "scene/scene_file.hpp"
#include "scene/scene_mesh.hpp"
#include "scene/scene_units.hpp"
#include "shell_word.hpp"
#include "signals.hpp"
#include "solve/linear_solver_defaults.hpp"

namespace {

using ixos::Arguments;

void describe(ixos::Simulation& simulation) {
  const ixos::Model& model = simulation.model();
  const auto& linear = simulation.parameters().sublist("Linear Solver");
  ixos::console::say(
      "{}: {} cells, {} degrees of freedom, {} rank(s); {}, time step {} T0 to {} T0; linear solver {}\n",
      simulation.parameters().name(), model.mesh().global_cells, model.space().global(),
      model.space().comm()->getSize(), simulation.time_integrator().scheme, simulation.step_control().time_step,
      simulation.step_control().final_time, ixos::linear_solver_in_words(linear));
  ixos::console::flush();
}

/// Where the scene file stands.
std::string scene_folder(const Arguments& arguments) {
  return std::filesystem::path(arguments.scene).parent_path().string();
}

int write_mesh(const Teuchos::ParameterList& scene, const Arguments& arguments, const ixos::Comm& comm) {
  ixos::on_first_rank(comm, [&] {
    std::error_code code;  // what cannot be looked at cannot be written either
    if (!arguments.overwrite && std::filesystem::exists(std::filesystem::symlink_status(arguments.mesh_file, code)))
      throw ixos::InputError("--write-mesh: " + arguments.mesh_file +
                             " exists; choose another name, or replace it with --overwrite");
  });
  Teuchos::ParameterList complete = ixos::complete_scene(scene);
  const ixos::Mesh mesh = ixos::scene_mesh(complete.sublist("Mesh"), scene_folder(arguments));
  ixos::on_first_rank(comm, [&] { ixos::write_exodus_mesh(mesh, arguments.mesh_file, complete.name()); });
  return 0;
}

void check_restart(const ixos::Simulation& simulation, const std::string& file, bool speaks) {
  const ixos::Restart restart(simulation, file);
  if (!speaks) return;
  ixos::console::say("{} is sound and fits the scene.\n", ixos::printable(restart.path()));
  for (const std::string& note : restart.notes()) ixos::console::say("{}\n", ixos::printable(note));
}

/// Returns the command that resumes from a checkpoint.
std::string restart_command(const Arguments& arguments, const std::string& checkpoint) {
  std::string command = "ixos " + ixos::shell_word(arguments.scene);
  for (const std::string& assignment : arguments.assignments) command += " --set " + ixos::shell_word(assignment);
  if (!arguments.output.empty()) command += " --output " + ixos::shell_word(arguments.output);
  return command + " --restart " + ixos::shell_word(checkpoint);
}

void warn(const std::vector<ixos::Warning>& warnings) {
  ixos::console::flush();
  for (const ixos::Warning& warning : warnings)
    ixos::console::complain("ixos: warning: {}\n", ixos::printable(warning.message));
}

/// Tells the user how the run ended.
void report_run(const ixos::RunResult& result, const Arguments& arguments, const std::string& folder, bool speaks) {
  const bool done = result.status == ixos::RunStatus::Completed || result.status == ixos::RunStatus::Stopped;
  if (done) {
    if (speaks)
      ixos::console::say("Reached t = {:.6g} T0 in {} steps{}{}. Results are in {}\n", result.end_time, result.steps,
                         result.reason.empty() ? "" : ", ", result.reason, ixos::printable(folder));
    return;
  }
  ixos::console::complain("ixos: the run ended at t = {:.6g} T0, after {} steps: {}. Results up to there are in {}\n",
                          result.end_time, result.steps, result.reason, ixos::printable(folder));
  if (!result.checkpoint.empty())
    ixos::console::complain("ixos: to resume: {}\n", ixos::printable(restart_command(arguments, result.checkpoint)));
}

int run_scene(const Arguments& arguments, const ixos::Comm& comm) {
  const bool speaks = comm->getRank() == 0 && !arguments.quiet;
  Teuchos::ParameterList scene;
  ixos::together<ixos::InputError>(comm, [&] { scene = ixos::read_scene_file(arguments.scene); });
  for (const std::string& assignment : arguments.assignments)
    ixos::set_parameter(scene, ixos::scene_parameters(), assignment);
  if (!arguments.mesh_file.empty()) return write_mesh(scene, arguments, comm);
  ixos::Simulation simulation(scene, comm, scene_folder(arguments));
  if (speaks) describe(simulation);
  for (const std::string& note : simulation.notes())
    if (speaks) ixos::console::say("Note: {}\n", ixos::printable(note));
  if (speaks) warn(simulation.warnings());
  if (arguments.explain) {
    const std::string explanation = ixos::explain(simulation);
    if (comm->getRank() == 0) ixos::console::print(explanation);
    return 0;
  }
  if (arguments.check) {
    if (!arguments.restart.empty()) check_restart(simulation, arguments.restart, speaks);
    if (speaks) ixos::console::say("{}The scene is sound.\n", to_string(simulation.mesh_quality()));
    return 0;
  }
  std::signal(SIGXFSZ, SIG_IGN);  // a limit to the size of files is an error of writing
  ixos::catch_signals();
  ixos::RunOptions options;
  options.folder = results_folder(arguments);
  options.scene_file = arguments.scene;
  options.restart = arguments.restart;
  options.overwrite = arguments.overwrite;
  if (speaks) options.tell = [](const std::string& line) { ixos::console::say("{}\n", ixos::printable(line)); };
  if (speaks)
    options.warn = [](const std::string& line) {
      ixos::console::complain("ixos: warning: {}\n", ixos::printable(line));
    };
  options.interrupted = ixos::signalled;
  ixos::ProgressLine line;
  const bool shows = speaks && isatty(STDERR_FILENO) != 0;
  if (shows || arguments.kill_after_step > 0)
    options.watch = [&](const ixos::Progress& p) {
      if (shows) line.show(p);
      if (p.step == arguments.kill_after_step) std::raise(SIGKILL);
    };
  const ixos::RunResult result = ixos::run(simulation, options);
  line.clear();
  if (comm->getRank() == 0) report_run(result, arguments, options.folder, speaks);
  if (speaks) warn(result.findings);
  if (result.status == ixos::RunStatus::Diverged) return 3;
  return result.status == ixos::RunStatus::Interrupted ? 5 : 0;
}

/// An error that all ranks see alike is said once.
int report(int status, const std::string& what, const ixos::Comm& comm) {
  if (comm->getRank() == 0) ixos::console::complain("ixos: {}\n", ixos::printable(what));
  return status;
}

/// Ends the job with a message of this rank: the others may be waiting in a collective operation.
int end_all(int status, const std::string& what, const ixos::Comm& comm) {
  ixos::console::flush();
  ixos::console::complain("ixos: {}\n", ixos::printable(what));
  if (comm->getSize() > 1) MPI_Abort(MPI_COMM_WORLD, status);
  return status;
}

int guarded_run(const Arguments& arguments, const ixos::Comm& comm) {
  try {
    return run_scene(arguments, comm);
  } catch (const ixos::InputError& error) {
    if (ixos::memory_ran_out()) return end_all(3, ixos::out_of_memory() + " (" + error.what() + ")", comm);
    return report(2, ixos::with_place(error.what(), arguments), comm);
  } catch (const ixos::FileError& error) {
    return report(4, error.what(), comm);
  } catch (const ixos::MemoryError& error) {
    return end_all(3, error.what(), comm);
  } catch (const std::bad_alloc&) {
    return end_all(3, ixos::out_of_memory(), comm);
  } catch (const std::exception& error) {
    const std::string what = error.what();
    // When Kokkos cannot allocate, it throws an exception that is no std::bad_alloc.
    if (ixos::memory_ran_out() || what.find("failed to allocate") != std::string::npos)
      return end_all(3, ixos::out_of_memory() + " (" + what + ")", comm);
    return end_all(1, std::string("internal error, please report it: ") + error.what(), comm);
  }
}

/// Carries out the options that need no scene.
int answer(const Arguments& arguments, const ixos::Comm& comm) {
  if (arguments.check || arguments.explain || arguments.overwrite || !arguments.mesh_file.empty() ||
      !arguments.assignments.empty() || !arguments.output.empty() || !arguments.restart.empty() ||
      arguments.kill_after_step > 0)
    return report(2, "a scene is needed: ixos SCENE.xml ...", comm);
  if (comm->getRank() != 0) return 0;
  if (arguments.version) ixos::print_version();
  if (arguments.list_schemes) ixos::print_schemes();
  if (arguments.completion) ixos::console::print(ixos::completion_script());
  if (arguments.parameters)
    ixos::console::say("{}",
                       ixos::parameter_documentation(ixos::scene_parameters(), "Parameters", "ixos --parameters"));
  if (!arguments.template_name.empty()) {
    try {
      ixos::console::say("{}", ixos::scene_template(arguments.template_name));
    } catch (const ixos::InputError& error) {
      return report(2, std::string("--template: ") + error.what(), comm);
    }
  }
  if (!arguments.version && !arguments.list_schemes && !arguments.parameters && !arguments.completion &&
      arguments.template_name.empty())
    ixos::console::print(ixos::how_to_begin());
  return 0;
}

/// The exit status of a program that did what it was asked, if its answer reached standard output.
int heard(const ixos::Comm& comm) {
  const std::string lost = ixos::first_problem(comm, ixos::console::lost());
  return lost.empty() ? 0 : report(4, lost, comm);
}

int answer_or_run(const ixos::CommandLine& line) {
  const ixos::Comm comm = Tpetra::getDefaultComm();
  if (!line.error.empty()) return report(2, line.error + " (ixos --help lists the options)", comm);
  if (!line.help.empty()) {
    if (comm->getRank() == 0) ixos::console::print(line.help);
    return heard(comm);
  }
  const Arguments& arguments = line.arguments;
  int status = arguments.scene.empty() ? answer(arguments, comm) : guarded_run(arguments, comm);
  Teuchos::broadcast(*comm, 0, &status);  // one rank answers for all
  return status == 0 ? heard(comm) : status;
}

/// Some libraries call exit() when memory runs out, HDF5's identifiers among them.
bool running = false;
void ended_by_a_library() {
  if (!running) return;
  std::fputs("ixos: a library ended the program; memory may have run out\n", stderr);
  _exit(3);
}

/// Runs the command. Nothing is thrown into MPI_Finalize, where the other ranks would not be.
int with_words(const ixos::CommandLine& line) {
  const ixos::Comm comm = Tpetra::getDefaultComm();
  try {
    return answer_or_run(line);
  } catch (const std::bad_alloc&) {
    return end_all(3, ixos::out_of_memory(), comm);
  } catch (const std::exception& error) {
    return end_all(1, std::string("internal error, please report it: ") + error.what(), comm);
  }
}

/// Makes the C library keep freed memory. Every factorisation frees its workspace and allocates the next one, and to
/// fetch its pages from the system anew takes a third of the time of a small one.
void keep_freed_memory() {
#ifdef __GLIBC__
  mallopt(M_MMAP_THRESHOLD, 32 << 20);  // the largest that glibc accepts
  mallopt(M_TRIM_THRESHOLD, 1 << 30);
#endif
}

int run_program(int argc, char** argv) {
  keep_freed_memory();
  try {
    const ixos::CommandLine line = ixos::parse(argc, argv);
    if (line.error.empty() && line.help.empty() && line.arguments.verify_restart)
      return ixos::verify_restart(line.arguments);  // starts processes with MPI: must not have started it itself
    ixos::start_hdf5();
    int none = 1;  // Kokkos would answer --help itself
    const Tpetra::ScopeGuard guard(&none, &argv);
    ixos::end_on_mpi_errors();
    std::signal(SIGPIPE, SIG_IGN);  // lost output is an error of writing
    running = true;
    const int status = with_words(line);
    running = false;
    return status;
  } catch (const std::bad_alloc&) {
    std::fprintf(stderr, "ixos: out of memory\n");
    return 3;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "ixos: cannot start: %s\n", error.what());
  } catch (...) {
    std::fprintf(stderr, "ixos: internal error, please report it\n");
  }
  return 1;
}

}  // namespace

int main(int argc, char** argv) {
  std::atexit(ended_by_a_library);
  return run_program(argc, argv);
}
