// A new beginning: displacements and velocities from arrays.
#include <fmt/format.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "arrays.hpp"
#include "base/agreement.hpp"
#include "base/error.hpp"
#include "base/snapshot.hpp"
#include "bindings.hpp"
#include "live_simulation.hpp"
#include "model/crossing.hpp"
#include "model/term_sums.hpp"

namespace py = pybind11;

namespace ixos::python {
namespace {

using Values = std::vector<double>;

/// Returns " on rank 1", where there are several.
std::string on_rank(const Model& model) {
  const Comm& comm = model.space().comm();
  return comm->getSize() == 1 ? "" : fmt::format(" on rank {}", comm->getRank());
}

/// Returns the numbers of an array of the rank's nodes x dimension as a local array, in which rigid bodies keep what
/// they have in `state`. Throws InputError for another shape and for what is no array of numbers.
Values numbers(const py::object& object, const std::string& name, const Values& state, const Model& model) {
  const Numbers given = real_numbers(object, name + on_rank(model));
  const int nodes = model.mesh().nodes(), d = model.space().dimension();
  if (given.ndim() != 2 || given.shape(0) != nodes || given.shape(1) != d)
    throw InputError(fmt::format("{}{}: the array has the shape {}; ({}, {}) is needed, nodes x dimension", name,
                                 on_rank(model), py::str(given.attr("shape")).cast<std::string>(), nodes, d));
  Values values(given.data(), given.data() + given.size());
  values.insert(values.end(), state.begin() + model.space().first_global(), state.end());
  return values;
}

/// Throws InputError for an owned node's number that is not finite, or differs from that of the scene's conditions.
void check_values(const Values& values, const Values& prescribed, const char* name, double time, const Model& model) {
  const auto d = static_cast<std::size_t>(model.space().dimension());
  const auto owned = static_cast<std::size_t>(model.space().owned());
  double size = 0;
  for (std::size_t i = 0; i < owned; ++i) size = std::max(size, std::abs(prescribed[i]));
  for (std::size_t i = 0; i < owned; ++i) {
    if (std::abs(values[i] - prescribed[i]) <= 1e-9 * size) continue;
    const std::string place = fmt::format("{}[{}, {}]{}", name, i / d, i % d, on_rank(model));
    if (!std::isfinite(values[i])) throw InputError(fmt::format("{}: {} is not a finite number", place, values[i]));
    throw InputError(fmt::format("{}: {} is not possible; the scene's Boundary Conditions prescribe {} at t = {} T0",
                                 place, values[i], prescribed[i], time));
  }
}

void check_velocities(const Values& v, const Values& prescribed, double time, const Simulation& simulation) {
  // In momentum form a constrained velocity is the scheme's own, so that it may differ from the motion's.
  check_values(v, has_exact_rates(simulation.integrator().table()) ? prescribed : v, "v", time, simulation.model());
  const bool moves =
      std::any_of(v.begin(), v.begin() + simulation.model().space().owned(), [](double x) { return x != 0; });
  if (moves && simulation.model().mass() == nullptr)
    throw InputError("v: the scheme \"" + simulation.time_integrator().scheme + "\" has no velocities");
}

void check_time(double time, const Simulation& simulation) {
  const StepControlOptions& control = simulation.step_control();
  if (!(time >= control.initial_time && time <= control.final_time))
    throw InputError(fmt::format("time: {} T0 is not within the scene's times, {} to {}", time, control.initial_time,
                                 control.final_time));
}

/// Throws InputError unless forces are defined at the displacement. Collective.
void check_admissible(const Model& model, const Values& u, double time) {
  const TermHistories histories = model.create_histories();
  const Segment here = segment_at({u.data(), time, &histories});
  const TermSums terms(model);
  Values scratch(u.size());
  bool admissible = terms.force(Part::Elastic, here, end_rule(), scratch.data());
  if (model.has_interactions())
    admissible = terms.force(Part::Interaction, here, end_rule(), scratch.data()) && admissible;
  if (model.space().minimum(admissible ? 1 : 0) == 0)
    throw InputError("u: it is not admissible: a gap is not positive, or an element is inverted");
  if (const std::string crossed = crossing(model, here); !crossed.empty())
    throw InputError("u: it is not admissible: " + crossed);
}

/// Calls Integrator::initialize(), which changes the state before all of it is known to be sound: an acceleration may
/// overflow. If it throws InputError, which it does on all ranks, restores the state before the call.
void initialize(Integrator& integrator, Values u, Values v, double time) {
  Snapshot before([&](Record& record) { integrator.transfer(record); });
  before.save();
  try {
    integrator.initialize(std::move(u), std::move(v), time);
  } catch (const InputError&) {
    before.restore();
    throw;
  }
}

/// Begins anew. Changes nothing if it throws. Collective; ranks on which the arrays are wrong refuse for all.
void set_state(LiveSimulation& live, const py::object& given_u, const py::object& given_v,
               std::optional<double> given_time) {
  const Changing change(live);
  Simulation& simulation = live.get();
  const Model& model = simulation.model();
  const State& state = simulation.integrator().state();
  const double time = given_time.value_or(simulation.integrator().time());
  Values u, v;
  std::string problem;
  try {
    u = given_u.is_none() ? state.u : numbers(given_u, "u", state.u, model);
    v = given_v.is_none() ? state.v : numbers(given_v, "v", state.v, model);
  } catch (const InputError& error) {
    problem = error.what();
  }
  compute(live, [&](Simulation& s) {
    together<InputError>(model.space().comm(), [&] {
      if (!problem.empty()) throw InputError(problem);
      check_time(time, s);
      Values prescribed_u(u), prescribed_v(v);
      model.constraints().set(time, prescribed_u.data(), prescribed_v.data(), nullptr);
      for (Values* const values : {&prescribed_u, &prescribed_v})
        model.constraints().planes().project(values->data(), model.mesh().nodes());
      if (!given_u.is_none()) check_values(u, prescribed_u, "u", time, model);
      if (!given_v.is_none()) check_velocities(v, prescribed_v, time, s);
      u = std::move(prescribed_u);
      v = std::move(prescribed_v);
    });
    model.space().update_ghosts(u.data());
    model.space().update_ghosts(v.data());
    check_admissible(model, u, time);
    initialize(s.integrator(), std::move(u), std::move(v), time);
  });
}

py::array constrained(const LiveSimulation& live) {
  const Model& model = live.model();
  const py::ssize_t d = model.space().dimension(), nodes = model.mesh().nodes();
  py::array_t<bool> result({nodes, d});
  for (int dof = 0; dof < model.space().first_global(); ++dof)
    result.mutable_data()[dof] = model.constraints().holds(dof);
  return result;
}

}  // namespace

void bind_initial_state(SimulationClass& simulation) {
  simulation
      .def("set_state", &set_state, py::arg("u") = py::none(), py::arg("v") = py::none(), py::arg("time") = py::none(),
           R"(Begins anew from displacements u [L0] and velocities v [L0/T0], arrays of nodes x dimension.

The rows are those of `points`; ghosts take their owners' values. What is None stays as it is: u, v, the time [T0].
Work, dissipated energy and the memory of materials and surfaces begin at zero. Raises InputError, and changes nothing, for another
shape, for numbers that are not finite, for values that boundary conditions prescribe otherwise (see `constrained`), for
gaps that are not positive, for inverted elements, and if the accelerations cannot be solved for. Constrained velocities
of schemes in momentum form become those of the motion. Collective.)")
      .def_property_readonly("constrained", &constrained,
                             "Whether a boundary condition prescribes the displacement, nodes x dimension.");
}

}  // namespace ixos::python
