/// Isotropic linear elasticity: the small-strain limit, exact superposition, and the oscillators of the tests.
#pragma once
#include "material/lame.hpp"
#include "material/spatial_tangent.hpp"
#include "material/strain.hpp"

namespace ixos {

/// W = mu eps:eps + lambda/2 (tr eps)^2 with eps = (H + H^T)/2; plane strain for D = 2. Not objective.
struct LinearElastic {
  static constexpr bool can_invert = false;
  static constexpr bool has_limit = false;
  static constexpr bool has_discrete_gradient = true;
  static constexpr bool has_spatial_tangent = true;
  static constexpr bool keeps_state = false;
  Lame lame;

  /// Returns the energy per volume [E0].
  template <std::size_t D, class T>
  T energy(const Small<T, D>& h) const {
    Small<T, D> p;
    stress(h, p);
    T sum = p[0][0] * h[0][0];
    for (std::size_t i = 0; i < D; ++i)
      for (std::size_t j = 0; j < D; ++j)
        if (i + j > 0) sum += p[i][j] * h[i][j];
    return 0.5 * sum;
  }

  /// Computes the Cauchy stress [E0]. Returns 1: a linear material never inverts.
  template <std::size_t D, class T>
  T stress(const Small<T, D>& h, Small<T, D>& p) const {
    T trace = h[0][0];
    for (std::size_t i = 1; i < D; ++i) trace += h[i][i];
    for (std::size_t i = 0; i < D; ++i)
      for (std::size_t j = 0; j < D; ++j) {
        p[i][j] = lame.mu * (h[i][j] + h[j][i]);
        if (i == j) p[i][j] += lame.lambda * trace;
      }
    return T(1.0);
  }

  /// Computes the stress whose work from H0 to H1 is the change of the energy (the stress in the middle), and its
  /// derivative in H1.
  template <std::size_t D, class T>
  void discrete_gradient(const Small<T, D>& h0, const Small<T, D>& h1, Small<T, D>& p) const {
    Small<T, D> mean;
    for (std::size_t i = 0; i < D; ++i)
      for (std::size_t j = 0; j < D; ++j) mean[i][j] = 0.5 * (h0[i][j] + h1[i][j]);
    stress(mean, p);
  }
  template <std::size_t D, class T>
  void discrete_gradient_moduli(const Small<T, D>& /*h0*/, const Small<T, D>& h1, Small<T, D * D>& moduli) const {
    Small<T, D> p;
    stress_and_moduli(h1, p, moduli);
    for (auto& row : moduli)
      for (T& value : row) value *= 0.5;
  }

  /// Returns the stress out of the plane in plane strain, lambda tr eps [E0].
  template <class T>
  T out_of_plane_stress(const Small<T, 2>& h) const {
    return lame.lambda * (h[0][0] + h[1][1]);
  }

  /// Computes the stress and the constant moduli, A[iJ][kL] = dP_iJ/dH_kL.
  template <std::size_t D, class T>
  T stress_and_moduli(const Small<T, D>& h, Small<T, D>& p, Small<T, D * D>& moduli) const {
    for (std::size_t i = 0; i < D; ++i)
      for (std::size_t j = 0; j < D; ++j)
        for (std::size_t k = 0; k < D; ++k)
          for (std::size_t m = 0; m < D; ++m) {
            double value = 0;
            if (i == k && j == m) value += lame.mu;
            if (i == m && j == k) value += lame.mu;
            if (i == j && k == m) value += lame.lambda;
            moduli[i * D + j][k * D + m] = T(value);
          }
    return stress(h, p);
  }

  /// Computes the moduli in the deformed body, which is taken as undeformed, and F^-1 = I.
  template <std::size_t D, class T>
  SpatialTangent<T> spatial_tangent(const Small<T, D>& /*h*/, Small<T, D>& inverse_deformation) const {
    for (std::size_t i = 0; i < D; ++i)
      for (std::size_t j = 0; j < D; ++j) inverse_deformation[i][j] = T(i == j ? 1.0 : 0.0);
    return {T(lame.mu), T(lame.mu), T(lame.lambda)};
  }

  /// See NeoHookePath. The sum of the stresses is that of the weighted displacement gradients.
  template <std::size_t D, class T>
  class Path {
   public:
    Path(const LinearElastic& law, const Small<T, D>& h0, const Small<T, D>& h1) : law_(law), from_(h0), to_(h1) {}
    template <bool = false>
    T add_stress(double weight, double t) {
      from_weight_ += weight * (1 - t);
      to_weight_ += weight * t;
      return T(1.0);
    }
    void add_moduli(double weight, double t) { add_stress(weight, t); }
    static constexpr bool is_near() { return true; }
    Small<T, D> stress(const T& factor) const {
      Small<T, D> h, p;
      for (std::size_t i = 0; i < D; ++i)
        for (std::size_t j = 0; j < D; ++j) h[i][j] = factor * (from_weight_ * from_[i][j] + to_weight_ * to_[i][j]);
      law_.stress(h, p);
      return p;
    }
    void moduli(const T& factor, Small<T, D * D>& a) const {
      Small<T, D> p;
      law_.stress_and_moduli(to_, p, a);
      for (auto& row : a)
        for (T& value : row) value *= factor * (from_weight_ + to_weight_);
    }

   private:
    const LinearElastic& law_;
    const Small<T, D>&from_, &to_;
    double from_weight_ = 0, to_weight_ = 0;
  };
};

}  // namespace ixos
