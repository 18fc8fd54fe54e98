// ixos: runs a scene. Exit status: 0 done; 1 a defect of ours; 2 bad input; 3 the solution could not be continued;
// 4 input or output failed; 5 interrupted.
#include <fmt/format.h>
#include <mpi.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <Tpetra_Core.hpp>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include "base/agreement.hpp"
#include "base/error.hpp"
#include "base/pack.hpp"
#include "base/parameter_entries.hpp"
#include "base/printable.hpp"
#include "io/exodus_mesh.hpp"
#include "io/hdf5_file.hpp"
#include "progress_line.hpp"
#include "scene/documentation.hpp"
#include "scene/explanation.hpp"
#include "scene/parameters.hpp"
#include "scene/restart.hpp"
#include "scene/run.hpp"
#include "scene/scene_file.hpp"
#include "scene/scene_mesh.hpp"
#include "scene/validation.hpp"
#include "shell_word.hpp"
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
    "  ixos xml/ball.xml --check                  is the scene sound?\n"
    "  ixos xml/ball.xml --restart ball.results/checkpoint.h5   go on from where a run was stopped\n"
    "  ixos xml/ball.xml --explain                what does it model, and what does it leave out?\n"
    "  ixos --template block > block.xml          a scene to begin with, every parameter explained\n"
    "  ixos xml/ball.xml --set \"Time Integrator/Type=Newmark\" --output newmark.results\n"
    "  ixos --list-schemes                        what the time integrators are good for\n"
    "  ixos --help                                all options\n";

void print_schemes() {
  for (const ixos::Scheme& scheme : ixos::schemes()) {
    fmt::print("{}\n  order:     {}\n  stability: {}\n  conserves: {}\n  cost:      {}\n  from:      {}\n", scheme.name,
               scheme.order, scheme.stability, scheme.conserves, scheme.cost, scheme.citation);
    for (const auto& [name, entry] : ixos::entries(scheme.parameters)) {
      std::ostringstream value;
      value << entry.getAny(false);
      fmt::print("  {} = {}: {}\n", name, value.str(), entry.docString());
    }
  }
}

void print_version() {
  fmt::print("ixos {}\nSIMD: {} doubles wide\nKLU2 from: {}\n", IXOS_VERSION, ixos::pack_width, ixos::klu2_library());
}

/// Where it was not given, the scene file's name without folder and ending, with .results.
std::string results_folder(const Arguments& arguments) {
  return arguments.output.empty() ? std::filesystem::path(arguments.scene).stem().string() + ".results"
                                  : arguments.output;
}

void describe(ixos::Simulation& simulation) {
  const ixos::Model& model = simulation.model();
  const auto& integrator = simulation.parameters().sublist("Time Integrator");
  const auto& linear = simulation.parameters().sublist("Linear Solver");
  fmt::print("{}: {} cells, {} degrees of freedom, {} rank(s); {}, time step {} T0 to {} T0; linear solver {}\n",
             simulation.parameters().name(), model.mesh().global_cells, model.space().global(),
             model.space().comm()->getSize(), integrator.get<std::string>("Type"), simulation.step_control().time_step,
             simulation.step_control().final_time, ixos::linear_solver_in_words(linear));
  std::fflush(stdout);
}

/// Where the scene file stands.
std::string scene_folder(const Arguments& arguments) {
  return std::filesystem::path(arguments.scene).parent_path().string();
}

int write_mesh(const Teuchos::ParameterList& scene, const Arguments& arguments, const ixos::Comm& comm) {
  Teuchos::ParameterList complete = ixos::validated(scene, ixos::scene_parameters());
  const ixos::Mesh mesh = ixos::scene_mesh(complete.sublist("Mesh"), scene_folder(arguments));
  ixos::on_first_rank(comm, [&] { ixos::write_exodus_mesh(mesh, arguments.mesh_file, complete.name()); });
  return 0;
}

