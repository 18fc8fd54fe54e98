// ixos: runs a scene. Exit status: 0 done; 1 a defect of ours; 2 bad input; 3 the solution could not be continued, or
// memory ran out; 4 input, output or communication failed; 5 interrupted.
#include <fmt/format.h>
#include <mpi.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <Teuchos_CommHelpers.hpp>
#include <Tpetra_Core.hpp>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include "base/agreement.hpp"
#include "base/error.hpp"
#include "base/memory.hpp"
#include "base/pack.hpp"
#include "base/printable.hpp"
#include "console.hpp"
#include "io/exodus_mesh.hpp"
#include "io/hdf5_file.hpp"
#include "ixos/mpi_errors.hpp"
#include "parameters/parameter_entries.hpp"
#include "progress_line.hpp"
#include "run/restart.hpp"
#include "run/run.hpp"
#include "scene/documentation.hpp"
#include "scene/explanation.hpp"
#include "scene/parameters.hpp"
#include "scene/placed_message.hpp"
#include "scene/scene_file.hpp"
#include "scene/scene_mesh.hpp"
#include "scene/scene_units.hpp"
#include "shell_word.hpp"
#include "solve/factorization.hpp"
#include "solve/klu2_repair.hpp"
#include "solve/linear_solver_defaults.hpp"
#include "time/catalogue.hpp"

namespace {

volatile std::sig_atomic_t signalled = 0;
void on_signal(int) { signalled = 1; }

struct Arguments {
  std::string scene;
  std::vector<std::string> assignments;
  std::string output;
  std::string restart;
  std::string template_name;
  std::string mesh_file;
  bool overwrite = false;
  bool check = false;
  bool explain = false;
  bool parameters = false;
  bool list_schemes = false;
  bool version = false;
  bool quiet = false;
};

const char* const how_to_begin =
    "Ixos simulates dynamic adhesion. Give it a scene:\n"
    "  ixos xml/ball.xml                          run the ball; results go to ball.results\n"
    "  ixos xml/ball.xml --check                  check the scene\n"
    "  ixos xml/ball.xml --restart ball.results/checkpoint.h5   resume a run\n"
    "  ixos xml/ball.xml --explain                say what the scene models and what it leaves out\n"
    "  ixos --template block > block.xml          write a complete scene with every parameter explained\n"
    "  ixos xml/ball.xml --set \"Time Integrator/Type=Newmark\" --output newmark.results\n"
    "  ixos --list-schemes                        describe the time integrators\n"
    "  ixos --help                                all options\n";

void print_schemes() {
  for (const ixos::Scheme& scheme : ixos::schemes()) {
    ixos::console::say("{}\n  order:     {}\n  stability: {}\n  conserves: {}\n  cost:      {}\n  from:      {}\n",
                       scheme.name, scheme.order, scheme.stability, scheme.conserves, scheme.cost, scheme.citation);
    for (const auto& [name, entry] : ixos::entries(scheme.parameters)) {
      std::ostringstream value;
      value << entry.getAny(false);
      ixos::console::say("  {} = {}: {}\n", name, value.str(), entry.docString());
    }
  }
}

void print_version() {
  ixos::console::say("ixos {}\nSIMD: {} doubles wide\nFactorisations: {}\nKLU2 from: {}\n", IXOS_VERSION,
                     ixos::pack_width, fmt::format("{}", fmt::join(ixos::factorizations(), ", ")),
                     ixos::klu2_library());
}

/// Where it was not given, the scene file's name without folder and ending, with .results.
std::string results_folder(const Arguments& arguments) {
  return arguments.output.empty() ? std::filesystem::path(arguments.scene).stem().string() + ".results"
                                  : arguments.output;
}

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
  for (const int signal : {SIGINT, SIGTERM}) std::signal(signal, on_signal);
  if (std::signal(SIGHUP, on_signal) == SIG_IGN) std::signal(SIGHUP, SIG_IGN);  // nohup
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
  options.interrupted = [] { return signalled != 0; };
  ixos::ProgressLine line;
  if (speaks && isatty(STDERR_FILENO) != 0) options.watch = [&line](const ixos::Progress& p) { line.show(p); };
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
    return report(
        2, ixos::placed_message(error.what(), arguments.scene, {results_folder(arguments), arguments.restart}), comm);
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
      !arguments.assignments.empty() || !arguments.output.empty() || !arguments.restart.empty())
    return report(2, "a scene is needed: ixos SCENE.xml ...", comm);
  if (comm->getRank() != 0) return 0;
  if (arguments.version) print_version();
  if (arguments.list_schemes) print_schemes();
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
  if (!arguments.version && !arguments.list_schemes && !arguments.parameters && arguments.template_name.empty())
    ixos::console::print(how_to_begin);
  return 0;
}

