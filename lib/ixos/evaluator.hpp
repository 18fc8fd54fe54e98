/// A Model as a Thyra model evaluator, for the integrators of other libraries.
///
/// Stable: SemiDiscreteEvaluator, NodalForce, LinearSolverFactory, problem_size, completed_linear_solver, Extract,
/// klu2_library.
#pragma once
#include "embedding/semi_discrete_balance.hpp"
#include "embedding/semi_discrete_evaluator.hpp"
#include "solve/choice/linear_solver.hpp"
#include "solve/choice/linear_solver_defaults.hpp"
#include "solve/choice/problem_size.hpp"
#include "solve/direct/klu2_repair.hpp"
#include "solve/thyra.hpp"
