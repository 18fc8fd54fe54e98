#include "term/support/loads.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "mesh/generators/shapes.hpp"
#include "support/refusal.hpp"
#include "support/reports.hpp"
#include "support/solids.hpp"
#include "time/schemes.hpp"

namespace ixos {
namespace {

TEST(LoadsSerialTest, MeansAreOfTheHistory) {
  Loads loads(2);
  EXPECT_TRUE(loads.empty());
  loads.add({1, 2}, expression("t^2", "", ""));
  loads.add({0, 1}, constant(3));
  std::vector<double> f(2, 0.0);
  loads.add_mean({{0.0, 0.5}, {1.0, 0.5}}, 2.0, 1.0, f.data());
  EXPECT_NEAR(f[0], (4 + 9) / 2.0, 1e-15);
  EXPECT_NEAR(f[1], (4 + 9) + 3, 1e-15);
}

TEST(LoadsSerialTest, ForcesAreSumsOfHistoriesTimesTheirForces) {
  Loads loads(2);
  loads.add({1, 2}, expression("t", "", ""));
  loads.add({10, 0}, constant(3));
  std::vector<double> f{100, 200};
  loads.add_force(2.0, 0.5, f.data());
  EXPECT_EQ(f, (std::vector<double>{100 + 0.5 * (2 + 30), 200 + 0.5 * 4}));
}

TEST(LoadsSerialTest, ForcesCanBeReplaced) {
  Loads loads(2);
  EXPECT_EQ(loads.add({1, 2}, constant(1)), 0);
  EXPECT_EQ(loads.add({10, 20}, constant(2)), 1);
  loads.replace(1, {3, 4});
  std::vector<double> f(2, 0.0);
  loads.add_force(0.0, 1.0, f.data());
  EXPECT_EQ(f, (std::vector<double>{1 + 6, 2 + 8}));
  EXPECT_THROW(loads.replace(2, {0, 0}), std::out_of_range);
  EXPECT_EQ(loads.forces(1), (std::vector<double>{3, 4}));
  EXPECT_THROW(loads.forces(2), std::out_of_range);
}

TEST(LoadsSerialTest, ForcesThatFitNoLocalArrayAreRefused) {
  Loads loads(2);
  EXPECT_EQ(test::refusal([&] {
              loads.add({1, 2, 3}, constant(1));
            }),
            "a load has 3 forces; the rank has 2 degrees of freedom, ghosts included");
  EXPECT_EQ(test::refusal([&] { loads.add({1, 2}, nullptr); }), "a load has no function of time; constant(1) is one");
  EXPECT_TRUE(loads.empty());
  loads.add({1, 2}, constant(1));
  EXPECT_NE(test::refusal([&] { loads.replace(0, {1}); }), "");
  EXPECT_EQ(loads.forces(0), (std::vector<double>{1, 2}));
  loads.close();
  EXPECT_THROW(loads.add({1, 2}, constant(1)), std::logic_error);
  loads.replace(0, {3, 4});
  EXPECT_EQ(loads.forces(0), (std::vector<double>{3, 4}));
}

// A free plate under equal forces on all its degrees of freedom, which change before every step.
TEST(LoadsTest, ReplacedForcesGiveTheirImpulseAndTheirWork) {
  BoxShape shape;
  shape.lengths = {3, 2, 0};
  shape.divisions = {6, 4, 1};
  const auto model = test::model_of(box(shape), test::elastic(linear_elastic, 0.2), Inertia::Consistent);
  const double nodes = static_cast<double>(model->space().global()) / 2, dt = 0.1;
  const std::size_t pull = model->loads().add(test::at_rest(*model), constant(1));
  Integrator integrator = test::direct(*model, average_vector_field(4, 8));
  integrator.initialize(test::at_rest(*model), test::at_rest(*model), 0.0);
  double impulse = 0;
  for (const double force : {0.01, -0.03, 0.0, 0.05}) {
    model->loads().replace(pull, std::vector<double>(test::at_rest(*model).size(), force));
    ASSERT_TRUE(integrator.step(dt).converged);
    impulse += dt * nodes * force;
    const State& state = integrator.state();
    const Momenta momenta = StateReport(*model, state).momenta();
    for (int i = 0; i < 2; ++i) EXPECT_NEAR(momenta.linear[static_cast<std::size_t>(i)], impulse, 1e-12);
    EXPECT_NEAR(integrator.external_work(), momenta.kinetic_energy + StateReport(*model, state).energy(Part::Elastic),
                1e-12);
  }
}

TEST(LoadsSerialTest, AnUndefinedHistoryIsNotFinite) {
  Loads loads(1);
  EXPECT_TRUE(loads.are_finite(1.0));
  loads.add({1}, constant(1));
  loads.add({1}, expression("1/(t-1)", "", ""));
  EXPECT_TRUE(loads.are_finite(2.0));
  EXPECT_FALSE(loads.are_finite(1.0));
}

}  // namespace
}  // namespace ixos
