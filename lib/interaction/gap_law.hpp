/// Laws of the gap behind one interface.
#pragma once
#include <algorithm>
#include <limits>
#include <memory>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "base/pack.hpp"
#include "interaction/cut_off.hpp"
#include "interaction/gap_domain.hpp"
#include "interaction/gap_power.hpp"
#include "interaction/law_history.hpp"
#include "interaction/side_points.hpp"

namespace ixos {

/// Energy psi(r) per reference area of a surface at gap r [L0] from an obstacle, and its derivatives. One call
/// evaluates a pack of gaps, or those of many points, so the indirection costs little. A law is a class of member
/// templates like VanDerWaals; GapLawOf puts it behind this interface. `history`: of a law with one, see HasHistory,
/// that of the point at the start of the step; null stands for a point without a past.
class GapLaw {
 public:
  using History = const Pack*;
  virtual ~GapLaw() = default;

  virtual Pack energy(const Pack& r, History history = nullptr) const = 0;  ///< psi [E0 L0]
  /// T = -dpsi/dr [E0], positive away from the obstacle; d2psi/dr2 [E0/L0].
  virtual Pack traction(const Pack& r, History history = nullptr) const = 0;
  virtual Pack stiffness(const Pack& r, History history = nullptr) const = 0;
  /// Mean of T over gaps from r0 to r1, minus its derivative in r1, and its potential in r1, which is zero at r0.
  virtual Pack mean_traction(const Pack& r0, const Pack& r1, History history = nullptr) const = 0;
  virtual Pack mean_stiffness(const Pack& r0, const Pack& r1, History history = nullptr) const = 0;
  virtual Pack mean_potential(const Pack& r0, const Pack& r1, History history = nullptr) const = 0;
  /// Scale of the rounding error of the traction [E0].
  virtual Pack magnitude(const Pack& r, History history = nullptr) const = 0;

  /// See rule_tractions() and rule_stiffnesses(). `history`: by point, or null.
  virtual bool tractions(const GapEnds<Pack>& ends, const Rule& rule, History history, Pack* t,
                         Pack& least_gap) const = 0;
  virtual bool stiffnesses(const GapEnds<Pack>& ends, const Rule& rule, bool convex, History history,
                           Pack* k) const = 0;

  /// Follow a history, see HasHistory. Laws without one throw std::logic_error.
  virtual Pack first(const Pack& r) const = 0;
  virtual Pack updated(const Pack& history, const Pack& r) const = 0;
  virtual Pack dissipated(const Pack& before, const Pack& after) const = 0;
  virtual Pack damage(const Pack& history) const = 0;

  virtual GapDomain domain() const = 0;
  /// Returns whether it pushes the surface away at some gap. A law that only attracts needs another one beside it.
  virtual bool repels() const = 0;
  /// Returns the gap at which repulsion turns into attraction, T = 0 [L0]. It is also the scale of small gaps: Newton
  /// steps keep r >= kappa min(r, this), and gap ratios count below ten times this. A law that only repels or only
  /// attracts returns the gap below which its traction changes by a multiple while the gap halves, or another scale of
  /// small gaps if it is defined at every gap. Positive.
  virtual double equilibrium_gap() const = 0;
  /// Returns the gap of largest attraction [L0], of a law that only repels the gap at which it begins. contact_measure
  /// counts gaps below.
  virtual double adhesion_gap() const = 0;
  virtual double range() const = 0;  ///< gap beyond which nothing acts; infinity if there is none
  /// Returns whether the law has a history, see HasHistory. Only surface terms follow it.
  virtual bool has_history() const = 0;
  /// Returns whether a surface that begins beyond the range may come to attract: false of a law with a history whose
  /// bonds only form at the start.
  virtual bool bonds_later() const { return true; }
  /// Returns this law with a range, see CutOff; if it ends before that range, this law as it is. range > 0. Throws
  /// InputError if the law has a history and ends beyond.
  virtual std::shared_ptr<const GapLaw> cut_off(double range) const = 0;
  /// Returns the powers of which the traction is the sum: those of Van der Waals. Nothing for other laws, whose bodies
  /// do not consist of molecules that attract each other in pairs, and for laws with a cutoff.
  virtual std::vector<GapPower> powers() const = 0;
};

template <class Law>
struct IsCutOff : std::false_type {};
template <class Law>
struct IsCutOff<CutOff<Law>> : std::true_type {};

/// Whether a law says of which powers its traction is the sum.
template <class Law, class = void>
struct HasPowers : std::false_type {};
template <class Law>
struct HasPowers<Law, std::void_t<decltype(std::declval<const Law&>().powers())>> : std::true_type {};

/// A class of member templates as a GapLaw.
template <class Law>
class GapLawOf final : public GapLaw {
 public:
  explicit GapLawOf(Law law) : law_(std::move(law)) {}
  const Law& law() const { return law_; }

  using typename GapLaw::History;
  Pack energy(const Pack& r, History history) const override {
    return with(history, [&](const auto& law) { return law.energy(r); });
  }
  Pack traction(const Pack& r, History history) const override {
    return with(history, [&](const auto& law) { return law.traction(r); });
  }
  Pack stiffness(const Pack& r, History history) const override {
    return with(history, [&](const auto& law) { return law.stiffness(r); });
  }
  Pack mean_traction(const Pack& r0, const Pack& r1, History history) const override {
    return with(history, [&](const auto& law) { return law.mean_traction(r0, r1); });
  }
  Pack mean_stiffness(const Pack& r0, const Pack& r1, History history) const override {
    return with(history, [&](const auto& law) { return law.mean_stiffness(r0, r1); });
  }
  Pack mean_potential(const Pack& r0, const Pack& r1, History history) const override {
    return with(history, [&](const auto& law) { return law.mean_potential(r0, r1); });
  }
  Pack magnitude(const Pack& r, History history) const override {
    return with(history, [&](const auto& law) { return law.magnitude(r); });
  }

