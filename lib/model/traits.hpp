/// Questions about a model: has it friction, histories, moved obstacles?
#pragma once
#include <string>

#include "model/model.hpp"

namespace ixos {

/// Returns whether the forces of all terms of that part are gradients for the rule, so that its tangent is symmetric.
bool is_gradient(const Model& model, Part part, const Rule& rule);
bool rates_are_gradients(const Model& model, RateForm form);

/// Returns whether some interaction has an obstacle that is moved. Equal on all ranks.
bool has_moved_obstacles(const Model& model);
/// Returns whether all obstacles have a place and a velocity at `time`. Equal on all ranks.
bool obstacles_are_finite(const Model& model, double time);
/// Returns whether some interaction's law is defined at every gap. Equal on all ranks.
bool has_laws_of_every_gap(const Model& model);
/// Returns whether some interaction has friction, whose force has kinks.
bool has_friction(const Model& model);
bool has_friction(const Model& model, const std::string& interaction);
/// Returns whether the interaction of that name has such a number. Equal on all ranks.
bool has(const Model& model, const std::string& interaction, SurfaceNumber number);

/// Returns whether some grip or rigid body has springs or dashpots.
bool has_springs(const Model& model);
/// Returns whether some rigid body turns.
bool has_turning_bodies(const Model& model);
/// Returns whether the forces of some term depend on its history. Equal on all ranks.
bool has_histories(const Model& model);
/// Returns whether some block has a viscosity.
bool has_viscosity(const Model& model);
/// Returns the largest viscosity of a block [T0].
double largest_viscosity(const Model& model);
/// Returns whether some block is nearly incompressible at finite strains and its cells can take mixed steps. Enhanced
/// ones cannot: their modes follow the displacement exactly, not the linearisation.
bool has_mixed_steps(const Model& model);
/// Returns whether some block has Maxwell branches.
bool has_viscoelasticity(const Model& model);

}  // namespace ixos
