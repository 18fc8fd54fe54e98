#include "material/catalogue.hpp"
#include "material/elastic_law.hpp"
#include "material/hooke.hpp"
#include "material/strain.hpp"

namespace ixos {
namespace {

/// W = mu/4 A:A + lambda/8 (tr A)^2 with A = F^T F - I; P = F S, S = mu A + lambda/2 tr A I (Holzapfel 2000, sec. 6.5).
/// Objective. It softens under strong compression.
struct SaintVenantKirchhoff {
  static constexpr bool has_discrete_gradient = true;
  static constexpr bool has_mixed_steps = false;  // lambda resists a change of tr A, not of J
  Lame lame;

  template <std::size_t D>
  Pack energy(const Small<Pack, D>& h) const {
    const Small<Pack, D> a = green_strain_doubled(h);
    Pack square = 0.0;
    for (std::size_t i = 0; i < D; ++i)
      for (std::size_t j = 0; j < D; ++j) square += a[i][j] * a[i][j];
    const Pack first = trace(a);
    return lame.mu / 4 * square + lame.lambda / 8 * (first * first);
  }

  template <std::size_t D>
  Pack stress(const Small<Pack, D>& h, Small<Pack, D>& p) const {
    const Small<Pack, D> f = deformation_gradient(h), s = second(green_strain_doubled(h));
    p = product(f, s);
    return determinant(f);
  }

  template <std::size_t D>
  Pack stress_and_moduli(const Small<Pack, D>& h, Small<Pack, D>& p, Small<Pack, D * D>& moduli) const {
    const Small<Pack, D> f = deformation_gradient(h), s = second(green_strain_doubled(h));
    p = product(f, s);
    fill(f, f, s, 1, moduli);
    return determinant(f);
  }

  /// F_mid S((A0 + A1)/2) does the work W1 - W0 exactly and keeps angular momentum (Simo and Tarnow 1992).
  template <std::size_t D>
  void discrete_gradient(const Small<Pack, D>& h0, const Small<Pack, D>& h1, Small<Pack, D>& p) const {
    p = product(deformation_gradient(middle(h0, h1)), mean_stress(h0, h1));
  }
  template <std::size_t D>
  void discrete_gradient_moduli(const Small<Pack, D>& h0, const Small<Pack, D>& h1, Small<Pack, D * D>& moduli) const {
    fill(deformation_gradient(middle(h0, h1)), deformation_gradient(h1), mean_stress(h0, h1), 0.5, moduli);
  }

  /// sigma_33 = S_33/J in plane strain.
  Pack out_of_plane_stress(const Small<Pack, 2>& h) const {
    return lame.lambda / 2 * trace(green_strain_doubled(h)) / determinant(deformation_gradient(h));
  }

 private:
  template <std::size_t D>
  static Small<Pack, D> middle(const Small<Pack, D>& h0, const Small<Pack, D>& h1) {
    Small<Pack, D> result;
    for (std::size_t i = 0; i < D; ++i)
      for (std::size_t j = 0; j < D; ++j) result[i][j] = 0.5 * (h0[i][j] + h1[i][j]);
    return result;
  }
  /// Returns S for A = 2 E.
  template <std::size_t D>
  Small<Pack, D> second(const Small<Pack, D>& a) const {
    return Hooke{{lame.mu / 2, lame.lambda / 2}}.stress(a);
  }
  template <std::size_t D>
  Small<Pack, D> mean_stress(const Small<Pack, D>& h0, const Small<Pack, D>& h1) const {
    return second(middle(green_strain_doubled(h0), green_strain_doubled(h1)));
  }

  /// Sets the moduli of P = G S, S at the mean of strains of which `share` changes with F.
  template <std::size_t D>
  void fill(const Small<Pack, D>& g, const Small<Pack, D>& f, const Small<Pack, D>& s, double share,
            Small<Pack, D * D>& moduli) const {
    moduli = {};
    Hooke{lame}.add_moduli(g, f, s, Pack(share), Pack(share), moduli);
  }
};

}  // namespace

ElasticEntry saint_venant_kirchhoff_entry() {
  return {
      "Saint Venant-Kirchhoff",
      "Saint Venant-Kirchhoff: Hooke's law between Green's strain and the second Piola-Kirchhoff stress; it softens "
      "under strong compression.",
      "Holzapfel 2000, section 6.5",
      isotropic_options().list(),
      [](const SceneNode& node) { return elastic_law(SaintVenantKirchhoff{isotropic_options().read(node).lame()}); },
      true};
}

}  // namespace ixos
