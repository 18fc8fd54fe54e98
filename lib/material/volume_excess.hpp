/// The stress of a change of volume as Newton's method predicted it.
#pragma once
#include <array>
#include <cmath>
#include <cstddef>

#include "base/pack.hpp"
#include "base/small_matrix.hpp"
#include "material/components.hpp"
#include "material/points.hpp"
#include "material/strain.hpp"

namespace ixos {

/// Returns l_k + F_k^-T : (F - F_k) - l, l = ln J: by how much the linearisation of l at Newton's iterate before
/// exceeds l. It is of second order in the step from there.
///
/// Full steps of Newton's method for the displacement and the pressure, where the pressure follows p = kappa l, differ
/// from those for the displacement alone in one thing: the coefficient of the second derivative of l in the tangent,
/// -F^-T dF^T F^-T, is kappa times the linearised l. The larger kappa is beside the shear modulus, the more iterations
/// that saves; residual and solution do not change. Near nu = 1/2 a step that keeps the volume to first order leaves
/// stresses of kappa times the second, from which the derivative of the force itself leads astray.
template <std::size_t D, class T>
T volume_excess(const Small<T, D>& iterate, const Small<T, D>& here, double way) {
  using std::log;
  const Small<T, D> f = deformation_gradient(iterate);
  const T before = determinant(f), now = determinant(deformation_gradient(here));
  const Small<T, D> g = inverse(f, before);
  T sum(0.0);
  for (std::size_t i = 0; i < D; ++i)
    for (std::size_t j = 0; j < D; ++j) sum += g[j][i] * (here[i][j] - iterate[i][j]);
  const auto possible = before > 0.0 && now > 0.0;
  return select(possible, T(way * sum - log(T(select(possible, T(now / before), T(1.0))))), T(0.0));
}

template <std::size_t G, class T>
T volume_excess(const PointEnds<T, G>& ends, std::size_t q, const RulePoint& point) {
  return volume_excess(ends.iterate_at(q, point), ends.at(q, point), ends.way);
}

/// Adds `factor` F^-T x F^-T to moduli between the components that a space has, (G x G)_iJkL = G_iL G_kJ.
template <class Space, class T>
void add_crossed(const Small<T, Space::G>& here, const T& factor, Small<T, Space::C>& moduli) {
  const Small<T, Space::G> f = deformation_gradient(here);
  const Small<T, Space::G> g = inverse(f, determinant(f));
  const auto component = [](std::size_t r) -> std::array<std::size_t, 2> {
    if constexpr (Space::is_ring)
      return meridian_components[r];
    else
      return {r / Space::G, r % Space::G};
  };
  for (std::size_t r = 0; r < Space::C; ++r)
    for (std::size_t c = 0; c < Space::C; ++c) {
      const auto [i, j] = component(r);
      const auto [k, l] = component(c);
      moduli[r][c] += factor * (g[l][i] * g[j][k]);
    }
}

/// Adds what the mixed form's tangent has beyond the force's derivatives at a point, given kappa: over the time points
/// of a rule.
template <class Space, class T>
[[gnu::noinline]] void add_volume_excess(const PointEnds<T, Space::G>& ends, std::size_t q, const Rule& rule,
                                         double kappa, Small<T, Space::C>& moduli) {
  for (const RulePoint& point : rule.points) {
    const T excess = volume_excess(ends, q, point);
    add_crossed<Space>(ends.at(q, point), T(-kappa * point.weight * point.to * excess), moduli);
  }
}

}  // namespace ixos
