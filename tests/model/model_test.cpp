#include "model/model.hpp"

#include <gtest/gtest.h>

#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Vector.hpp>
#include <cmath>

#include "model/term_sums.hpp"
#include "scene/simulation.hpp"
#include "support/bodies.hpp"
#include "support/comparison.hpp"
#include "support/reports.hpp"
#include "support/scene_text.hpp"
#include "time/schemes.hpp"
#include "time/stage_problem.hpp"

namespace ixos {
namespace {

using test::block_2d;
using test::block_3d;
using test::time_integrator;
using test::world;

Simulation simulation(const std::string& body) {
  return Simulation(test::scene(body + time_integrator("Newmark", 0.1, 1)), world());
}

TEST(ModelTest, MassAndMomentaOfARigidMotionAreExact) {
  for (const auto& [body, volume] : {std::pair{block_2d(0), 6.0}, std::pair{block_3d(0), 2.0}}) {
    Simulation s = simulation(body);
    Model& model = s.model();
    const auto d = static_cast<std::size_t>(model.mesh().dimension);
    std::vector<double> u(static_cast<std::size_t>(model.space().local()), 0.0);
    std::vector<double> v(u.size());
    for (std::size_t i = 0; i < v.size(); ++i) v[i] = i % d == 0 ? 2.0 : 0.0;
    const Momenta momenta = test::ReportAt(model, u.data(), v.data()).momenta();
    EXPECT_NEAR(momenta.linear[0], 2 * volume, 1e-12);
    EXPECT_NEAR(momenta.linear[1], 0, 1e-12);
    EXPECT_NEAR(momenta.kinetic_energy, 0.5 * 4 * volume, 1e-12);
    // L_z = -y m v about the origin.
    EXPECT_NEAR(momenta.angular.back(), -(d == 2 ? 1.0 : 0.5) * 2 * volume, 1e-12);
  }
}

TEST(ModelTest, MomentOfInertiaOfASpinIsExact) {
  Simulation s = simulation(block_2d(0));
  Model& model = s.model();
  const LocalMesh& mesh = model.mesh();
  std::vector<double> u(static_cast<std::size_t>(model.space().local()), 0.0);
  std::vector<double> v(u.size());
  for (std::size_t n = 0; n < u.size() / 2; ++n) {
    v[2 * n] = -(mesh.coordinates[2 * n + 1] - 1);
    v[2 * n + 1] = mesh.coordinates[2 * n] - 1.5;
  }
  // A linear velocity field lies in the space of bilinear shape functions: m (a^2 + b^2)/12.
  EXPECT_NEAR(test::ReportAt(model, u.data(), v.data()).momenta().angular[0], 6 * (9 + 4) / 12.0, 1e-12);
}

/// |R(x + h d) - R(x) - h W d| for each h.
std::vector<double> tangent_errors(Model& model, const Table& table, const std::vector<double>& steps) {
  const auto local = static_cast<std::size_t>(model.space().local());
  const LocalMesh& mesh = model.mesh();
  const auto d = static_cast<std::size_t>(mesh.dimension);
  std::vector<State> states(table.stages.size());
  for (std::size_t s = 0; s < states.size(); ++s)
    for (std::vector<double>* field : {&states[s].u, &states[s].v, &states[s].a}) {
      field->resize(local);
      // Smooth fields of the coordinates: ghosts agree with their owners.
      for (std::size_t i = 0; i < local; ++i)
        (*field)[i] = 0.05 * std::sin(1.7 * mesh.coordinates[i] + 0.9 * static_cast<double>(i % d + s)) + 0.02;
    }
  StageProblem problem(model, table);
  states[0].histories = model.create_histories();
  StepMemories memories = model.create_memories();
  problem.arm(table.stages.size() - 1, states, 0.1, memories);

  const auto map = problem.map();
  Vector x(map), direction(map), f0(map), f1(map), wd(map), moved(map);
  {
    const auto xv = x.getLocalViewHost(Tpetra::Access::OverwriteAll);
    const auto dv = direction.getLocalViewHost(Tpetra::Access::OverwriteAll);
    for (std::size_t i = 0; i < static_cast<std::size_t>(model.space().owned()); ++i) {
      xv(i, 0) = 0.06 * std::cos(1.3 * mesh.coordinates[i] + static_cast<double>(i % d));
      dv(i, 0) = std::sin(2.1 * mesh.coordinates[i] + 0.5 * static_cast<double>(i % d));
    }
  }
  const auto w = problem.create_operator();
  EXPECT_TRUE(problem.residual(x, f0));
  problem.tangent(x, *w);
  w->apply(direction, wd);
  std::vector<double> errors;
  for (double h : steps) {
    moved.update(1.0, x, h, direction, 0.0);
    EXPECT_TRUE(problem.residual(moved, f1));
    f1.update(-1.0, f0, -h, wd, 1.0);
    errors.push_back(f1.norm2());
  }
  return errors;
}

TEST(ModelTest, TangentIsTheDerivativeOfTheResidualForEveryScheme) {
  const std::string wall = test::list(
      "Interactions", test::list("Wall", test::word("Side Set", "bottom") + test::numbers("Point", {0, -0.4}) +
                                             test::number("Gamma W", 0.1)));
  const std::string wall_3d = test::list(
      "Interactions", test::list("Wall", test::word("Side Set", "bottom") + test::numbers("Point", {0, 0, -0.4}) +
                                             test::number("Gamma W", 0.1)));
  for (const std::string& body : {block_2d(0.5) + wall, block_3d(0.5) + wall_3d}) {
    Simulation s = simulation(body);
    for (const Table& table :
         {newmark(0.3, 0.6), bathe_composite(0.3, 0.45), gautam_sauer_composite(0.25, 0.5, 5, Path::Linear),
          gautam_sauer_composite(0.25, 0.5, 5, Path::Kinematic), average_vector_field(4, 8)}) {
      const auto errors = tangent_errors(s.model(), table, {1e-2, 1e-3, 1e-4});
      // The remainder of the expansion is of second order: a tenth of the step, a hundredth of the error.
      EXPECT_NEAR(errors[0] / errors[1], 100, 15) << table.name;
      EXPECT_NEAR(errors[1] / errors[2], 100, 15) << table.name;
    }
  }
}

TEST(ModelTest, TwoRanksAssembleTheSameOperatorAsOne) {
  for (const std::string& body : {block_2d(0.5), block_3d(0.5)}) {
    Simulation whole = simulation(body);
    Simulation alone(test::scene(body + time_integrator("Newmark", 0.1, 1)), test::self());
    const auto image = [](const Model& model) {
      const auto w = model.pattern().create_matrix(model.space());
      const LocalMesh& mesh = model.mesh();
      std::vector<double> u(static_cast<std::size_t>(model.space().local()));
      for (std::size_t i = 0; i < u.size(); ++i) u[i] = 0.1 * std::sin(1.9 * mesh.coordinates[i]);
      double* values = w->getLocalMatrixHost().values.data();
      TermSums(model).add_tangent(Part::Elastic, {nullptr, nullptr, u.data()}, end_rule(), Tangent::Exact, values);
      model.mass()->add_to(3.0, values);
      Vector x(model.space().owned_map()), y(model.space().owned_map());
      {
        const auto view = x.getLocalViewHost(Tpetra::Access::OverwriteAll);
        for (std::size_t i = 0; i < view.extent(0); ++i) view(i, 0) = std::cos(2.3 * mesh.coordinates[i]);
      }
      w->apply(x, y);
      std::vector<double> local(u.size());
      model.space().import(y, local.data());
      return test::gathered(model, local);
    };
    EXPECT_LT(test::distance(image(whole.model()), image(alone.model())), 1e-13);
  }
}

}  // namespace
}  // namespace ixos
