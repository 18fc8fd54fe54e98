#include "base/symmetric_tensor.hpp"

#include <Teuchos_LAPACK.hpp>
#include <algorithm>
#include <cmath>
#include <limits>

namespace ixos {

double von_mises(const SymmetricTensor& stress) {
  const auto [xx, yy, zz, xy, yz, zx] = stress;
  // Differences of normal stresses: a large pressure leaves no rounding behind.
  const double normal = (xx - yy) * (xx - yy) + (yy - zz) * (yy - zz) + (zz - xx) * (zz - xx);
  return std::sqrt(0.5 * normal + 3 * (xy * xy + yz * yz + zx * zx));
}

std::array<double, 3> principal_values(const SymmetricTensor& stress) {
  std::array<double, 3> values;
  values.fill(std::numeric_limits<double>::quiet_NaN());
  if (!std::all_of(stress.begin(), stress.end(), [](double component) { return std::isfinite(component); }))
    return values;
  const auto [xx, yy, zz, xy, yz, zx] = stress;
  std::array<double, 9> matrix{xx, xy, zx, xy, yy, yz, zx, yz, zz};
  std::array<double, 16> work;
  int info = 0;
  Teuchos::LAPACK<int, double>().SYEV('N', 'U', 3, matrix.data(), 3, values.data(), work.data(),
                                      static_cast<int>(work.size()), &info);
  std::reverse(values.begin(), values.end());
  return values;
}

}  // namespace ixos
