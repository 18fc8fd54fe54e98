/// Directions of an advice: the settings of a scene that it may change.
#pragma once
#include <Teuchos_ParameterList.hpp>
#include <string>
#include <vector>

#include "study/common/study_run.hpp"

namespace ixos {

/// A level of refinement: a size that falls from level to level, and the settings that give it.
struct AdviceLevel {
  std::string label;
  double size = 0;
  Assignments settings;
};

/// A way to refine: a scheme with its steps, a contact element with its meshes.
struct AdviceBranch {
  std::string label;
  Assignments settings;
  std::vector<AdviceLevel> levels;  ///< the coarsest first; at least one
  bool same_limit = true;           ///< whether refinement leads to the solution that the first branch leads to, too
  bool may_be_better = true;        ///< whether the branch may be more accurate than the first at the same level
  bool higher_order = false;        ///< whether it has elements of a higher order than the first
  std::string law{};                ///< an elastic law in place of the scene's; empty: the scene's own
};

/// Branches that exclude each other. The first one is the scene's own.
struct AdviceDirection {
  std::string name;
  std::vector<AdviceBranch> branches;
  std::size_t scene_level = 0;  ///< the level of the scene as it is
  /// Whether refinement leads to the exact solution. If not, the scene's own branch counts as exact, and the direction
  /// is a choice of the model.
  bool converges = true;
  /// Whether, in a direction after step and mesh, the next level must be run because the scene's own may be inaccurate.
  /// Otherwise the scene's own counts as exact.
  bool suspect = false;
};

/// Everything that an advice may change. The first two directions are the time step and the mesh.
struct AdviceDirections {
  std::vector<AdviceDirection> all;
  int dimension = 2;         ///< of the mesh; a guess if a file holds the mesh
  bool adaptive = false;     ///< whether the time direction refines the tolerance of adaptive steps
  std::string mesh_note;     ///< why the mesh cannot be refined; empty if it can
  Assignments perturbation;  ///< changes each density by 1e-10 of it
};

inline constexpr std::size_t time_direction = 0, mesh_direction = 1;

/// Returns whether a branch replaces the scene's model: refinement does not lead to what the scene's own branch leads
/// to.
bool replaces_model(const AdviceDirections& directions, std::size_t direction, std::size_t branch);

/// Returns whether a branch has another elastic law, whose strain measure must hold for the strains of the runs.
bool has_other_laws(const AdviceDirections& directions);

/// Returns what can be varied in a complete scene. Refines the time step and the mesh by factors of two. The coarsest
/// step divides the run into at least 30 steps, and is at most 16 times the scene's; the coarsest mesh has up to
/// eight times the cell length of the scene's, as far as its numbers of cells can be halved.
AdviceDirections advice_directions(const Teuchos::ParameterList& complete);

}  // namespace ixos
