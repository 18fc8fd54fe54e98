#include "model/material.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

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
            "the material of block \"pad\" has the density 0; it must be greater than 0 and finite");
  test::expect_contains(message([](Material& m) { m.density = INFINITY; }), "density inf");
  test::expect_contains(message([](Material& m) { m.law = nullptr; }), "block \"pad\" has no elastic law");
  test::expect_contains(message([](Material& m) { m.mass_damping = -1; }), "mass damping -1; it must be at least 0");
  test::expect_contains(message([](Material& m) { m.stiffness_damping = NAN; }), "stiffness damping nan");
  test::expect_contains(message([](Material& m) { m.viscosity = -2; }), "viscosity -2");
  test::expect_contains(message([](Material& m) { m.points = 11; }), "11 Gauss points");
  test::expect_contains(message([](Material& m) { m.points = 1, m.formulation = Formulation::Enhanced; }),
                        "1 Gauss point a direction, which is too few for Enhanced elements");
}

}  // namespace
}  // namespace ixos
