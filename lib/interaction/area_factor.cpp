#include "interaction/area_factor.hpp"

#include <stdexcept>
#include <utility>

#include "base/error.hpp"
#include "interaction/gap_law.hpp"

namespace ixos {
namespace {

/// a and its derivatives at a gap. With b = (1 + g/2R)/(1 + g/R) = (1 + 1/(1 + g/R))/2, a is b or b^2.
struct Factor {
  Factor(const AreaFactor& factor, const Pack& r) {
    const Pack inverse = 1.0 / (1.0 + r / factor.radius), b = 0.5 * (1.0 + inverse);
    const Pack first = -0.5 / factor.radius * inverse * inverse, second = -2.0 / factor.radius * inverse * first;
    value = factor.power == 2 ? Pack(b * b) : b;
    slope = factor.power == 2 ? Pack(2.0 * b * first) : first;
    curvature = factor.power == 2 ? Pack(2.0 * (first * first + b * second)) : second;
  }
  Pack value, slope, curvature;
};

/// (a(r1) - a(r0))/(r1 - r0) and its derivative in r1, without cancellation.
struct Difference {
  Difference(const AreaFactor& factor, const Pack& r0, const Pack& r1) {
    const double scale = -0.5 / factor.radius;
    const Pack i0 = 1.0 / (1.0 + r0 / factor.radius), i1 = 1.0 / (1.0 + r1 / factor.radius);
    const Pack first = scale * i0 * i1, slope_of_first = -1.0 / factor.radius * i1 * first;  // of b
    value = first;
    slope = slope_of_first;
    if (factor.power != 2) return;
    const Pack sum = 1.0 + 0.5 * (i0 + i1);  // b0 + b1
    value = first * sum;
    slope = slope_of_first * sum + first * (scale * i1 * i1);
  }
  Pack value, slope;
};

class AreaFactorLaw final : public GapLaw {
 public:
  AreaFactorLaw(std::shared_ptr<const GapLaw> law, const AreaFactor& factor) : law_(std::move(law)), factor_(factor) {}

  Pack energy(const Pack& r, History) const override { return law_->energy(r) * Factor(factor_, r).value; }
  Pack traction(const Pack& r, History) const override {
    const Factor a(factor_, r);
    return law_->traction(r) * a.value - law_->energy(r) * a.slope;
  }
  Pack stiffness(const Pack& r, History) const override {
    const Factor a(factor_, r);
    return law_->stiffness(r) * a.value - 2.0 * law_->traction(r) * a.slope + law_->energy(r) * a.curvature;
  }

  /// The product rule of differences: psi0 a0 - psi1 a1 = (psi0 - psi1)(a0 + a1)/2 - (psi0 + psi1)(a1 - a0)/2.
  Pack mean_traction(const Pack& r0, const Pack& r1, History) const override {
    const Pack a = 0.5 * (Factor(factor_, r0).value + Factor(factor_, r1).value);
    const Pack psi = 0.5 * (law_->energy(r0) + law_->energy(r1));
    return law_->mean_traction(r0, r1) * a - psi * Difference(factor_, r0, r1).value;
  }
  Pack mean_stiffness(const Pack& r0, const Pack& r1, History) const override {
    const Factor start(factor_, r0), end(factor_, r1);
    const Difference difference(factor_, r0, r1);
    const Pack psi = 0.5 * (law_->energy(r0) + law_->energy(r1));
    return law_->mean_stiffness(r0, r1) * (0.5 * (start.value + end.value)) -
           0.5 * law_->mean_traction(r0, r1) * end.slope - 0.5 * law_->traction(r1) * difference.value +
           psi * difference.slope;
  }
  Pack mean_potential(const Pack& /*r0*/, const Pack& /*r1*/, History) const override {
    throw std::logic_error("an interaction with an area factor has no potential of its exact mean");
  }
  bool tractions(const GapEnds<Pack>& ends, const Rule& rule, History, Pack* t, Pack& least_gap) const override {
    return rule_tractions(Itself{this}, ends, rule, t, least_gap);
  }
  bool stiffnesses(const GapEnds<Pack>& ends, const Rule& rule, bool convex, History, Pack* k) const override {
    return rule_stiffnesses(Itself{this}, ends, rule, convex, k);
  }
  Pack first(const Pack&) const override { refuse_history(); }
  Pack updated(const Pack&, const Pack&) const override { refuse_history(); }
  Pack dissipated(const Pack&, const Pack&) const override { refuse_history(); }
  Pack damage(const Pack&) const override { refuse_history(); }
  bool repels() const override { return law_->repels(); }

  Pack magnitude(const Pack& r, History) const override {
    const Factor a(factor_, r);
    using std::experimental::abs;
    return law_->magnitude(r) * abs(a.value) + abs(law_->energy(r) * a.slope);
  }

  GapDomain domain() const override { return law_->domain(); }
  double equilibrium_gap() const override { return law_->equilibrium_gap(); }
  double adhesion_gap() const override { return law_->adhesion_gap(); }
  double range() const override { return law_->range(); }
  bool has_history() const override { return false; }
  bool bonds_later() const override { return law_->bonds_later(); }
  std::vector<GapPower> powers() const override { return {}; }
  std::shared_ptr<const GapLaw> cut_off(double range) const override {
    return with_area_factor(law_->cut_off(range), factor_);
  }

 private:
  [[noreturn]] static void refuse_history() { throw std::logic_error("the law has no history"); }
  /// With the members of a law, for rule_tractions().
  struct Itself {
    static constexpr bool has_range = true;
    const AreaFactorLaw* law;
    double range() const { return law->range(); }
    Pack traction(const Pack& r) const { return law->traction(r, nullptr); }
    Pack stiffness(const Pack& r) const { return law->stiffness(r, nullptr); }
    Pack mean_traction(const Pack& r0, const Pack& r1) const { return law->mean_traction(r0, r1, nullptr); }
    Pack mean_stiffness(const Pack& r0, const Pack& r1) const { return law->mean_stiffness(r0, r1, nullptr); }
  };

  std::shared_ptr<const GapLaw> law_;
  AreaFactor factor_;
};

}  // namespace

std::shared_ptr<const GapLaw> with_area_factor(std::shared_ptr<const GapLaw> law, const AreaFactor& factor) {
  if (factor.radius == 0) throw InputError("an area factor needs a radius that is not zero");
  if (law->has_history())
    throw InputError("an area factor needs a law without a history: it would dissipate by the factor at each gap");
  return std::make_shared<AreaFactorLaw>(std::move(law), factor);
}

}  // namespace ixos
