// Quantities that are computed from the present state: energies, momenta, contact, reactions, gaps, stresses.
#include <algorithm>

#include "arrays.hpp"
#include "base/closest_name.hpp"
#include "base/error.hpp"
#include "bindings.hpp"
#include "live_simulation.hpp"
#include "model/set_reactions.hpp"
#include "model/state_report.hpp"
#include "model/term_sums.hpp"
#include "run/history_row.hpp"

namespace py = pybind11;

namespace ixos::python {
namespace {

StateReport report_of(const Simulation& s) { return {s.model(), s.integrator().state()}; }

/// The names are those of history.csv.
py::dict energies(const LiveSimulation& simulation) {
  double kinetic = 0, elastic = 0, contact = 0;
  compute(simulation, [&](Simulation& s) {
    const StateReport report = report_of(s);
    kinetic = report.momenta().kinetic_energy;
    elastic = report.elastic_energy();
    if (s.model().has_interactions()) contact = report.energy(Part::Interaction);
  });
  py::dict result;
  result["kinetic_energy"] = kinetic;
  result["elastic_energy"] = elastic;
  result["contact_energy"] = contact;
  result["external_work"] = simulation.integrator().external_work();
  result["dissipated_energy"] = simulation.integrator().dissipated_energy();
  result["total_energy"] = kinetic + elastic + contact;
  return result;
}

Momenta momenta(const LiveSimulation& simulation) {
  return compute(simulation, [](Simulation& s) { return report_of(s).momenta(); });
}

py::dict contact(const LiveSimulation& simulation) {
  InteractionReport report = compute(simulation, [](Simulation& s) { return report_of(s).interaction_report(); });
  py::dict result;
  result["contact_force"] = taken(std::move(report.force));
  result["contact_measure"] = report.measure;
  result["min_gap"] = report.least_gap;
  return result;
}

/// The keys are the beginnings of the columns of history.csv.
py::dict interaction(const LiveSimulation& simulation, const std::string& name) {
  InteractionReport report;
  std::vector<double> moment;
  compute(simulation, [&](Simulation& s) {
    const InteractionGroup group = report_of(s).interaction(name);
    report = group.report();
    moment = group.moment();
  });
  py::dict result;
  result["contact_force"] = taken(std::move(report.force));
  if (!moment.empty()) result["contact_moment"] = taken(std::move(moment));
  result["contact_measure"] = report.measure;
  result["min_gap"] = report.least_gap;
  return result;
}

py::array reaction(const LiveSimulation& simulation, const std::string& set) {
  const std::size_t number = simulation.model().mesh().node_set(set);
  return taken(compute(
      simulation, [&](Simulation& s) { return set_reactions(s.model(), s.integrator().state().reaction, {number}); }));
}

py::dict probe(const LiveSimulation& simulation, const std::string& name) {
  std::vector<std::string> names;
  for (const Probe& probe : simulation.get().probes()) {
    names.push_back(probe.name);
    if (probe.name != name) continue;
    const DofSpace& space = simulation.model().space();
    std::vector<double> u, v;
    compute(simulation, [&](Simulation& s) {
      u = probe.point.value(space, s.integrator().state().u);
      v = probe.point.value(space, s.integrator().state().v);
    });
    py::dict result;
    result["u"] = taken(std::move(u));
    result["v"] = taken(std::move(v));
    return result;
  }
  throw InputError(no_such("probe", name, names, "The scene has"));
}

/// The columns that a run counts; the state does not have them.
bool is_counted(const std::string& column) {
  for (const char* name : {"step", "time_step", "newton_iterations", "linear_iterations", "wall_seconds"})
    if (column == name) return true;
  return false;
}

py::dict row(const LiveSimulation& simulation) {
  std::vector<std::string> names;
  std::vector<double> values;
  compute(simulation, [&](Simulation& s) {
    const HistoryRow row(s);
    names = row.columns();
    values = row.values({}).row;
  });
  py::dict result;
  for (std::size_t i = 0; i < names.size(); ++i)
    if (!is_counted(names[i])) result[py::str(names[i])] = values[i];
  return result;
}

double column(const LiveSimulation& simulation, const std::string& name) {
  const py::dict all = row(simulation);
  if (all.contains(name.c_str())) return all[name.c_str()].cast<double>();
  std::vector<std::string> names;
  for (const auto& item : all) names.push_back(item.first.cast<std::string>());
  throw InputError(no_such("column", name, names, "The columns of a state are"));
}

/// Returns nodal values of the model at the present displacement, a row a node if there are several a node.
template <class Values>
py::array nodal(const LiveSimulation& simulation, const Values& values) {
  std::vector<double> result = compute(simulation, [&](Simulation& s) { return (report_of(s).*values)(); });
  const py::ssize_t d = simulation.model().space().dimension();
  const auto nodes = static_cast<py::ssize_t>(simulation.model().mesh().nodes());
  const Shape shape = static_cast<py::ssize_t>(result.size()) == nodes ? Shape{nodes} : Shape{nodes, d};
  return taken(std::move(result), shape);
}

/// Returns the part's forces f(u), which stand on the left of M a + C v + f(u) = loads; zero for ghosts.
py::array forces(const LiveSimulation& simulation, Part part) {
  const DofSpace& space = simulation.model().space();
  std::vector<double> result(static_cast<std::size_t>(space.local()), 0.0);
  compute(simulation, [&](Simulation& s) {
    const Segment here = segment_at(s.integrator().state().place());
    TermSums(s.model()).force(part, here, end_rule(), result.data());
  });
  std::fill(result.begin() + space.owned(), result.end(), 0.0);
  const py::ssize_t nodes = simulation.model().mesh().nodes(), d = space.dimension();
  return taken(std::move(result), {nodes, d});
}

}  // namespace

void bind_measures(SimulationClass& simulation) {
  simulation
      .def("row", &row,
           "Returns what the present state gives the columns of history.csv, by their names; NaN where Output leaves "
           "out a group. Collective.")
      .def("__getitem__", &column, py::arg("column"), "Returns one of row(). Collective.")
      .def_property_readonly("energies", &energies,
                             "Energies and work by their names in history.csv [E0 L0^D]. Collective.")
      .def_property_readonly(
          "linear_momentum", [](const LiveSimulation& s) { return taken(momenta(s).linear); },
          "Linear momentum. Collective.")
      .def_property_readonly(
          "angular_momentum", [](const LiveSimulation& s) { return taken(momenta(s).angular); },
          "Angular momentum about the origin: z in two dimensions. Collective.")
      .def_property_readonly("contact", &contact,
                             "contact_force, contact_measure and min_gap, as in history.csv. Collective.")
      .def("interaction", &interaction, py::arg("name"),
           "Returns contact_force, contact_moment about the origin (not of axisymmetric bodies), contact_measure and "
           "min_gap of one interaction. Collective.")
      .def("reaction", &reaction, py::arg("node_set"),
           "Returns the sum of the reactions of a node set [E0 L0^(D-1)]. Collective.")
      .def("probe", &probe, py::arg("name"), "Returns displacement u and velocity v of a probe. Collective.")
      .def_property_readonly(
          "elastic_forces", [](const LiveSimulation& s) { return forces(s, Part::Elastic); },
          "Nodal forces of elasticity, nodes x dimension [E0 L0^(D-1)], as in M a + C v + f_el + f_c = loads; zero for "
          "ghosts.")
      .def_property_readonly(
          "interaction_forces", [](const LiveSimulation& s) { return forces(s, Part::Interaction); },
          "Nodal forces f_c of the interactions, likewise. They sum to -contact_force.")
      .def_property_readonly(
          "gaps", [](const LiveSimulation& s) { return nodal(s, &StateReport::nodal_gap); },
          "Gaps to the nearest obstacle by node [L0]; NaN away from interacting surfaces. Valid for owned nodes.")
      .def_property_readonly(
          "pressure", [](const LiveSimulation& s) { return nodal(s, &StateReport::contact_pressure); },
          "Traction of the interactions along the obstacles' normals by node [E0]. Valid for owned nodes.")
      .def_property_readonly(
          "traction", [](const LiveSimulation& s) { return nodal(s, &StateReport::interaction_traction); },
          "Traction of the interactions, nodes x dimension [E0]. Valid for owned nodes.");
}

}  // namespace ixos::python
