/// Tangent moduli in the deformed body.
#pragma once

namespace ixos {

/// The moduli of a law whose tangent, pushed forward to the deformed body, is a_ijkl = mu delta_ik b_jl + c delta_il
/// delta_jk + lambda delta_ij delta_kl, with b = F F^T. A neo-Hookean law has c = mu - lambda ln J, a linear one c = mu
/// and F = I. Per reference volume [E0]. Two nodes then couple by mu (dN_a/dX . dN_b/dX) delta_ik + c dN_b/dx_i
/// dN_a/dx_k + lambda dN_a/dx_i dN_b/dx_k (Bonet and Wood 2008, sec. 9.4).
template <class T>
struct SpatialTangent {
  T mu, c, lambda;

  void scale(const T& factor) {
    mu *= factor;
    c *= factor;
    lambda *= factor;
  }
};

}  // namespace ixos
