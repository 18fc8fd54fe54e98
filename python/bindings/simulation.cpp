// The class Simulation: its making, its steps and its clock.
#include <fmt/format.h>
#include <pybind11/stl.h>

#include <chrono>
#include <cmath>

#include "bindings.hpp"
#include "live_simulation.hpp"
#include "scene/explain/explanation.hpp"
#include "scene_list.hpp"

namespace py = pybind11;

namespace ixos::python {
namespace {

/// Throws InputError unless a step may have this length.
void check_length(double dt) {
  if (!(dt > 0 && std::isfinite(dt)))
    throw InputError(fmt::format("dt: a step of {} T0 is not possible; it must be finite and greater than 0", dt));
}

StepResult attempt(LiveSimulation& simulation, double dt) {
  check_length(dt);
  const Changing change(simulation);
  return compute(simulation, [&](Simulation& s) { return s.integrator().attempt(dt); });
}

void accept(const py::object& self) {
  auto& simulation = self.cast<LiveSimulation&>();
  const Changing change(simulation);
  compute(simulation, [](Simulation& s) { s.integrator().accept(); });
  notify(self);
}

StepResult step(const py::object& self, double dt) {
  check_length(dt);
  auto& simulation = self.cast<LiveSimulation&>();
  const Changing change(simulation);
  StepResult result = compute(simulation, [&](Simulation& s) { return s.integrator().step(dt); });
  if (result.converged) notify(self);
  return result;
}

StepResult nominal_step(const py::object& self) {
  return step(self, self.cast<LiveSimulation&>().get().step_control().time_step);
}

/// Takes steps without a call from Python for each, until a twentieth of a second has passed, so that Python sees
/// signals. Returns how many were accepted; sets `failed` if the last one was not.
long some_steps(const LiveSimulation& simulation, long count, double dt, bool& failed) {
  return compute(simulation, [&](Simulation& s) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::milliseconds(50);
    long done = 0;
    while (done < count && !failed) {
      failed = !s.integrator().step(dt).converged;
      if (!failed) ++done;
      if (std::chrono::steady_clock::now() > end) break;
    }
    return done;
  });
}

/// Takes up to `count` steps. Returns how many were accepted.
long steps(const py::object& self, long count, double dt) {
  if (count < 0) throw InputError(fmt::format("count: {} steps are not possible; at least 0 are allowed", count));
  check_length(dt);
  auto& simulation = self.cast<LiveSimulation&>();
  long done = 0;
  for (bool failed = false; done < count && !failed;) {
    if (has_observers(self)) {
      failed = !step(self, dt).converged;
      if (!failed) ++done;
    } else {
      const Changing change(simulation);
      done += some_steps(simulation, count - done, dt, failed);
    }
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
  }
  return done;
}

std::string words(const StepResult& result) {
  return result.converged ? fmt::format("<StepResult: converged in {} Newton iterations>", result.newton_iterations)
                          : fmt::format("<StepResult: failed: {}>", result.reason);
}

void bind_step_result(py::module_& module) {
  py::class_<StepResult>(module, "StepResult", "The result of a step. It is true if the step converged.")
      .def_readonly("converged", &StepResult::converged)
      .def_readonly("newton_iterations", &StepResult::newton_iterations)
      .def_readonly("linear_iterations", &StepResult::linear_iterations, "Iterations of iterative linear solvers.")
      .def_readonly("reason", &StepResult::reason, "Why the step failed.")
      .def_readonly("crossed", &StepResult::crossed, "Whether it failed because a surface crossed its obstacle.")
      .def("__bool__", [](const StepResult& result) { return result.converged; })
      .def("__repr__", &words);
}

}  // namespace

