/// A body from the program's mesh, materials, interactions, conditions and loads, and what it answers.
///
/// A Model has neither a state nor a time integrator. Give it to an Integrator (ixos/integrator.hpp) or to a
/// SemiDiscreteEvaluator (ixos/evaluator.hpp). A StateReport tells energies, forces and gaps of one of its states. A
/// DofExchange carries vectors between the program's map and the model's.
///
/// Stable: Model, Material, Formulation, Inertia, Part, StateReport, Momenta, InteractionReport, InteractionGroup,
/// SurfaceNumber, CellFields, Comm, Map, Vector, MultiVector, GlobalId, LocalId, DofSpace, DofExchange, Settings,
/// make_elastic_law, make_gap_law, make_obstacle, flat_wall, HalfSpace, SurfaceInteraction, Friction, FrictionType,
/// add_interaction, prescribe, hold_in_plane, add_traction, add_point_force, add_body_force, add_gravity, grip_rigidly,
/// grip_elastically, grip_reaction, RigidMotion, Constraints, Loads, TimeFunction, TimeValue, function_of_time,
/// constant, value_ramp, rate_ramp, RampShape, sine, interpolated, TableInterpolation, Waveform, check_over,
/// set_reactions, set_reaction.
#pragma once
#include "base/tpetra.hpp"
#include "discretization/dof_exchange.hpp"
#include "discretization/dof_space.hpp"
#include "histories/rigid_motion.hpp"
#include "histories/time_function.hpp"
#include "histories/waveform.hpp"
#include "interaction/catalogue.hpp"
#include "interaction/gap_law.hpp"
#include "interaction/half_space.hpp"
#include "interaction/obstacle.hpp"
#include "material/catalogue.hpp"
#include "material/elastic_law.hpp"
#include "model/conditions.hpp"
#include "model/grips.hpp"
#include "model/interaction_group.hpp"
#include "model/material.hpp"
#include "model/model.hpp"
#include "model/set_reactions.hpp"
#include "model/state_report.hpp"
#include "model/surface_interaction.hpp"
#include "parameters/settings.hpp"
#include "rule/rule.hpp"
#include "term/body/elastic_term.hpp"
#include "term/body/mass.hpp"
#include "term/force_term.hpp"
#include "term/interaction.hpp"
#include "term/support/constraints.hpp"
#include "term/support/loads.hpp"
