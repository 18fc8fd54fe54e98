// Whole runs, with results on disk.
#include "run/run.hpp"

#include <fmt/format.h>
#include <pybind11/stl.h>

#include "bindings.hpp"
#include "live_simulation.hpp"
#include "run/summary.hpp"
#include "scene_list.hpp"

namespace py = pybind11;

namespace ixos::python {
namespace {

std::vector<std::string> messages(const std::vector<Warning>& warnings) {
  std::vector<std::string> result;
  for (const Warning& warning : warnings) result.push_back(warning.message);
  return result;
}

/// Runs to the final time. An exception of an observer, and Ctrl-C, end the run on all ranks as a signal ends the
/// command: with a checkpoint. Then rethrows the exception, on the rank that has it.
RunResult run_live(const py::object& self, const std::string& folder, bool overwrite, const std::string& restart,
                   const py::object& log, const py::object& progress) {
  auto& simulation = self.cast<LiveSimulation&>();
  const Changing change(simulation);
  std::exception_ptr stopped;
  const auto guarded = [&](const auto& call) {
    const py::gil_scoped_acquire hold;
    try {
      if (!stopped) call();
    } catch (...) {
      stopped = std::current_exception();
    }
  };
  RunOptions options;
  options.folder = folder;
  options.scene_file = simulation.file();
  options.overwrite = overwrite;
  options.restart = restart;
  if (!log.is_none()) options.log = [&](const std::string& line) { guarded([&] { log(line); }); };
  options.observe = [&](const Progress&) {
    guarded([&] { notify(self); });
    return std::string();
  };
  if (!progress.is_none())
    options.watch = options.iterate = [&](const Progress& here) { guarded([&] { progress(here); }); };
  options.stage = [&](const std::shared_ptr<Simulation>& stage) { simulation.go_on_with(stage); };
  options.interrupted = [&] {
    guarded([] {
      if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    });
    return stopped != nullptr;
  };
  RunResult result = compute(simulation, [&](Simulation& inner) {
    return at_scene(simulation.file(), {folder, restart}, [&] { return run(inner, options); });
  });
  if (stopped) std::rethrow_exception(stopped);
  return result;
}

}  // namespace

void bind_run(py::module_& module, SimulationClass& simulation) {
  py::class_<Progress>(module, "Progress", "Where a run stands: after a step, or at an iterate of Newton's method.")
      .def_readonly("time", &Progress::time, "Of the last accepted step [T0].")
      .def_readonly("final_time", &Progress::final_time, "[T0]")
      .def_readonly("step", &Progress::step, "Number of accepted steps.")
      .def_readonly("newton_iterations", &Progress::newton_iterations, "Of the whole run.")
      .def_readonly("wall_seconds", &Progress::wall_seconds)
      .def_readonly("seconds_left", &Progress::seconds_left, "If the rest goes as fast; 0: unknown.")
      .def_readonly("time_step", &Progress::time_step, "Of the accepted step, or of that under way [T0].")
      .def_readonly("within_step", &Progress::within_step, "Whether a step is under way, of which the next three tell.")
      .def_property_readonly(
          "iteration", [](const Progress& p) { return p.newton.iteration; }, "Of the step under way.")
      .def_property_readonly(
          "residual", [](const Progress& p) { return p.newton.residual; },
          "Norm of the residual of the step under way.")
      .def_property_readonly(
          "bound", [](const Progress& p) { return p.newton.bound; }, "The residual at which the step has converged.")
      .def("__repr__", [](const Progress& p) {
        return fmt::format("<ixos.Progress: t = {:.6g} of {:.6g} T0, step {}, iteration {}>", p.time, p.final_time,
                           p.step, p.newton.iteration);
      });
  py::class_<RunResult>(module, "RunResult", py::dynamic_attr(), "How a run ended, and what it counted.")
      .def_property_readonly(
          "status", [](const RunResult& r) { return to_string(r.status); },
          "completed, stopped, diverged or interrupted.")
      .def_readonly("reason", &RunResult::reason)
      .def_readonly("steps", &RunResult::steps)
      .def_readonly("rejected_steps", &RunResult::rejected_steps)
      .def_readonly("end_time", &RunResult::end_time, "[T0]")
      .def_readonly("newton_iterations", &RunResult::newton_iterations)
      .def_readonly("linear_iterations", &RunResult::linear_iterations)
      .def_readonly("wall_seconds", &RunResult::wall_seconds)
      .def_readonly("max_energy_error", &RunResult::max_energy_error, "[E0 L0^D]")
      .def_readonly("largest_energy", &RunResult::largest_energy, "[E0 L0^D]")
      .def_readonly("checkpoint", &RunResult::checkpoint, "Path of the newest checkpoint; may be empty.")
      .def_property_readonly("max_forces",
                             [](const RunResult& r) {
                               py::dict forces;
                               for (const auto& [name, value] : r.max_forces) forces[py::str(name)] = value;
                               return forces;
                             })
      .def_property_readonly(
          "jumps",
          [](const RunResult& r) {
            return py::dict(py::arg("count") = r.jumps.count, py::arg("released") = r.jumps.released,
                            py::arg("largest") = r.jumps.largest.released);
          },
          "Number of jumps of a quasi-static run to other equilibria, and the energy that they released, and that of "
          "the largest [E0 L0^D].")
      .def_property_readonly("warnings", [](const RunResult& r) { return messages(r.warnings); })
      .def_property_readonly("findings", [](const RunResult& r) { return messages(r.findings); })
      .def("__repr__", [](const RunResult& r) {
        return fmt::format("<ixos.RunResult: {}, t = {:.6g} T0, {} steps{}{}>", to_string(r.status), r.end_time,
                           r.steps, r.reason.empty() ? "" : ": ", r.reason);
      });
  simulation.def("_run", &run_live, py::arg("folder"), py::arg("overwrite"), py::arg("restart"), py::arg("log"),
                 py::arg("progress"));
}

}  // namespace ixos::python
