/// Laws as kernels see them.
#pragma once
#include <cstddef>
#include <limits>
#include <vector>

#include "material/elastic_law.hpp"
#include "material/law_points.hpp"

namespace ixos {

/// Returns the loops over points of a material, which must outlive them.
template <class Space, class Law>
LawPoints<Law, Space> law_in(const Law& law) {
  return LawPoints<Law, Space>(law);
}
template <class Space>
const PointLaw<Space>& law_in(const AnyLaw<Space>& law) {
  return law.points();
}

/// Returns the energy of what the law sees at a kernel's points [E0 L0^D]; NaN in lanes where it sees nothing.
template <class Kernel, class Material, class Geometry, class T, std::size_t N, std::size_t D>
T energy_of(const Material& material, const Geometry& geometry, const Small<T, N, D>& u) {
  std::vector<Small<T, Kernel::G>> h;
  const T found = Kernel::seen(material, geometry, u, h);
  std::vector<T> w(h.size());
  law_in<typename Kernel::Space>(material).energy(h.size(), h.data(), w.data());
  T sum(0.0);
  for (std::size_t q = 0; q < w.size(); ++q) sum += geometry.points[q].weight * w[q];
  return select(found > 0.0, sum, T(std::numeric_limits<double>::quiet_NaN()));
}

/// Returns the least admissibility of what the law sees at a kernel's points; at most 0 in lanes where it sees nothing.
template <class Kernel, class Material, class Geometry, class T, std::size_t N, std::size_t D>
T admissibility_of(const Material& material, const Geometry& geometry, const Small<T, N, D>& u) {
  std::vector<Small<T, Kernel::G>> h;
  const T found = Kernel::seen(material, geometry, u, h);
  const auto& law = law_in<typename Kernel::Space>(material);
  T result(1e300);
  for (const auto& own : h) result = smaller(result, law.admissibility(own));
  return select(found > 0.0, result, smaller(result, T(0.0)));
}

}  // namespace ixos
