#include "interaction/direction.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/error.hpp"

namespace ixos {

std::array<double, 3> unit_vector(const SceneNode& node, const std::string& entry, std::size_t dimension,
                                  const std::array<double, 3>& fallback, const std::string& meaning) {
  const auto given = node.numbers(entry, dimension, {fallback.begin(), fallback.begin() + dimension});
  double largest = 0;
  for (double n : given) largest = std::max(largest, std::abs(n));
  if (!(largest > 0)) throw InputError(node.path_of(entry) + " is zero: " + meaning);
  double square = 0;
  for (double n : given) square += n / largest * (n / largest);
  std::array<double, 3> result{};
  for (std::size_t d = 0; d < dimension; ++d) result[d] = given[d] / largest / std::sqrt(square);
  return result;
}

std::array<double, 3> place_of(const SceneNode& node, const std::string& entry, std::size_t dimension) {
  const auto given = node.numbers(entry, dimension, std::vector<double>(dimension, 0.0));
  std::array<double, 3> result{};
  std::copy(given.begin(), given.end(), result.begin());
  return result;
}

std::array<double, 3> last_axis(std::size_t dimension) {
  std::array<double, 3> result{};
  result[dimension - 1] = 1;
  return result;
}

}  // namespace ixos
