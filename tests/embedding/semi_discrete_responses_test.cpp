// Responses, against closed forms and against what a model reports.
#include "embedding/semi_discrete_responses.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "mesh/generators/shapes.hpp"
#include "model/grips.hpp"
#include "solve/semi_discrete_bodies.hpp"
#include "support/solids.hpp"

namespace ixos {
namespace {

std::vector<double> values(const SemiDiscreteResponses& responses, Response response, SemiDiscreteBalance& balance) {
  const int j = static_cast<int>(response);
  Vector g(Extract::getTpetraMap(responses.space(j)));
  responses.evaluate(j, balance, g);
  const auto view = g.getLocalViewHost(Tpetra::Access::ReadOnly);
  return {view.data(), view.data() + view.extent(0)};
}

TEST(SemiDiscreteResponsesTest, NamesAreColumnsOfTheHistory) {
  const auto plane = test::held_block(2), solid = test::held_block(3);
  const SemiDiscreteResponses responses(plane->model(), {"left"}), spatial(solid->model(), {});
  EXPECT_EQ(responses.count(), 4);
  EXPECT_EQ(spatial.count(), 3);
  EXPECT_EQ(responses.names(0), (std::vector<std::string>{"kinetic_energy", "elastic_energy", "contact_energy"}));
  EXPECT_EQ(responses.names(1),
            (std::vector<std::string>{"linear_momentum_x", "linear_momentum_y", "angular_momentum_z"}));
  EXPECT_EQ(responses.names(2),
            (std::vector<std::string>{"contact_force_x", "contact_force_y", "contact_measure", "min_gap"}));
  EXPECT_EQ(responses.names(3), (std::vector<std::string>{"reaction_left_x", "reaction_left_y"}));
  EXPECT_EQ(spatial.names(1).size(), 6U);
  EXPECT_EQ(spatial.names(2).size(), 5U);
  for (int j = 0; j < responses.count(); ++j)
    EXPECT_EQ(static_cast<std::size_t>(responses.space(j)->dim()), responses.names(j).size());
}

TEST(SemiDiscreteResponsesTest, ARigidMotionHasItsClosedForms) {
  const auto s = test::held_block(2);
  const Model& model = s->model();
  const double mass = 0.7 * 8;
  const Vector u = test::uniform(model, 0.25, 1), v = test::uniform(model, 3, 0);
  SemiDiscreteBalance balance(model);
  balance.set({&u, &v, nullptr, 0.0});
  const SemiDiscreteResponses responses(model, {});
  const auto energies = values(responses, Response::Energies, balance);
  EXPECT_NEAR(energies[0], mass * 9 / 2, 1e-11);
  EXPECT_NEAR(energies[1], 0, 1e-13);
  const auto momenta = values(responses, Response::Momenta, balance);
  EXPECT_NEAR(momenta[0], 3 * mass, 1e-11);
  EXPECT_NEAR(momenta[1], 0, 1e-12);
  EXPECT_NEAR(momenta[2], -3 * mass * (1 + 0.25), 1e-11);  // -v_x m y of the centre
  const auto interaction = values(responses, Response::Interaction, balance);
  EXPECT_NEAR(interaction[3], 0.5 + 0.25, 1e-13);
  EXPECT_NEAR(interaction[0], 0, 1e-14);
  // The wall's pull on 4 L0 at one gap is minus the derivative of its energy by that gap.
  const double h = 1e-5;
  double slope = 0;
  for (const double sign : {1.0, -1.0}) {
    const Vector moved = test::uniform(model, 0.25 + sign * h, 1);
    balance.set({&moved, nullptr, nullptr, 0.0});
    slope += sign * values(responses, Response::Energies, balance)[2] / (2 * h);
  }
  EXPECT_NEAR(interaction[1], -slope, 1e-8 * std::abs(slope));
}

// A body at rest, held by springs whose ends are 0.3 away in x.
TEST(SemiDiscreteResponsesTest, StretchedSpringsStoreElasticEnergy) {
  BoxShape shape;
  shape.lengths = {3, 2, 0};
  shape.divisions = {6, 4, 1};
  const auto model = test::model_of(box(shape), test::elastic(neo_hooke, 0.2), Inertia::Consistent);
  RigidMotionOptions options;
  options.translation = {rate_ramp(0.1, 0.0, 0.0, RampShape::Linear), nullptr};  // 0.1 t
  grip_elastically(*model, "Machine", "left", {2, options}, {{4, 0}, {}});
  const Vector u = test::uniform(*model, 0.1, 0);
  const SemiDiscreteEvaluator evaluator(*model);
  auto out = evaluator.createOutArgs();
  const auto energies = Thyra::createMember(evaluator.get_g_space(0));
  const auto gradient = Thyra::createMembers(evaluator.get_x_space(), 3);
  out.set_g(0, energies);
  out.set_DgDx(
      0, Thyra::ModelEvaluatorBase::Derivative<double>(gradient, Thyra::ModelEvaluatorBase::DERIV_MV_GRADIENT_FORM));
  evaluator.evalModel(test::arguments(evaluator, u, test::uniform(*model, 0, 0), test::uniform(*model, 0, 0), 3.0),
                      out);
  EXPECT_NEAR(Thyra::get_ele(*energies, 1), 4 * 0.2 * 0.2 / 2, 1e-14);
  EXPECT_NEAR(Thyra::sum(*gradient->col(1)), -4 * 0.2, 1e-13);
}

// A bar of linear elasticity without lateral contraction, stretched by 1 %: the held side bears E times strain times
// its height, and a uniform acceleration adds the inertia of the held nodes.
TEST(SemiDiscreteResponsesTest, ReactionsOfAStretchedBarAreItsStressTimesItsSection) {
  const std::string bar =
      test::list("Mesh", test::word("Type", "Box") +
                             test::list("Box", test::numbers("Lengths", {4, 2}) + test::counts("Divisions", {6, 3}))) +
      test::list("Materials",
                 test::list("Rubber", test::word("Model", "Linear Elastic") + test::number("Young's Modulus", 5) +
                                          test::number("Poisson's Ratio", 0) + test::number("Density", 0.7))) +
      test::list("Boundary Conditions",
                 test::list("Left", test::word("Node Set", "left")) +
                     test::list("Right", test::word("Node Set", "right") + test::word("Components", "x"))) +
      test::time_integrator("Newmark", 0.1, 1);
  const Simulation s(test::scene(bar), test::world());
  const Model& model = s.model();
  Vector u(model.space().owned_map());
  {
    const auto view = u.getLocalViewHost(Tpetra::Access::OverwriteAll);
    for (std::size_t i = 0; i < view.extent(0); ++i) view(i, 0) = i % 2 == 0 ? 0.01 * model.mesh().coordinates[i] : 0.0;
  }
  const SemiDiscreteResponses responses(model, {"left", "right"});
  SemiDiscreteBalance balance(model);
  balance.set({&u, nullptr, nullptr, 0.0});
  const auto stretched = values(responses, Response::Reactions, balance);
  EXPECT_NEAR(stretched[0], -5 * 0.01 * 2, 1e-13);
  EXPECT_NEAR(stretched[2], 5 * 0.01 * 2, 1e-13);
  EXPECT_NEAR(stretched[1], 0, 1e-14);
  EXPECT_NEAR(values(responses, Response::Energies, balance)[1], 0.5 * 5 * 1e-4 * 8, 1e-14);
  EXPECT_TRUE(std::isinf(values(responses, Response::Interaction, balance)[3]));
  // All nodes alike: half an element's mass belongs to each side.
  const Vector a = test::uniform(model, 3, 0);
  balance.set({&u, nullptr, &a, 0.0});
  const double end_mass = 0.7 * 2 * 4 / 6.0 / 2;
  EXPECT_NEAR(values(responses, Response::Reactions, balance)[0], stretched[0] + 3 * end_mass, 1e-13);
}

TEST(SemiDiscreteResponsesTest, SetsWithoutReactionsAreRefused) {
  const auto s = test::held_block(2);
  EXPECT_THROW(SemiDiscreteResponses(s->model(), {"lfet"}), InputError);
  try {
    const SemiDiscreteResponses responses(s->model(), {"right"});
    ADD_FAILURE() << "the set \"right\" is free";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("\"right\""), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace ixos
