/// Moves the numbers that points of bodies and surfaces keep to another mesh.
#pragma once
#include <map>
#include <string>
#include <vector>

#include "adapt/split_mesh.hpp"
#include "model/model.hpp"
#include "state/histories.hpp"

namespace ixos {

/// A surface that slides, in the state on the new mesh: fields by node of the whole mesh.
struct SlidingSurface {
  std::vector<double> normal;  ///< of its obstacle or of the other surface, nodes x dimension
  std::vector<double> gap;     ///< [L0]
  double cutoff = 0;           ///< gap from which on nothing resists slip [L0]
};
/// By the names of interactions, see Model::slot_names().
using SlidingSurfaces = std::map<std::string, SlidingSurface>;

/// Sets the histories of a model to those of a model on another mesh of the same unsplit cells. A point takes the mean
/// of the points around it in the cell, or on the side, that it lay in: with weights that are linear between them, and
/// constant beyond the outermost ones, see move_columns(). A cell that both meshes have keeps its numbers to the last
/// bit, a function that is linear in the reference coordinates stays that function between the outermost points, and no
/// number leaves the range that it had there. A point between two old cells takes the mean of both. Tractions of
/// friction lose their part along the normal, and vanish where nothing resists slip. The sums of what points dissipated
/// change with the points. A point whose cell or side had none keeps its own. Lists, such as the visibility of a
/// surface on itself, stay as they are in `histories`. Collective.
void move_histories(const SplitMesh& from, const Model& before, const TermHistories& past, const SplitMesh& to,
                    const Model& after, const SlidingSurfaces& surfaces, TermHistories& histories);

/// Returns whether points keep something.
bool keeps_something(const TermHistories& histories);

}  // namespace ixos
