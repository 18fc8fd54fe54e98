/// The reactions of node sets.
#pragma once
#include <string>
#include <vector>

#include "model/model.hpp"

namespace ixos {

/// Returns sums over node sets, given by their numbers in the mesh: sets x dimension [E0 L0^(D-1)]. `forces` are nodal
/// forces, valid for owned nodes, such as State::reaction; only those at constrained degrees of freedom count,
/// and those across planes that nodes are held in. Leaves
/// out derivative nodes, whose reactions are moments. Collective.
std::vector<double> set_reactions(const Model& model, const std::vector<double>& forces,
                                  const std::vector<std::size_t>& sets);

/// Returns the sums over the set of that name, one for each dimension. Throws InputError if there is no such set.
/// Collective.
std::vector<double> set_reaction(const Model& model, const std::vector<double>& forces, const std::string& set);

/// Throws InputError if there is no such set, or if no displacement of it is prescribed, so that it has no reaction.
/// Collective.
void check_held(const Model& model, const std::string& set);

}  // namespace ixos
