// MueLu on the ball's tangent, and the life of a preconditioner.
#include <gtest/gtest.h>

#include <Thyra_LinearOpWithSolveFactoryHelpers.hpp>
#include <Thyra_MultiVectorStdOps.hpp>
#include <Thyra_VectorStdOps.hpp>
#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Vector.hpp>
#include <algorithm>
#include <cmath>

#include "model/term_sums.hpp"
#include "scene/simulation.hpp"
#include "solve/choice/linear_solver.hpp"
#include "solve/choice/linear_solver_defaults.hpp"
#include "solve/direct/factorization.hpp"
#include "solve/iterative/rigid_body_modes.hpp"
#include "solve/kept_state.hpp"
#include "solve/thyra.hpp"
#include "support/bodies.hpp"
#include "support/scene_text.hpp"

namespace ixos {
namespace {

using test::world;

/// Elastic tangent at rest plus `mass` M, of the model's sparsity.
Teuchos::RCP<CrsMatrix> tangent(const Model& model, double mass) {
  const auto w = model.pattern().create_matrix(model.space());
  const std::vector<double> rest(static_cast<std::size_t>(model.space().local()), 0.0);
  double* values = w->getLocalMatrixHost().values.data();
  TermSums(model).add_tangent(Part::Elastic, {nullptr, nullptr, rest.data()}, end_rule(), Tangent::Exact, values);
  model.mass()->add_to(mass, values);
  return w;
}

void copy_values(const CrsMatrix& from, CrsMatrix& to) {
  const auto source = from.getLocalMatrixHost();
  std::copy_n(source.values.data(), source.nnz(), to.getLocalMatrixHost().values.data());
}

Teuchos::ParameterList multigrid(const Model& model) {
  Teuchos::ParameterList list;
  list.set("Linear Solver Type", "Belos");
  return completed_linear_solver(list,
                                 {model.mesh().dimension, model.space().global(), model.space().comm()->getSize()});
}

long iterations(const Model& model, double mass) {
  const auto w = tangent(model, mass);
  const LinearSolverFactory factory(multigrid(model), &model);
  LinearSystem system(factory, w);
  Vector b(w->getRowMap()), x(w->getRowMap()), r(w->getRowMap());
  const LocalMesh& mesh = model.mesh();
  {
    const auto view = b.getLocalViewHost(Tpetra::Access::OverwriteAll);
    for (std::size_t i = 0; i < view.extent(0); ++i) view(i, 0) = std::sin(3.1 * mesh.coordinates[i]);
  }
  EXPECT_TRUE(system.solve(b, x));
  w->apply(x, r);
  r.update(1.0, b, -1.0);
  EXPECT_LT(r.norm2(), 1e-11 * b.norm2());
  return factory.statistics().iterations;
}

TEST(MultigridTest, IterationsOnTwoRanksAreThoseOfOneAndDoNotFollowTheMesh) {
  const auto scene = test::scene_file("ball.xml", {"Mesh/Disk/Core Divisions=64", "Mesh/Disk/Rings=24"});
  Simulation coarse(test::scene_file("ball.xml", {"Mesh/Disk/Core Divisions=32", "Mesh/Disk/Rings=12"}), test::self());
  Simulation whole(scene, world()), alone(scene, test::self());
  ASSERT_GT(alone.model().space().global(), 20000);
  // The ball's own inertia at dt = 0.001 (Newmark), and a hundredth of it, where elasticity rules.
  for (double dt : {0.001, 0.1}) {
    const long one = iterations(alone.model(), 4 / (dt * dt));
    const long many = iterations(whole.model(), 4 / (dt * dt));
    EXPECT_LE(std::abs(static_cast<double>(many - one)), 0.3 * static_cast<double>(one)) << one << " and " << many;
    // Without a preconditioner they would double.
    if (dt == 0.1) {
      EXPECT_LT(static_cast<double>(one), 1.5 * static_cast<double>(iterations(coarse.model(), 4 / (dt * dt))));
    }
  }
}

// Aggregates do not join bodies that are not connected. On each aggregate, the motions of the whole mesh span those of
// its body, wherever the centre of the rotations is.
TEST(MultigridTest, BodiesApartTakeTheIterationsOfOne) {
  const auto scene = [](const std::vector<double>& places) {
    std::string parts, materials;
    for (const double x : places) {
      const std::string name = "p" + std::to_string(materials.size());
      parts +=
          test::list(name, test::word("Type", "Box") +
                               test::list("Box", test::count("Dimension", 3) + test::numbers("Lengths", {2, 1, 1}) +
                                                     test::counts("Divisions", {12, 6, 6})) +
                               test::numbers("Translation", {x, 0, 0}));
      materials += test::list(name, test::word("Block", name + "_body") + test::number("Density", 1));
    }
    return test::scene(test::list("Mesh", test::word("Type", "Parts") + test::list("Parts", parts)) +
                       test::list("Materials", materials) + test::time_integrator("Newmark", 1, 1));
  };
  Simulation one(scene({0}), world()), near(scene({0, 3}), world()), far(scene({0, 1000}), world());
  for (const double dt : {0.1, 10.0}) {  // inertia rules; elasticity does
    const long alone = iterations(one.model(), 4 / (dt * dt));
    EXPECT_GT(alone, 3);
    EXPECT_LE(iterations(near.model(), 4 / (dt * dt)), alone + 2);
    EXPECT_LE(iterations(far.model(), 4 / (dt * dt)), alone + 2);
  }
}

TEST(MultigridTest, RigidBodyModesCarryNoElasticForce) {
  for (const std::string& body : {test::block_2d(0), test::block_3d(0)}) {
    Simulation s(test::scene(body + test::time_integrator("Newmark", 0.1, 1)), world());
    const auto k = tangent(s.model(), 0);
    const auto modes = rigid_body_modes(s.model());
    MultiVector force(k->getRowMap(), modes->getNumVectors());
    k->apply(*modes, force);
    std::vector<double> norms(modes->getNumVectors());
    force.norm2(Teuchos::ArrayView<double>(norms.data(), static_cast<int>(norms.size())));
    for (double norm : norms) EXPECT_LT(norm, 1e-13);
    modes->norm2(Teuchos::ArrayView<double>(norms.data(), static_cast<int>(norms.size())));
    for (double norm : norms) EXPECT_GT(norm, 0.1);
  }
}

TEST(LaggedSolverTest, APreconditionerOutlivesItsMatrixWhileThatPays) {
  Simulation s(test::scene(test::block_2d(0) + test::time_integrator("Newmark", 0.1, 1)), world());
  const auto w = tangent(s.model(), 10);
  Teuchos::ParameterList list = multigrid(s.model());
  list.set("Preconditioner Type", "Ifpack2");
  list.sublist("Linear Solver Types").sublist("Belos").set("Solver Type", "Block GMRES");
  Vector b(w->getRowMap()), x(w->getRowMap());
  b.putScalar(1.0);
  const auto setups = [&](double cost) {
    list.sublist("Reuse").set("Setup Cost", cost);
    const LinearSolverFactory factory(list, &s.model());
    LinearSystem system(factory, w);
    for (int k = 0; k < 10; ++k) {
      EXPECT_TRUE(system.solve(b, x));
      system.refresh();  // the same values: as good a preconditioner as on the first day
    }
    return factory.statistics().setups;
  };
  EXPECT_EQ(setups(20), 1);
  // An excess of 0 iterations is not more than a cost of 0: the same values never ask for a new one.
  EXPECT_EQ(setups(0), 1);
}

TEST(LaggedSolverTest, IterationsCompareWithinAFamily) {
  // Two matrices take turns with one factorisation: the other one's iterations are no sign of its age.
  Simulation s(test::scene(test::block_2d(0) + test::time_integrator("Newmark", 0.1, 1)), world());
  const auto w = tangent(s.model(), 1), even = tangent(s.model(), 1), odd = tangent(s.model(), 2);
  Teuchos::ParameterList list = multigrid(s.model());
  list.set("Preconditioner Type", "Direct");
  list.sublist("Preconditioner Types").sublist("Direct").set("Solver Type", first_rank_factorization());
  list.sublist("Reuse").set("Setup Cost", 5.0);
  const auto setups = [&](int families) {
    const LinearSolverFactory factory(list, &s.model());
    const auto strategy = factory.strategy();
    const auto space = vector_space(w->getRowMap());
    const Teuchos::RCP<const Thyra::LinearOpBase<double>> op = const_linear_op(w, space);
    const auto solver = strategy->createOp();
    const auto b = Thyra::createMember(space), x = Thyra::createMember(space);
    Thyra::assign(b.ptr(), 1.0);
    const Thyra::SolveCriteria<double> criteria(
        Thyra::SolveMeasureType(Thyra::SOLVE_MEASURE_NORM_RESIDUAL, Thyra::SOLVE_MEASURE_NORM_RHS), 1e-10);
    for (int k = 0; k < 20; ++k) {
      copy_values(k % 2 == 0 ? *even : *odd, *w);
      dynamic_cast<const StateKeeper&>(*strategy).choose_family(k % families);
      Thyra::initializeOp<double>(*strategy, op, solver.ptr());
      Thyra::assign(x.ptr(), 0.0);
      EXPECT_EQ(Thyra::solve<double>(*solver, Thyra::NOTRANS, *b, x.ptr(), Teuchos::constPtr(criteria)).solveStatus,
                Thyra::SOLVE_STATUS_CONVERGED);
    }
    return factory.statistics().setups;
  };
  EXPECT_EQ(setups(2), 1);
  EXPECT_GT(setups(1), 1);
}

TEST(LaggedSolverTest, APreconditionerThatCostsTooManyIterationsIsRenewed) {
  Simulation s(test::scene(test::block_2d(0) + test::time_integrator("Newmark", 0.1, 1)), world());
  const auto w = tangent(s.model(), 10);
  Teuchos::ParameterList list = multigrid(s.model());
  list.set("Preconditioner Type", "Ifpack2");
  list.sublist("Linear Solver Types").sublist("Belos").set("Solver Type", "Block GMRES");
  list.sublist("Reuse").set("Setup Cost", 5.0);
  const LinearSolverFactory factory(list, &s.model());
  LinearSystem system(factory, w);
  Vector b(w->getRowMap()), x(w->getRowMap());
  b.putScalar(1.0);
  EXPECT_TRUE(system.solve(b, x));
  // Another matrix altogether: the old preconditioner is far off, until the excess has paid for a new one.
  const auto other = tangent(s.model(), 0.3);
  copy_values(*other, *w);
  for (int k = 0; k < 20; ++k) {
    system.refresh();
    EXPECT_TRUE(system.solve(b, x));
  }
  EXPECT_GE(factory.statistics().setups, 2);
}

TEST(LaggedSolverTest, AnIterationThatDoesNotConvergeIsAFailedSolve) {
  Simulation s(test::scene(test::block_2d(0) + test::time_integrator("Newmark", 0.1, 1)), world());
  const auto w = tangent(s.model(), 10);
  Teuchos::ParameterList list = multigrid(s.model());
  list.set("Preconditioner Type", "Ifpack2");
  list.sublist("Preconditioner Types").sublist("Ifpack2").set("Prec Type", "DIAGONAL");
  list.sublist("Linear Solver Types")
      .sublist("Belos")
      .sublist("Solver Types")
      .sublist("Pseudo Block CG")
      .set("Maximum Iterations", 2);
  const LinearSolverFactory factory(list, &s.model());
  LinearSystem system(factory, w);
  Vector b(w->getRowMap()), x(w->getRowMap());
  b.randomize();
  EXPECT_FALSE(system.solve(b, x));
}

TEST(LinearSolverDefaultsSerialTest, SizeDimensionAndRanksChoose) {
  const auto choice = [](int dimension, long long dofs, int ranks) {
    const auto list = completed_linear_solver({}, {dimension, dofs, ranks});
    return list.get<std::string>("Linear Solver Type") + " " + list.get<std::string>("Preconditioner Type");
  };
  EXPECT_EQ(choice(2, 100, 1), "Direct None");
  EXPECT_EQ(choice(2, 2001, 1), "Belos Direct");
  EXPECT_EQ(choice(2, 300001, 1), "Belos MueLu");
  EXPECT_EQ(choice(3, 30000, 1), "Belos Direct");
  EXPECT_EQ(choice(3, 30001, 1), "Belos MueLu");
  EXPECT_EQ(choice(2, 50001, 2), "Belos MueLu");
  EXPECT_EQ(choice(3, 5000, 2), "Belos Direct");
}

TEST(LinearSolverDefaultsSerialTest, ShortStepsNeedNoMatrixInThreeDimensions) {
  const auto choice = [](ProblemSize size, double stiffness) {
    size.stiffness = stiffness;
    const auto list = completed_linear_solver({}, size);
    return list.get<std::string>("Preconditioner Type") + " " + list.get<std::string>("Operator");
  };
  EXPECT_EQ(choice({3, 30000, 1}, 250), "Chebyshev Matrix-Free");
  EXPECT_EQ(choice({3, 30000, 1}, 251), "Direct Assembled");
  EXPECT_EQ(choice({3, 3000000, 4}, 1), "Chebyshev Matrix-Free");
  EXPECT_EQ(choice({3, 2000, 1}, 1), "None Assembled");
  EXPECT_EQ(choice({2, 30000, 1}, 1), "Direct Assembled");
  EXPECT_EQ(choice({3, 3000, 1, "a scheme"}, 1), "Direct Assembled") << "unsymmetric";
  EXPECT_EQ(choice({3, 3000, 1, "", "a material"}, 1), "Direct Assembled") << "enhanced elements";
}

TEST(LinearSolverDefaultsSerialTest, SmallCompactBodiesHaveTwoLevels) {
  enum class Cells { Quadratic, WithParents, Linear };
  const auto choice = [](long long dofs, double width, int ranks = 1, Cells cells = Cells::Quadratic,
                         double stiffness = 1e300, double aspect = 1) {
    ProblemSize size{3, dofs, ranks};
    size.width = width;
    size.quadratic = cells == Cells::Quadratic;
    size.refined = cells == Cells::WithParents;
    size.stiffness = stiffness;
    size.aspect = aspect;
    const auto list = completed_linear_solver({}, size);
    return list.get<std::string>("Preconditioner Type") + " " + list.get<std::string>("Operator");
  };
  // A cube of 8^3 cells has 17^3 nodes, and 9 levels of nodes from a corner; a beam of 2 x 2 x 64 has 65.
  EXPECT_EQ(choice(14739, 546), "Two-Level Matrix-Free");
  EXPECT_EQ(choice(9675, 3225 / 65.0), "Direct Assembled");
  // Levels of linear cells have one layer of nodes: 16^3 cells, 44 x 12 x 12 and 88 x 10 x 10.
  EXPECT_EQ(choice(14739, 289, 1, Cells::WithParents), "Two-Level Matrix-Free");
  EXPECT_EQ(choice(22815, 169, 1, Cells::WithParents), "Two-Level Matrix-Free");
  EXPECT_EQ(choice(32307, 121, 1, Cells::WithParents), "Direct Matrix-Free");
  EXPECT_EQ(choice(9675, 3225 / 65.0, 1, Cells::WithParents), "Direct Assembled");
  EXPECT_EQ(choice(5000, 300, 1, Cells::WithParents), "Two-Level Matrix-Free");
  EXPECT_EQ(choice(4999, 300, 1, Cells::WithParents), "Direct Assembled");
  EXPECT_EQ(choice(14739, 289, 1, Cells::WithParents, 1e300, 10), "Direct Assembled") << "long cells";
  EXPECT_TRUE(may_use_coarse_cells({}, 3, 5000, 1));
  EXPECT_FALSE(may_use_coarse_cells({}, 3, 4999, 1));
  EXPECT_EQ(choice(14739, 289, 1, Cells::Linear), "Direct Assembled");
  EXPECT_EQ(choice(4800, 300, 2), "Direct Assembled") << "two ranks";
  EXPECT_EQ(choice(2000, 90), "None Assembled");
  EXPECT_EQ(choice(14739, 546, 1, Cells::Quadratic, 200), "Chebyshev Matrix-Free") << "short steps";
  ProblemSize size{3, 14739, 1};
  size.quadratic = true;
  Teuchos::ParameterList assembled;
  assembled.set("Operator", "Assembled");
  EXPECT_EQ(completed_linear_solver(assembled, size).get<std::string>("Preconditioner Type"), "Direct");
}

TEST(LinearSolverDefaultsSerialTest, NarrowBandsAreFactorisedForEachTangent) {
  const auto choice = [](int dimension, long long dofs, double width, double stiffness = 1e300, int ranks = 1,
                         const std::string& asymmetry = "") {
    ProblemSize size{dimension, dofs, ranks, asymmetry};
    size.width = width;
    size.stiffness = stiffness;
    const std::string words = linear_solver_in_words(completed_linear_solver({}, size));
    return words.substr(0, words.rfind(','));
  };
  const std::string cg = "Belos (Pseudo Block CG), preconditioner ";
  EXPECT_EQ(choice(2, 2000, 1e300), "Direct (Band)");
  EXPECT_EQ(choice(2, 50000, 40), "Direct (Band)");
  EXPECT_EQ(choice(2, 50000, 41), cg + "Direct (" + first_rank_factorization() + ")");
  EXPECT_EQ(choice(2, 50000, 40, 1e300, 2), "Direct (Band)") << "two ranks";
  const std::string gmres = "Belos (Pseudo Block GMRES), preconditioner ";
  EXPECT_EQ(choice(2, 50000, 40, 1e300, 1, "a scheme"), "Direct (Band LU)");
  EXPECT_EQ(choice(2, 50000, 40, 1e300, 2, "a scheme"), "Direct (Band LU)") << "two ranks";
  EXPECT_EQ(choice(2, 50000, 41, 1e300, 1, "a scheme"), gmres + "Direct (KLU)");
  EXPECT_EQ(choice(3, 30000, 60, 1e300, 1, "a scheme"), gmres + "Direct (Band LU)");
  EXPECT_EQ(choice(3, 30000, 25), "Direct (Band)");
  EXPECT_EQ(choice(3, 30000, 26), cg + "Direct (Band)");
  EXPECT_EQ(choice(3, 30000, 60), cg + "Direct (Band)");
  EXPECT_EQ(choice(3, 30000, 61), cg + "Direct (MUMPS Single)");
  EXPECT_EQ(choice(3, 2000, 1e300), "Direct (Band)");
  Teuchos::ParameterList matrix_free;
  matrix_free.set("Operator", "Matrix-Free");
  ProblemSize slender{2, 50000, 1};
  slender.width = 10;
  EXPECT_EQ(completed_linear_solver(matrix_free, slender).get<std::string>("Linear Solver Type"), "Belos");
  EXPECT_EQ(choice(3, 3000, 25, 200), cg + "Chebyshev") << "short steps";
}

TEST(LaggedSolverTest, AKeptFactorizationSolvesItsOwnMatrixInOneIteration) {
  Simulation s(test::scene(test::block_2d(0) + test::time_integrator("Newmark", 0.1, 1)), world());
  const auto w = tangent(s.model(), 10);
  Teuchos::ParameterList list;
  list.set("Linear Solver Type", "Belos").set("Preconditioner Type", "Direct");
  const LinearSolverFactory factory(completed_linear_solver(list, {2, 100, 1}), &s.model());
  LinearSystem system(factory, w);
  Vector b(w->getRowMap()), x(w->getRowMap()), r(w->getRowMap());
  b.randomize();
  EXPECT_TRUE(system.solve(b, x));
  EXPECT_LE(factory.statistics().iterations, 2);
  // A matrix 2 per cent off takes a few; its solution is as exact.
  const auto other = tangent(s.model(), 10.2);
  copy_values(*other, *w);
  system.refresh();
  EXPECT_TRUE(system.solve(b, x));
  w->apply(x, r);
  r.update(1.0, b, -1.0);
  EXPECT_LT(r.norm2(), 1e-11 * b.norm2());
  EXPECT_GT(factory.statistics().iterations, 2);
  EXPECT_EQ(factory.statistics().setups, 1);
}

// CG refuses indefinite matrices. The solver then uses the factorisation itself.
TEST(LaggedSolverTest, AFactorizationSolvesAnIndefiniteMatrix) {
  Simulation s(test::scene(test::block_2d(0) + test::time_integrator("Newmark", 0.1, 1)), world());
  for (const char* type : {"MUMPS Single", "KLU", "Band LU"}) {
    Teuchos::ParameterList list;
    list.set("Linear Solver Type", "Belos").set("Preconditioner Type", "Direct");
    list.sublist("Preconditioner Types").sublist("Direct").set("Solver Type", type);
    const LinearSolverFactory factory(completed_linear_solver(list, {2, 100, 1}), &s.model());
    const auto w = tangent(s.model(), 10);
    LinearSystem system(factory, w);
    Vector b(w->getRowMap()), x(w->getRowMap()), r(w->getRowMap()), least(w->getRowMap());
    least.randomize();
    EXPECT_TRUE(system.solve(least, x));
    copy_values(*tangent(s.model(), -0.05), *w);  // K - 0.05 M
    w->apply(x, r);
    // Its quadratic form has both signs.
    Vector rough(w->getRowMap());
    rough.randomize();
    w->apply(rough, r);
    EXPECT_GT(rough.dot(r), 0) << type;
    Vector uniform(w->getRowMap());
    uniform.putScalar(1.0);
    w->apply(uniform, r);
    EXPECT_LT(uniform.dot(r), 0) << type;
    b.putScalar(1.0);
    bool solved = false;
    for (int attempt = 0; attempt < 2 && !solved; ++attempt) {  // the first may only find that it is indefinite
      system.refresh();
      try {
        solved = system.solve(b, x);
      } catch (const std::runtime_error&) {
      }
    }
    EXPECT_TRUE(solved) << type;
    w->apply(x, r);
    r.update(1.0, b, -1.0);
    EXPECT_LT(r.norm2(), 1e-11 * b.norm2()) << type;
  }
}

}  // namespace
}  // namespace ixos
