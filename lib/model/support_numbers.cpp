#include "model/support_numbers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"

namespace ixos {

std::vector<double> support_numbers(const char* what, std::vector<double> values, const LocalMesh& mesh) {
  const int dimension = mesh.dimension;
  if (values.empty()) return values;
  if (values.size() != static_cast<std::size_t>(dimension))
    throw InputError(
        fmt::format("the {} has {} components, but the mesh has {} dimensions", what, values.size(), dimension));
  for (const double value : values)
    if (!(value >= 0 && std::isfinite(value)))
      throw InputError(fmt::format("the {} has the component {}; each must be finite and at least 0", what, value));
  if (mesh.axisymmetric && values[0] != 0)
    throw InputError(fmt::format(
        "the {} has the radial component {}; on an axisymmetric mesh it acts along y only: use 0", what, values[0]));
  if (std::all_of(values.begin(), values.end(), [](double value) { return value == 0; })) values.clear();
  return values;
}

}  // namespace ixos
