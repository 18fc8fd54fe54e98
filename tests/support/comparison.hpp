/// Reading states in tests.
#pragma once
#include <vector>

#include "model/model.hpp"
#include "scene/simulation.hpp"

namespace ixos::test {

/// A local array's owned values, gathered on every rank in the node order of the undistributed mesh. Collective.
std::vector<double> gathered(const Model& model, const std::vector<double>& local);

/// Kinetic, elastic and interaction energy of the present state. Collective.
double total_energy(const Simulation& simulation);

/// The largest |a_i - b_i|.
double distance(const std::vector<double>& a, const std::vector<double>& b);

}  // namespace ixos::test
