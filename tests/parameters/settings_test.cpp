#include "parameters/settings.hpp"

#include <gtest/gtest.h>

#include <Teuchos_Array.hpp>
#include <cmath>

#include "interaction/catalogue.hpp"
#include "interaction/gap_law.hpp"
#include "interaction/obstacle.hpp"
#include "material/catalogue.hpp"
#include "material/elastic_law.hpp"
#include "support/refusal.hpp"

namespace ixos {
namespace {

using test::expect_contains;
using test::refusal;

TEST(SettingsTest, ValuesKeepTheirTypes) {
  Teuchos::ParameterList list;
  set(list, {{"number", 2.5},
             {"count", 3},
             {"word", "Hamaker"},
             {"point", {0.0, -1.0}},
             {"whole", {0, 1}},
             {"choice", true}});
  EXPECT_EQ(list.get<double>("number"), 2.5);
  EXPECT_EQ(list.get<int>("count"), 3);
  EXPECT_TRUE(list.get<bool>("choice"));
  EXPECT_EQ(list.get<std::string>("word"), "Hamaker");
  EXPECT_EQ(list.get<Teuchos::Array<double>>("point").toVector(), (std::vector<double>{0, -1}));
  EXPECT_EQ(list.get<Teuchos::Array<double>>("whole").toVector(), (std::vector<double>{0, 1}));
}

TEST(SettingsTest, LawsAreMadeFromThem) {
  const Lame lame = make_elastic_law("Linear Elastic", {{"Young's Modulus", 3}, {"Poisson's Ratio", 0.25}})->lame();
  EXPECT_NEAR(lame.mu, 1.2, 1e-15);
  EXPECT_NEAR(lame.lambda, 1.2, 1e-15);
  EXPECT_NEAR(youngs_modulus(make_elastic_law("Neo-Hooke")->lame()), 1, 1e-15);  // the default

  EXPECT_NEAR(make_gap_law("Van der Waals", {{"Gamma L", 2.0}})->adhesion_gap(), std::pow(5.0, -1.0 / 6) / 2, 1e-15);
  EXPECT_NEAR(
      make_gap_law("Van der Waals", {{"Constants", "Hamaker"}, {"Hamaker Constant", 0.1}, {"Length Scale", 0.5}})
          ->equilibrium_gap(),
      std::pow(15.0, -1.0 / 6) / 2, 1e-15);
  EXPECT_EQ(make_gap_law("Morse", {{"Equilibrium Gap", 0.3}})->equilibrium_gap(), 0.3);  // of a list of its own

  const HalfSpace wall =
      *make_obstacle("Half-Space", 2, {{"Point", {1.0, -2.0}}, {"Normal", {0.0, 3.0}}})->half_space();
  EXPECT_EQ(wall.point, (std::array<double, 3>{1, -2, 0}));
  EXPECT_EQ(wall.normal, (std::array<double, 3>{0, 1, 0}));
  EXPECT_EQ(make_obstacle("Sphere", 3, {{"Radius", 2.0}})->half_space(), nullptr);
}

TEST(SettingsTest, WrongOnesAreRefusedAsInScenes) {
  const std::string unknown = refusal([] { make_elastic_law("Neo-Hook"); });
  expect_contains(unknown, "elastic law \"Neo-Hook\": ");
  expect_contains(unknown, "did you mean \"Neo-Hooke\"?");
  const std::string name = refusal([] { make_elastic_law("Neo-Hooke", {{"Young Modulus", 1.0}}); });
  expect_contains(name, "elastic law \"Neo-Hooke\": Young Modulus: there is no parameter");
  expect_contains(name, "did you mean \"Young's Modulus\"?");
  const std::string range = refusal([] { make_elastic_law("Neo-Hooke", {{"Poisson's Ratio", 0.5}}); });
  expect_contains(range, "elastic law \"Neo-Hooke\": Poisson's Ratio: 0.5");
  expect_contains(refusal([] { make_gap_law("Van der Waals", {{"Gamma L", "large"}}); }), "must be of type double");
  expect_contains(refusal([] { make_gap_law("Van der Waals", {{"Work of Adhesion", 1.0}}); }), "belongs to Constants");
  expect_contains(refusal([] { make_obstacle("Sphere", 2); }), "obstacle \"Sphere\": Sphere/Radius is missing");
  expect_contains(refusal([] {
                    make_obstacle("Half-Space", 2, {{"Point", {0.0, 0.0, 0.0}}});
                  }),
                  "obstacle \"Half-Space\": Point has 3 elements, not 2");
}

}  // namespace
}  // namespace ixos
