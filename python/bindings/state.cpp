// The present state as views.
#include <algorithm>

#include "arrays.hpp"
#include "bindings.hpp"
#include "live_simulation.hpp"

namespace py = pybind11;

namespace ixos::python {
namespace {

/// Returns nodes x dimension, without the numbers of rigid bodies. Arrays of the owned nodes are empty without loads or
/// constraints.
py::array by_node(const std::vector<double>& values, const py::object& self) {
  const Model& model = self.cast<const LiveSimulation&>().model();
  const py::ssize_t d = model.space().dimension(), nodes = model.mesh().nodes();
  return view(values.data(), {std::min(static_cast<py::ssize_t>(values.size()) / d, nodes), d}, self);
}

py::array acceleration(const py::object& self) {
  const auto* values =
      compute(self.cast<const LiveSimulation&>(), [](Simulation& s) { return &s.integrator().acceleration(); });
  return by_node(*values, self);
}

}  // namespace

void bind_state(SimulationClass& simulation) {
  simulation
      .def_property_readonly(
          "u", [](const py::object& self) { return by_node(self.cast<const LiveSimulation&>().state().u, self); },
          "Displacements, nodes x dimension [L0]: a view. The rank's owned nodes come first, then ghosts.")
      .def_property_readonly(
          "v", [](const py::object& self) { return by_node(self.cast<const LiveSimulation&>().state().v, self); },
          "Velocities, nodes x dimension [L0/T0]: a view.")
      .def_property_readonly("a", &acceleration,
                             "Accelerations, nodes x dimension [L0/T0^2]: a view. Schemes in momentum form solve for "
                             "them at the first request of a step. Collective.")
      .def_property_readonly(
          "loads",
          [](const py::object& self) { return by_node(self.cast<const LiveSimulation&>().state().load, self); },
          "External forces, owned nodes x dimension [E0 L0^(D-1)]: a view; empty without loads.")
      .def_property_readonly(
          "reactions",
          [](const py::object& self) { return by_node(self.cast<const LiveSimulation&>().state().reaction, self); },
          "Reactions, owned nodes x dimension [E0 L0^(D-1)]: a view; empty without constraints.");
}

}  // namespace ixos::python
