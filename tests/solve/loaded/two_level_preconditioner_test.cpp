// The cycle between quadratic and linear cells, or between linear cells and their coarse cells: its coarse matrix is
// P^T W P, the cycle is symmetric and positive definite, iterations do not follow the mesh, and runs repeat and resume
// with it.
#include "solve/loaded/two_level_preconditioner.hpp"

#include <gtest/gtest.h>

#include <Thyra_MultiVectorStdOps.hpp>
#include <Thyra_VectorStdOps.hpp>
#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Vector.hpp>
#include <cmath>

#include "base/error.hpp"
#include "embedding/semi_discrete_tangent.hpp"
#include "scene/explain/explanation.hpp"
#include "scene/simulation.hpp"
#include "solve/choice/linear_solver.hpp"
#include "solve/choice/linear_solver_defaults.hpp"
#include "solve/choice/problem_size.hpp"
#include "solve/operator_preconditioner.hpp"
#include "support/comparison.hpp"
#include "support/refusal.hpp"
#include "support/scene_text.hpp"
#include "support/silent_interaction.hpp"

namespace ixos {
namespace {

using test::count;
using test::list;
using test::number;
using test::numbers;
using test::word;
using test::world;

std::string box(int dimension, int cells, int order = 2, const std::string& more = "") {
  const std::vector<int> divisions(static_cast<std::size_t>(dimension), cells);
  return list("Mesh", word("Type", "Box") + count("Cell Order", order) +
                          list("Box", count("Dimension", dimension) +
                                          numbers("Lengths", std::vector<double>(divisions.size(), 2.0)) +
                                          test::counts("Divisions", divisions)) +
                          more);
}

std::string solver(const std::string& preconditioner, const std::string& op = "Automatic") {
  return list("Linear Solver",
              word("Linear Solver Type", "Belos") + word("Preconditioner Type", preconditioner) + word("Operator", op));
}

/// A damped block above a wall, held at its left side.
struct Block {
  int dimension = 3;
  int cells = 2;
  std::string material{};
  std::string wall{};
  std::string more{};
  int order = 2;
  std::string mesh{};  ///< more of the list "Mesh"

