#include "run/field_recorder.hpp"

#include "base/agreement.hpp"
#include "base/phase_timer.hpp"
#include "run/energies.hpp"
#include "run/field_information.hpp"

namespace ixos {
namespace {

FieldNames field_names(const std::vector<OutputField>& fields, int dimension) {
  FieldNames names;
  for (const OutputField& field : fields)
    for (const std::string& component : field.components(dimension))
      (field.nodal ? names.nodal : names.cell).push_back(component);
  names.global = frame_energies();
  return names;
}

}  // namespace

FieldRecorder::FieldRecorder(Simulation& simulation, const std::string& path, const std::string& scene_file)
    : simulation_(simulation),
      comm_(simulation.model().space().comm()),
      fields_(chosen_fields(simulation.output().fields, simulation.model())) {
  const LocalMesh& mesh = simulation.model().mesh();
  file_ = (simulation.output().fields_format == FieldsFormat::Hdf5 ? hdf5_fields : exodus_fields)(
      path,
      {OutputMesh(mesh, comm_->getSize()), field_names(fields_, mesh.dimension), simulation.parameters().name(),
       field_information(simulation, scene_file, fields_)},
      comm_);
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

bool FieldRecorder::has_fields_of(const FieldRecorder& other) const {
  const int d = simulation_.model().mesh().dimension;
  const FieldNames mine = field_names(fields_, d), others = field_names(other.fields_, d);
  return mine.nodal == others.nodal && mine.cell == others.cell &&
         simulation_.output().fields_format == other.simulation_.output().fields_format;
}

void FieldRecorder::sync() {
  together(comm_, [this] { file_->sync(); });
}

void FieldRecorder::close() {
  together(comm_, [this] { file_->close(); });
}

void FieldRecorder::record() {
  const TimedScope timed(Phase::Output);
  Integrator& integrator = simulation_.integrator();
  FieldFrame frame(integrator);
  NodalValues nodal;
  CellValues cell;
  for (const OutputField& field : fields_) {
    if (field.nodal)
      for (auto& component : field.nodal(frame)) nodal.push_back(std::move(component));
    else
      for (auto& component : field.cell(frame)) cell.push_back(std::move(component));
  }
  const Energies energies = energies_of(simulation_);
  together(comm_, [&] {
    file_->write(integrator.time(), nodal, cell,
                 {energies.kinetic, energies.elastic, energies.contact, integrator.external_work(),
                  integrator.dissipated_energy(), energies.total()});
  });
}

}  // namespace ixos
