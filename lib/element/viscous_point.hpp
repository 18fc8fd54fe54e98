/// Kelvin-Voigt viscosity at a quadrature point of a stage.
#pragma once
#include <cstddef>

#include "base/small_matrix.hpp"
#include "material/hooke.hpp"
#include "rule/rate_form.hpp"

namespace ixos {

/// A stage's viscous stress P(u) at a quadrature point, over any scalar type. e is the change of Green's strain since
/// the step's start.
///
/// End: P = F S with S = D : (s e + known)/dt; s e + known is the stage's velocity row applied to Green's strain, so
/// that P has the order of the scheme. P is the gradient of (s e + known) : D : (s e + known)/(2 s dt).
///
/// Middle: P = (F_n + F)/2 S with S = D : e/dt. Second order; P : (F - F_n) = e : D : e/dt is the energy dissipated in
/// the step, at least 0; P does not turn the body (after Simo and Tarnow 1992). It is no gradient. (The gradient whose
/// work is the same, the mean of grad (e : D : e/dt) over the straight path, has F_n + 2/3 (F - F_n) in place of the
/// middle and is of first order.)
template <std::size_t D, class T>
struct ViscousPoint {
  using Matrix = Small<T, D>;

  const Hooke& law;  ///< of rates [E0 T0]
  RateForm form;
  double unknown;     ///< s; 1 for Middle
  double inverse_dt;  ///< 1/dt [1/T0]
  Matrix start;       ///< displacement gradient at the step's start
  Matrix change;      ///< since then
  Matrix known;       ///< of the row for strains; 0 for Middle

  /// Returns P [E0].
  Matrix stress() const { return product(deformation(form == RateForm::End ? 1.0 : 0.5), law.stress(rate())); }

  /// Adds weight times the symmetric part of dP/dF, see Hooke::add_moduli. For End this is dP/dF. For Middle the
  /// rest is smaller by the strain of one step.
  void add_moduli(const T& weight, Small<T, D * D>& moduli) const {
    const Matrix f = deformation(1.0), s = law.stress(rate());
    const T slope(unknown * inverse_dt * weight);
    if (form == RateForm::End) return law.add_moduli(f, f, s, weight, slope, moduli);
    const Matrix middle = deformation(0.5);
    law.add_moduli(middle, f, s, T(0.25 * weight), T(0.5 * slope), moduli);
    law.add_moduli(f, middle, s, T(0.25 * weight), T(0.5 * slope), moduli);
  }

  /// Returns the energy whose gradient P is [E0]; End only.
  T energy() const {
    const Matrix r = rate();
    return contraction(law.stress(r), r) * (0.5 / (unknown * inverse_dt));
  }

  /// Returns e : D : e/dt [E0]; Middle only.
  T dissipated() const {
    const Matrix r = rate();
    return contraction(law.stress(r), r) * (1 / inverse_dt);
  }

  /// Returns the rate of strain [1/T0].
  Matrix rate() const {
    Matrix result = change_of_strain(start, change);
    for (std::size_t i = 0; i < D; ++i)
      for (std::size_t j = 0; j < D; ++j) result[i][j] = inverse_dt * (unknown * result[i][j] + known[i][j]);
    return result;
  }

 private:
  Matrix deformation(double share) const {
    Matrix f = deformation_gradient(start);
    for (std::size_t i = 0; i < D; ++i)
      for (std::size_t j = 0; j < D; ++j) f[i][j] += share * change[i][j];
    return f;
  }
};

}  // namespace ixos
