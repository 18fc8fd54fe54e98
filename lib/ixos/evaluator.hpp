/// A Model as a Thyra model evaluator, for the integrators of other libraries.
///
/// Stable: SemiDiscreteEvaluator, LinearSolverFactory, Extract, klu2_library.
#pragma once
#include "solve/klu2_repair.hpp"
#include "solve/linear_solver.hpp"
#include "solve/semi_discrete_evaluator.hpp"
#include "solve/thyra.hpp"
