/// Bodies for tests: scenes as parameter lists.
#pragma once
#include <Teuchos_ParameterList.hpp>
#include <string>
#include <vector>

namespace ixos::test {

/// A free rubber block of 3 x 2 quadrilaterals, 3 by 2 L0, density 1, E = 1, nu = 0.3, that translates, spins (`spin`
/// in 1/T0) and stretches: smooth, strongly nonlinear motion on the time scale 1.
std::string block_2d(double spin, const std::string& material = "Neo-Hooke");

/// The same in three dimensions, 2 x 1 x 1 hexahedra, spinning about all axes.
std::string block_3d(double spin);

/// The choices of a scene with an adhesive block.
struct Adhesion {
  std::string law = "Van der Waals";
  std::string obstacle = "Half-Space";
  std::string model = "Neo-Hooke";
};

/// A block of 2 by 1 L0 (and 1 deep), density 1, that moves down, and a little to the right, to an obstacle half an L0
/// below it: a wall, or a sphere of radius 3. It meets the obstacle before t = 1. `wall`: more entries of the
/// interaction, whose list is "Wall".
std::string adhesive_block(int dimension, const Adhesion& adhesion, const std::string& wall = "");

/// All combinations of laws, obstacles and nonlinear elastic laws.
std::vector<Adhesion> adhesions();

/// A quadrilateral on rollers that vibrates vertically: a linear oscillator. Its circular frequency is that of
/// oscillator_frequency().
std::string oscillator();
double oscillator_frequency();

/// The names of all schemes that move a body: the whole catalogue but "Static".
std::vector<std::string> moving_schemes();

}  // namespace ixos::test