void check_restart(const ixos::Simulation& simulation, const std::string& file, bool speaks) {
  const ixos::Restart restart(simulation, file);
  if (!speaks) return;
  fmt::print("{} is sound, and fits the scene.\n", ixos::printable(restart.path()));
  for (const std::string& note : restart.notes()) fmt::print("{}\n", ixos::printable(note));
}

/// The command that goes on from a checkpoint.
std::string restart_command(const Arguments& arguments, const std::string& checkpoint) {
  std::string command = "ixos " + ixos::shell_word(arguments.scene);
  for (const std::string& assignment : arguments.assignments) command += " --set " + ixos::shell_word(assignment);
  if (!arguments.output.empty()) command += " --output " + ixos::shell_word(arguments.output);
  return command + " --restart " + ixos::shell_word(checkpoint);
}

/// A scheme may run to its end and yet make or lose energy: that is said where it is much.
void report_energy(const ixos::RunResult& result) {
  const double share = result.max_energy_error / result.largest_energy;
  if (!(share > 0.05)) return;
  std::fflush(stdout);
  fmt::print(stderr,
             "ixos: the scheme's energy error reached {:.3g}, {:.0f} % of the largest kinetic, elastic or interaction "
             "energy; shorter steps or a scheme that conserves energy (--list-schemes) make it smaller\n",
             result.max_energy_error, 100 * share);
}

/// What the run came to, for a person.
void report_run(const ixos::RunResult& result, const Arguments& arguments, const std::string& folder, bool speaks) {
  const bool done = result.status == ixos::RunStatus::Completed || result.status == ixos::RunStatus::Stopped;
  if (done) {
    if (speaks)
      fmt::print("Reached t = {:.6g} T0 in {} steps{}{}. Results are in {}\n", result.end_time, result.steps,
                 result.reason.empty() ? "" : ", ", result.reason, ixos::printable(folder));
    return;
  }
  fmt::print(stderr, "ixos: the run ended at t = {:.6g} T0, after {} steps: {}. Results up to there are in {}\n",
             result.end_time, result.steps, result.reason, ixos::printable(folder));
  if (!result.checkpoint.empty())
    fmt::print(stderr, "ixos: to go on from there: {}\n",
               ixos::printable(restart_command(arguments, result.checkpoint)));
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
  if (const std::string bad = ixos::quality_warning(simulation.mesh_quality()); speaks && !bad.empty())
    fmt::print(stderr, "ixos: warning: {}\n", bad);
  if (arguments.explain) {
    const std::string explanation = ixos::explain(simulation);
    if (comm->getRank() == 0) fmt::print("{}", explanation);
    return 0;
  }
  if (arguments.check) {
    if (!arguments.restart.empty()) check_restart(simulation, arguments.restart, speaks);
    if (speaks) fmt::print("{}The scene is sound.\n", to_string(simulation.mesh_quality()));
    return 0;
  }
  std::signal(SIGXFSZ, SIG_IGN);  // a limit to the size of files is an error of writing
  std::signal(SIGINT, on_signal);
  std::signal(SIGTERM, on_signal);
  ixos::RunOptions options;
  options.folder = results_folder(arguments);
  options.restart = arguments.restart;
  if (speaks) options.tell = [](const std::string& line) { fmt::print("{}\n", ixos::printable(line)); };
  options.interrupted = [] { return signalled != 0; };
  ixos::ProgressLine line;
  if (speaks && isatty(STDERR_FILENO) != 0) options.watch = [&line](const ixos::Progress& p) { line.show(p); };
  const ixos::RunResult result = ixos::run(simulation, options);
  line.clear();
  if (comm->getRank() == 0) report_run(result, arguments, options.folder, speaks);
  if (speaks && !ixos::is_static(simulation.integrator().table())) report_energy(result);
  if (result.status == ixos::RunStatus::Diverged) return 3;
  return result.status == ixos::RunStatus::Interrupted ? 5 : 0;
}

/// An error that all ranks see alike is said once.
int report(int status, const std::string& what, const ixos::Comm& comm) {
  if (comm->getRank() == 0) fmt::print(stderr, "ixos: {}\n", ixos::printable(what));
  return status;
}

