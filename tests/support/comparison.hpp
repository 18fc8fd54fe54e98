/// Reading distributed states in tests.
#pragma once
#include <vector>

#include "model/model.hpp"

namespace ixos::test {

/// A local array's owned values, gathered on every rank in the node order of the undistributed mesh. Collective.
std::vector<double> gathered(const Model& model, const std::vector<double>& local);

/// The largest |a_i - b_i|.
double distance(const std::vector<double>& a, const std::vector<double>& b);

}  // namespace ixos::test
