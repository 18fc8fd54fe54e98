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

/// A quadrilateral on rollers that vibrates vertically: a linear oscillator. Its circular frequency is that of
/// oscillator_frequency().
std::string oscillator();
double oscillator_frequency();

/// The names of all schemes that move a body: the whole catalogue but "Static".
std::vector<std::string> moving_schemes();

}  // namespace ixos::test
