/// Means over the reference volume of an element, for output.
#pragma once
#include <array>
#include <cstddef>
#include <vector>

#include "base/small_matrix.hpp"
#include "material/strain.hpp"

namespace ixos {

/// Returns the mean of value(point), an array of numbers, over points with these weights.
template <class T, class Value>
auto mean_over(std::size_t points, const T* weights, const Value& value) {
  auto sums = value(0);
  for (auto& sum : sums) sum *= weights[0];
  auto volume = weights[0];
  for (std::size_t q = 1; q < points; ++q) {
    const auto values = value(q);
    for (std::size_t i = 0; i < sums.size(); ++i) sums[i] += weights[q] * values[i];
    volume += weights[q];
  }
  for (auto& sum : sums) sum = sum / volume;
  return sums;
}

/// Returns tr(sigma) [E0], J and W [E0] of a displacement gradient. tr(sigma) = P:F/J, and in plane strain also the
/// stress out of the plane.
template <class Material, class T, std::size_t D>
std::array<T, 3> invariants(const Material& material, const Small<T, D>& h) {
  Small<T, D> p;
  const T jacobian = material.stress(h, p);
  T trace(0.0);
  for (std::size_t i = 0; i < D; ++i) {
    trace += p[i][i];
    for (std::size_t j = 0; j < D; ++j) trace += p[i][j] * h[i][j];
  }
  trace = trace / jacobian;
  if constexpr (D == 2) trace += material.out_of_plane_stress(h);
  return {trace, jacobian, material.energy(h)};
}

/// Returns the Cauchy stress J^-1 P F^T of a displacement gradient, xx, yy, zz, xy, yz, zx [E0]. Laws of small strains,
/// which are not `finite`, give it themselves.
template <class Material, class T, std::size_t D>
std::array<T, 6> cauchy_stress(const Material& material, const Small<T, D>& h, bool finite) {
  Small<T, D> p;
  const T jacobian = material.stress(h, p);
  Small<T, 3> sigma{};
  for (std::size_t i = 0; i < D; ++i)
    for (std::size_t j = i; j < D; ++j) {
      sigma[i][j] = p[i][j];
      if (finite) {
        for (std::size_t k = 0; k < D; ++k) sigma[i][j] += p[i][k] * h[j][k];
        sigma[i][j] = sigma[i][j] / jacobian;
      }
    }
  if constexpr (D == 2) sigma[2][2] = material.out_of_plane_stress(h);
  return {sigma[0][0], sigma[1][1], sigma[2][2], sigma[0][1], sigma[1][2], sigma[0][2]};
}

/// Returns the viscous Cauchy stress J^-1 F S F^T of a displacement gradient H and a rate of Green's strain, of which
/// the law gives S: xx, yy, zz, xy, yz, zx. In plane strain the rate has no components out of the plane, but S has one.
template <class Law, class T, std::size_t D>
std::array<T, 6> viscous_cauchy_stress_at(const Law& law, const Small<T, D>& h, const Small<T, D>& strain_rate) {
  Small<T, 3> f{}, rate{};
  f[2][2] = T(1.0);  // in plane strain
  const Small<T, D> in_space = deformation_gradient(h);
  for (std::size_t i = 0; i < D; ++i)
    for (std::size_t j = 0; j < D; ++j) {
      f[i][j] = in_space[i][j];
      rate[i][j] = strain_rate[i][j];
    }
  const Small<T, 3> s = law.stress(rate);
  const T jacobian = determinant(f);
  const auto component = [&](std::size_t i, std::size_t j) {
    T sum(0.0);
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t l = 0; l < 3; ++l) sum += f[i][k] * s[k][l] * f[j][l];
    return T(sum / jacobian);
  };
  return {component(0, 0), component(1, 1), component(2, 2), component(0, 1), component(1, 2), component(2, 0)};
}

/// Returns that of a displacement gradient H and the gradient G of the velocity, whose rate of Green's strain is
/// sym(F^T G).
template <class Law, class T, std::size_t D>
std::array<T, 6> viscous_cauchy_stress(const Law& law, const Small<T, D>& h, const Small<T, D>& g) {
  const Small<T, D> f = deformation_gradient(h);
  Small<T, D> rate{};
  for (std::size_t i = 0; i < D; ++i)
    for (std::size_t j = 0; j < D; ++j)
      for (std::size_t k = 0; k < D; ++k) rate[i][j] += 0.5 * (f[k][i] * g[k][j] + f[k][j] * g[k][i]);
  return viscous_cauchy_stress_at(law, h, rate);
}

}  // namespace ixos
