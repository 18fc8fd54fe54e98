#include "geometry/patch_points.hpp"

#include "fem/quadrature.hpp"

namespace ixos {

template <>
std::vector<PatchPoint<2>> patch_points<2>(int along) {
  const Quadrature gauss = gauss_legendre_unit(along);
  std::vector<PatchPoint<2>> result;
  for (std::size_t q = 0; q < gauss.points.size(); ++q) result.push_back({{gauss.points[q]}, gauss.weights[q]});
  return result;
}

template <>
std::vector<PatchPoint<3>> patch_points<3>(int along) {
  const Quadrature gauss = gauss_legendre_unit(along);
  std::vector<PatchPoint<3>> result;
  for (std::size_t j = 0; j < gauss.points.size(); ++j)
    for (std::size_t i = 0; i < gauss.points.size(); ++i)
      result.push_back({{gauss.points[i], gauss.points[j]}, gauss.weights[i] * gauss.weights[j]});
  return result;
}

}  // namespace ixos
