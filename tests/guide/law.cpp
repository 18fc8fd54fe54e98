#include "interaction/catalogue.hpp"
#include "interaction/gap_law.hpp"

namespace ixos {
namespace {

/// psi = k (r - r_e)^2/2: springs of no mass between the surface and the obstacle.
class Foundation {
 public:
  static constexpr bool has_range = false;             // true: range() is the gap beyond which nothing acts
  static constexpr GapDomain domain = GapDomain::All;  // Positive: a state with a gap r <= 0 is inadmissible

  Foundation(double stiffness, double gap) : k_(stiffness), gap_(gap) {}

  template <class T>
  T energy(const T& r) const {  // psi per reference area
    return 0.5 * k_ * (r - gap_) * (r - gap_);
  }
  template <class T>
  T traction(const T& r) const {  // -dpsi/dr, positive away from the obstacle
    return -k_ * (r - gap_);
  }
  template <class T>
  T stiffness(const T& /*r*/) const {  // d2psi/dr2
    return k_;
  }
  template <class T>
  T mean_traction(const T& r0, const T& r1) const {  // mean of the traction over gaps from r0 to r1
    return -k_ * (0.5 * (r0 + r1) - gap_);
  }
  template <class T>
  T mean_stiffness(const T& /*r0*/, const T& /*r1*/) const {  // minus its derivative in r1
    return 0.5 * k_;
  }
  template <class T>
  T mean_potential(const T& r0, const T& r1) const {  // its potential in r1, zero at r1 = r0
    return k_ * (r1 - r0) * (0.25 * (3.0 * r0 + r1) - gap_);
  }
  template <class T>
  T magnitude(const T& r) const {  // scale of the rounding error of the traction
    return k_ * (r * r + 2 * gap_ * gap_) / gap_;
  }
  bool repels() const { return true; }             // false: it only attracts
  double equilibrium_gap() const { return gap_; }  // Newton steps keep r >= kappa min(r, this) if gaps are positive
  double adhesion_gap() const { return gap_; }     // contact_measure counts gaps below this

 private:
  double k_, gap_;
};

struct Parameters {
  double stiffness = 0.1, gap = 0.25;
};

}  // namespace

LawEntry foundation_law() {
  Options<Parameters> options;
  options.add("Stiffness", &Parameters::stiffness, "Traction per change of the gap [E0/L0].", greater_than(0))
      .add("Gap", &Parameters::gap, "Gap at which no traction acts [L0].", greater_than(0));
  return {"Foundation", "Springs between the surface and the obstacle.", "", options.list(),
          [options](const SceneNode& node) {
            const Parameters p = options.read(node);
            return gap_law(Foundation(p.stiffness, p.gap));
          }};
}

}  // namespace ixos
