/// A body from the program's mesh, materials, interactions, conditions and loads, and what it answers.
///
/// A Model has no time integrator. It evaluates energies, forces, gaps and reports at a displacement. Give it to an
/// Integrator (ixos/integrator.hpp) or to a SemiDiscreteEvaluator (ixos/evaluator.hpp). A DofExchange carries vectors
/// between the program's map and the model's.
///
/// Stable: Model, Material, Formulation, Inertia, Part, Momenta, InteractionReport, InteractionGroup, CellFields, Comm,
/// Map, Vector, MultiVector, GlobalId, LocalId, DofSpace, DofExchange, Settings, make_elastic_law, make_gap_law,
/// make_obstacle, flat_wall, HalfSpace, SurfaceInteraction, Friction, FrictionType, add_interaction, prescribe,
/// add_traction, add_point_force, add_body_force, add_gravity, grip_rigidly, grip_elastically, grip_reaction,
/// RigidMotion, Constraints, Loads, TimeFunction, TimeValue, function_of_time, constant, value_ramp, rate_ramp,
/// RampShape, sine, interpolated, TableInterpolation, Waveform, check_over, set_reactions, set_reaction.
#pragma once
#include "base/tpetra.hpp"
#include "discretization/dof_exchange.hpp"
#include "discretization/dof_space.hpp"
#include "fem/rule.hpp"
#include "histories/rigid_motion.hpp"
#include "histories/time_function.hpp"
#include "histories/waveform.hpp"
#include "interaction/catalogue.hpp"
#include "interaction/half_space.hpp"
#include "interaction/obstacle.hpp"
#include "material/catalogue.hpp"
#include "model/conditions.hpp"
#include "model/constraints.hpp"
#include "model/grips.hpp"
#include "model/interaction_group.hpp"
#include "model/loads.hpp"
#include "model/mass.hpp"
#include "model/material.hpp"
#include "model/model.hpp"
#include "model/set_reactions.hpp"
#include "model/surface_interaction.hpp"
#include "parameters/settings.hpp"
#include "term/elastic_term.hpp"
#include "term/force_term.hpp"
#include "term/interaction.hpp"
