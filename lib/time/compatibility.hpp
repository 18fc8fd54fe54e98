/// Checks that a model has what a scheme asks of its terms.
#pragma once
#include <string>

#include "model/model.hpp"
#include "time/table.hpp"

namespace ixos {

/// Returns whether some stage takes the discrete gradient of the elastic energy.
bool needs_discrete_gradient(const Table& table);

/// Returns whether law and element formulation of a material have a discrete gradient.
bool has_discrete_gradient(const Material& material);

/// Returns why Maxwell branches do not go with the rest of the material and with the scheme, and what to use in place;
/// empty if they do.
std::string why_no_branches(const Material& material, const Table& table);

/// Returns why the scheme does not go with interactions of two bodies, and what to use in place; empty if it does.
/// `reacts`: the primary surface takes the reaction.
std::string why_no_pairs(const Table& table, bool reacts = true);

/// Returns why the scheme cannot move rigid bodies; empty if it can. `turning`: one of them turns; `carrying`: one that
/// turns carries nodes.
std::string why_no_bodies(const Table& table, bool turning, bool carrying);

/// Throws InputError, on all ranks, with the block or the interaction, if the scheme needs a discrete gradient or a
/// mean in closed form that the model does not have, or takes no Maxwell branches or rigid bodies that it has. Not
/// collective.
void check_compatible(const Model& model, const Table& table);

}  // namespace ixos
