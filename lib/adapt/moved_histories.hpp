/// What points of bodies and surfaces keep, on another mesh.
#pragma once
#include "adapt/split_mesh.hpp"
#include "model/model.hpp"
#include "state/histories.hpp"

namespace ixos {

/// Sets the histories of a model to those of a model on another mesh of the same unsplit cells. A point takes the mean
/// of the points around it in the cell, or on the side, that it lay in: with weights that are linear between them, and
/// constant beyond the outermost ones, see move_columns(). So a cell that stays keeps its numbers to the last bit, a
/// function that is linear in the reference coordinates stays that function between the outermost points, and no
/// number leaves the range that it had there. A point whose cell or side had none keeps its own. Lists, such as the
/// visibility of a surface on itself, stay as they are in `histories`. Collective.
void move_histories(const SplitMesh& from, const Model& before, const TermHistories& past, const SplitMesh& to,
                    const Model& after, TermHistories& histories);

/// Returns whether points keep something.
bool keeps_something(const TermHistories& histories);

}  // namespace ixos
