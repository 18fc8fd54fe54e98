/// Laws of the gap behind one interface.
#pragma once
#include <algorithm>
#include <limits>
#include <memory>
#include <type_traits>
#include <utility>

#include "base/error.hpp"
#include "base/pack.hpp"
#include "interaction/cut_off.hpp"
#include "interaction/gap_domain.hpp"
#include "interaction/law_history.hpp"

namespace ixos {

/// Energy psi(r) per reference area of a surface at gap r [L0] from an obstacle, and its derivatives. One call
/// evaluates a pack of gaps, so the indirection costs little. A law is a class of member templates like VanDerWaals;
/// GapLawOf puts it behind this interface.
class GapLaw {
 public:
  virtual ~GapLaw() = default;

  virtual Pack energy(const Pack& r) const = 0;     ///< psi [E0 L0]
  virtual Pack traction(const Pack& r) const = 0;   ///< T = -dpsi/dr [E0], positive away from the obstacle
  virtual Pack stiffness(const Pack& r) const = 0;  ///< d2psi/dr2 [E0/L0]
  /// Mean of T over gaps from r0 to r1, minus its derivative in r1, and its potential in r1, which is zero at r0.
  virtual Pack mean_traction(const Pack& r0, const Pack& r1) const = 0;
  virtual Pack mean_stiffness(const Pack& r0, const Pack& r1) const = 0;
  virtual Pack mean_potential(const Pack& r0, const Pack& r1) const = 0;
  /// Scale of the rounding error of the traction [E0].
  virtual Pack magnitude(const Pack& r) const = 0;

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
  /// Returns whether the law has a history, see HasHistory. The functions above are then those of a point without a
  /// past, and only surface terms follow the history.
  virtual bool has_history() const = 0;
  /// Returns whether a surface that begins beyond the range may come to attract: false of a law with a history whose
  /// bonds only form at the start.
  virtual bool bonds_later() const { return true; }
  /// Returns this law with a range, see CutOff; if it ends before that range, this law as it is. range > 0. Throws
  /// InputError if the law has a history and ends beyond.
  virtual std::shared_ptr<const GapLaw> cut_off(double range) const = 0;
};

template <class Law>
struct IsCutOff : std::false_type {};
template <class Law>
struct IsCutOff<CutOff<Law>> : std::true_type {};

/// A class of member templates as a GapLaw.
template <class Law>
class GapLawOf final : public GapLaw {
 public:
  explicit GapLawOf(Law law) : law_(std::move(law)) {}
  const Law& law() const { return law_; }

  Pack energy(const Pack& r) const override { return law_.energy(r); }
  Pack traction(const Pack& r) const override { return law_.traction(r); }
  Pack stiffness(const Pack& r) const override { return law_.stiffness(r); }
  Pack mean_traction(const Pack& r0, const Pack& r1) const override { return law_.mean_traction(r0, r1); }
  Pack mean_stiffness(const Pack& r0, const Pack& r1) const override { return law_.mean_stiffness(r0, r1); }
  Pack mean_potential(const Pack& r0, const Pack& r1) const override { return law_.mean_potential(r0, r1); }
  Pack magnitude(const Pack& r) const override { return law_.magnitude(r); }
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

/// A GapLaw with the members of a law, for kernels: it holds what they ask for at every point.
class AnyGapLaw {
 public:
  static constexpr bool has_range = true;

  explicit AnyGapLaw(std::shared_ptr<const GapLaw> law)
      : domain(law->domain()),
        law_(std::move(law)),
        range_(law_->range()),
        equilibrium_gap_(law_->equilibrium_gap()),
        adhesion_gap_(law_->adhesion_gap()) {}

  GapDomain domain;

  Pack energy(const Pack& r) const { return law_->energy(r); }
  Pack traction(const Pack& r) const { return law_->traction(r); }
  Pack stiffness(const Pack& r) const { return law_->stiffness(r); }
  Pack mean_traction(const Pack& r0, const Pack& r1) const { return law_->mean_traction(r0, r1); }
  Pack mean_stiffness(const Pack& r0, const Pack& r1) const { return law_->mean_stiffness(r0, r1); }
  Pack mean_potential(const Pack& r0, const Pack& r1) const { return law_->mean_potential(r0, r1); }
  Pack magnitude(const Pack& r) const { return law_->magnitude(r); }
  double range() const { return range_; }
  double equilibrium_gap() const { return equilibrium_gap_; }
  double adhesion_gap() const { return adhesion_gap_; }

 private:
  std::shared_ptr<const GapLaw> law_;
  double range_, equilibrium_gap_, adhesion_gap_;
};

}  // namespace ixos