  std::string text() const {
    std::vector<double> below(static_cast<std::size_t>(dimension), 0.0);
    below.back() = -0.3;
    return box(dimension, cells, order, mesh) +
           list("Materials", list("Rubber", number("Density", 0.7) + number("Mass Damping", 0.3) +
                                                number("Stiffness Damping", 0.2) + material)) +
           list("Interactions",
                list("Wall", word("Side Set", "bottom") + (wall.empty() ? numbers("Point", below) : wall))) +
           list("Boundary Conditions", list("Held", word("Node Set", "left"))) + more;
  }
  std::unique_ptr<Simulation> simulation(const Comm& comm = world()) const {
    return std::make_unique<Simulation>(test::scene(text() + test::time_integrator("Newmark", 0.1, 1)), comm);
  }
};

double wave(const double* x, std::size_t d, std::size_t i, double phase) {
  double sum = 0;
  for (std::size_t j = 0; j < d; ++j)
    sum += std::sin((1.3 + static_cast<double>(j)) * x[j] + phase + static_cast<double>(i + j));
  return sum;
}

/// A smooth field of the place, by local degree of freedom.
std::vector<double> local_wave(const LocalMesh& mesh, double amplitude, double phase) {
  const auto d = static_cast<std::size_t>(mesh.dimension);
  std::vector<double> field;
  for (std::size_t k = 0; k < mesh.coordinates.size(); ++k)
    field.push_back(amplitude * wave(&mesh.coordinates[k / d * d], d, k % d, phase));
  return field;
}

Vector owned_wave(const LocalMesh& mesh, const DofSpace& space, double phase) {
  Vector result(space.owned_map());
  const std::vector<double> local = local_wave(mesh, 1, phase);
  const auto view = result.getLocalViewHost(Tpetra::Access::OverwriteAll);
  std::copy_n(local.data(), view.extent(0), view.data());
  return result;
}

/// Compares the coarse matrix with P^T W P, both applied to fields without left-out degrees of freedom.
void expect_galerkin_product_of(const Block& block, double tolerance = 1e-12) {
  const auto s = block.simulation();
  const Model& model = s->model();
  SemiDiscreteOperator w(model);
  const std::vector<double> bent = local_wave(model.mesh(), 0.01, 0);
  w.linearize({1.5, 0.8, 2.0}, {bent.data(), 0.7});
  const CoarseSpace& coarse = w.coarse_space();
  const auto matrix = w.coarse_matrix();
  const auto &fine_map = model.space().owned_map(), &coarse_map = coarse.space().owned_map();
  Vector fine(fine_map), product(fine_map), expected(coarse_map), found(coarse_map);
  for (const double phase : {0.0, 1.0, 2.0}) {
    Vector x = owned_wave(coarse.mesh(), coarse.space(), 5 * phase);
    if (phase == 2) x.randomize();
    {
      const auto view = x.getLocalViewHost(Tpetra::Access::ReadWrite);
      for (const int dof : coarse.left_out())
        if (dof < coarse.space().owned()) view(static_cast<std::size_t>(dof), 0) = 0;
    }
    coarse.prolongate(x, fine);
    w.apply(fine, product);
    coarse.restrict_to_coarse(product, expected);
    matrix->apply(x, found);
    found.update(-1.0, expected, 1.0);
    EXPECT_LT(found.normInf(), tolerance * expected.normInf());
    EXPECT_GT(expected.normInf(), 1e-3);
  }
  Vector diagonal(coarse.space().owned_map());
  matrix->getLocalDiagCopy(diagonal);
  const auto view = diagonal.getLocalViewHost(Tpetra::Access::ReadOnly);
  for (const int dof : coarse.left_out())
    if (dof < coarse.space().owned()) {
      EXPECT_EQ(view(static_cast<std::size_t>(dof), 0), 2.0);
    }
}

/// Does so for quadratic cells and for linear ones.
void expect_galerkin_product(Block block) {
  block.more += solver("Two-Level");
  expect_galerkin_product_of(block);
  block.order = 1;
  block.cells *= 2;
  expect_galerkin_product_of(block);
}

TEST(CoarseMatrixTest, IsTheGalerkinProductOfElasticityMassAndWall) {
  for (const int dimension : {2, 3}) {
    expect_galerkin_product({dimension});
    expect_galerkin_product({dimension, 2, word("Model", "Linear Elastic")});
    expect_galerkin_product({dimension, 2, word("Model", "Mooney-Rivlin")});
  }
}

TEST(CoarseMatrixTest, IsTheGalerkinProductWithContactSidesOfFourthOrder) {
  for (const int dimension : {2, 3}) {
    std::vector<double> below(static_cast<std::size_t>(dimension), 0.0);
    below.back() = -0.3;
    const std::string wall = word("Contact Element", "Q2C4") + numbers("Point", below);
    expect_galerkin_product_of({dimension, 2, "", wall, solver("Two-Level")});
  }
}

/// Cells in a corner of the bottom are halved: their corners in the middle of coarser edges and faces follow those.
std::string finer_corner(int dimension) {
  return list("Refine",
              list("Corner", numbers("Upper", std::vector<double>(static_cast<std::size_t>(dimension), 0.9))));
}

TEST(CoarseMatrixTest, IsTheGalerkinProductWhereNodesHang) {
  for (const int dimension : {2, 3}) {
    Block block{dimension, 3, "", "", solver("Two-Level")};
    block.mesh = finer_corner(dimension);
    expect_galerkin_product_of(block);
    // Before a sphere that turns, with dampers.
    std::vector<double> center(static_cast<std::size_t>(dimension), 0.2);
    center.back() = -3.4;
    block.wall = word("Obstacle", "Sphere") + list("Sphere", number("Radius", 3) + numbers("Center", center)) +
                 list("Motion", word("Rotation", "Turn") + (dimension == 3 ? numbers("Axis", {0, 1, 0}) : ""));
    const std::vector<double> some(static_cast<std::size_t>(dimension), 0.7);
    block.more += list("Histories", test::expression("Turn", "0.05*t", "0.05", "0")) +
                  list("Grips", list("Machine", word("Type", "Springs") + word("Node Set", "right") +
                                                    numbers("Stiffness", some) + numbers("Damping", some)));
    expect_galerkin_product_of(block);
  }
}

// The iterations of a mesh with hanging nodes are not many more than those of a mesh without.
TEST(TwoLevelTest, HangingNodesCostFewIterations) {
  const auto iterations = [](const std::string& mesh, int cells) {
    Block block{3, cells, "", "", solver("Two-Level", "Matrix-Free")};
    block.mesh = mesh;
    const auto s = block.simulation();
    const StepResult step = s->integrator().step(0.1);
    EXPECT_TRUE(step.converged);
    return static_cast<double>(step.linear_iterations) / step.newton_iterations;
  };
  EXPECT_LT(iterations(finer_corner(3), 4), 1.3 * iterations("", 4));
}

TEST(CoarseMatrixTest, IsTheGalerkinProductWithBranches) {
  const std::string branches =
      list("Maxwell Branches", numbers("Relaxation Times", {0.05, 2}) + numbers("Moduli", {0.4, 0.2}));
  for (const int dimension : {2, 3}) expect_galerkin_product({dimension, 2, branches});
}

TEST(CoarseMatrixTest, IsTheGalerkinProductBeforeASphereThatTurns) {
  const auto sphere = [](int dimension) {
    std::vector<double> center(static_cast<std::size_t>(dimension), 0.2), axis{0, 1, 0};
    center.back() = -3.4;
    return word("Obstacle", "Sphere") + list("Sphere", number("Radius", 3) + numbers("Center", center)) +
           list("Motion", word("Rotation", "Turn") + (dimension == 3 ? numbers("Axis", axis) : std::string()));
  };
  const std::string turn = list("Histories", test::expression("Turn", "0.05*t", "0.05", "0"));
  for (const int dimension : {2, 3}) expect_galerkin_product({dimension, 2, "", sphere(dimension), turn});
}

TEST(CoarseMatrixTest, IsTheGalerkinProductWithSpringsAndDashpots) {
  const auto grips = [](int dimension) {
    const std::vector<double> some(static_cast<std::size_t>(dimension), 0.7);
    return list("Grips", list("Machine", word("Type", "Springs") + word("Node Set", "right") +
                                             numbers("Stiffness", some) + numbers("Damping", some)));
  };
  for (const int dimension : {2, 3}) expect_galerkin_product({dimension, 2, "", "", grips(dimension)});
}

Teuchos::ParameterList two_level(const std::string& coarse = "Automatic") {
  Teuchos::ParameterList list;
  list.set("Linear Solver Type", "Belos").set("Preconditioner Type", "Two-Level");
  list.sublist("Preconditioner Types").sublist("Two-Level").sublist("Coarse").set("Type", coarse);
  return list;
}

Teuchos::ParameterList completed(const Model& model, const std::string& coarse) {
  ProblemSize size;
  size.dimension = model.mesh().dimension;
  size.dofs = model.space().global();
  size.ranks = model.space().comm()->getSize();
  size.quadratic = true;
  return completed_linear_solver(two_level(coarse), size);
}

TEST(TwoLevelTest, IsSymmetricAndPositiveDefiniteAndAtMostTheInverse) {
  for (const char* type : {"Direct", "MueLu"})
    for (const int dimension : {2, 3}) {
      const auto s = Block{dimension, dimension == 2 ? 6 : 3}.simulation();
      const Model& model = s->model();
      const auto w = Teuchos::rcp(new SemiDiscreteOperator(model));
      const std::vector<double> rest(static_cast<std::size_t>(model.space().local()), 0.0);
      w->linearize({0.1, 0, 1}, {rest.data()});
      const LinearSolverFactory factory(completed(model, type), &model);
      const auto preconditioner = factory.preconditioner();
      const auto space = vector_space(model.space().owned_map());
      const auto op = linear_op(w, space);
      preconditioner->compute(op);
      const auto b = preconditioner->getUnspecifiedPrecOp();
      const auto x = Thyra::createMember(space), y = Thyra::createMember(space), wx = Thyra::createMember(space),
                 wy = Thyra::createMember(space), bwx = Thyra::createMember(space), bwy = Thyra::createMember(space);
      Thyra::seed_randomize<double>(5);
      for (int k = 0; k < 5; ++k) {
        Thyra::randomize(-1.0, 1.0, x.ptr());
        Thyra::randomize(-1.0, 1.0, y.ptr());
        Thyra::apply(*op, Thyra::NOTRANS, *x, wx.ptr());
        Thyra::apply(*op, Thyra::NOTRANS, *y, wy.ptr());
        Thyra::apply(*b, Thyra::NOTRANS, *wx, bwx.ptr());
        Thyra::apply(*b, Thyra::NOTRANS, *wy, bwy.ptr());
        const double energy = Thyra::dot(*x, *wx), cycle = Thyra::dot(*bwx, *wx);
        EXPECT_NEAR(Thyra::dot(*bwx, *wy), Thyra::dot(*wx, *bwy), 1e-5 * energy) << type << dimension;
        EXPECT_GT(cycle, 0.3 * energy) << type << dimension;
        EXPECT_LT(cycle, 1.01 * energy) << type << dimension;
      }
    }
}

/// Returns the iterations of CG from the elastic tangent at rest, held at one side.
long iterations(int dimension, int cells, const std::string& coarse, const Comm& comm = world(), int order = 2) {
  Block block{dimension, cells};
  block.order = order;
  block.more = solver("Two-Level");
  const auto s = block.simulation(comm);
  const Model& model = s->model();
  const auto w = Teuchos::rcp(new SemiDiscreteOperator(model));
  const std::vector<double> rest(static_cast<std::size_t>(model.space().local()), 0.0);
  w->linearize({0, 0, 1}, {rest.data()});
  const LinearSolverFactory factory(completed(model, coarse), &model);
  LinearSystem system(factory, w);
  const Vector b = owned_wave(model.mesh(), model.space(), 1);
  Vector x(b.getMap()), r(b, Teuchos::Copy);
  EXPECT_TRUE(system.solve(b, x)) << cells << " cells, " << coarse;
  w->apply(x, r, Teuchos::NO_TRANS, -1.0, 1.0);
  EXPECT_LT(r.norm2(), 1e-11 * b.norm2());
  return factory.statistics().iterations;
}

// LinearSystem solves to 1e-12.
TEST(TwoLevelTest, IterationsDoNotFollowTheMesh) {
  for (const char* coarse : {"Direct", "MueLu"}) {
    for (const int cells : {4, 8, 16}) EXPECT_LE(iterations(2, cells, coarse), 18) << cells << coarse;
    for (const int cells : {4, 5, 6, 8}) EXPECT_LE(iterations(3, cells, coarse), 18) << cells << coarse;
  }
}

TEST(TwoLevelTest, IterationsDoNotFollowTheMeshOfLinearCells) {
  for (const char* coarse : {"Direct", "MueLu"}) {
    for (const int cells : {8, 32}) EXPECT_LE(iterations(2, cells, coarse, world(), 1), 18) << cells << coarse;
    for (const int cells : {8, 12}) EXPECT_LE(iterations(3, cells, coarse, world(), 1), 18) << cells << coarse;
  }
}

TEST(TwoLevelTest, IterationsOnTwoRanksAreThoseOfOne) {
  for (const int order : {1, 2})
    EXPECT_NEAR(static_cast<double>(iterations(3, 8 / order, "Direct", world(), order)),
                static_cast<double>(iterations(3, 8 / order, "Direct", test::self(), order)), 1);
}

/// Springs of a program that hold the body everywhere, f = u; their action has no Galerkin product.
class Bed final : public test::SilentInteraction {
 public:
  class Action final : public TangentAction {
   public:
    explicit Action(std::size_t dofs) : dofs_(dofs) {}
    void linearize(const Segment&, const Rule&, Tangent, const LinearPart&) override {}
    bool applies_mass() const override { return false; }
    bool has_coarse() const override { return false; }
    void add_product(const double* x, double* y) const override {
      for (std::size_t i = 0; i < dofs_; ++i) y[i] += x[i];
    }
    void add_diagonal(double* d) const override {
      for (std::size_t i = 0; i < dofs_; ++i) d[i] += 1;
    }

