/// A Model as a Thyra model evaluator, for the integrators of other libraries.
///
/// Stable: SemiDiscreteEvaluator, NodalForce, LinearSolverFactory, problem_size, completed_linear_solver, Extract,
/// klu2_library.
#pragma once
#include "solve/klu2_repair.hpp"
#include "solve/linear_solver.hpp"
#include "solve/linear_solver_defaults.hpp"
#include "solve/problem_size.hpp"
#include "solve/semi_discrete_balance.hpp"
#include "solve/semi_discrete_evaluator.hpp"
#include "solve/thyra.hpp"
