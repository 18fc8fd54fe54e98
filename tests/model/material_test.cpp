#include "model/material.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "material/lame.hpp"
#include "support/refusal.hpp"

namespace ixos {
namespace {

std::string message(const std::function<void(Material&)>& spoil, bool inertia = true) {
  Material material;
  material.block = "pad";
  material.law = linear_elastic(lame_constants(1, 0.2));
  material.density = 2;
  spoil(material);
  return test::refusal([&] { check_material(material, inertia); });
}

TEST(MaterialSerialTest, ValuesOutOfRangeAreRefused) {
  EXPECT_EQ(message([](Material&) {}), "");
  EXPECT_EQ(message([](Material& m) { m.density = 0; }, false), "");
  EXPECT_EQ(message([](Material& m) { m.density = 0; }),
            "the material of block \"pad\" is not allowed: Density 0 must be greater than 0 and finite");
  test::expect_contains(message([](Material& m) { m.density = INFINITY; }), "Density inf");
  test::expect_contains(message([](Material& m) { m.law = nullptr; }),
                        "block \"pad\" is not allowed: Model is missing");
  test::expect_contains(message([](Material& m) { m.mass_damping = -1; }), "Mass Damping -1 must be at least 0");
  test::expect_contains(message([](Material& m) { m.stiffness_damping = NAN; }), "Stiffness Damping nan");
  test::expect_contains(message([](Material& m) { m.viscosity = -2; }), "Viscosity -2");
  test::expect_contains(message([](Material& m) { m.points = 11; }), "Quadrature Points 11");
  test::expect_contains(message([](Material& m) { m.points = 1, m.formulation = Formulation::Enhanced; }),
                        "Quadrature Points 1 is too few for \"Enhanced\" elements");
  test::expect_contains(message([](Material& m) { m.viscosity = 1, m.formulation = Formulation::MeanDilatation; }),
                        "Viscosity 1 is not there for elements other than \"Standard\"");
}

}  // namespace
}  // namespace ixos
