/// Time integration of a Model, step by step.
///
/// The functions that are named after schemes make their tables; default_linear_solver() chooses the solver of their
/// stages.
///
/// Stable: Integrator, StepResult, State, Table, newmark, bathe_composite, gautam_sauer_composite,
/// average_vector_field, generalized_alpha, hht_alpha, midpoint, energy_momentum, central_difference,
/// static_equilibrium, NewtonOptions, LinearSolverFactory, default_linear_solver, StepControl,
/// StepControlOptions, AdaptiveOptions, StepJudgement, judge_step.
#pragma once
#include "solve/choice/linear_solver.hpp"
#include "solve/newton/newton.hpp"
#include "state/state.hpp"
#include "time/default_linear_solver.hpp"
#include "time/integrator.hpp"
#include "time/schemes.hpp"
#include "time/step_control.hpp"
#include "time/step_judge.hpp"
#include "time/table.hpp"
