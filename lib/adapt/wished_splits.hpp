/// The splits of a mesh that follows its front.
#pragma once
#include <memory>
#include <set>
#include <vector>

#include "adapt/bulk.hpp"
#include "adapt/front.hpp"
#include "adapt/options.hpp"
#include "adapt/split_mesh.hpp"
#include "mesh/splitting/refine.hpp"

namespace ixos {

/// The numbers of a state by which cells are split.
struct Signs {
  std::vector<Front> fronts{};         ///< of all surfaces, in one state or several
  std::unique_ptr<BulkStrain> bulk{};  ///< null: the bulk asks for nothing
};

/// Returns the leaves with a face that is too coarse, by their numbers in the tree: they have fewer halvings than
/// allowed, and the traction changes by more than its bound.
std::set<int> coarse_leaves(const SplitMesh& mesh, const Signs& signs, const AdaptOptions& options);

/// Returns the splits that the state asks for, from the unsplit cells on: cells are split while a change is above its
/// bound, that of a face above (1 + AdaptOptions::keep)/2 of it, those that are split already while it is above
/// AdaptOptions::keep times the bound, and those in the regions, and around all of these as split() does. `keep_all`:
/// all that is split stays split. Throws InputError as refine().
CellSplits wished_splits(const SplitMesh& mesh, const Signs& signs, const AdaptOptions& options,
                         const std::vector<NamedRegion>& regions, bool keep_all);

}  // namespace ixos
