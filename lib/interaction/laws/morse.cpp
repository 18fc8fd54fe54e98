#include <cmath>

#include "interaction/catalogue.hpp"

namespace ixos {
namespace {

/// Returns f(x) lane by lane.
template <class Function>
Pack lanewise(const Pack& x, const Function& f) {
  return Pack([&](auto i) { return f(static_cast<double>(x[i])); });
}

/// expm1(x)/x, the mean of e^t over t from 0 to x.
double mean_exponential(double x) { return x == 0 ? 1 : std::expm1(x) / x; }

/// Minus the derivative of mean_exponential(-x), which is [1 - (1 + x) e^-x]/x^2, by its series where that loses
/// digits.
double mean_slope(double x) {
  if (std::abs(x) > 0.5) return (1 - (1 + x) * std::exp(-x)) / (x * x);
  double term = 1, sum = 0;
  for (int k = 0; k < 20; ++k) {
    sum += term / (k + 2);
    term *= -x / (k + 1);
  }
  return sum;
}

/// Ein(x) = int_0^x (1 - e^-t)/t dt (Abramowitz and Stegun 1964, 5.1.40), by its series for small and negative x.
double entire_exponential_integral(double x) {
  constexpr double euler = 0.577215664901532861;
  if (x > 2) return -std::expint(-x) + std::log(x) + euler;
  double term = 1, sum = 0;
  for (int k = 1; k < 200; ++k) {
    term *= -x / k;
    sum -= term / k;
  }
  return sum;
}

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
    const Pack slow = lanewise(x, [](double t) { return mean_slope(t); });
    const Pack fast = lanewise(x, [](double t) { return 2 * mean_slope(2 * t); });
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

  double equilibrium_gap() const { return gap_; }
  double adhesion_gap() const { return gap_ + std::log(2.0) / decay_; }

 private:
  Pack at(const Pack& r) const {
    return lanewise(r, [this](double gap) { return std::exp(-decay_ * (gap - gap_)); });
  }
  double work_, decay_, gap_;
};

/// Defaults: the work of adhesion and the largest attraction of the default Van der Waals law, at its equilibrium gap.
struct Parameters {
  double work = 0.01549567, strength = 0.0624428, gap = 0.2547093;
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
            if (!std::isfinite(decay) || !(decay > 0))
              node.refuse("",
                          "Strength and Work of Adhesion are too extreme: the decay constant 2 s0/W must be positive "
                          "and finite");
            return gap_law(Morse(p.work, decay, p.gap));
          }};
}

}  // namespace ixos
