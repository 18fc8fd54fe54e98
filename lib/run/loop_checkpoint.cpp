#include "run/loop_checkpoint.hpp"

#include <fmt/format.h>

#include <utility>

#include "base/agreement.hpp"
#include "checkpoint/checkpoint_file.hpp"
#include "checkpoint/seal.hpp"
#include "run/checkpoints.hpp"
#include "run/restart.hpp"

namespace ixos {
namespace {

void transfer_loop(Record& record, Integrator& integrator, const std::vector<ProgramState>& states) {
  if (!record.has_section("integrator"))
    throw InputError("is the checkpoint of a run: resume it with run() or ixos --restart");
  transfer(record, states);
  integrator.transfer(record);
}

/// Names what an integrator's model must have in common with that of the file.
void transfer_model(Record& record, const Integrator& integrator) {
  if (!record.has_section("model")) throw InputError("was written for a scene: read it with its Simulation");
  const Record::Section section(record, "model");
  std::string scheme = integrator.table().name;
  record.text("scheme", scheme);
  if (scheme != integrator.table().name)
    throw InputError(fmt::format("belongs to the scheme \"{}\", not to \"{}\"", scheme, integrator.table().name));
  const Model& model = integrator.model();
  const std::vector<double>& all = model.mesh().coordinates;
  const std::vector<double> mine(all.begin(), all.begin() + model.space().owned());
  std::vector<double> coordinates = mine;
  record.field("coordinates", coordinates, Extent::Owned);
  if (model.space().minimum(coordinates == mine ? 1 : 0) == 0)
    throw InputError("belongs to another mesh: its nodes stand elsewhere");
}

}  // namespace

void write_checkpoint(const std::string& path, Simulation& simulation, const std::vector<ProgramState>& states) {
  write_checkpoint_file(path, simulation.model().space(), simulation.model().mesh(), [&](Record& record) {
    write_identity(record, simulation);
    transfer_loop(record, simulation.integrator(), states);
  });
}

std::vector<std::string> read_checkpoint(const std::string& path, Simulation& simulation,
                                         const std::vector<ProgramState>& states) {
  Restart restart(simulation, path);
  restart.load([&](Record& record) { transfer_loop(record, simulation.integrator(), states); });
  return restart.notes();
}

void write_checkpoint(const std::string& path, Integrator& integrator, const std::vector<ProgramState>& states) {
  const Model& model = integrator.model();
  std::string build = build_name();
  write_checkpoint_file(path, model.space(), model.mesh(), [&](Record& record) {
    record.text("build", build);
    transfer_model(record, integrator);
    transfer_loop(record, integrator, states);
  });
}

std::vector<std::string> read_checkpoint(const std::string& path, Integrator& integrator,
                                         const std::vector<ProgramState>& states) {
  const Model& model = integrator.model();
  on_first_rank(model.space().comm(), [&] {
    const std::string problem = seal_problem(path);
    if (!problem.empty()) throw InputError(path + ": " + problem);
  });
  CheckpointReader reader(path, model.space(), model.mesh());
  std::vector<std::string> notes;
  load_placed(path, [&] {
    if (std::string build = other_build(reader); !build.empty()) notes.push_back(std::move(build));
    if (!reader.same_partition())
      notes.push_back(fmt::format("It was written on {} rank(s), or by another partition.", reader.ranks()));
    transfer_model(reader, integrator);
    transfer_loop(reader, integrator, states);
  });
  return notes;
}

}  // namespace ixos