void bind_simulation(py::module_& module) {
  bind_step_result(module);
  SimulationClass simulation(module, "Simulation", py::dynamic_attr(), R"(A scene at its initial state, ready for steps.

Scene.simulation() makes it. On several ranks every rank must call its functions alike. Arrays that are called views are
the library's own memory: they show the present state until the next step; ask for them again after it.)");
  simulation
      .def(py::init([](const SceneList& scene, const py::object& comm, const Mesh* mesh) {
             return std::make_unique<LiveSimulation>(scene.list, scene.file, comm, mesh);
           }),
           py::arg("scene"), py::arg("comm") = py::none(), py::arg("mesh") = nullptr)
      .def("step", &step, py::arg("dt"),
           "Takes one step of length dt [T0]. If it fails, nothing has changed. Calls the observers.")
      .def("step", &nominal_step, "Takes one step of the scene's Time Step.")
      .def("steps", &steps, py::arg("count"), py::arg("dt"),
           "Takes up to `count` steps, until one fails. Returns the number of accepted steps. Calls Python between the "
           "steps only if there are observers.")
      .def("attempt", &attempt, py::arg("dt"),
           "Computes a step without accepting it: judge it, then accept() it or attempt another length.")
      .def("accept", &accept, "Accepts the attempted step. Calls the observers.")
      .def(
          "error",
          [](const LiveSimulation& s) { return compute(s, [](Simulation& now) { return now.integrator().error(); }); },
          "Returns the local error of a displacement in the attempted step [L0].")
      .def(
          "gap_ratio",
          [](const LiveSimulation& s) {
            return compute(s, [](Simulation& now) { return now.integrator().gap_ratio(); });
          },
          "Returns the largest ratio of the gaps that a point of a surface has in the attempted step.")
      .def(
          "stable_step",
          [](const LiveSimulation& s, double wanted) {
            return compute(s, [&](Simulation& now) { return now.integrator().stable_step(wanted); });
          },
          py::arg("wanted"), "Returns the longest stable step no longer than `wanted` [T0].")
      .def_property_readonly(
          "time", [](const LiveSimulation& s) { return s.integrator().time(); }, "Time [T0].")
      .def_property_readonly(
          "time_step", [](const LiveSimulation& s) { return s.get().step_control().time_step; },
          "The scene's Time Step [T0].")
      .def_property_readonly(
          "final_time", [](const LiveSimulation& s) { return s.get().step_control().final_time; },
          "The scene's Final Time [T0].")
      .def_property_readonly("scheme", [](const LiveSimulation& s) { return s.get().time_integrator().scheme; })
      .def_property_readonly("rank", [](const LiveSimulation& s) { return s.model().space().comm()->getRank(); })
      .def_property_readonly("ranks", [](const LiveSimulation& s) { return s.model().space().comm()->getSize(); })
      .def_property_readonly("observers", &observers,
                             "The list of functions that are called with the simulation after each accepted step.")
      .def_property_readonly(
          "_parameters",
          [](const LiveSimulation& s) {
            return SceneList{s.get().parameters(), s.file()};
          },
          "The complete scene in plain numbers.")
      .def_property_readonly("warnings",
                             [](const LiveSimulation& s) {
                               std::vector<std::string> messages;
                               for (const Warning& warning : s.get().warnings()) messages.push_back(warning.message);
                               return messages;
                             })
      .def_property_readonly(
          "notes", [](const LiveSimulation& s) { return s.get().notes(); }, "What Ixos left out of a mesh file.")
      .def(
          "explain", [](const LiveSimulation& s) { return compute(s, [](Simulation& now) { return explain(now); }); },
          "Returns what the scene models and what it leaves out.")
      .def("__repr__", [](const LiveSimulation& s) {
        return fmt::format("<ixos.Simulation: {}, {} degrees of freedom, t = {:.6g} T0>", s.get().parameters().name(),
                           s.model().space().global(), s.integrator().time());
      });
  bind_state(simulation);
  bind_initial_state(simulation);
  bind_measures(simulation);
  bind_local_mesh(module, simulation);
  bind_run(module, simulation);
}

}  // namespace ixos::python
