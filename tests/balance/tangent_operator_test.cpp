// The tangent without a matrix is the assembled one: in its action, its diagonal and its constrained columns, for every
// rule and element; a run with either ends in the same place.
#include "balance/tangent_operator.hpp"

#include <gtest/gtest.h>

#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Vector.hpp>
#include <cmath>
#include <tuple>
#include <vector>

#include "base/error.hpp"
#include "embedding/semi_discrete_tangent.hpp"
#include "scene/simulation.hpp"
#include "solve/iterative/chebyshev_polynomial.hpp"
#include "solve/iterative/single_products.hpp"
#include "support/bodies.hpp"
#include "support/comparison.hpp"
#include "support/scene_text.hpp"
#include "time/stage_problem.hpp"

namespace ixos {
namespace {

using test::world;

/// A damped block whose bottom sticks to a wall and whose left side is held; a contact patch in the bottom's middle.
std::string block(int dimension, const std::string& element, const std::string& material, int points = 2,
                  int bulk_points = 0, const std::string& formulation = "Standard") {
  const bool flat = dimension == 2;
  const std::vector<double> up = flat ? std::vector<double>{0, 1} : std::vector<double>{0, 0, 1};
  std::vector<double> below(up);
  for (double& x : below) x *= -0.3;
  return test::list(
             "Mesh",
             test::word("Type", "Box") + test::count("Cell Order", element[1] == '2' ? 2 : 1) +
                 test::list(
                     "Box",
                     test::count("Dimension", dimension) +
                         test::numbers("Lengths", flat ? std::vector<double>{4, 2} : std::vector<double>{4, 3, 2}) +
                         test::counts("Divisions", flat ? std::vector<int>{5, 3} : std::vector<int>{4, 3, 2})) +
                 test::list("Sets",
                            test::list("patch", test::word("From", "bottom") +
                                                    test::numbers("Upper", flat ? std::vector<double>{3, 1}
                                                                                : std::vector<double>{3, 2, 1})))) +
         test::list("Materials",
                    test::list("Body", test::word("Model", material) + test::number("Density", 0.7) +
                                           test::number("Mass Damping", 0.3) + test::number("Stiffness Damping", 0.2) +
                                           test::count("Quadrature Points", points) +
                                           test::word("Element Formulation", formulation))) +
         test::list("Interactions",
                    test::list("Wall", test::word("Side Set", "patch") + test::word("Contact Element", element) +
                                           test::count("Bulk Points", bulk_points) + test::numbers("Point", below))) +
         test::list("Boundary Conditions", test::list("Held", test::word("Node Set", "left")));
}

/// A smooth field of the place: ghosts agree with their owners.
std::vector<double> wave(const Model& model, double amplitude, double phase) {
  const LocalMesh& mesh = model.mesh();
  const auto d = static_cast<std::size_t>(mesh.dimension);
  std::vector<double> field(static_cast<std::size_t>(model.space().local()));
  for (std::size_t i = 0; i < field.size(); ++i)
    for (std::size_t j = 0; j < d; ++j)
      field[i] += amplitude * std::sin(1.3 * mesh.coordinates[i / d * d + j] + phase + static_cast<double>(i % d + j));
  return field;
}

Vector owned(const Model& model, const std::vector<double>& local) {
  Vector result(model.space().owned_map());
  const auto view = result.getLocalViewHost(Tpetra::Access::OverwriteAll);
  std::copy_n(local.data(), view.extent(0), view.data());
  return result;
}

double distance(const Vector& a, const Vector& b) {
  Vector difference(a, Teuchos::Copy);
  difference.update(-1.0, b, 1.0);
  return difference.norm2() / b.norm2();
}

struct Case {
  int dimension;
  const char* element;
  const char* material;
  int points = 2;
  int bulk_points = 0;
};

/// Relative: elastic actions keep single precision.
constexpr double single = 1e-6;

class TangentOperatorTest : public testing::TestWithParam<Case> {};

TEST_P(TangentOperatorTest, IsTheAssembledTangentOfEveryScheme) {
  const auto [dimension, element, material, points, bulk_points] = GetParam();
  for (const char* scheme :
       {"Newmark", "Bathe Composite", "Gautam-Sauer Composite", "Average Vector Field", "Midpoint"}) {
    Simulation s(
        test::scene(block(dimension, element, material, points, bulk_points) + test::time_integrator(scheme, 0.1, 1)),
        world());
    Model& model = s.model();
    const Table& table = s.integrator().table();
    // A product of a mean over a path leaves out terms of second order in the step.
    const double bound = std::string(scheme) == "Average Vector Field" ? 1e-5 : single;
    for (int level : {0, 1, 3}) {
      std::vector<State> states(table.stages.size());
      for (std::size_t k = 0; k < states.size(); ++k) {
        const double phase = static_cast<double>(k);
        states[k].u = wave(model, 0.02, phase);
        states[k].v = wave(model, 0.02, phase + 1);
        states[k].a = wave(model, 0.02, phase + 2);
      }
      const Vector x = owned(model, wave(model, 0.03, 0.5)), direction = owned(model, wave(model, 1, 7));
      const auto& map = model.space().owned_map();  // a copied vector would share the values
      Vector f(map), free_f(map), product(map), free_product(map), diagonal(map), free_diagonal(map);
      states[0].histories = model.create_histories();
      StepMemories memories = model.create_memories();
      StageProblem assembled(model, table), matrix_free(model, table, true);
      for (StageProblem* problem : {&assembled, &matrix_free}) {
        problem->arm(table.stages.size() - 1, states, 0.1, memories);
        problem->relax_tangent(level);
      }
      ASSERT_TRUE(assembled.residual(x, f));
      ASSERT_TRUE(matrix_free.residual(x, free_f));
      // Prescribed values are still on their way: the residual needs the constrained columns.
      EXPECT_LT(distance(free_f, f), single) << scheme;
      const auto w = assembled.create_operator(), free_w = matrix_free.create_operator();
      assembled.tangent(x, *w);
      matrix_free.tangent(x, *free_w);
      w->apply(direction, product);
      free_w->apply(direction, free_product);
      EXPECT_LT(distance(free_product, product), bound) << scheme << ", level " << level;
      {
        const SingleProducts precision(dynamic_cast<const Operator&>(*free_w));
        free_w->apply(direction, free_product);
        EXPECT_LT(distance(free_product, product), bound) << scheme << ", level " << level;
      }
      product.update(2.0, direction, 1.0);
      free_product.assign(direction);
      free_w->apply(direction, free_product, Teuchos::NO_TRANS, 1.0, 2.0);
      EXPECT_LT(distance(free_product, product), bound) << scheme << ", level " << level;
      dynamic_cast<CrsMatrix&>(*w).getLocalDiagCopy(diagonal);
      dynamic_cast<TangentOperator&>(*free_w).diagonal(free_diagonal);
      EXPECT_LT(distance(free_diagonal, diagonal), bound) << scheme << ", level " << level;
      dynamic_cast<TangentOperator&>(*free_w).matrix()->apply(direction, free_product);
      w->apply(direction, product);
      EXPECT_LT(distance(free_product, product), 1e-14) << scheme << ", level " << level;
    }
  }
}

// Errors of single precision are relative to the differences in a cell: a translation by 1e4 adds none to the
// stiffness, and its mass is exact to single precision.
TEST(SinglePrecisionTest, SeesNothingOfATranslation) {
  for (const auto& [dimension, order, law] :
       std::vector<std::tuple<int, int, const char*>>{{2, 1, "Neo-Hooke"},
                                                      {2, 2, "Neo-Hooke"},
                                                      {3, 1, "Neo-Hooke"},
                                                      {3, 2, "Neo-Hooke"},
                                                      {3, 1, "Saint Venant-Kirchhoff"}}) {
    const std::vector<double> lengths(static_cast<std::size_t>(dimension), 2.0);
    const std::vector<int> divisions(static_cast<std::size_t>(dimension), 3);
    Simulation s(test::scene(test::list("Mesh", test::word("Type", "Box") + test::count("Cell Order", order) +
                                                    test::list("Box", test::count("Dimension", dimension) +
                                                                          test::numbers("Lengths", lengths) +
                                                                          test::counts("Divisions", divisions))) +
                             test::list("Materials",
                                        test::list("Body", test::word("Model", law) + test::number("Density", 0.7))) +
                             test::time_integrator("Newmark", 0.1, 1)),
                 world());
    const Model& model = s.model();
    SemiDiscreteOperator w(model);
    const std::vector<double> bend = wave(model, 1, 7), bent = wave(model, 0.02, 1);
    std::vector<double> moved(bend);
    for (double& x : moved) x += 1e4;
    const Vector still = owned(model, bend), far = owned(model, moved);
    Vector exact(still.getMap()), rough(still.getMap());
    for (const TangentWeights& weights : {TangentWeights{0, 0, 1}, TangentWeights{2, 0, 1e-9}}) {
      w.linearize(weights, {bent.data()});
      w.apply(weights.mass == 0 ? still : far, exact);
      const SingleProducts precision(w);
      w.apply(far, rough);
      EXPECT_LT(distance(rough, exact), single) << dimension << order << law;
      EXPECT_GT(distance(rough, exact), 0) << dimension << order << law;
    }
    w.apply(far, rough);
    EXPECT_EQ(distance(rough, exact), 0) << "in double precision again";
  }
}

/// Keeps the precisions that were asked for.
struct WatchedOperator : TangentOperator {
  explicit WatchedOperator(const Model& model) : TangentOperator(model, [](double*) {}) {}
  Precision set_precision(Precision precision) const override {
    asked.push_back(precision);
    return TangentOperator::set_precision(precision);
  }
  mutable std::vector<Precision> asked;
};

TEST(SinglePrecisionTest, ChebyshevsPolynomialAsksForItAndReturnsToWhatItFound) {
  Simulation s(test::scene(block(2, "Q1C1", "Neo-Hooke") + test::time_integrator("Newmark", 0.1, 1)), world());
  const Model& model = s.model();
  const auto w = Teuchos::rcp(new WatchedOperator(model));
  const std::vector<double> u = wave(model, 0.02, 1);
  const Rule rule = end_rule();
  BalancePoint point;
  point.elastic = point.interaction = Segment{nullptr, nullptr, u.data()};
  point.elastic_rule = point.interaction_rule = &rule;
  w->linearize(point, {2, 0, 1}, Tangent::Exact, 1);
  ChebyshevPolynomial polynomial;
  polynomial.initialize(w, {});
  EXPECT_TRUE(w->asked.empty()) << "the spectrum is estimated in double precision";
  const Vector b = owned(model, wave(model, 1, 7));
  polynomial(b);
  EXPECT_EQ(w->asked, (std::vector<Precision>{Precision::Single, Precision::Double}));
  const SingleProducts outer(*w);
  polynomial(b);
  EXPECT_EQ(w->set_precision(Precision::Double), Precision::Single);
}

void expect_scales(const std::string& body) {
  const Simulation s(test::scene(body + test::time_integrator("Newmark", 0.1, 1)), world());
  const Model& model = s.model();
  const auto stiffness = model.pattern().create_matrix(model.space()),
             mass = model.pattern().create_matrix(model.space());
  const std::vector<double> rest(static_cast<std::size_t>(model.space().local()), 0.0);
  TermSums(model).add_tangent(Part::Elastic, {nullptr, nullptr, rest.data()}, end_rule(), Tangent::Exact,
                              stiffness->getLocalMatrixHost().values.data());
  model.mass()->add_to(1.0, mass->getLocalMatrixHost().values.data());
  Vector k(model.space().owned_map()), m(model.space().owned_map()), ratio(model.space().owned_map());
  stiffness->getLocalDiagCopy(k);
  mass->getLocalDiagCopy(m);
  EXPECT_NEAR(model.scales().elastic, k.meanValue(), 1e-13 * k.meanValue());
  EXPECT_NEAR(model.scales().mass, m.meanValue(), 1e-13 * m.meanValue());
  ratio.reciprocal(m);
  ratio.elementWiseMultiply(1.0, k, ratio, 0.0);
  EXPECT_NEAR(model.scales().stiffest, ratio.normInf(), 1e-13 * ratio.normInf());
}

TEST_P(TangentOperatorTest, ScalesOfTheModelAreThoseOfTheMatrices) {
  const auto [dimension, element, material, points, bulk_points] = GetParam();
  expect_scales(block(dimension, element, material, points, bulk_points));
}

TEST(ScalesTest, AreThoseOfTheMatricesWhateverTheFormulation) {
  for (const char* formulation : {"Mean Dilatation", "Enhanced"})
    for (int dimension : {2, 3}) expect_scales(block(dimension, "Q1C1", "Neo-Hooke", 2, 0, formulation));
}

INSTANTIATE_TEST_SUITE_P(Elements, TangentOperatorTest,
                         testing::Values(Case{2, "Q1C1", "Neo-Hooke"}, Case{2, "Q1C4", "Neo-Hooke"},
                                         Case{2, "Q1CH", "Neo-Hooke"}, Case{3, "Q1C1", "Neo-Hooke"},
                                         Case{3, "Q1C2", "Neo-Hooke"}, Case{3, "Q1CH", "Neo-Hooke"},
                                         Case{2, "Q2C2", "Neo-Hooke"}, Case{3, "Q2C2", "Neo-Hooke"},
                                         Case{2, "Q2C4", "Neo-Hooke"}, Case{3, "Q2C4", "Neo-Hooke"},
                                         Case{3, "Q2C2", "Linear Elastic"}, Case{3, "Q1C1", "Linear Elastic"},
                                         Case{3, "Q1C2", "Neo-Hooke", 5, 6}));

TEST(MatrixFreeRunTest, EndsWhereTheAssembledOneEnds) {
  using Way = std::pair<const char*, const char*>;
  for (const auto& [scheme, element] :
       {Way{"Gautam-Sauer Composite", "Q1C2"}, Way{"Bathe Composite", "Q1C2"}, Way{"Bathe Composite", "Q2C2"}}) {
    const double tolerance = std::string(element) == "Q2C2" ? 1e-9 : 1e-10;  // of more unknowns
    std::vector<double> reference;
    for (const char* op : {"Assembled", "Matrix-Free"})
      for (const char* preconditioner : {"MueLu", "Direct", "Chebyshev"}) {
        Simulation s(test::scene(block(3, element, "Neo-Hooke") + test::time_integrator(scheme, 0.05, 1) +
                                 test::list("Linear Solver", test::word("Linear Solver Type", "Belos") +
                                                                 test::word("Preconditioner Type", preconditioner) +
                                                                 test::word("Operator", op))),
                     world());
        for (int step = 0; step < 5; ++step) {
          const StepResult result = s.integrator().step(0.05);
          ASSERT_TRUE(result.converged) << result.reason;
        }
        const std::vector<double> u = test::gathered(s.model(), s.integrator().state().u);
        if (reference.empty()) reference = u;
        ASSERT_EQ(u.size(), reference.size());
        for (std::size_t i = 0; i < u.size(); ++i)
          ASSERT_NEAR(u[i], reference[i], tolerance) << op << ' ' << preconditioner;
      }
  }
}

TEST(MatrixFreeRunTest, ShortStepsTakeChebyshevsPolynomialByThemselves) {
  const std::string control = "Time Integrator/Time Step Control/";
  const auto simulation = [&](const std::vector<std::string>& sets) {
    std::vector<std::string> all{"Mesh/Box/Lengths={9, 9, 9}", "Mesh/Box/Divisions={9, 9, 9}",
                                 control + "Time Step=0.008"};
    all.insert(all.end(), sets.begin(), sets.end());
    return std::make_unique<Simulation>(test::scene_file("block-on-wall.xml", all), world());
  };
  const auto preconditioner = [](const Simulation& s) {
    return s.parameters().sublist("Linear Solver").get<std::string>("Preconditioner Type");
  };
  const auto automatic = simulation({}), direct = simulation({"Linear Solver/Linear Solver Type=Direct"});
  EXPECT_EQ(preconditioner(*automatic), "Chebyshev");
  const std::string adaptive = control + "Adaptive/";
  const std::vector<std::string> judged{control + "Type=Adaptive", adaptive + "Tolerance=1e-3"};
  std::vector<std::string> short_steps(judged);
  short_steps.push_back(adaptive + "Maximum Time Step=0.008");
  EXPECT_EQ(preconditioner(*simulation(short_steps)), "Chebyshev");
  for (const std::vector<std::string>& sets :
       {judged, {control + "Time Step=0.1"}, {"Materials/Rubber/Stiffness Damping=0.1"}})
    EXPECT_EQ(preconditioner(*simulation(sets)), "Direct") << sets[0];
  for (int k = 0; k < 5; ++k)
    for (Simulation* s : {automatic.get(), direct.get()}) ASSERT_TRUE(s->integrator().step(0.008).converged);
  const auto moved = [](const Simulation& s) { return test::gathered(s.model(), s.integrator().state().u); };
  const double size = test::distance(moved(*direct), std::vector<double>(moved(*direct).size()));
  EXPECT_LT(test::distance(moved(*automatic), moved(*direct)), 1e-8 * size);
  EXPECT_GT(size, 1e-6);
}

TEST(MatrixFreeRunTest, AnExplicitSchemeNeedsNone) {
  Simulation s(test::scene(block(3, "Q1C1", "Neo-Hooke") + test::time_integrator("Central Difference", 1e-3, 1) +
                           test::list("Linear Solver", test::word("Linear Solver Type", "Belos") +
                                                           test::word("Operator", "Matrix-Free"))),
               world());
  EXPECT_TRUE(s.integrator().step(s.integrator().stable_step(1e-3)).converged);
}

TEST(MatrixFreeRunTest, IsRefusedWhereThereIsNoSuchTangent) {
  const std::string op =
      test::list("Linear Solver", test::word("Operator", "Matrix-Free") + test::word("Linear Solver Type", "Belos"));
  for (const char* scheme : {"Energy-Momentum"})
    EXPECT_THROW(Simulation(test::scene(test::block_3d(0) + test::time_integrator(scheme, 0.1, 1) + op), world()),
                 InputError);
}

}  // namespace
}  // namespace ixos
