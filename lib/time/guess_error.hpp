/// The distance of a guess of Newton's iteration from the solution.
#pragma once
#include <vector>

#include "model/model.hpp"

namespace ixos {

/// Returns the largest difference of the error guess - u between two nodes of a cell of this rank, over their distance:
/// a strain or a rotation. A rigid translation is no error: Newton's first iteration makes it good exactly. Both arrays
/// are local.
double guess_error(const Model& model, const std::vector<double>& guess, const std::vector<double>& u);

}  // namespace ixos
