/// The bilinear law with damage: an attraction that does not heal.
#pragma once
#include <array>
#include <cstddef>
#include <limits>

#include "base/pack.hpp"
#include "interaction/law_history.hpp"
#include "interaction/piecewise_law.hpp"

namespace ixos {

class FrozenDamage;

/// A cohesive law (Camanho and Davila 2002). The traction is -K r up to the adhesion gap d0 = s0/K, where the
/// attraction is largest, falls linearly to 0 at df, and is 0 beyond. Its history is kappa, the largest gap so far at
/// the end of a step [L0]. At smaller gaps the traction is that of the damaged bond, -(1 - D) K r with the damage D =
/// df (kappa - d0)/(kappa (df - d0)) in [0, 1]. A negative gap is an overlap: the traction K |r| repels, whatever the
/// damage.
///
/// A bond on touch is one that also forms later: a point that begins at a gap above d0 has no bond, and only repels,
/// until a step ends at a gap of 0 or less. Then it has a whole bond, whose energy and traction there are those of the
/// repulsion, so that nothing is spent or gained. A negative history stands for a point that waits for its bond.
///
/// As a law of the gap alone it is the envelope, which an undamaged point follows when it is pulled off. The energy of
/// the envelope is 0 beyond df, that of at() is 0 at r = 0.
class DamageLaw : public PiecewiseLaw {
 public:
  static constexpr bool has_history = true;

  /// K [E0/L0], s0 [E0] and df [L0], all positive, s0/K < df.
  DamageLaw(double stiffness, double strength, double range, bool bonds_on_touch = false);

  /// Returns whether a point without a bond at the start may come to have one.
  bool bonds_later() const { return bonds_on_touch_; }
  double stiffness_of_bond() const { return stiffness_; }
  double softening() const { return softening_; }  ///< s0/(df - d0) [E0/L0]

  /// Returns kappa of a point whose gap has been at most r, and the one that follows after a step that ends at r.
  Pack first(const Pack& r) const {
    const Pack whole = adhesion_gap();
    return bonds_on_touch_ ? select(r > whole, Pack(waiting), whole) : updated(whole, r);
  }
  Pack updated(const Pack& kappa, const Pack& r) const {
    const Pack grown = select(r > kappa, r, kappa);
    return bonds_on_touch_ ? select(kappa < 0.0, select(r > 0.0, kappa, Pack(adhesion_gap())), grown) : grown;
  }
  /// Returns D, which is 1 from df on, and of a point that waits for its bond.
  Pack damage(const Pack& kappa) const {
    const Pack broken = smaller(without_waiting(kappa, range()), Pack(range()));
    return range() * (broken - adhesion_gap()) / (broken * (range() - adhesion_gap()));
  }
  /// Returns the law that holds over a step.
  FrozenDamage at(const Pack& kappa) const;
  /// Returns the work dissipated per area while kappa grows, s0 df (kappa - d0)/(2 (df - d0)) from d0 on, which is
  /// W = s0 df/2 at df [E0 L0].
  Pack dissipated(const Pack& from, const Pack& to) const {
    const auto up_to_range = [this](const Pack& kappa) {
      return smaller(without_waiting(kappa, adhesion_gap()), Pack(range()));
    };
    return (0.5 * softening_ * range()) * (up_to_range(to) - up_to_range(from));
  }

 private:
  static constexpr double waiting = -1;  ///< the history of a point that waits for its bond

  /// Returns kappa, and `gap` in place of a history that waits for a bond.
  Pack without_waiting(const Pack& kappa, double gap) const {
    return bonds_on_touch_ ? select(kappa < 0.0, Pack(gap), kappa) : kappa;
  }

  double stiffness_, softening_;
  bool bonds_on_touch_;
};

/// The law of a point over one step, with the kappa of the step's start frozen. Its energy is the incremental potential
/// E(r) = min over kappa' of the stored energy plus the work dissipated since the step's start (Ortiz and Stainier
/// 1999): the stored energy (1 - D) K r^2/2 up to kappa, beyond it that of kappa plus the work of the envelope from
/// there. After a step to r, E(r) is the new stored energy plus the dissipated work, at any step size. The traction is
/// piecewise linear, so means are sums of trapezoids. It has the members of a law.
class FrozenDamage {
 public:
  FrozenDamage(const DamageLaw& law, const Pack& kappa);

  Pack energy(const Pack& r) const {
    return choose(r, [&](const Piece& piece) {
      const Pack x = r - piece.start;
      return Pack(piece.energy - x * (piece.traction + 0.5 * piece.slope * x));
    });
  }
  Pack traction(const Pack& r) const {
    return choose(r, [&](const Piece& piece) { return piece.at(r); });
  }
  Pack stiffness(const Pack& r) const {
    return choose(r, [&](const Piece& piece) { return Pack(-piece.slope); });
  }
  /// As that of PiecewiseLaw.
  Pack magnitude(const Pack& r) const { return magnitude_near_kinks(*this, r); }
  Pack mean_traction(const Pack& r0, const Pack& r1) const;
  Pack mean_stiffness(const Pack& r0, const Pack& r1) const;
  Pack mean_potential(const Pack& r0, const Pack& r1) const;

 private:
  /// The interval of gaps from `low` to that of the next piece. Numbers are those at `start`, the slope is dT/dr.
  struct Piece {
    Pack low, start, traction, slope, energy;
    Pack at(const Pack& r) const { return traction + slope * (r - start); }
  };

  /// Returns value(piece of the gap).
  template <class Value>
  Pack choose(const Pack& r, const Value& value) const {
    Pack result = value(pieces_.back());
    for (std::size_t i = pieces_.size() - 1; i-- > 0;) result = select(r < high(i), Pack(value(pieces_[i])), result);
    return result;
  }
  Pack high(std::size_t i) const {
    return i + 1 < pieces_.size() ? pieces_[i + 1].low : Pack(std::numeric_limits<double>::infinity());
  }

  std::array<Piece, 4> pieces_;  ///< overlap, damaged bond, envelope, nothing
};

/// A point that waits for its bond acts as one whose bond is broken.
inline FrozenDamage DamageLaw::at(const Pack& kappa) const { return {*this, without_waiting(kappa, range())}; }

}  // namespace ixos
