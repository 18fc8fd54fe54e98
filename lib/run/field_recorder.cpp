#include "run/field_recorder.hpp"

#include <limits>

#include "base/agreement.hpp"
#include "base/phase_timer.hpp"

namespace ixos {
namespace {

FieldNames field_names(const Model& model) {
  FieldNames names;
  std::vector<std::string> vectors{"displacement", "velocity", "acceleration"};
  if (model.has_interactions()) vectors.emplace_back("interaction_traction");
  for (const std::string& vector : vectors)
    for (int i = 0; i < model.mesh().dimension; ++i) names.nodal.push_back(vector + "_" + "xyz"[i]);
  names.cell = {"first_stress_invariant", "jacobian", "energy_density"};
  if (model.has_viscosity()) names.cell.emplace_back("dissipated_energy_density");
  names.global = {"kinetic_energy", "elastic_energy",    "contact_energy",
                  "external_work",  "dissipated_energy", "total_energy"};
  return names;
}

/// A running simulation does not end because of an acceleration that only the output needs.
std::vector<double> acceleration_or_nan(Integrator& integrator) {
  try {
    return integrator.acceleration();
  } catch (const InputError&) {
    return std::vector<double>(integrator.state().u.size(), std::numeric_limits<double>::quiet_NaN());
  }
}

}  // namespace

FieldRecorder::FieldRecorder(Simulation& simulation, const std::string& path)
    : simulation_(simulation), comm_(simulation.model().space().comm()) {
  const Model& model = simulation.model();
  file_ = (simulation.output().fields_format == FieldsFormat::Hdf5 ? hdf5_fields : exodus_fields)(
      path, {OutputMesh(model.mesh(), comm_->getSize()), field_names(model), simulation.parameters().name()}, comm_);
}

void FieldRecorder::create() {
  together(comm_, [this] { file_->create(); });
}

void FieldRecorder::verify(const FieldLength& keep) const {
  together(comm_, [&] { file_->verify(keep); });
}

void FieldRecorder::resume(const FieldLength& keep) {
  together(comm_, [&] { file_->resume(keep); });
}

void FieldRecorder::sync() {
  together(comm_, [this] { file_->sync(); });
}

void FieldRecorder::close() {
  together(comm_, [this] { file_->close(); });
}

void FieldRecorder::record() {
  const TimedScope timed(Phase::Output);
  const Model& model = simulation_.model();
  Integrator& integrator = simulation_.integrator();
  const std::vector<double> a = acceleration_or_nan(integrator);
  const State& state = integrator.state();
  const auto d = static_cast<std::size_t>(model.mesh().dimension);
  const auto nodes = static_cast<std::size_t>(model.mesh().nodes());

  std::vector<std::vector<double>> nodal;
  const auto add = [&](const std::vector<double>& field) {
    for (std::size_t i = 0; i < d; ++i) {
      nodal.emplace_back(nodes);
      for (std::size_t n = 0; n < nodes; ++n) nodal.back()[n] = field[n * d + i];
    }
  };
  add(state.u);
  add(state.v);
  add(a);
  if (model.has_interactions()) {
    std::vector<double> traction = model.interaction_traction(state.u.data());
    model.space().update_ghosts(traction.data());
    add(traction);
  }
  const bool viscous = model.has_viscosity();
  std::vector<std::vector<std::vector<double>>> cell(viscous ? 4 : 3);
  for (CellFields& fields : model.cell_fields(state.u.data())) {
    cell[0].push_back(std::move(fields.stress_invariant));
    cell[1].push_back(std::move(fields.jacobian));
    if (viscous) {
      fields.dissipated.resize(fields.energy_density.size());
      cell[3].push_back(std::move(fields.dissipated));
    }
    cell[2].push_back(std::move(fields.energy_density));
  }
  const double kinetic = model.momenta(state.u.data(), state.v.data()).kinetic_energy;
  const double elastic = model.energy(Part::Elastic, state.u.data());
  const double contact = model.energy(Part::Interaction, state.u.data());
  together(comm_, [&] {
    file_->write(integrator.time(), nodal, cell,
                 {kinetic, elastic, contact, integrator.external_work(), integrator.dissipated_energy(),
                  kinetic + elastic + contact});
  });
}

}  // namespace ixos