/// The exit status of a program that did what it was asked, if its answer reached standard output.
int heard(const ixos::Comm& comm) {
  const std::string lost = ixos::first_problem(comm, ixos::console::lost());
  return lost.empty() ? 0 : report(4, lost, comm);
}

int parse_and_run(int argc, char** argv) {
  const ixos::Comm comm = Tpetra::getDefaultComm();

  Arguments arguments;
  CLI::App app("Ixos simulates dynamic adhesion.", "ixos");
  app.footer(how_to_begin);
  app.add_option("SCENE", arguments.scene, "scene file (XML)");
  app.add_option("--set", arguments.assignments, "\"List/Sublist/Name=value\": changes the scene; may be repeated")
      ->allow_extra_args(false);
  app.add_option("--output", arguments.output, "folder for the results (default: SCENE without its ending, .results)");
  app.add_flag("--overwrite", arguments.overwrite,
               "replace the results of another scene in the results folder, or the file of --write-mesh");
  app.add_option("--restart", arguments.restart,
                 "resume from this checkpoint, or from the newest sound checkpoint of this folder")
      ->check([](const std::string& file) { return file.empty() ? "a file is needed" : ""; });
  app.add_flag("--check", arguments.check, "check the scene and build it, but do not run it");
  app.add_flag("--explain", arguments.explain, "print what the scene models and what it leaves out, but do not run it");
  app.add_option("--template", arguments.template_name, "print a complete, commented scene: ball or block");
  app.add_option("--write-mesh", arguments.mesh_file, "write the scene's mesh to this Exodus file, but do not run it");
  app.add_flag("--parameters", arguments.parameters, "print every parameter of a scene, as Markdown");
  app.add_flag("--list-schemes", arguments.list_schemes, "print the time integrators and what each is good for");
  app.add_flag("--version", arguments.version, "print version and build");
  app.add_flag("--quiet", arguments.quiet, "print nothing but errors");
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    if (comm->getRank() == 0) ixos::console::print(app.help());
    return heard(comm);
  } catch (const CLI::ParseError& error) {
    return report(2, std::string(error.what()) + " (ixos --help lists the options)", comm);
  }
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
int with_words(int argc, char** argv) {
  const ixos::Comm comm = Tpetra::getDefaultComm();
  try {
    return parse_and_run(argc, argv);
  } catch (const std::bad_alloc&) {
    return end_all(3, ixos::out_of_memory(), comm);
  } catch (const std::exception& error) {
    return end_all(1, std::string("internal error, please report it: ") + error.what(), comm);
  }
}

int run_program(int argc, char** argv) {
  try {
    int none = 1;  // Kokkos would answer --help itself
    const Tpetra::ScopeGuard guard(&none, &argv);
    ixos::end_on_mpi_errors();
    std::signal(SIGPIPE, SIG_IGN);  // lost output is an error of writing
    running = true;
    const int status = with_words(argc, argv);
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
  ixos::start_hdf5();
  return run_program(argc, argv);
}
