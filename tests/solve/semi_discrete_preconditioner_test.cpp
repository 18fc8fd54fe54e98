// W_prec of the semi-discrete model: what it saves, who takes it, and when there is none.
#include <gtest/gtest.h>

#include <Thyra_LinearOpWithSolveFactoryHelpers.hpp>
#include <Thyra_MultiVectorStdOps.hpp>
#include <Tpetra_CrsMatrix.hpp>

#include "base/error.hpp"
#include "solve/semi_discrete_bodies.hpp"

namespace ixos {
namespace {

using Base = Thyra::ModelEvaluatorBase;
using test::belos;
using Example = test::EvaluatorExample;

/// Returns the product of the preconditioner and a wave.
Teuchos::RCP<Thyra::VectorBase<double>> applied(const Model& model, const Thyra::PreconditionerBase<double>& prec) {
  const auto b = test::thyra(test::wave(model, 1, 2)), x = b->clone_v();
  Thyra::apply(*prec.getUnspecifiedPrecOp(), Thyra::NOTRANS, *b, x.ptr());
  return x;
}

/// A ball of more unknowns than a multigrid's coarsest level has.
std::unique_ptr<Simulation> fine_ball() {
  auto ball = std::make_unique<Simulation>(
      test::scene_file("ball.xml", {"Mesh/Disk/Core Divisions=24", "Mesh/Disk/Rings=12"}), test::world());
  EXPECT_GT(ball->model().space().global(), 3000);
  return ball;
}

Base::InArgs<double> lifted(const SemiDiscreteEvaluator& evaluator, const Model& model, double height) {
  const Vector zero(model.space().owned_map());
  auto in = test::arguments(evaluator, test::uniform(model, height, 1), zero, zero, 0);
  in.set_W_x_dot_dot_coeff(4e6);
  in.set_alpha(0.0);
  in.set_beta(1.0);
  return in;
}

TEST(SemiDiscretePreconditionerTest, AFailedStateLeavesThePreconditionerAsItWas) {
  const auto s = fine_ball();
  const Model& model = s->model();
  for (const char* preconditioner : {"Direct", "MueLu"}) {
    const SemiDiscreteEvaluator evaluator(model, test::solvers(model, belos(preconditioner)));
    const auto prec = evaluator.create_W_prec();
    auto out = evaluator.createOutArgs();
    out.set_W_prec(prec);
    evaluator.evalModel(lifted(evaluator, model, 0), out);
    const auto before = applied(model, *prec);
    evaluator.evalModel(lifted(evaluator, model, -100), out);
    EXPECT_EQ(test::relative_distance(*applied(model, *prec), *before), 0) << preconditioner;
  }
}

TEST(SemiDiscretePreconditionerTest, AFailedWMakesItsPreconditionerUnusableUntilTheNextEvaluation) {
  const auto s = fine_ball();
  const Model& model = s->model();
  for (const char* preconditioner : {"Direct", "MueLu"}) {
    const SemiDiscreteEvaluator evaluator(model, test::solvers(model, belos(preconditioner)));
    const auto w = evaluator.create_W_op();
    const auto prec = evaluator.create_W_prec();
    auto out = evaluator.createOutArgs();
    out.set_W_op(w);
    out.set_W_prec(prec);
    evaluator.evalModel(lifted(evaluator, model, 0), out);
    const auto before = applied(model, *prec);
    evaluator.evalModel(lifted(evaluator, model, -100), out);
    // A multigrid reads W itself, a factorisation has its own copy.
    EXPECT_EQ(std::isnan(Thyra::norm_2(*applied(model, *prec))), preconditioner == std::string("MueLu"));
    evaluator.evalModel(lifted(evaluator, model, 0), out);
    EXPECT_LT(test::relative_distance(*applied(model, *prec), *before), 1e-12) << preconditioner;
  }
}

TEST(SemiDiscretePreconditionerTest, WithoutPreconditionerThereIsNoWPrec) {
  Teuchos::ParameterList direct;
  direct.set("Linear Solver Type", "Direct");
  const Example e(2, direct);
  EXPECT_FALSE(e.evaluator.createOutArgs().supports(Base::OUT_ARG_W_prec));
  EXPECT_TRUE(e.evaluator.create_W_prec().is_null());
  const SemiDiscreteEvaluator plain(e.model);
  EXPECT_FALSE(plain.createOutArgs().supports(Base::OUT_ARG_W_prec));
  EXPECT_TRUE(plain.get_W_factory().is_null());
}

TEST(SemiDiscretePreconditionerTest, AMatrixFreeWIsRefusedWithViscosity) {
  const auto s = test::held_block(2, test::number("Viscosity", 0.4));
  EXPECT_FALSE(problem_size(s->model()).asymmetry.empty());
  EXPECT_THROW(test::solvers(s->model(), belos("MueLu", "Matrix-Free")), InputError);
  Teuchos::ParameterList list = belos("None", "Matrix-Free");
  EXPECT_THROW(SemiDiscreteEvaluator(s->model(), std::make_shared<LinearSolverFactory>(list)), InputError);
}

const Thyra::SolveCriteria<double> tight(Thyra::SolveMeasureType(Thyra::SOLVE_MEASURE_NORM_RESIDUAL,
                                                                 Thyra::SOLVE_MEASURE_NORM_RHS),
                                         1e-8);

/// The iterations of GMRES for W x = b, with or without W_prec, and the residual that they leave.
std::pair<int, double> solve(const Model& model, const Teuchos::ParameterList& list, bool preconditioned) {
  const auto factory = test::solvers(model, list);
  const SemiDiscreteEvaluator evaluator(model, factory);
  Teuchos::ParameterList plain = belos("None");
  plain.sublist("Linear Solver Types").sublist("Belos").set("Solver Type", "Pseudo Block GMRES");
  plain.sublist("Linear Solver Types")
      .sublist("Belos")
      .sublist("Solver Types")
      .sublist("Pseudo Block GMRES")
      .set("Num Blocks", 300);
  const auto krylov = test::solvers(model, plain);
  const auto w = evaluator.create_W_op();
  const auto prec = evaluator.create_W_prec();
  auto out = evaluator.createOutArgs();
  out.set_W_op(w);
  if (preconditioned) out.set_W_prec(prec);
  evaluator.evalModel(lifted(evaluator, model, 0), out);
  const auto strategy = krylov->strategy();
  const auto solver = strategy->createOp();
  if (preconditioned)
    Thyra::initializePreconditionedOp<double>(*strategy, w, prec, solver.ptr());
  else
    Thyra::initializeOp<double>(*strategy, w, solver.ptr());
  const auto b = test::thyra(test::wave(model, 1, 2)), x = b->clone_v(), r = b->clone_v();
  Thyra::assign(x.ptr(), 0.0);
  const auto status = Thyra::solve<double>(*solver, Thyra::NOTRANS, *b, x.ptr(), Teuchos::constPtr(tight));
  Thyra::apply(*w, Thyra::NOTRANS, *x, r.ptr());
  return {status.extraParameters->get<int>("Iteration Count"), test::relative_distance(*r, *b)};
}

TEST(SemiDiscretePreconditionerTest, WPrecSavesIterations) {
  const auto s = fine_ball();
  const auto without = solve(s->model(), belos("MueLu"), false);
  for (const auto& [preconditioner, share] : {std::pair{"MueLu", 0.3}, {"Direct", 0.05}, {"Chebyshev", 0.7}}) {
    const auto with = solve(s->model(), belos(preconditioner), true);
    EXPECT_LT(with.second, 1e-7) << preconditioner;
    EXPECT_LT(with.first, share * without.first) << preconditioner;
  }
}

TEST(SemiDiscretePreconditionerTest, SolversAndPreconditionersOutliveTheEvaluatorAndItsFactory) {
  const auto s = test::held_block(2);
  const Model& model = s->model();
  for (const char* preconditioner : {"Direct", "MueLu", "Chebyshev"}) {
    auto evaluator = std::make_unique<SemiDiscreteEvaluator>(model, test::solvers(model, belos(preconditioner)));
    const auto strategy = evaluator->get_W_factory();
    const auto prec = evaluator->create_W_prec();
    const auto w = evaluator->create_W_op();
    auto out = evaluator->createOutArgs();
    out.set_W_op(w);
    out.set_W_prec(prec);
    evaluator->evalModel(lifted(*evaluator, model, 0), out);
    evaluator.reset();
    const auto b = test::thyra(test::wave(model, 1, 2)), x = b->clone_v(), r = b->clone_v();
    const auto solver = strategy->createOp();
    for (const bool given : {true, false}) {
      if (given)
        Thyra::initializePreconditionedOp<double>(*strategy, w, prec, solver.ptr());
      else
        Thyra::initializeOp<double>(*strategy, w, solver.ptr());
      Thyra::assign(x.ptr(), 0.0);
      Thyra::solve<double>(*solver, Thyra::NOTRANS, *b, x.ptr(), Teuchos::constPtr(tight));
      Thyra::apply(*w, Thyra::NOTRANS, *x, r.ptr());
      EXPECT_LT(test::relative_distance(*r, *b), 1e-7) << preconditioner;
    }
  }
}

// NOX hands its factory a W_prec that it evaluates alone, without W_op.
TEST(SemiDiscretePreconditionerTest, ItsOwnFactoryTakesItsWPrec) {
  const Example e(2, belos("Direct"));
  const auto prec = e.evaluator.create_W_prec();
  auto out = e.evaluator.createOutArgs();
  out.set_W_prec(prec);
  e.evaluator.evalModel(e.in, out);
  auto second = e.evaluator.createOutArgs();
  const auto w = e.evaluator.create_W_op();
  second.set_W_op(w);
  e.evaluator.evalModel(e.in, second);
  const auto strategy = e.evaluator.get_W_factory();
  ASSERT_TRUE(strategy->supportsPreconditionerInputType(Thyra::PRECONDITIONER_INPUT_TYPE_AS_OPERATOR));
  const auto solver = strategy->createOp();
  const auto b = test::thyra(test::wave(e.model, 1, 2)), x = b->clone_v(), r = b->clone_v();
  const auto expect_solution = [&](int most) {
    const long before = e.factory->statistics().iterations;
    Thyra::solve<double>(*solver, Thyra::NOTRANS, *b, x.ptr(), Teuchos::constPtr(tight));
    Thyra::apply(*w, Thyra::NOTRANS, *x, r.ptr());
    EXPECT_LT(test::relative_distance(*r, *b), 1e-7);
    EXPECT_LE(e.factory->statistics().iterations - before, most);
  };
  Thyra::initializePreconditionedOp<double>(*strategy, w, prec, solver.ptr());
  expect_solution(2);
  EXPECT_EQ(e.factory->statistics().setups, 0);  // its own one was not needed
  Thyra::initializeOp<double>(*strategy, w, solver.ptr());
  expect_solution(2);
  EXPECT_EQ(e.factory->statistics().setups, 1);
}

}  // namespace
}  // namespace ixos
