#include "run/mesh_follower.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "adapt/moved_histories.hpp"
#include "adapt/moved_motion.hpp"
#include "adapt/whole_field.hpp"
#include "adapt/wished_splits.hpp"
#include "base/error.hpp"
#include "interaction/friction_law.hpp"
#include "interaction/gap_law.hpp"
#include "model/state_report.hpp"
#include "run/energies.hpp"

namespace ixos {
namespace {

/// Returns the surfaces with friction in a state. Collective.
SlidingSurfaces sliding_surfaces(const Simulation& simulation, const State& state) {
  SlidingSurfaces surfaces;
  const Mesh& mesh = simulation.split_mesh().mesh();
  const LocalMesh& local = simulation.model().mesh();
  const Comm& comm = simulation.model().space().comm();
  const StateReport report(simulation.model(), state);
  for (const SceneInteraction& interaction : simulation.interactions()) {
    if (interaction.friction.type == FrictionType::None) continue;
    const std::string& name = interaction.node.name();
    const InteractionGroup group = report.interaction(name);
    std::vector<double> gap = group.gap();
    std::replace_if(
        gap.begin(), gap.end(), [](double own) { return std::isnan(own); }, 0.0);  // away from the surface
    surfaces[name] = {whole_field(local, comm, group.normal(), static_cast<std::size_t>(mesh.dimension), mesh.nodes()),
                      whole_field(local, comm, gap, 1, mesh.nodes()),
                      FrictionLaw(interaction.friction, acting_law(interaction)).cutoff()};
  }
  return surfaces;
}

/// Returns a state whose points keep what it alone gives them.
State without_past(const Model& model, const std::vector<double>& u, const std::vector<double>& v, double time) {
  State state{u, v, {}};
  state.time = time;
  state.histories = model.create_histories();
  model.initialize(known_states({state}, 1).front(), state.histories);
  return state;
}

/// Returns whether some points keep more than that. Collective.
bool has_past(const Model& model, const State& state) {
  if (!keeps_something(state.histories)) return false;
  return model.space().maximum(without_past(model, state.u, state.v, state.time).histories == state.histories ? 0 : 1) >
         0;
}

/// Returns what a state asks of the mesh; in the middle of a step the front alone, as waves of strain would have most
/// steps repeated. Collective.
Signs signs_of(const Simulation& simulation, const State& state, bool has_bulk) {
  Signs signs;
  const SplitMesh& mesh = simulation.split_mesh();
  const AdaptOptions& options = simulation.adaptation();
  const LocalMesh& local = simulation.model().mesh();
  const Comm& comm = simulation.model().space().comm();
  const int dimension = mesh.mesh().dimension, nodes = mesh.mesh().nodes();
  const StateReport report(simulation.model(), state);
  for (const SceneInteraction& interaction : simulation.interactions()) {
    const std::vector<double> gaps =
        whole_field(local, comm, report.interaction(interaction.node.name()).gap_of_both(), 1, nodes);
    const auto law = acting_law(interaction);
    signs.fronts.emplace_back(mesh, interaction.side_set, law, gaps);
    if (interaction.is_pair()) signs.fronts.emplace_back(mesh, interaction.primary, law, gaps);
  }
  if (has_bulk && options.strain > 0)
    signs.bulk = std::make_unique<BulkStrain>(
        mesh, whole_field(local, comm, state.u, static_cast<std::size_t>(dimension), nodes),
        options.directions.empty() ? dimension : static_cast<int>(options.directions.size()));
  return signs;
}

/// Builds the simulation on another mesh, in the same state. Returns null, with the reason, if that is not admissible
/// there. Throws InputError if the mesh cannot be made.
std::shared_ptr<Simulation> moved(const Simulation& simulation, const CellSplits& splits, std::string& reason) {
  std::shared_ptr<Simulation> next = simulation.on_mesh(splits);
  next->resumes();
  Integrator& integrator = next->integrator();
  const Integrator& before = simulation.integrator();
  Motion motion =
      moved_motion(simulation.split_mesh(), simulation.model(), before.state(), next->split_mesh(), next->model());
  try {
    if (has_past(simulation.model(), before.state())) {
      State state = without_past(next->model(), motion.u, motion.v, before.time());
      move_histories(simulation.split_mesh(), simulation.model(), before.state().histories, next->split_mesh(),
                     next->model(), sliding_surfaces(*next, state), state.histories);
      integrator.resume(state);
    } else {
      integrator.initialize(std::move(motion.u), std::move(motion.v), before.time());
    }
  } catch (const InputError& error) {
    reason = error.what();
    return nullptr;
  }
  integrator.continue_works(before, 0);
  integrator.set_interaction_points(before.table().interaction_points);
  return next;
}

}  // namespace

/// Returns the simulation with these splits; null, and a problem, if the state is not admissible there.
std::shared_ptr<Simulation> MeshFollower::with(const CellSplits& splits, const char* what) {
  if (splits == simulation_.split_mesh().tree().splits() || splits == refused_) return nullptr;
  std::string reason;
  std::shared_ptr<Simulation> next = moved(simulation_, splits, reason);
  if (next) return next;
  refused_ = splits;
  problem_ =
      fmt::format("at t = {:.6g} T0 cells stay as {} as they are: {}", simulation_.integrator().time(), what, reason);
  return nullptr;
}

std::shared_ptr<Simulation> MeshFollower::refined() {
  const AdaptOptions& options = simulation_.adaptation();
  const SplitMesh& mesh = simulation_.split_mesh();
  const Signs signs = signs_of(simulation_, simulation_.integrator().attempted(), false);
  const std::set<int> coarse = coarse_leaves(mesh, signs, options);
  if (std::includes(stay_coarse_.begin(), stay_coarse_.end(), coarse.begin(), coarse.end())) return nullptr;
  if (repeats_ >= options.levels) {
    problem_ = fmt::format(
        "the step from t = {:.6g} T0 was accepted with faces that are too coarse: it was repeated {} times on finer "
        "meshes; use shorter steps",
        simulation_.integrator().time(), repeats_);
    return nullptr;
  }
  const CellSplits finer = wished_splits(mesh, signs, options, simulation_.refined_places(), true),
                   present = mesh.tree().splits();
  if (finer == present) {
    stay_coarse_.insert(coarse.begin(), coarse.end());
    problem_ = fmt::format(
        "at t = {:.6g} T0 faces at the front stay too coarse: prisms, pyramids and the cells beside them are not split",
        simulation_.integrator().time());
    return nullptr;
  }
  std::shared_ptr<Simulation> next = with(finer, "coarse");
  if (!next) return nullptr;
  const Energies before = energies_of(simulation_), after = energies_of(*next);
  // Beside prisms and pyramids some cells may have to be joined, so that others can be split.
  if (!finer.contain(present)) changes_.coarsening += std::abs(after.total() - before.total());
  changes_.energy.add_change(before, after);
  ++changes_.count;
  ++changes_.repeated;
  ++repeats_;
  return next;
}

std::shared_ptr<Simulation> MeshFollower::adapted(long step, double largest_energy) {
  const AdaptOptions& options = simulation_.adaptation();
  if (step % options.interval != 0) return nullptr;
  const SplitMesh& mesh = simulation_.split_mesh();
  const Signs signs = signs_of(simulation_, simulation_.integrator().state(), true);
  const auto wished = [&](bool keep_all) {
    return wished_splits(mesh, signs, options, simulation_.refined_places(), keep_all);
  };
  const Energies before = energies_of(simulation_);
  const double scale = std::max(largest_energy, before.largest());
  for (const bool keep_all : {false, true}) {
    const CellSplits splits = wished(keep_all);
    const bool joins = !splits.contain(mesh.tree().splits());
    if (joins && splits == too_dear_) continue;
    std::shared_ptr<Simulation> next = with(splits, joins ? "fine" : "coarse");
    if (!next) return nullptr;
    const Energies after = energies_of(*next);
    const double change = after.total() - before.total();
    const double coarsening = changes_.coarsening + (joins ? std::abs(change) : 0);
    if (joins && !(coarsening <= options.budget * scale)) {
      too_dear_ = splits;
      problem_ = fmt::format(
          "at t = {:.6g} T0 cells stay split: to join them would change the energy by {:.3g} of the largest one in "
          "all, "
          "more than Mesh/Adapt/Budget, {}",
          simulation_.integrator().time(), coarsening / scale, options.budget);
      continue;
    }
    changes_.coarsening = coarsening;
    changes_.energy.add_change(before, after);
    ++changes_.count;
    return next;
  }
  return nullptr;
}

void MeshFollower::accept() {
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
  record.number("kinetic energy", changes_.energy.kinetic);
  record.number("elastic energy", changes_.energy.elastic);
  record.number("contact energy", changes_.energy.contact);
  record.number("coarsening", changes_.coarsening);
  record.number("unknowns", changes_.unknowns);
  record.number("most unknowns", changes_.most_unknowns);
  record.number("repeats", repeats_);
  for (const auto& [name, kept] : {std::pair("refused splits", &refused_), std::pair("too dear splits", &too_dear_)}) {
    std::string text = record.loading() ? "" : kept->text();
    record.text(name, text);
    if (record.loading()) *kept = CellSplits::of_text(text);
  }
}

std::shared_ptr<Simulation> on_first_mesh(const Simulation& simulation) {
  const AdaptOptions& options = simulation.adaptation();
  std::shared_ptr<Simulation> finer;
  for (int level = 0; level < options.levels; ++level) {
    const Simulation& present = finer ? *finer : simulation;
    const SplitMesh& mesh = present.split_mesh();
    const Signs signs = signs_of(present, present.integrator().state(), true);
    const CellSplits splits = wished_splits(mesh, signs, options, present.refined_places(), true);
    if (splits == mesh.tree().splits()) break;
    std::string reason;
    std::shared_ptr<Simulation> next = moved(present, splits, reason);
    if (!next) throw InputError("Mesh/Adapt: the first mesh cannot be as fine as the front asks: " + reason);
    finer = std::move(next);
  }
  return finer;
}

}  // namespace ixos
