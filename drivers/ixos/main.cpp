// ixos: runs a scene. Exit status: 0 done; 1 a defect of ours; 2 bad input; 3 the solution could not be continued, or
// memory ran out; 4 input, output or communication failed; 5 interrupted.
#include <malloc.h>
#include <mpi.h>
#include <unistd.h>

#include <fmt/format.h>

#include <Teuchos_CommHelpers.hpp>
#include <Tpetra_Core.hpp>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>

#include "base/agreement.hpp"
#include "base/error.hpp"
#include "base/memory.hpp"
#include "base/printable.hpp"
#include "console.hpp"
#include "io/hdf5_file.hpp"
#include "io/mesh_file.hpp"
#include "ixos/accuracy.hpp"
#include "ixos/answers.hpp"
#include "ixos/arguments.hpp"
#include "ixos/launch.hpp"
#include "ixos/mpi_errors.hpp"
#include "ixos/scene_run.hpp"
#include "ixos/trial.hpp"
#include "ixos/verify_restart.hpp"
#include "run/restart.hpp"
#include "scene/explain/documentation.hpp"
#include "scene/explain/explanation.hpp"
#include "scene/read/parameters.hpp"
#include "scene/read/scene_mesh.hpp"
#include "scene/read/scene_units.hpp"
#include "scene/scene_file.hpp"
#include "study/common/named_quantities.hpp"

namespace {

using ixos::Arguments;

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
  ixos::on_first_rank(comm, [&] { ixos::prepare_drawings(complete.sublist("Mesh"), scene_folder(arguments)); });
  const ixos::Mesh mesh = ixos::scene_mesh(complete.sublist("Mesh"), scene_folder(arguments));
  ixos::on_first_rank(comm, [&] {
    ixos::write_mesh(mesh, arguments.mesh_file, complete.name());
    if (!mesh.ties.empty() && !arguments.quiet)
      ixos::console::say("{}: {}\n", ixos::printable(arguments.mesh_file), ixos::lost_ties(mesh));
  });
  return 0;
}

void check_restart(const ixos::Simulation& simulation, const std::string& file, bool speaks) {
  const auto other = ixos::simulation_of_checkpoint(simulation, file);
  const ixos::Restart restart(other ? *other : simulation, file);
  if (!speaks) return;
  ixos::console::say("{} is sound and fits the scene.\n", ixos::printable(restart.path()));
  for (const std::string& note : restart.notes()) ixos::console::say("{}\n", ixos::printable(note));
}

/// Returns what --check says of a scene that can run.
std::string verdict(std::size_t warnings) {
  if (warnings == 0) return "The scene is sound.";
  if (warnings == 1) return "The scene can run, but the warning above says what may be wrong with it.";
  return fmt::format("The scene can run, but the {} warnings above say what may be wrong with it.", warnings);
}

int run_scene(const Arguments& arguments, const ixos::Comm& comm) {
  const bool speaks = ixos::speaks(arguments, comm);
  ixos::PlacedScene scene{{}, scene_folder(arguments)};
  ixos::together<ixos::InputError>(comm, [&] { scene.list = ixos::read_scene_file(arguments.scene); });
  for (const std::string& assignment : arguments.assignments)
    ixos::set_parameter(scene.list, ixos::scene_parameters(), assignment);
  if (!arguments.mesh_file.empty()) return write_mesh(scene.list, arguments, comm);
  if (arguments.accuracy > 0) {
    const ixos::AccuracyTask task = ixos::accuracy_task(scene, arguments.accuracy, comm);
    if (!arguments.check && !arguments.explain) return ixos::reach_accuracy(scene, task, arguments, comm);
    scene = ixos::with_settings(scene, task.first);
  }
  ixos::Simulation simulation(scene.list, comm, scene.folder);
  ixos::named_quantities(simulation);  // refuses those that the run does not have
  if (!arguments.restart.empty()) simulation.resumes();
  if (speaks) ixos::introduce(simulation);
  if (speaks) ixos::warn(simulation.warnings());
  if (arguments.explain) {
    const std::string explanation = ixos::explain(simulation);
    if (comm->getRank() == 0) ixos::console::print(explanation);
    return 0;
  }
  if (arguments.check) {
    if (!arguments.restart.empty()) check_restart(simulation, arguments.restart, speaks);
    if (speaks) ixos::tell_sets_and_hints(simulation);
    if (speaks)
      ixos::console::say("{}{}\n", to_string(simulation.mesh_quality()), verdict(simulation.warnings().size()));
    return 0;
  }
  if (arguments.tries) return ixos::try_scene(simulation, arguments);
  const ixos::RunResult result = ixos::carry_out(simulation, arguments);
  const int status = ixos::report_end(result, arguments, comm);
  if (speaks) ixos::warn(result.findings);
  return status;
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
  if (arguments.check || arguments.tries || arguments.explain || arguments.overwrite || !arguments.mesh_file.empty() ||
      !arguments.assignments.empty() || !arguments.output.empty() || !arguments.restart.empty() ||
      arguments.kill_after_step > 0 || arguments.accuracy > 0)
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
  // The launcher ends all ranks soon after the first one, which in MPI waits for the one that speaks.
  if (arguments.verify_restart)
    return report(2, "--verify-restart starts its runs itself: call it without mpirun, with --ranks N", comm);
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
    if (line.error.empty() && line.help.empty() && line.arguments.verify_restart && !ixos::is_launched())
      return ixos::verify_restart(line.arguments);  // starts processes with MPI: must not have started it itself
    ixos::start_hdf5();
    int none = 1;  // Kokkos would answer --help itself
    std::optional<Tpetra::ScopeGuard> guard;
    {
      const ixos::SingleStart alone;
      guard.emplace(&none, &argv);
    }
    ixos::use_one_blas_thread();
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