   private:
    std::size_t dofs_;
  };
  explicit Bed(const Model& model)
      : pattern_(model.pattern()), dofs_(static_cast<std::size_t>(model.space().owned())) {}
  bool add_force(const Segment& segment, const Rule&, double* f) const override {
    for (std::size_t i = 0; i < dofs_; ++i) f[i] += segment.to[i];
    return true;
  }
  void add_tangent(const Segment&, const Rule&, Tangent, double* values) const override {
    pattern_.for_each_row([&](int row, const auto& places) {
      places([&](int column, std::size_t place) { values[place] += row == column ? 1 : 0; });
    });
  }
  std::unique_ptr<TangentAction> create_action() const override { return std::make_unique<Action>(dofs_); }

 private:
  const Pattern& pattern_;
  std::size_t dofs_;
};

// A program's term may offer an action without a Galerkin product: Automatic leaves the cycle then, and who asks for it
// learns the reason.
TEST(TwoLevelTest, ATermOfAProgramWithoutGalerkinProductIsNamed) {
  const auto s = Block{3, 2}.simulation();
  Model& model = s->model();
  const auto chosen = [&](ProblemSize size, const std::string& type) {
    size.dofs = 1000000;
    size.width = 10000;
    Teuchos::ParameterList asked = type.empty() ? Teuchos::ParameterList() : two_level();
    return completed_linear_solver(asked, size).get<std::string>("Preconditioner Type");
  };
  EXPECT_EQ(problem_size(model).fine_only, "");
  EXPECT_EQ(chosen(problem_size(model), ""), "Two-Level");
  model.add_interaction(std::make_unique<Bed>(model), "Bed");
  EXPECT_EQ(problem_size(model).fine_only, "\"Bed\"");
  EXPECT_EQ(chosen(problem_size(model), ""), "MueLu");
  const std::string words =
      "\"Two-Level\" needs a Galerkin product on linear cells (TangentAction::add_coarse), which \"Bed\" "
      "does not offer; use \"MueLu\", \"Ifpack2\" or \"Direct\"";
  test::expect_contains(test::refusal([&] { chosen(problem_size(model), "Two-Level"); }), words);
  const SemiDiscreteOperator w(model);  // where no list was completed
  test::expect_contains(test::refusal([&] { w.coarse_space(); }), words);
}

void expect_same_end(int order) {
  std::vector<double> reference;
  for (const char* preconditioner : {"Direct", "Two-Level"}) {
    Block block{3, order == 1 ? 6 : 3};
    block.order = order;
    block.more = solver(preconditioner) +
                 list("Initial Conditions", numbers("Velocity Gradient", {0, 0, 0, 0, 0, 0, 0.3, 0, -0.2}));
    const auto s = block.simulation();
    for (int step = 0; step < 4; ++step) {
      const StepResult result = s->integrator().step(0.05);
      ASSERT_TRUE(result.converged) << result.reason;
    }
    const std::vector<double> u = test::gathered(s->model(), s->integrator().state().u);
    if (reference.empty()) reference = u;
    ASSERT_EQ(u.size(), reference.size());
    for (std::size_t i = 0; i < u.size(); ++i) ASSERT_NEAR(u[i], reference[i], 1e-8) << preconditioner;
  }
}

TEST(TwoLevelTest, ARunEndsWhereAnotherSolverLeadsIt) { expect_same_end(2); }
TEST(TwoLevelTest, ARunOfLinearCellsEndsWhereAnotherSolverLeadsIt) { expect_same_end(1); }

TEST(TwoLevelTest, ScenesThatItDoesNotSuitAreRefused) {
  const auto refusal = [](const Block& block) { return test::refusal([&] { block.simulation(); }); };
  Block linear{3, 3};
  linear.order = 1;
  linear.more = solver("Two-Level");
  test::expect_contains(refusal(linear), "\"Two-Level\" needs a mesh of quadratic cells, or of linear ones that halve");
  Block enriched{2, 4};
  enriched.order = 1;
  enriched.wall = word("Contact Element", "Q1C2") + numbers("Point", {0.0, -0.3});
  enriched.more = solver("Two-Level");
  test::expect_contains(refusal(enriched),
                        "\"Two-Level\" needs a mesh of quadratic cells, or of linear ones that halve");
  Block assembled{3, 2};
  assembled.more = solver("Two-Level", "Assembled");
  test::expect_contains(refusal(assembled), "\"Two-Level\" needs matrix-free tangents, and Operator is \"Assembled\"");
  Block viscous{3, 2, number("Viscosity", 0.1)};
  viscous.more = solver("Two-Level");
  test::expect_contains(refusal(viscous), "\"Two-Level\" needs ");
  Block direct{3, 2};
  direct.more = list("Linear Solver", word("Linear Solver Type", "Direct") + word("Preconditioner Type", "Two-Level"));
  test::expect_contains(refusal(direct), "\"Two-Level\" needs Linear Solver Type \"Belos\"");
}

TEST(TwoLevelTest, ExplanationsNameIt) {
  Block block{3, 2};
  block.more = solver("Two-Level");
  const std::string text = explain(*block.simulation());
  test::expect_contains(text, "preconditioner Two-Level (coarse: Direct");
  test::expect_contains(text, "matrix-free tangents");
  test::expect_contains(text, "tangent matrices (0)");
}

TEST(TwoLevelSerialTest, LargeQuadraticMeshesGetItInSpace) {
  const auto choice = [](int dimension, long long dofs, bool quadratic, const char* op = "Automatic") {
    Teuchos::ParameterList asked;
    asked.set("Operator", op);
    ProblemSize size;
    size.dimension = dimension;
    size.dofs = dofs;
    size.quadratic = quadratic;
    Teuchos::ParameterList list = completed_linear_solver(asked, size);
    const auto type = list.get<std::string>("Preconditioner Type");
    if (type != "Two-Level") return type;
    return type + " " + list.sublist("Preconditioner Types").sublist(type).sublist("Coarse").get<std::string>("Type") +
           " " + list.get<std::string>("Operator");
  };
  EXPECT_EQ(choice(3, 30001, true), "Two-Level Direct Matrix-Free");
  EXPECT_EQ(choice(3, 1000000, true), "Two-Level MueLu Matrix-Free");
  EXPECT_EQ(choice(3, 2001, true), "Two-Level Direct Matrix-Free") << "compact";
  EXPECT_EQ(choice(3, 30000, true, "Assembled"), "Direct");
  EXPECT_EQ(choice(3, 30001, false), "MueLu");
  EXPECT_EQ(choice(3, 30001, true, "Assembled"), "MueLu");
  EXPECT_EQ(choice(2, 300001, true), "MueLu");
}

}  // namespace
}  // namespace ixos