/// After an error that all ranks see: is there one that could not close a file? See Hdf5Output::left_open.
bool any_left_open(const ixos::Comm& comm) {
  std::fflush(stderr);
  return !ixos::first_problem(comm, ixos::Hdf5Output::left_open() ? "a file was left open" : "").empty();
}

int guarded_run(const Arguments& arguments, const ixos::Comm& comm) {
  try {
    return run_scene(arguments, comm);
  } catch (const ixos::InputError& error) {
    const std::string what = error.what();
    const auto begins = [&what](const std::string& place) { return what.rfind(place, 0) == 0; };
    const bool placed = begins(arguments.scene) || begins("--set") || begins("/") ||
                        begins(results_folder(arguments)) || (!arguments.restart.empty() && begins(arguments.restart));
    return report(2, placed ? what : arguments.scene + ": " + what, comm);
  } catch (const ixos::FileError& error) {
    report(4, error.what(), comm);
    if (any_left_open(comm)) MPI_Abort(MPI_COMM_WORLD, 4);
    return 4;
  } catch (const std::exception& error) {
    fmt::print(stderr, "ixos: a defect of ours, please report it: {}\n", ixos::printable(error.what()));
    // The other ranks may be waiting in a collective operation.
    if (comm->getSize() > 1) MPI_Abort(MPI_COMM_WORLD, 1);
    return 1;
  }
}

/// What can be said without a scene.
int answer(const Arguments& arguments, const ixos::Comm& comm) {
  if (arguments.check || arguments.explain || !arguments.mesh_file.empty() || !arguments.assignments.empty() ||
      !arguments.output.empty() || !arguments.restart.empty())
    return report(2, "a scene is needed: ixos SCENE.xml ...", comm);
  if (comm->getRank() != 0) return 0;
  if (arguments.version) print_version();
  if (arguments.list_schemes) print_schemes();
  if (arguments.parameters)
    fmt::print("{}", ixos::parameter_documentation(ixos::scene_parameters(), "Parameters", "ixos --parameters"));
  if (!arguments.template_name.empty()) {
    try {
      fmt::print("{}", ixos::scene_template(arguments.template_name));
    } catch (const ixos::InputError& error) {
      return report(2, std::string("--template: ") + error.what(), comm);
    }
  }
  if (!arguments.version && !arguments.list_schemes && !arguments.parameters && arguments.template_name.empty())
    fmt::print("{}", how_to_begin);
  return 0;
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
  app.add_option("--restart", arguments.restart,
                 "go on from this checkpoint of the scene, or a folder's newest sound one")
      ->check([](const std::string& file) { return file.empty() ? "a file is needed" : ""; });
  app.add_flag("--check", arguments.check, "check the scene and build it, but do not run it");
  app.add_flag("--explain", arguments.explain, "say what the scene models and what it leaves out, but do not run it");
  app.add_option("--template", arguments.template_name, "print a complete, commented scene: ball or block");
  app.add_option("--write-mesh", arguments.mesh_file, "write the scene's mesh to this Exodus file, but do not run it");
  app.add_flag("--parameters", arguments.parameters, "every parameter of a scene, as Markdown");
  app.add_flag("--list-schemes", arguments.list_schemes, "the time integrators, and what each is good for");
  app.add_flag("--version", arguments.version, "version and build");
  app.add_flag("--quiet", arguments.quiet, "say nothing but errors");
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    if (comm->getRank() == 0) fmt::print("{}", app.help());
    return 0;
  } catch (const CLI::ParseError& error) {
    return report(2, std::string(error.what()) + " (ixos --help lists the options)", comm);
  }
  if (!arguments.scene.empty()) return guarded_run(arguments, comm);
  return answer(arguments, comm);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    int none = 1;  // Kokkos would answer --help itself
    const Tpetra::ScopeGuard guard(&none, &argv);
    return parse_and_run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "ixos: cannot start: %s\n", error.what());
  } catch (...) {
    std::fprintf(stderr, "ixos: a defect of ours, please report it\n");
  }
  return 1;
}
