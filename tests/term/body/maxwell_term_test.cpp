// Maxwell branches of a block: forces, tangents and potentials against each other, the work of a step against what is
// stored and dissipated, rotations, fields, and histories that come back.
#include "term/body/maxwell_term.hpp"

#include <gtest/gtest.h>

#include <Tpetra_CrsMatrix.hpp>
#include <cmath>

#include "base/snapshot.hpp"
#include "material/neo_hooke.hpp"
#include "mesh/generators/shapes.hpp"
#include "support/by_hand.hpp"
#include "support/refusal.hpp"
#include "support/solids.hpp"

namespace ixos {
namespace {

constexpr double dt = 0.1;
const std::vector<MaxwellBranch> branches{{0.5, 0.05}, {0.2, 3}};

enum class Kind { Plane, Ring, Solid };
constexpr Kind kinds[] = {Kind::Plane, Kind::Ring, Kind::Solid};

/// A block of a mesh and its branches; the model serves the mesh only.
struct Body {
  explicit Body(Kind kind, const std::vector<MaxwellBranch>& own = branches,
                HistoryUpdate update = HistoryUpdate::BackwardEuler) {
    BoxShape shape;
    shape.dimension = kind == Kind::Solid ? 3 : 2;
    shape.lengths = {3, 2, 1};
    shape.divisions = {3, 2, 2};
    shape.lower = {1, 0, 0};
    Mesh mesh = box(shape);
    mesh.axisymmetric = kind == Kind::Ring;
    model = test::model_of(mesh, test::elastic(neo_hooke, 0.3), Inertia::None);
    term = make_maxwell_term(model->mesh(), model->mesh().blocks[0], model->pattern(), own, update);
    steps = std::make_unique<test::ByHand<Viscoelasticity>>(*term);
  }

  void begin(double mean_time) const {
    StageStart start;
    start.length = dt;
    start.mean_time = mean_time;
    steps->begin_stage(start);
  }
  /// Takes a step of dt.
  double accept(const std::vector<double>& from, const std::vector<double>& to) const {
    AcceptedStep step;
    step.states = {{from.data(), nullptr, nullptr}, {to.data(), nullptr, nullptr}};
    step.dt = dt;
    const double lost = sum(steps->accept(step).dissipated);
    steps->in_step = true;  // the stage goes on
    return lost;
  }
  /// Leaves a history.
  void exercise() const {
    begin(dt / 2);
    accept(field(0.02, 0), field(0.15, 0.5));
    accept(field(0.15, 0.5), field(0.1, 2));
  }

  /// A smooth field of the node's coordinates, equal on all ranks.
  std::vector<double> field(double size, double phase) const {
    std::vector<double> values = test::at_rest(*model);
    const auto d = static_cast<std::size_t>(model->mesh().dimension);
    for (std::size_t i = 0; i < values.size(); ++i) {
      double angle = phase + 2.1 * static_cast<double>(i % d);
      for (std::size_t j = 0; j < d; ++j)
        angle += (0.7 + 0.4 * static_cast<double>(j)) * model->mesh().coordinates[i / d * d + j];
      values[i] = size * std::sin(angle);
    }
    return values;
  }

  double sum(double share) const {
    model->space().sum(&share, 1);
    return share;
  }
  double dot(const std::vector<double>& a, const std::vector<double>& b) const {
    double share = 0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(model->space().owned()); ++i) share += a[i] * b[i];
    return sum(share);
  }
  std::vector<double> force(const Segment& segment, const Rule& rule) const {
    std::vector<double> f = test::at_rest(*model);
    EXPECT_TRUE(term->add_force(steps->in(segment), rule, f.data()));
    return f;
  }
  /// Returns K x, rows of owned nodes, of the assembled tangent.
  std::vector<double> product(const Segment& segment, const Rule& rule, const std::vector<double>& x) const {
    const auto matrix = model->pattern().create_matrix(model->space());
    double* values = matrix->getLocalMatrixHost().values.data();
    term->add_tangent(steps->in(segment), rule, Tangent::Exact, values);
    std::vector<double> y(x.size(), 0.0);
    model->pattern().for_each_row(values, [&](int row, const auto& entries) {
      entries([&](int column, double value) {
        y[static_cast<std::size_t>(row)] += value * x[static_cast<std::size_t>(column)];
      });
    });
    return y;
  }

