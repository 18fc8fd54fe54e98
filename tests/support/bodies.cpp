#include "support/bodies.hpp"

#include <cmath>

#include "support/scene_text.hpp"
#include "time/catalogue.hpp"

namespace ixos::test {
namespace {

std::string rubber(const std::string& model, double nu) {
  return list("Materials", list("Rubber", word("Model", model) + number("Young's Modulus", 1) +
                                              number("Poisson's Ratio", nu) + number("Density", 1)));
}

}  // namespace

std::string block_2d(double spin, const std::string& material) {
  return list("Mesh", word("Type", "Box") + list("Box", numbers("Lengths", {3, 2}) + counts("Divisions", {3, 2}))) +
         rubber(material, 0.3) +
         list("Initial Conditions", numbers("Velocity", {0.3, -0.2}) +
                                        numbers("Velocity Gradient", {0.15, -spin, spin, -0.05}) +
                                        numbers("Origin", {1.5, 1.0}));
}

std::string block_3d(double spin) {
  return list("Mesh", word("Type", "Box") + list("Box", count("Dimension", 3) + numbers("Lengths", {2, 1, 1}) +
                                                            counts("Divisions", {2, 1, 1}))) +
         rubber("Neo-Hooke", 0.3) +
         list("Initial Conditions", numbers("Velocity", {0.3, -0.2, 0.1}) +
                                        numbers("Velocity Gradient", {0.1, -spin, 0.5 * spin, spin, 0.0, -0.3 * spin,
                                                                      -0.5 * spin, 0.3 * spin, -0.1}) +
                                        numbers("Origin", {1.0, 0.5, 0.5}));
}

std::string adhesive_block(int dimension, const Adhesion& adhesion, const std::string& wall) {
  const bool plane = dimension == 2, sphere = adhesion.obstacle == "Sphere";
  const std::string box = plane
                              ? numbers("Lengths", {2, 1}) + counts("Divisions", {6, 3})
                              : count("Dimension", 3) + numbers("Lengths", {2, 1, 1}) + counts("Divisions", {3, 2, 2});
  const std::string below = plane ? numbers("Point", {0, -0.5}) : numbers("Point", {0, 0, -0.5});
  const std::string center = plane ? numbers("Center", {0.8, -3.5}) : numbers("Center", {0.8, 0.4, -3.5});
  return list("Mesh", word("Type", "Box") + list("Box", box)) +
         list("Materials", list("Rubber", number("Density", 1) + word("Model", adhesion.model))) +
         list(
             "Interactions",
             list("Wall", word("Side Set", "bottom") + word("Law", adhesion.law) + word("Obstacle", adhesion.obstacle) +
                              (sphere ? list("Sphere", number("Radius", 3) + center) : below) + wall)) +
         list("Initial Conditions", plane ? numbers("Velocity", {0.05, -0.5}) : numbers("Velocity", {0.05, 0, -0.5}));
}

std::vector<Adhesion> adhesions() {
  std::vector<Adhesion> result;
  for (const char* law : {"Van der Waals", "Morse"})
    for (const char* obstacle : {"Half-Space", "Sphere"})
      for (const char* model : {"Neo-Hooke", "Saint Venant-Kirchhoff"}) result.push_back({law, obstacle, model});
  return result;
}

std::string oscillator() {
  return list("Mesh", word("Type", "Box") + list("Box", numbers("Lengths", {1, 1}) + counts("Divisions", {1, 1}))) +
         rubber("Linear Elastic", 0) +
         list("Boundary Conditions", list("Base", word("Node Set", "bottom")) +
                                         list("Rollers", word("Node Set", "top") + word("Components", "x"))) +
         list("Initial Conditions", numbers("Velocity Gradient", {0, 0, 0, 1}));
}

// The top edge moves as one: u = U(t) y, energy E U^2/2 (nu = 0), kinetic energy rho U'^2/6.
double oscillator_frequency() { return std::sqrt(3.0); }

std::vector<std::string> moving_schemes() {
  std::vector<std::string> names;
  for (const Scheme& scheme : schemes())
    if (scheme.name != "Static") names.push_back(scheme.name);
  return names;
}

}  // namespace ixos::test