  [[gnu::flatten]] bool tractions(const GapEnds<Pack>& ends, const Rule& rule, [[maybe_unused]] History history,
                                  Pack* t, Pack& least_gap) const override {
    if constexpr (HasHistory<Law>::value)
      if (history != nullptr) return rule_tractions(LawOfBatch<Law>{&law_, history}, ends, rule, t, least_gap);
    return rule_tractions(law_, ends, rule, t, least_gap);
  }
  [[gnu::flatten]] bool stiffnesses(const GapEnds<Pack>& ends, const Rule& rule, bool convex,
                                    [[maybe_unused]] History history, Pack* k) const override {
    if constexpr (HasHistory<Law>::value)
      if (history != nullptr) return rule_stiffnesses(LawOfBatch<Law>{&law_, history}, ends, rule, convex, k);
    return rule_stiffnesses(law_, ends, rule, convex, k);
  }

  Pack first([[maybe_unused]] const Pack& r) const override {
    if constexpr (HasHistory<Law>::value) return law_.first(r);
    refuse_history();
  }
  Pack updated([[maybe_unused]] const Pack& history, [[maybe_unused]] const Pack& r) const override {
    if constexpr (HasHistory<Law>::value) return law_.updated(history, r);
    refuse_history();
  }
  Pack dissipated([[maybe_unused]] const Pack& before, [[maybe_unused]] const Pack& after) const override {
    if constexpr (HasHistory<Law>::value) return law_.dissipated(before, after);
    refuse_history();
  }
  Pack damage([[maybe_unused]] const Pack& history) const override {
    if constexpr (HasHistory<Law>::value) return law_.damage(history);
    refuse_history();
  }

  GapDomain domain() const override { return Law::domain; }
  bool repels() const override { return law_.repels(); }
  double equilibrium_gap() const override { return law_.equilibrium_gap(); }
  double adhesion_gap() const override { return law_.adhesion_gap(); }
  double range() const override {
    if constexpr (Law::has_range) return law_.range();
    return std::numeric_limits<double>::infinity();
  }
  bool has_history() const override { return HasHistory<Law>::value; }
  bool bonds_later() const override {
    if constexpr (HasHistory<Law>::value) return law_.bonds_later();
    return true;
  }
  std::vector<GapPower> powers() const override {
    if constexpr (HasPowers<Law>::value) {
      const auto powers = law_.powers();
      return {powers.begin(), powers.end()};
    } else {
      return {};
    }
  }
  std::shared_ptr<const GapLaw> cut_off(double range) const override {
    if constexpr (IsCutOff<Law>::value) {
      return std::make_shared<GapLawOf>(Law(law_.uncut(), range));
    } else {
      if (range >= this->range()) return std::make_shared<GapLawOf>(law_);
      if constexpr (HasHistory<Law>::value)
        throw InputError("a law with a history cannot be cut off before it ends");
      else
        return std::make_shared<GapLawOf<CutOff<Law>>>(CutOff<Law>(law_, range));
    }
  }

 private:
  [[noreturn]] static void refuse_history() { throw std::logic_error("the law has no history"); }
  template <class Value>
  Pack with([[maybe_unused]] History history, const Value& value) const {
    if constexpr (HasHistory<Law>::value)
      if (history != nullptr) return value(law_.at(*history));
    return value(law_);
  }

  Law law_;
};

template <class Law>
std::shared_ptr<const GapLaw> gap_law(Law law) {
  return std::make_shared<GapLawOf<Law>>(std::move(law));
}

/// Returns the work of adhesion W [E0 L0]: -psi at the equilibrium gap, of a law that only attracts or is in
/// equilibrium at a gap of 0 -psi(0), of a law that only repels 0.
inline double work_of_adhesion(const GapLaw& law) {
  double energy = law.energy(law.repels() ? law.equilibrium_gap() : 0.0)[0];
  if (law.domain() == GapDomain::All) energy = std::min<double>(energy, law.energy(0.0)[0]);
  return energy < 0 ? -energy : 0;
}

/// A GapLaw at one point, with the members of a law.
struct GapLawAt {
  const GapLaw* law;
  GapLaw::History history;

  Pack energy(const Pack& r) const { return law->energy(r, history); }
  Pack traction(const Pack& r) const { return law->traction(r, history); }
  Pack stiffness(const Pack& r) const { return law->stiffness(r, history); }
  Pack mean_traction(const Pack& r0, const Pack& r1) const { return law->mean_traction(r0, r1, history); }
  Pack mean_stiffness(const Pack& r0, const Pack& r1) const { return law->mean_stiffness(r0, r1, history); }
  Pack mean_potential(const Pack& r0, const Pack& r1) const { return law->mean_potential(r0, r1, history); }
  Pack magnitude(const Pack& r) const { return law->magnitude(r, history); }
};

/// A GapLaw at the points of a batch.
struct GapLawOfBatch {
  const GapLaw* law;
  GapLaw::History history;  ///< by quadrature point, or null
};
inline bool rule_tractions(const GapLawOfBatch& laws, const GapEnds<Pack>& ends, const Rule& rule, Pack* t,
                           Pack& least_gap) {
  return laws.law->tractions(ends, rule, laws.history, t, least_gap);
}
inline bool rule_stiffnesses(const GapLawOfBatch& laws, const GapEnds<Pack>& ends, const Rule& rule, bool convex,
                             Pack* k) {
  return laws.law->stiffnesses(ends, rule, convex, laws.history, k);
}

}  // namespace ixos
