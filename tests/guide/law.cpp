#include "interaction/catalogue.hpp"

namespace ixos {
namespace {

/// psi = -e/(2 z) with z = r + d: a charged surface behind an insulator of thickness d.
class Electrostatic {
 public:
  static constexpr bool has_range = false;                  // true: range() is the gap beyond which nothing acts
  static constexpr GapDomain domain = GapDomain::Positive;  // a state with a gap r <= 0 is inadmissible

  Electrostatic(double strength, double thickness) : e_(strength), d_(thickness) {}

  template <class T>
  T energy(const T& r) const {  // psi per reference area
    return -0.5 * e_ / (r + d_);
  }
  template <class T>
  T traction(const T& r) const {  // -dpsi/dr, positive away from the obstacle
    return -0.5 * e_ / ((r + d_) * (r + d_));
  }
  template <class T>
  T stiffness(const T& r) const {  // d2psi/dr2
    return -e_ / ((r + d_) * (r + d_) * (r + d_));
  }
  template <class T>
  T mean_traction(const T& r0, const T& r1) const {  // mean of the traction over gaps from r0 to r1
    return -0.5 * e_ / ((r0 + d_) * (r1 + d_));
  }
  template <class T>
  T mean_stiffness(const T& r0, const T& r1) const {  // minus its derivative in r1
    return -0.5 * e_ / ((r0 + d_) * (r1 + d_) * (r1 + d_));
  }
  template <class T>
  T mean_potential(const T& r0, const T& r1) const {  // its potential in r1, zero at r1 = r0
    using std::log;
    return 0.5 * e_ / (r0 + d_) * log((r1 + d_) / (r0 + d_));
  }
  template <class T>
  T magnitude(const T& r) const {  // scale of the rounding error of the traction
    return 3 * e_ / ((r + d_) * (r + d_));
  }
  double equilibrium_gap() const { return d_; }  // Newton steps keep r >= kappa min(r, this)
  double adhesion_gap() const { return d_; }     // contact_measure counts gaps below this

 private:
  double e_, d_;
};

struct Parameters {
  double strength = 0.01, thickness = 1;
};

}  // namespace

LawEntry electrostatic_law() {
  Options<Parameters> options;
  options.add("Strength", &Parameters::strength, "Permittivity times the squared voltage [E0 L0^2].", greater_than(0))
      .add("Thickness", &Parameters::thickness, "Thickness of the insulator over its permittivity [L0].",
           greater_than(0));
  return {"Electrostatic", "Attraction of a charged surface.", "", options.list(), [options](const SceneNode& node) {
            const Parameters p = options.read(node);
            return gap_law(Electrostatic(p.strength, p.thickness));
          }};
}

}  // namespace ixos
