#include <cmath>

#include "interaction/catalogue.hpp"
#include "interaction/gap_law.hpp"
#include "interaction/law_parameters.hpp"
#include "interaction/mean_functions.hpp"

namespace ixos {
namespace {

/// psi = W (y^2 - 2 y) with y = e^(-k (r - r_e)) (Morse 1929). Defined for every gap. Means are closed forms that keep
/// their digits as r1 approaches r0.
class Morse {
 public:
  static constexpr bool has_range = false;
  static constexpr GapDomain domain = GapDomain::All;

  /// Work of adhesion W [E0 L0], decay k [1/L0], gap of the minimum r_e [L0].
  Morse(double work, double decay, double gap) : work_(work), decay_(decay), gap_(gap) {}

  Pack energy(const Pack& r) const {
    const Pack y = at(r);
    return work_ * (y * y - 2.0 * y);
  }
  Pack traction(const Pack& r) const {
    const Pack y = at(r);
    return (2 * decay_ * work_) * (y * y - y);
  }
  Pack stiffness(const Pack& r) const {
    const Pack y = at(r);
    return (2 * decay_ * decay_ * work_) * (2.0 * y * y - y);
  }
  Pack mean_traction(const Pack& r0, const Pack& r1) const {
    const Pack y = at(r0), x = decay_ * (r1 - r0);
    const Pack slow = lanewise(x, [](double t) { return mean_exponential(-t); });
    const Pack fast = lanewise(x, [](double t) { return mean_exponential(-2 * t); });
    return (2 * decay_ * work_) * (y * y * fast - y * slow);
  }
  Pack mean_stiffness(const Pack& r0, const Pack& r1) const {
    const Pack y = at(r0), x = decay_ * (r1 - r0);
    const Pack slow = lanewise(x, [](double t) { return exponential_moment_1(t); });
    const Pack fast = lanewise(x, [](double t) { return 2 * exponential_moment_1(2 * t); });
    return (2 * decay_ * decay_ * work_) * (y * y * fast - y * slow);
  }
  Pack mean_potential(const Pack& r0, const Pack& r1) const {
    const Pack y = at(r0), x = decay_ * (r1 - r0);
    const Pack slow = lanewise(x, [](double t) { return entire_exponential_integral(t); });
    const Pack fast = lanewise(x, [](double t) { return entire_exponential_integral(2 * t); });
    return work_ * (2.0 * y * slow - y * y * fast);
  }
  Pack magnitude(const Pack& r) const {
    const Pack y = at(r);
    return (2 * decay_ * work_) * (y * y + y) + std::experimental::abs(stiffness(r) * r);
  }
  double energy(double r) const { return energy(Pack(r))[0]; }
  double traction(double r) const { return traction(Pack(r))[0]; }

  bool repels() const { return true; }
  double equilibrium_gap() const { return gap_; }
  double adhesion_gap() const { return gap_ + std::log(2.0) / decay_; }

 private:
  Pack at(const Pack& r) const {
    return lanewise(r, [this](double gap) { return std::exp(-decay_ * (gap - gap_)); });
  }
  double work_, decay_, gap_;
};

struct Parameters {
  double work = default_work, strength = default_strength, gap = default_gap;
};

}  // namespace

LawEntry morse_law() {
  Options<Parameters> options;
  options.add("Work of Adhesion", &Parameters::work, "Depth W of the potential [E0 L0].", greater_than(0))
      .add("Strength", &Parameters::strength, "Largest attraction s0 [E0]. The decay constant is 2 s0/W.",
           greater_than(0))
      .add("Equilibrium Gap", &Parameters::gap, "Gap at which no traction acts [L0].", greater_than(0));
  return {"Morse",
          "psi(r) = W (y^2 - 2 y), y = exp(-k (r - r_e)), k = 2 s0/W. Its finite repulsion allows penetration.",
          "Morse 1929", options.list(), [options](const SceneNode& node) {
            const Parameters p = options.read(node);
            const double decay = 2 * p.strength / p.work;
            check_derived(node, "Strength and Work of Adhesion", {{"decay constant 2 s0/W", decay}});
            return gap_law(Morse(p.work, decay, p.gap));
          }};
}

}  // namespace ixos