  std::unique_ptr<Model> model;
  std::unique_ptr<Viscoelasticity> term;
  std::unique_ptr<test::ByHand<Viscoelasticity>> steps;
};

std::vector<double> moved(const std::vector<double>& u, double step, const std::vector<double>& direction) {
  std::vector<double> result = u;
  for (std::size_t i = 0; i < u.size(); ++i) result[i] += step * direction[i];
  return result;
}

TEST(MaxwellTermTest, TangentsAreDerivativesAndPotentialsFitForces) {
  for (Kind kind : kinds)
    for (double length : {0.0, dt}) {  // a state, a stage
      const Body body(kind);
      body.exercise();
      const std::vector<double> from = body.field(0.1, 2), to = body.field(0.12, 1), du = body.field(1, 3);
      const auto segment = [&](const std::vector<double>& u) {
        return Segment{from.data(), nullptr, u.data(), 0, length};
      };
      const double step = 1e-5;
      const std::vector<double> high = moved(to, step, du), low = moved(to, -step, du);
      for (const Rule& rule : {end_rule(), gauss_rule(2)}) {
        const std::vector<double> more = body.force(segment(high), rule), less = body.force(segment(low), rule);
        const std::vector<double> found = body.product(segment(to), rule, du);
        double largest = 0;
        for (std::size_t i = 0; i < static_cast<std::size_t>(body.model->space().owned()); ++i) {
          EXPECT_NEAR(found[i], (more[i] - less[i]) / (2 * step), 1e-7);
          largest = std::max(largest, std::abs(found[i]));
        }
        EXPECT_GT(largest, 1e-2);
        // The action keeps single precision.
        const auto action = body.term->create_action();
        EXPECT_EQ(action == nullptr, kind == Kind::Ring);
        if (!action) continue;
        action->linearize(body.steps->in(segment(to)), rule, Tangent::Exact, {});
        std::vector<double> applied = test::at_rest(*body.model);
        action->add_product(du.data(), applied.data());
        for (std::size_t i = 0; i < static_cast<std::size_t>(body.model->space().owned()); ++i)
          EXPECT_NEAR(applied[i], found[i], 1e-5 * (1 + std::abs(found[i])));
      }
      const auto energy = [&](const std::vector<double>& u) {
        return body.sum(length > 0 ? body.term->potential(body.steps->at(u.data()))
                                   : body.term->energy(body.steps->at(u.data())));
      };
      EXPECT_NEAR((energy(high) - energy(low)) / (2 * step), body.dot(body.force(segment(to), end_rule()), du), 1e-7);
    }
}

TEST(MaxwellTermTest, TheDiagonalIsThatOfTheTangent) {
  for (Kind kind : kinds) {
    const Body body(kind);
    const std::vector<double> u = body.field(0.1, 1);
    std::vector<double> diagonal = test::at_rest(*body.model), applied = diagonal, sums = diagonal;
    body.term->add_diagonal(body.steps->at(u.data()), diagonal.data());
    if (const auto action = body.term->create_action()) {
      action->linearize(body.steps->segment(nullptr, nullptr, u.data()), end_rule(), Tangent::Exact, {});
      action->add_diagonal(applied.data());
    } else {
      applied = diagonal;
    }
    EXPECT_TRUE(body.term->add_row_sums(body.steps->segment(nullptr, nullptr, u.data()), sums.data()));
    for (std::size_t i = 0; i < static_cast<std::size_t>(body.model->space().owned()); ++i) {
      EXPECT_NEAR(applied[i], diagonal[i], 1e-5 * diagonal[i]);
      EXPECT_GT(diagonal[i], 0);
      EXPECT_GT(sums[i], diagonal[i]);
    }
  }
}

/// Returns the work of the mean force over a step, less what it stores and dissipates, over that; `falsified` is the
/// relative error of the force's moduli.
double imbalance(Kind kind, double falsified) {
  std::vector<MaxwellBranch> wrong = branches;
  for (MaxwellBranch& branch : wrong) branch.modulus *= 1 + falsified;
  const Body body(kind), other(kind, wrong);
  body.exercise();
  other.exercise();
  body.begin(dt / 2);
  other.begin(dt / 2);
  const std::vector<double> from = body.field(0.1, 2), to = body.field(0.12, 1), du = moved(to, -1, from);
  const double work = other.dot(other.force({from.data(), nullptr, to.data(), 0, dt}, gauss_rule(8)), du);
  const double before = body.sum(body.term->energy(body.steps->at(from.data()))), lost = body.accept(from, to);
  EXPECT_GT(lost, 1e-3);
  return (work - lost - body.sum(body.term->energy(body.steps->at(to.data()))) + before) / lost;
}

TEST(MaxwellTermTest, WorkIsStoredOrDissipated) {
  for (Kind kind : kinds) {
    EXPECT_NEAR(imbalance(kind, 0), 0, 1e-12);
    EXPECT_GT(std::abs(imbalance(kind, 1e-6)), 1e-8) << "the account is no remainder";
  }
}

TEST(MaxwellTermTest, ARigidRotationLosesNothing) {
  const Body body(Kind::Plane);
  const auto turned = [&](double angle) {
    std::vector<double> u = test::at_rest(*body.model);
    for (std::size_t i = 0; i < u.size(); i += 2) {
      const double x = body.model->mesh().coordinates[i], y = body.model->mesh().coordinates[i + 1];
      u[i] = (std::cos(angle) - 1) * x - std::sin(angle) * y;
      u[i + 1] = std::sin(angle) * x + (std::cos(angle) - 1) * y;
    }
    return u;
  };
  body.begin(dt);
  for (int step = 0; step < 10; ++step) {
    const std::vector<double> from = turned(0.6 * step), to = turned(0.6 * (step + 1));
    for (double force : body.force({nullptr, nullptr, to.data(), 0, dt}, end_rule())) EXPECT_NEAR(force, 0, 1e-14);
    EXPECT_NEAR(body.accept(from, to), 0, 1e-28);
  }
}

// A simple shear g that is held: the stress is that of the branches, (0.5 + 0.2) g at first, and after a step each has
// relaxed by 1/(1 + dt/tau).
TEST(MaxwellTermTest, StressAndDissipationAreFields) {
  for (Kind kind : {Kind::Plane, Kind::Solid}) {
    const Body body(kind);
    const double g = 1e-4;
    const auto d = static_cast<std::size_t>(body.model->mesh().dimension);
    std::vector<double> u = test::at_rest(*body.model);
    for (std::size_t i = 0; i < u.size(); i += d) u[i] = g * body.model->mesh().coordinates[i + 1];
    const auto shear = [&] {
      std::vector<SymmetricTensor> stress(static_cast<std::size_t>(body.model->mesh().blocks[0].cells()));
      body.term->add_cell_stress(body.steps->at(u.data()), stress);
      return stress.empty() ? 0.0 : stress[0][3];
    };
    const bool seen = body.model->mesh().blocks[0].cells() > 0;
    if (seen) {
      EXPECT_NEAR(shear(), 0.7 * g, 1e-8 * g);
    }
    body.begin(dt);
    const double lost = body.accept(u, u);
    if (seen) {
      EXPECT_NEAR(shear(), (0.5 / 3 + 0.2 / (1 + dt / 3)) * g, 1e-7 * g);
    }
    // psi before less psi after: nothing works at a strain that is held.
    const double volume = 6;
    const double expected = (0.5 * (1 - 1 / 9.0) + 0.2 * (1 - std::pow(1 + dt / 3, -2))) * g * g / 2 * volume;
    EXPECT_NEAR(lost, expected, 1e-6 * expected);
    std::vector<double> density;
    body.term->add_cell_dissipation(body.steps->histories, density);
    for (double value : density) EXPECT_NEAR(value, expected / volume, 1e-6 * expected);
  }
}

// A simple shear that grows to g within a step, then is held: the error of its dashpot's shear against Ci' = (Cb -
// Ci)/tau, which at small strain is solved in closed form. 12 and 21 of Ci count, half of each is the shear strain.
TEST(MaxwellTermTest, TheErrorOfAStepIsThatOfTheHistory) {
  const double g = 1e-5, modulus = 0.4;
  for (HistoryUpdate update : {HistoryUpdate::BackwardEuler, HistoryUpdate::SecondOrder})
    for (double x : {0.01, 1.0, 30.0}) {
      const Body body(Kind::Solid, {{modulus, dt / x}}, update);
      const std::vector<double> rest = test::at_rest(*body.model);
      std::vector<double> u = rest;
      for (std::size_t i = 0; i < u.size(); i += 3) u[i] = g * body.model->mesh().coordinates[i + 1];
      const auto shear = [&] {
        std::vector<SymmetricTensor> stress(static_cast<std::size_t>(body.model->mesh().blocks[0].cells()));
        body.term->add_cell_stress(body.steps->at(u.data()), stress);
        return stress.empty() ? 0.0 : stress[0][3];
      };
      const auto error = [&](const std::vector<double>& from) {
        const std::array<double, 2> own =
            body.term->squared_error(body.steps->segment(from.data(), nullptr, u.data(), 0, dt));
        EXPECT_NEAR(body.sum(own[1]), 6, 1e-12);
        return std::sqrt(body.sum(own[0]) / 6);
      };
      const bool seen = body.model->mesh().blocks[0].cells() > 0;
      body.begin(dt);
      const double growing = error(rest);
      body.accept(rest, u);
      const double after_growth = modulus * g * (1 - std::exp(-x)) / x, left = shear(), held = error(u);
      if (seen) {
        EXPECT_NEAR(growing, std::abs(left - after_growth) / std::sqrt(2), 1e-5 * growing + 1e-12 * g) << x;
      }
      body.accept(u, u);
      if (seen) {
        EXPECT_NEAR(held, std::abs(shear() - left * std::exp(-x)) / std::sqrt(2), 1e-5 * held + 1e-12 * g) << x;
      }
    }
}

// The stress of each branch after a step in which the strain grows, and one in which it is held.
TEST(MaxwellTermTest, AnAcceptedStepTellsItsStresses) {
  const std::vector<MaxwellBranch> both{{0.5, 0.05}, {0.2, 3}};
  for (Kind kind : kinds)
    for (HistoryUpdate update : {HistoryUpdate::BackwardEuler, HistoryUpdate::SecondOrder}) {
      const Body body(kind, both, update);
      body.begin(dt);
      const std::vector<double> from = test::at_rest(*body.model), to = body.field(1e-6, 0.5);
      double share = 1, sum = 0;
      for (int step = 0; step < 2; ++step) {
        body.accept(step == 0 ? from : to, to);
        const BranchSquares squares = body.term->last_squares(body.steps->histories);
        const double strain = std::sqrt(body.sum(squares.strain));
        EXPECT_GT(strain, 0);
        sum = 0;
        for (std::size_t n = 0; n < both.size(); ++n) {
          const double x = dt / both[n].time, s = update == HistoryUpdate::BackwardEuler ? x : x * (1 + x / 2);
          const double grown = update == HistoryUpdate::BackwardEuler ? 1 / (1 + x) : (1 + s / 2) / (1 + s);
          share = step == 0 ? grown : grown / (1 + s);
          EXPECT_NEAR(std::sqrt(body.sum(squares.branches.at(n))), both[n].modulus * share * strain, 1e-4 * strain);
          sum += both[n].modulus * share * strain;
        }
        EXPECT_NEAR(std::sqrt(body.sum(squares.sum)), sum, 1e-4 * strain);
      }
    }
}

TEST(MaxwellTermTest, HistoriesOfOtherBranchesAreRefused) {
  const Body body(Kind::Plane);
  body.exercise();
  const Body* loads = &body;
  Snapshot snapshot([&](Record& record) { loads->term->transfer(record, loads->steps->histories); });
  snapshot.save();
  const auto refusal = [&](const std::vector<MaxwellBranch>& own) {
    const Body other(Kind::Plane, own);
    loads = &other;
    return test::refusal([&] { snapshot.restore(); });
  };
  EXPECT_EQ(
      refusal({{0.5, 0.05}}),
      "the checkpoint has 2 Maxwell branches of the relaxation times 0.05, 3, the scene 1 of 0.05; their histories "
      "do not fit others");
  EXPECT_EQ(refusal({{0.5, 0.05}, {0.2, 4}}),
            "the checkpoint has 2 Maxwell branches of the relaxation times 0.05, 3, the scene 2 of 0.05, 4; their "
            "histories do not fit others");
  EXPECT_EQ(refusal({{0.7, 0.05}, {0.1, 3}}), "") << "strains of dashpots do not depend on the moduli";
}

TEST(MaxwellTermTest, HistoriesComeBack) {
  for (Kind kind : kinds) {
    const Body body(kind);
    EXPECT_TRUE(body.term->dissipates() && body.term->has_state() && body.term->has_history());
    const std::vector<double> u = body.field(0.1, 1), v = body.field(0.2, 2);
    body.exercise();
    Snapshot snapshot([&](Record& record) { body.term->transfer(record, body.steps->histories); });
    snapshot.save();
    const double energy = body.term->energy(body.steps->at(u.data()));
    body.accept(u, v);
    EXPECT_NE(body.term->energy(body.steps->at(u.data())), energy);
    snapshot.restore();
    EXPECT_EQ(body.term->energy(body.steps->at(u.data())), energy);
    body.steps->initialize(u.data());
    const Body fresh(kind);
    EXPECT_EQ(body.term->energy(body.steps->at(u.data())), fresh.term->energy(fresh.steps->at(u.data())));
  }
}

// Laws of small strains do not ask for J > 0.
TEST(MaxwellTermTest, InvertedElementsAreInadmissible) {
  for (Kind kind : kinds) {
    const Body body(kind);
    const auto d = static_cast<std::size_t>(body.model->mesh().dimension);
    std::vector<double> from = test::at_rest(*body.model), to = from, f = from;
    for (std::size_t i = 1; i < to.size(); i += d) to[i] = -1.4 * body.model->mesh().coordinates[i];
    const bool seen = body.model->mesh().blocks[0].cells() > 0;
    const auto is_admissible = [&](const std::vector<double>& end, const Rule& rule) {
      return body.term->add_force(body.steps->segment(from.data(), nullptr, end.data(), 0, dt), rule, f.data());
    };
    body.begin(dt);
    EXPECT_TRUE(is_admissible(from, end_rule()));
    EXPECT_EQ(is_admissible(to, end_rule()), !seen);
    EXPECT_EQ(is_admissible(to, point_rule({0.5}, {1})), !seen) << "the end is inverted, not the middle";
  }
}

TEST(MaxwellTermTest, MeansOtherThanOfPointsAreDefects) {
  const Body body(Kind::Plane);
  std::vector<double> u = test::at_rest(*body.model), f = u;
  EXPECT_THROW(body.term->add_force({u.data(), nullptr, u.data(), 0, dt}, discrete_gradient_rule(), f.data()),
               std::logic_error);
  EXPECT_THROW(body.begin(0), std::logic_error);
}

}  // namespace
}  // namespace ixos
