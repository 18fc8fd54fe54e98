/// Checks that a model has what a scheme asks of its terms.
#pragma once
#include "model/model.hpp"
#include "time/table.hpp"

namespace ixos {

/// Returns whether some stage takes the discrete gradient of the elastic energy.
bool needs_discrete_gradient(const Table& table);

/// Returns whether law and element formulation of a material have a discrete gradient.
bool has_discrete_gradient(const Material& material);

/// Returns whether some stage takes the exact mean of the term, as a gradient, and the term has no potential of it.
/// Before a curved obstacle the exact mean is no gradient, so nothing asks for its potential. Equal on all ranks.
bool lacks_potential(const ForceTerm& term, const Table& table);

/// Throws InputError, on all ranks, with the block or the interaction, if the scheme needs a discrete gradient or a
/// potential that the model does not have. Not collective.
void check_compatible(const Model& model, const Table& table);

}  // namespace ixos
