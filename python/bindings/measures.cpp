// Quantities that are computed from the present state: energies, momenta, contact, reactions, gaps, stresses.
#include "arrays.hpp"
#include "bindings.hpp"
#include "live_simulation.hpp"
#include "run/set_reactions.hpp"

namespace py = pybind11;

namespace ixos::python {
namespace {

/// The names are those of history.csv.
py::dict energies(const LiveSimulation& simulation) {
  const Model& model = simulation.model();
  const State& state = simulation.state();
  const double kinetic = model.momenta(state.u.data(), state.v.data()).kinetic_energy;
  const double elastic = model.energy(Part::Elastic, state.u.data());
  const double contact = model.has_interactions() ? model.energy(Part::Interaction, state.u.data()) : 0.0;
  py::dict result;
  result["kinetic_energy"] = kinetic;
  result["elastic_energy"] = elastic;
  result["contact_energy"] = contact;
  result["external_work"] = simulation.integrator().external_work();
  result["dissipated_energy"] = simulation.integrator().dissipated_energy();
  result["total_energy"] = kinetic + elastic + contact;
  return result;
}

py::dict contact(const LiveSimulation& simulation) {
  InteractionReport report = simulation.model().interaction_report(simulation.state().u.data());
  py::dict result;
  result["contact_force"] = taken(std::move(report.force));
  result["contact_measure"] = report.measure;
  result["min_gap"] = report.least_gap;
  return result;
}

py::array reaction(const LiveSimulation& simulation, const std::string& set) {
  const std::size_t number = simulation.model().mesh().node_set(set);
  return taken(set_reactions(simulation.get(), {number}));
}

py::dict probe(const LiveSimulation& simulation, const std::string& name) {
  for (const Probe& probe : simulation.get().probes()) {
    if (probe.name != name) continue;
    const DofSpace& space = simulation.model().space();
    py::dict result;
    result["u"] = taken(probe.point.value(space, simulation.state().u));
    result["v"] = taken(probe.point.value(space, simulation.state().v));
    return result;
  }
  throw py::key_error("the scene has no probe \"" + name + "\"");
}

py::array by_node(const LiveSimulation& simulation, std::vector<double> values) {
  const py::ssize_t d = simulation.model().space().dimension();
  const auto nodes = static_cast<py::ssize_t>(simulation.model().mesh().nodes());
  return taken(std::move(values), static_cast<py::ssize_t>(values.size()) == nodes ? Shape{nodes} : Shape{nodes, d});
}

}  // namespace

void bind_measures(SimulationClass& simulation) {
  simulation
      .def_property_readonly("energies", &energies,
                             "Energies and work by their names in history.csv [E0 L0^D]. Collective.")
      .def_property_readonly(
          "linear_momentum",
          [](const LiveSimulation& s) {
            return taken(s.model().momenta(s.state().u.data(), s.state().v.data()).linear);
          },
          "Linear momentum. Collective.")
      .def_property_readonly(
          "angular_momentum",
          [](const LiveSimulation& s) {
            return taken(s.model().momenta(s.state().u.data(), s.state().v.data()).angular);
          },
          "Angular momentum about the origin: z in two dimensions. Collective.")
      .def_property_readonly("contact", &contact,
                             "contact_force, contact_measure and min_gap, as in history.csv. Collective.")
      .def("reaction", &reaction, py::arg("node_set"),
           "Returns the sum of the reactions of a node set [E0 L0^(D-1)]. Collective.")
      .def("probe", &probe, py::arg("name"), "Returns displacement u and velocity v of a probe. Collective.")
      .def_property_readonly(
          "gaps", [](const LiveSimulation& s) { return by_node(s, s.model().nodal_gap(s.state().u.data())); },
          "Gaps to the nearest obstacle by node [L0]; NaN away from interacting surfaces. Valid for owned nodes.")
      .def_property_readonly(
          "pressure",
          [](const LiveSimulation& s) { return by_node(s, s.model().contact_pressure(s.state().u.data())); },
          "Traction of the interactions along the obstacles' normals by node [E0]. Valid for owned nodes.")
      .def_property_readonly(
          "traction",
          [](const LiveSimulation& s) { return by_node(s, s.model().interaction_traction(s.state().u.data())); },
          "Traction of the interactions, nodes x dimension [E0]. Valid for owned nodes.");
}

}  // namespace ixos::python
