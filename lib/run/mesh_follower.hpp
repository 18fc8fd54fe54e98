/// Changes of the mesh during a run: it follows the front.
#pragma once
#include <memory>

#include "base/record.hpp"
#include "scene/simulation.hpp"

namespace ixos {

/// The changes of a run so far.
struct MeshChanges {
  long count = 0;
  long repeated = 0;      ///< of these: a step began anew on a finer mesh
  double energy = 0;      ///< what all of them added to kinetic, elastic and interaction energy [E0 L0^D]
  double coarsening = 0;  ///< sum of the magnitudes of those by joined cells
  double unknowns = 0;    ///< sum over the accepted steps
  long long most_unknowns = 0;
};

/// Looks at the states of a simulation, and builds the same scene on other meshes. Collective.
class MeshFollower {
 public:
  explicit MeshFollower(Simulation& simulation) : simulation_(simulation) {}

  bool on() const { return simulation_.adaptation().on(); }

  /// Returns the simulation on a finer mesh in the state at the start of the attempted step, if that step ends with a
  /// cell that is too coarse; null if it does not, or if the mesh was refined for this step as often as it has levels.
  std::shared_ptr<Simulation> refined();
  /// Returns the simulation on the mesh that the accepted state asks for, where cells may be joined; null between two
  /// looks, if that is the mesh that it has, or if the budget is used up. `largest_energy`: of the run so far.
  std::shared_ptr<Simulation> adapted(long step, double largest_energy);
  /// Takes part in an accepted step.
  void count();

  const MeshChanges& changes() const { return changes_; }
  /// Counts on from the follower of a simulation that ends, and what the change to this one did.
  void go_on_from(const MeshFollower& before) {
    changes_ = before.changes_;
    repeats_ = before.repeats_;
    exhausted_ = before.exhausted_;
  }

  /// For checkpoints: the counts, and the splits of the mesh, which splits_of_checkpoint() reads.
  void transfer(Record& record);

 private:
  std::shared_ptr<Simulation> moved_to(const CellSplits& splits);

  Simulation& simulation_;
  MeshChanges changes_;
  int repeats_ = 0;         ///< of the step under way
  bool exhausted_ = false;  ///< the budget
};

/// Returns the simulation on the mesh that its initial state asks for; null if it has that mesh.
std::shared_ptr<Simulation> on_initial_mesh(const Simulation& simulation);

/// The section of a checkpoint with the splits of the mesh, and their name there.
inline constexpr const char* adaptation_section = "adaptation";
inline constexpr const char* splits_name = "splits";

}  // namespace ixos
