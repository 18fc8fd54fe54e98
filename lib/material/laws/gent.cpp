#include "material/catalogue.hpp"
#include "material/elastic_law.hpp"
#include "material/isochoric_law.hpp"
#include "material/laws/compressibility.hpp"
#include "material/log_series.hpp"
#include "material/strain_law.hpp"

namespace ixos {
namespace {

/// W = -(mu Jm/2) ln(1 - x/Jm) for x < Jm, where the chains are fully stretched.
struct Gent {
  static constexpr bool has_limit = true;
  double mu, limit;

  template <class T>
  T energy(const T& x, const T&) const {
    return -(mu * limit / 2) * log_one_plus(T(x * (-1 / limit)));
  }
  template <class T>
  Slopes<T> slopes(const T& x, const T& y) const {
    return {T((mu * limit / 2) / room(x, y)), T(0.0)};
  }
  template <class T>
  Curvatures<T> curvatures(const T& x, const T& y) const {
    const T inverse = 1.0 / room(x, y);
    return {T((mu * limit / 2) * (inverse * inverse)), T(0.0), T(0.0)};
  }
  template <class T>
  T room(const T& x, const T&) const {
    return limit - x;
  }
};

struct Parameters : Compressibility {
  double shear = 0.4, limit = 50;
};

}  // namespace

ElasticEntry gent_entry() {
  Options<Parameters> options;
  options.add("Shear Modulus", &Parameters::shear, "Shear modulus mu [E0].", greater_than(0))
      .add("Limit", &Parameters::limit,
           "Limit Jm of I1 - 3 [-]. States at or beyond it are inadmissible, like inverted elements.", greater_than(0));
  add_compressibility(options);
  return {
      "Gent",
      "Gent: W = -mu Jm/2 ln(1 - (I1 - 3)/Jm) + U(J), with the isochoric invariant I1; it becomes rigid as I1 - 3 "
      "approaches Jm.",
      "Gent 1996", options.list(), [options](const SceneNode& node) {
        const Parameters p = options.read(node);
        return elastic_law(StrainLaw(IsochoricLaw<Gent>{{p.shear, p.limit}, p.volumetric(p.shear), p.lame(p.shear)}));
      }};
}

}  // namespace ixos
