/// Changes of the mesh during a run: it follows the front.
#pragma once
#include <memory>
#include <set>
#include <string>
#include <utility>

#include "base/record.hpp"
#include "run/energies.hpp"
#include "scene/simulation.hpp"

namespace ixos {

/// The changes of a run so far.
struct MeshChanges {
  long count = 0;
  long repeated = 0;      ///< of these: a step began anew on a finer mesh
  Energies energy;        ///< what all of them added [E0 L0^D]
  double coarsening = 0;  ///< sum of the magnitudes of the changes by joined cells
  double unknowns = 0;    ///< sum over the accepted steps
  long long most_unknowns = 0;
};

/// Looks at the states of a simulation, and builds the same scene on other meshes. Collective.
class MeshFollower {
 public:
  explicit MeshFollower(Simulation& simulation) : simulation_(simulation) {}

  bool on() const { return simulation_.adaptation().on(); }

  /// Returns the simulation on a finer mesh in the state at the start of the attempted step, if that step ends with a
  /// face that is too coarse; null if it does not, if the mesh was refined for this step as often as it has levels, or
  /// if the state is not admissible there. Throws InputError if the mesh cannot be made.
  std::shared_ptr<Simulation> refined();
  /// Returns the simulation on the mesh that the accepted state asks for; null between two looks, or if that is the
  /// mesh that it has, or not admissible. Cells stay split if their energy is more than the budget has left.
  /// `largest_energy`: of the run so far. Throws as refined().
  std::shared_ptr<Simulation> adapted(long step, double largest_energy);
  /// Takes part in an accepted step.
  void accept();

  const MeshChanges& changes() const { return changes_; }
  /// Returns what keeps the mesh from a change since the last call; empty if nothing does.
  std::string take_problem() { return std::exchange(problem_, {}); }
  /// Counts on from the follower of a simulation that ends, and what the change to this one did.
  void go_on_from(const MeshFollower& before) {
    changes_ = before.changes_;
    repeats_ = before.repeats_;
  }

  /// For checkpoints: the counts, and the splits of the mesh, which splits_of_checkpoint() reads.
  void transfer(Record& record);

 private:
  std::shared_ptr<Simulation> with(const CellSplits& splits, const char* what);

  Simulation& simulation_;
  MeshChanges changes_;
  int repeats_ = 0;            ///< of the step under way
  CellSplits refused_;         ///< those with which the state was not admissible
  CellSplits too_dear_;        ///< those whose energy the budget did not have
  std::set<int> stay_coarse_;  ///< leaves whose faces are too coarse, but cannot be split
  std::string problem_;
};

/// Returns the simulation on the mesh that its present state asks for, in that state, before its first step; null if it
/// has that mesh. Throws InputError if the mesh cannot be made, or the state is not admissible there.
std::shared_ptr<Simulation> on_first_mesh(const Simulation& simulation);

/// The section of a checkpoint with the splits of the mesh, and their name there.
inline constexpr const char* adaptation_section = "adaptation";
inline constexpr const char* splits_name = "splits";

}  // namespace ixos
