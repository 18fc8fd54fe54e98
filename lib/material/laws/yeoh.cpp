#include "material/catalogue.hpp"
#include "material/elastic_law.hpp"
#include "material/isochoric_law.hpp"
#include "material/laws/compressibility.hpp"
#include "material/strain_law.hpp"

namespace ixos {
namespace {

/// W = c1 x + c2 x^2 + c3 x^3.
struct Yeoh {
  static constexpr bool has_limit = false;
  double c1, c2, c3;

  template <class T>
  T energy(const T& x, const T&) const {
    return x * (c1 + x * (c2 + c3 * x));
  }
  template <class T>
  Slopes<T> slopes(const T& x, const T&) const {
    return {T(c1 + x * (2 * c2 + 3 * c3 * x)), T(0.0)};
  }
  template <class T>
  Curvatures<T> curvatures(const T& x, const T&) const {
    return {T(2 * c2 + 6 * c3 * x), T(0.0), T(0.0)};
  }
};

struct Parameters : Compressibility {
  double c1 = 0.2, c2 = -0.002, c3 = 0.0001;
};

}  // namespace

ElasticEntry yeoh_entry() {
  Options<Parameters> options;
  options.add("C1", &Parameters::c1, "Constant c1 [E0], half the shear modulus.", greater_than(0))
      .add("C2", &Parameters::c2, "Constant c2 [E0], often negative: it softens at moderate strains.", any_number())
      .add("C3", &Parameters::c3, "Constant c3 [E0]: it stiffens at large strains.", any_number());
  add_compressibility(options);
  return {"Yeoh", "Yeoh: W = c1 (I1 - 3) + c2 (I1 - 3)^2 + c3 (I1 - 3)^3 + U(J), with the isochoric invariant I1.",
          "Yeoh 1993", options.list(), [options](const SceneNode& node) {
            const Parameters p = options.read(node);
            const double mu = 2 * p.c1;
            return elastic_law(StrainLaw(IsochoricLaw<Yeoh>{{p.c1, p.c2, p.c3}, p.volumetric(mu), p.lame(mu)}));
          }};
}

}  // namespace ixos
