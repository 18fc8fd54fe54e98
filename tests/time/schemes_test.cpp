// Every parameter of every scheme changes its table's coefficients as the literature's formulas say.
#include "time/schemes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "base/error.hpp"
#include "fem/quadrature.hpp"
#include "mesh/generators/shapes.hpp"
#include "parameters/validation.hpp"
#include "scene/simulation.hpp"
#include "support/bodies.hpp"
#include "support/scene_text.hpp"
#include "support/solids.hpp"
#include "time/catalogue.hpp"
#include "time/stage_problem.hpp"

namespace ixos {
namespace {

void expect_row(const Row& row, double s, double u0, double v0, double a0, const std::string& what) {
  EXPECT_NEAR(row.unknown, s, 1e-13 * (1 + std::abs(s))) << what;
  const Row::Known known = row.known.empty() ? Row::Known{} : row.known[0];
  EXPECT_NEAR(known.u, u0, 1e-13 * (1 + std::abs(u0))) << what;
  EXPECT_NEAR(known.v, v0, 1e-13 * (1 + std::abs(v0))) << what;
  EXPECT_NEAR(known.a, a0, 1e-13 * (1 + std::abs(a0))) << what;
}

/// The table that a scene's list for this scheme makes.
Table from_xml(const std::string& name, const std::string& parameters) {
  const Scheme& chosen = scheme(name);
  return chosen.table(validated(test::scene(parameters), chosen.parameters));
}

TEST(SchemesSerialTest, NewmarkFollowsBetaAndGamma) {
  for (const auto& [beta, gamma] : {std::pair{0.25, 0.5}, std::pair{0.3, 0.6}, std::pair{1.0 / 6, 0.5}}) {
    const Table table = from_xml("Newmark", test::number("Beta", beta) + test::number("Gamma", gamma));
    const Stage& stage = table.stages.at(0);
    expect_row(stage.velocity, gamma / beta, -gamma / beta, 1 - gamma / beta, 1 - gamma / (2 * beta), "velocity");
    expect_row(stage.acceleration, 1 / beta, -1 / beta, -1 / beta, -(1 / (2 * beta) - 1), "acceleration");
    expect_row(stage.inertia, 1 / beta, -1 / beta, -1 / beta, -(1 / (2 * beta) - 1), "inertia");
  }
}

TEST(SchemesSerialTest, CompositeFollowsBetaGammaPointsAndPath) {
  for (const auto& [beta, gamma] : {std::pair{0.25, 0.5}, std::pair{0.3, 0.7}}) {
    const Table table = from_xml("Gautam-Sauer Composite", test::number("Beta", beta) + test::number("Gamma", gamma) +
                                                               test::count("Interaction Points", 7));
    const Stage& stage = table.stages.at(0);
    // M (v - v_n) with v of Newmark.
    expect_row(stage.inertia, gamma / beta, -gamma / beta, -gamma / beta, 1 - gamma / (2 * beta), "inertia");
    expect_row(stage.damping, 1, -1, 0, 0, "damping");
    EXPECT_EQ(stage.elastic.kept_weight, 0.5);
    ASSERT_EQ(stage.elastic.points.size(), 1U);
    EXPECT_EQ(stage.elastic.points[0].weight, 0.5);
    ASSERT_EQ(stage.interaction.points.size(), 7U);
    const Quadrature gauss = gauss_legendre_unit(7);
    for (std::size_t i = 0; i < 7; ++i) {
      EXPECT_DOUBLE_EQ(stage.interaction.points[i].to, gauss.points[i]);
      EXPECT_DOUBLE_EQ(stage.interaction.points[i].weight, gauss.weights[i]);
    }
  }
  const Table kinematic = from_xml("Gautam-Sauer Composite", test::word("Path", "Kinematic"));
  const Quadrature gauss = gauss_legendre_unit(5);
  const double xi = gauss.points[1];
  EXPECT_DOUBLE_EQ(kinematic.stages[0].interaction.points[1].to, xi * xi);
  EXPECT_DOUBLE_EQ(kinematic.stages[0].interaction.points[1].velocity, xi * (1 - xi));
}

TEST(SchemesSerialTest, GeneralizedAlphaAndHhtFollowTheirParameter) {
  for (double rho : {0.0, 0.5, 0.8, 1.0}) {
    const Table table = from_xml("Generalized-Alpha", test::number("Spectral Radius", rho));
    const double a_m = (2 * rho - 1) / (rho + 1), a_f = rho / (rho + 1);
    const double gamma = 0.5 - a_m + a_f, beta = (1 - a_m + a_f) * (1 - a_m + a_f) / 4;
    const Stage& stage = table.stages.at(0);
    expect_row(stage.inertia, (1 - a_m) / beta, -(1 - a_m) / beta, -(1 - a_m) / beta,
               -(1 - a_m) * (1 / (2 * beta) - 1) + a_m, "inertia");
    expect_row(stage.damping, (1 - a_f) * gamma / beta, -(1 - a_f) * gamma / beta, (1 - a_f) * (1 - gamma / beta) + a_f,
               (1 - a_f) * (1 - gamma / (2 * beta)), "damping");
    EXPECT_DOUBLE_EQ(stage.elastic.kept_weight, a_f);
    EXPECT_DOUBLE_EQ(stage.elastic.points.at(0).weight, 1 - a_f);
  }
  for (double alpha : {-1.0 / 3, -0.1, 0.0}) {
    const Stage stage = from_xml("HHT-Alpha", test::number("Alpha", alpha)).stages.at(0);
    const double beta = (1 - alpha) * (1 - alpha) / 4, gamma = 0.5 - alpha;
    expect_row(stage.inertia, 1 / beta, -1 / beta, -1 / beta, -(1 / (2 * beta) - 1), "inertia");
    expect_row(stage.velocity, gamma / beta, -gamma / beta, 1 - gamma / beta, 1 - gamma / (2 * beta), "velocity");
    EXPECT_DOUBLE_EQ(stage.elastic.kept_weight, -alpha);
    EXPECT_DOUBLE_EQ(stage.load.at(1).weight, 1 + alpha);
  }
}

TEST(SchemesSerialTest, MidpointTakesForcesInTheMiddle) {
  const Stage stage = from_xml("Midpoint", "").stages.at(0);
  expect_row(stage.inertia, 2, -2, -2, 0, "inertia");
  ASSERT_EQ(stage.elastic.points.size(), 1U);
  EXPECT_EQ(stage.elastic.points[0].to, 0.5);
  EXPECT_EQ(stage.elastic.points[0].from, 0.5);
}

TEST(SchemesSerialTest, CentralDifferenceIsVelocityVerlet) {
  const Table table = from_xml("Central Difference", test::number("Safety", 0.7));
  EXPECT_EQ(table.safety, 0.7);
  EXPECT_TRUE(is_explicit(table));
  EXPECT_FALSE(is_explicit(from_xml("Newmark", "")));
  EXPECT_EQ(table.mass, Inertia::Lumped);
  // u = u_n + dt v_n + dt^2/2 a_n, a_n from the balance at the start; the damping takes v_n + dt a_n at the end.
  expect_row(table.stages.at(0).inertia, 2, -2, -2, 0, "inertia");
  expect_row(table.stages[0].velocity, 0, 0, 1, 1, "velocity");
  EXPECT_EQ(table.stages[0].elastic.kept_weight, 1);
  EXPECT_EQ(table.stages[0].load.at(0).time, 0);
  Table implicit = table;
  implicit.mass = Inertia::Consistent;
  EXPECT_THROW(check(implicit), std::invalid_argument) << "explicit tables have a lumped mass";
}

TEST(SchemesSerialTest, EnergyMomentumTakesDiscreteGradients) {
  const Table table = from_xml("Energy-Momentum", "");
  expect_row(table.stages.at(0).inertia, 2, -2, -2, 0, "inertia");
  EXPECT_EQ(table.stages[0].elastic.mean, Mean::DiscreteGradient);
  EXPECT_EQ(table.stages[0].interaction.mean, Mean::DiscreteGradient);
  const auto model = test::model_of(box(BoxShape{}), test::elastic(neo_hooke, 0.3), Inertia::Consistent);
  EXPECT_FALSE(is_symmetric(*model, table.stages[0]));
  EXPECT_TRUE(is_symmetric(*model, from_xml("Average Vector Field", "").stages[0]));
}

TEST(SchemesSerialTest, AverageVectorFieldFollowsItsPoints) {
  const Table table =
      from_xml("Average Vector Field", test::count("Elastic Points", 3) + test::count("Interaction Points", 6));
  EXPECT_EQ(table.stages[0].elastic.points.size(), 3U);
  EXPECT_EQ(table.stages[0].interaction.points.size(), 6U);
  expect_row(table.stages[0].inertia, 2, -2, -2, 0, "inertia");
}

TEST(SchemesSerialTest, BatheIsThePublishedFormula) {
  // Bathe 2007 at split 1/2: dt v = u_n - 4 u_h + 3 u, dt^2 a = dt v_n - 4 dt v_h + 3 dt v, for states that obey the
  // trapezoid of the first stage.
  const Table table = from_xml("Bathe Composite", "");
  const double u0 = 0.3, v0 = -0.7, a0 = 1.1, uh = 0.45, u = 0.9;  // dt = 1
  const double vh = 4 * (uh - u0) - v0;
  const double ah = 16 * (uh - u0) - 8 * v0 - a0;
  const auto value = [&](const Row& row, double unknown) {
    double sum = row.unknown * unknown;
    const double known[2][3] = {{u0, v0, a0}, {uh, vh, ah}};
    for (std::size_t j = 0; j < row.known.size(); ++j)
      sum += row.known[j].u * known[j][0] + row.known[j].v * known[j][1] + row.known[j].a * known[j][2];
    return sum;
  };
  EXPECT_NEAR(value(table.stages[0].velocity, uh), vh, 1e-13);
  EXPECT_NEAR(value(table.stages[0].acceleration, uh), ah, 1e-12);
  const double v = u0 - 4 * uh + 3 * u;
  EXPECT_NEAR(value(table.stages[1].velocity, u), v, 1e-13);
  EXPECT_NEAR(value(table.stages[1].acceleration, u), v0 - 4 * vh + 3 * v, 1e-12);
}

TEST(SchemesSerialTest, BatheFollowsSpectralRadiusAndSplit) {
  for (const auto& [rho, g] : {std::pair{0.5, 0.4}, std::pair{1.0, 0.5}, std::pair{0.0, 0.6}}) {
    const Table table = from_xml("Bathe Composite", test::number("Spectral Radius", rho) + test::number("Split", g));
    const double q1 = (rho + 1) / (2 * g * (rho - 1) + 4);
    const double q0 = (g - 1) * q1 + 0.5;
    const double q2 = 0.5 - g * q1;
    EXPECT_DOUBLE_EQ(table.stages[0].end, g);
    EXPECT_NEAR(table.stages[0].inertia.unknown, 4 / (g * g), 1e-12);
    EXPECT_NEAR(table.stages[0].damping.unknown, 2 / g, 1e-12);
    EXPECT_NEAR(table.stages[1].inertia.unknown, 1 / (q2 * q2), 1e-12);
    EXPECT_NEAR(table.stages[1].damping.unknown, 1 / q2, 1e-12);
    EXPECT_NEAR(table.stages[1].velocity.known[0].v, -q0 / q2, 1e-12);
    EXPECT_NEAR(table.stages[1].velocity.known[1].v, -q1 / q2, 1e-12);
  }
  // Split 0: equal tangents.
  const Table equal = from_xml("Bathe Composite", test::number("Spectral Radius", 0.5) + test::number("Split", 0));
  EXPECT_NEAR(equal.stages[0].inertia.unknown, equal.stages[1].inertia.unknown, 1e-11);
}

TEST(SchemesSerialTest, StagesWithLikeTangentsAreThoseWithinAFactorOfTwo) {
  const auto like = [](double split) {
    const Table table = bathe_composite(0, split);
    const double ratio = table.stages[0].inertia.unknown / table.stages[1].inertia.unknown;
    return std::pair{ratio, have_like_tangents(table.stages[0], table.stages[1])};
  };
  EXPECT_NEAR(like(0.5).first, 16.0 / 9, 1e-12);
  EXPECT_TRUE(like(0.5).second);
  EXPECT_TRUE(like(bathe_default_split(0)).second);
  EXPECT_GT(like(0.4).first, 2);
  EXPECT_FALSE(like(0.4).second);
  EXPECT_FALSE(like(0.8).second);
}

TEST(SchemesSerialTest, EveryTableIsConsistent) {
  for (const Scheme& candidate : schemes())
    EXPECT_NO_THROW(check(candidate.table(validated({}, candidate.parameters)))) << candidate.name;
  EXPECT_NO_THROW(check(bathe_composite(0.3, 0.7)));
  EXPECT_NO_THROW(check(newmark(0.4, 0.8)));
}

TEST(SchemesSerialTest, InconsistentTablesAreRefused) {
  Table table = newmark(0.25, 0.5);
  table.stages[0].velocity.unknown += 0.01;
  EXPECT_THROW(check(table), std::invalid_argument);
  table = average_vector_field(2, 2);
  table.stages[0].elastic.points[0].weight += 0.01;
  EXPECT_THROW(check(table), std::invalid_argument);
}

TEST(SchemesSerialTest, UnknownSchemeNamesTheNearest) {
  try {
    scheme("Newmrak");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("did you mean \"Newmark\""), std::string::npos);
  }
}

/// Newmark (1/4, 1/2) as a user would write it.
std::string trapezoid(const std::string& more = "", const std::vector<double>& velocity = {2, -2, -1, 0}) {
  return more + test::word("Work", "End Mean") +
         test::list("Stages", test::list("One", test::numbers("Velocity", velocity) +
                                                    test::numbers("Acceleration", {4, -4, -4, -1})));
}

TEST(CustomTableSerialTest, NewmarkWrittenDownIsNewmark) {
  const auto end = [](const std::string& scheme, const std::string& parameters) {
    Simulation s(test::scene(test::block_2d(1.0) + test::time_integrator(scheme, 0.05, 1, parameters)), test::world());
    for (int n = 0; n < 10; ++n) EXPECT_TRUE(s.integrator().step(0.05).converged);
    return s.integrator().state().u;
  };
  EXPECT_EQ(end("Custom", trapezoid()), end("Newmark", ""));
}

TEST(CustomTableSerialTest, TakesTheExactMeanAndAnErrorConstant) {
  const auto custom = [](const std::string& stage, const std::string& more) {
    return from_xml(
        "Custom",
        more + test::list("Stages", test::list("One", test::numbers("Velocity", {2, -2, -1, 0}) +
                                                          test::numbers("Acceleration", {4, -4, -4, -1}) + stage)));
  };
  const Table table = custom(test::word("Interaction Mean", "Exact"), test::number("Error Constant", 0.3));
  EXPECT_EQ(table.stages.at(0).interaction.mean, Mean::Exact);
  EXPECT_EQ(table.error_constant, 0.3);
  EXPECT_NO_THROW(check(table));
  EXPECT_EQ(custom("", "").stages.at(0).interaction.mean, Mean::Points);
  EXPECT_THROW(custom(test::word("Interaction Mean", "Exact") + test::word("Path", "Kinematic"), ""),
               std::invalid_argument);
}

TEST(CustomTableSerialTest, TablesOfNoUseAreRefused) {
  const auto refusal = [](const std::string& parameters) -> std::string {
    try {
      Simulation s(test::scene(test::block_2d(0) + test::time_integrator("Custom", 0.05, 1, parameters)),
                   test::world());
    } catch (const InputError& error) {
      return error.what();
    }
    return "accepted";
  };
  EXPECT_EQ(refusal(trapezoid()), "accepted");
  const auto contains = [](const std::string& text, const std::string& part) {
    EXPECT_NE(text.find(part), std::string::npos) << text;
  };
  contains(refusal(""), "Time Integrator/Custom: Stages is empty");
  contains(refusal(trapezoid("", {2, -2, -1.1, 0})), "the velocity row gives");
  contains(refusal(trapezoid("", {2, -2, -1})), "3 numbers; a row has one for the unknown");
  contains(refusal(trapezoid("", {2, -2, -1, 0, 0, 0, 0})), "at most 4");
  contains(refusal(trapezoid(test::numbers("Work Weights", {1.0}) + test::word("Closing", "Collocat"))),
           "did you mean \"Collocate\"?");
  const std::string stage = test::numbers("Velocity", {2, -2, -1, 0}) + test::numbers("Acceleration", {4, -4, -4, -1});
  contains(refusal(test::list("Stages", test::list("One", stage + test::numbers("Elastic Weights", {0.9})))),
           "weights sum to 0.9, not 1");
  contains(refusal(test::list("Stages", test::list("One", stage + test::numbers("Elastic Points", {0.5, 1})))),
           "1 weights for 2 points");
  contains(refusal(test::word("Work", "Stages") + test::list("Stages", test::list("One", stage))),
           "0 weights for the work of 1 stages");
}

}  // namespace
}  // namespace ixos
