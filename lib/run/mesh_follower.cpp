#include "run/mesh_follower.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "adapt/moved_motion.hpp"
#include "adapt/whole_field.hpp"
#include "adapt/wished_splits.hpp"
#include "base/error.hpp"
#include "model/state_report.hpp"
#include "run/handover.hpp"

namespace ixos {
namespace {

/// Returns what a state asks of the mesh; in the middle of a step the front alone, as waves of strain would have most
/// steps repeated. Collective.
Signs signs_of(const Simulation& simulation, const State& state, bool has_bulk) {
  Signs signs;
  const SplitMesh& mesh = simulation.split_mesh();
  const LocalMesh& local = simulation.model().mesh();
  const Comm& comm = simulation.model().space().comm();
  const StateReport report(simulation.model(), state);
  for (const SceneInteraction& interaction : simulation.interactions())
    signs.fronts.emplace_back(
        mesh, interaction.side_set, *interaction.law,
        whole_field(local, comm, report.interaction(interaction.node.name()).gap(), 1, mesh.mesh().nodes()));
  if (has_bulk && simulation.adaptation().strain > 0)
    signs.bulk = std::make_unique<BulkStrain>(
        mesh, whole_field(local, comm, state.u, static_cast<std::size_t>(mesh.mesh().dimension), mesh.mesh().nodes()));
  return signs;
}

}  // namespace

std::shared_ptr<Simulation> MeshFollower::moved_to(const CellSplits& splits) {
  std::shared_ptr<Simulation> next = simulation_.on_mesh(splits, true);
  next->resumes();
  Integrator& integrator = next->integrator();
  const Integrator& before = simulation_.integrator();
  Motion motion =
      moved_motion(simulation_.split_mesh(), simulation_.model(), before.state(), next->split_mesh(), next->model());
  integrator.initialize(std::move(motion.u), std::move(motion.v), before.time());
  integrator.continue_works(before, 0);
  return next;
}

std::shared_ptr<Simulation> MeshFollower::refined() {
  const AdaptOptions& options = simulation_.adaptation();
  if (repeats_ >= options.levels) return nullptr;
  const SplitMesh& mesh = simulation_.split_mesh();
  const Signs signs = signs_of(simulation_, simulation_.integrator().attempted(), false);
  if (!has_coarse_cells(mesh, signs, options)) return nullptr;
  const CellSplits splits = wished_splits(mesh, signs, options, simulation_.refined_places(), true);
  if (splits == mesh.tree().splits()) return nullptr;
  std::shared_ptr<Simulation> next;
  try {
    next = moved_to(splits);
  } catch (const InputError&) {
    return nullptr;  // a surface is so near its obstacle that the finer one is not admissible
  }
  changes_.energy += total_energy(*next) - total_energy(simulation_);
  ++changes_.count;
  ++changes_.repeated;
  ++repeats_;
  return next;
}

std::shared_ptr<Simulation> MeshFollower::adapted(long step, double largest_energy) {
  const AdaptOptions& options = simulation_.adaptation();
  if (exhausted_ || step % options.interval != 0) return nullptr;
  const SplitMesh& mesh = simulation_.split_mesh();
  const Signs signs = signs_of(simulation_, simulation_.integrator().state(), true);
  const CellSplits splits = wished_splits(mesh, signs, options, simulation_.refined_places(), false);
  if (splits == mesh.tree().splits()) return nullptr;
  std::shared_ptr<Simulation> next;
  try {
    next = moved_to(splits);
  } catch (const InputError&) {
    return nullptr;  // a larger cell inverts, or a gap closes
  }
  const double change = total_energy(*next) - total_energy(simulation_);
  const double coarsening = changes_.coarsening + std::abs(change);
  if (!(coarsening <= options.budget * largest_energy)) {
    exhausted_ = true;
    return nullptr;
  }
  changes_.coarsening = coarsening;
  changes_.energy += change;
  ++changes_.count;
  return next;
}

void MeshFollower::count() {
  repeats_ = 0;
  const long long unknowns = simulation_.model().space().global();
  changes_.unknowns += static_cast<double>(unknowns);
  changes_.most_unknowns = std::max(changes_.most_unknowns, unknowns);
}

void MeshFollower::transfer(Record& record) {
  if (!on()) return;
  if (record.loading() && !record.has_section(adaptation_section)) return;
  const Record::Section section(record, adaptation_section);
  std::string splits = record.loading() ? "" : simulation_.split_mesh().tree().splits().text();
  record.text(splits_name, splits);
  record.number("changes", changes_.count);
  record.number("repeated steps", changes_.repeated);
  record.number("energy", changes_.energy);
  record.number("coarsening", changes_.coarsening);
  record.number("unknowns", changes_.unknowns);
  record.number("most unknowns", changes_.most_unknowns);
  record.number("repeats", repeats_);
  record.number("exhausted", exhausted_);
}

std::shared_ptr<Simulation> on_initial_mesh(const Simulation& simulation) {
  const AdaptOptions& options = simulation.adaptation();
  std::shared_ptr<Simulation> finer;
  for (int level = 0; level < options.levels; ++level) {
    const Simulation& present = finer ? *finer : simulation;
    const SplitMesh& mesh = present.split_mesh();
    const Signs signs = signs_of(present, present.integrator().state(), true);
    const CellSplits splits = wished_splits(mesh, signs, options, present.refined_places(), true);
    if (splits == mesh.tree().splits()) break;
    finer = present.on_mesh(splits, false);
  }
  return finer;
}

}  // namespace ixos
