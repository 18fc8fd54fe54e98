#include <cmath>

#include "material/catalogue.hpp"
#include "material/elastic_law.hpp"
#include "material/strain.hpp"
#include "parameters/range_validator.hpp"

namespace ixos {
namespace {

/// W = mu/2 (tr C - 3 - 2 ln J): a neo-Hookean law with nu = 0 at small strains.
struct SoftRubber {
  static constexpr bool has_discrete_gradient = false;  // true: add discrete_gradient() and discrete_gradient_moduli()
  Lame lame;                                            // at small strains

  template <std::size_t D>
  Pack energy(const Small<Pack, D>& h) const {  // W of the displacement gradient H
    Pack square = 0.0;
    for (const auto& row : h)
      for (const Pack& value : row) square += value * value;
    const Pack log_jacobian = std::experimental::log(determinant(deformation_gradient(h)));
    return lame.mu / 2 * (2.0 * trace(h) + square) - lame.mu * log_jacobian;
  }

  template <std::size_t D>
  Pack stress(const Small<Pack, D>& h, Small<Pack, D>& p) const {  // P = dW/dH; returns J
    const Small<Pack, D> f = deformation_gradient(h);
    const Pack jacobian = determinant(f);
    const Small<Pack, D> g = inverse(f, jacobian);
    for (std::size_t i = 0; i < D; ++i)
      for (std::size_t j = 0; j < D; ++j) p[i][j] = lame.mu * (f[i][j] - g[j][i]);
    return jacobian;
  }

  template <std::size_t D>
  Pack stress_and_moduli(const Small<Pack, D>& h, Small<Pack, D>& p, Small<Pack, D * D>& moduli) const {
    const Pack jacobian = stress(h, p);
    const Small<Pack, D> g = inverse(deformation_gradient(h), jacobian);
    for (std::size_t i = 0; i < D; ++i)  // moduli[i D + J][k D + L] = dP_iJ/dH_kL
      for (std::size_t j = 0; j < D; ++j)
        for (std::size_t k = 0; k < D; ++k)
          for (std::size_t l = 0; l < D; ++l) {
            moduli[i * D + j][k * D + l] = lame.mu * (g[l][i] * g[j][k]);
            if (i == k && j == l) moduli[i * D + j][k * D + l] += lame.mu;
          }
    return jacobian;
  }

  Pack out_of_plane_stress(const Small<Pack, 2>& /*h*/) const { return 0.0; }  // sigma_33 in plane strain, for output
};

struct Parameters {
  double shear = 0.5;
};

}  // namespace

ElasticEntry soft_rubber_entry() {
  Options<Parameters> options;
  options.add("Shear Modulus", &Parameters::shear, "Shear modulus mu [E0].", greater_than(0));
  return {"Soft Rubber", "A neo-Hookean law without lateral contraction at small strains.", "", options.list(),
          [options](const SceneNode& node) {
            return elastic_law(SoftRubber{{options.read(node).shear, 0}});
          }};
}

}  // namespace ixos
