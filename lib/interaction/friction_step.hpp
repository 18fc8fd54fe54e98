/// Friction at a point of a surface over one step.
#pragma once
#include <cmath>
#include <cstddef>

#include "interaction/elastic_slip.hpp"
#include "interaction/friction.hpp"
#include "interaction/smoothed_slip.hpp"

namespace ixos {

/// A response at the end of a slip, or averaged over the straight path from no slip to it.
enum class SlipKind { At, Mean };

/// The resistance to slip at a point over a step, as functions of the slip since the step's start. The slip is a vector
/// in the tangent plane of the start [L0]. With an elastic slip the traction of the start is state, and the elastic
/// slip e = traction over eps; smoothed friction has none.
template <class T, std::size_t D>
class FrictionStep {
 public:
  using Vector = std::array<T, D>;
  using Matrix = Small<T, D>;
  using Response = SlipResponse<T, D>;
  /// The state after the step: the traction in the tangent plane of the start [E0], the length of the slip beyond the
  /// elastic one [L0], the work that it dissipated per area [E0 L0], and whether it slid, 1 or 0.
  struct End {
    Vector traction;
    T slip, work, slid;
  };

  /// `creep_length`: length up to which smoothed friction grows [L0], see SmoothedSlip; `traction`: that which resisted
  /// slip at the start; `threshold`: T_s of the step. The friction must outlive it, with a stiffness that is not 0.
  FrictionStep(const Friction& friction, double creep_length, const Vector& traction, const T& threshold)
      : friction_(friction), creep_length_(creep_length), traction_(traction), threshold_(threshold) {}

  /// Returns the traction and its derivatives; `plane` is the projector onto the tangent plane.
  template <SlipPart part>
  Response respond(const Vector& slip, const Matrix& plane, SlipKind kind) const {
    if (is_smoothed()) return kind == SlipKind::Mean ? smoothed().mean(slip, plane) : smoothed().at(slip, plane);
    return kind == SlipKind::Mean ? elastic().template mean<part>(elastic_slip(), slip, plane)
                                  : elastic().at(whole(slip), plane);
  }

  /// Returns the energy per area that the elastic slip of the start stores [E0 L0].
  T stored_energy() const {
    const Vector slip = elastic_slip();
    return 0.5 * friction_.stiffness * inner(slip, slip);
  }
  /// Returns the potential of the step per area; at no slip it is the stored energy, if the threshold allows it.
  T energy(const Vector& slip) const { return is_smoothed() ? smoothed().energy(slip) : elastic().energy(whole(slip)); }
  /// Returns the potential of the mean traction, zero at no slip.
  T mean_potential(const Vector& slip) const {
    return is_smoothed() ? smoothed().mean_potential(slip) : elastic().mean_potential(elastic_slip(), slip);
  }
  /// Returns a stiffness that acts, or more: at most eps, T_s/|q| at a slip q beyond T_s/eps, 0 without a threshold
  /// [E0/L0].
  T acting_stiffness(const Vector& slip) const {
    const T size = length(whole(slip));
    // Smoothed friction is stiffest at no slip: 2 T_s/d.
    const T radius = is_smoothed() ? T(0.5 * creep_length_) : T(threshold_ / friction_.stiffness);
    const auto acts = threshold_ > 0.0;
    return select(acts, T(threshold_ / select(acts, larger(size, radius), T(1.0))), T(0.0));
  }

  /// Ends the step with a slip where the threshold is `end_threshold`. The work has the parts of docs/theory.md,
  /// "Friction", in their order.
  End end(const Vector& slip, const T& end_threshold) const {
    const double stiffness = friction_.stiffness;
    const Vector all = whole(slip);
    End end;
    T least = creep_length_;  // smoothed friction slides fully beyond its creep
    if (is_smoothed()) {
      end.work = smoothed().energy(all);
      end.slip = length(all);
      end.traction = smoothed().at(all, {}).traction;
    } else {
      const T radius = threshold_ / stiffness, excess = positive(T(length(elastic_slip()) - radius));
      end.slip = positive(T(length(all) - radius));
      end.work = threshold_ * end.slip + 0.5 * stiffness * excess * excess;
      end.traction = elastic().at(all, {}).traction;
      least = 1e-10 * radius;  // a surface that comes to rest slides by rounding
    }
    end.slip = select(threshold_ > 0.0, end.slip, T(0.0));  // a surface that is apart does not slide
    const T size = length(end.traction), drop = positive(T(size - end_threshold));
    const T share = select(drop > 0.0, T(end_threshold / select(size > 0.0, size, T(1.0))), T(1.0));
    if (!is_smoothed()) {
      end.slip += drop / stiffness;
      end.work += 0.5 * (size + end_threshold) * (drop / stiffness);
    }
    for (T& component : end.traction) component *= share;
    end.slid = select(end.slip > least, T(1.0), T(0.0));
    return end;
  }

 private:
  bool is_smoothed() const { return friction_.type == FrictionType::Smoothed; }
  SmoothedSlip<T, D> smoothed() const { return {creep_length_, threshold_}; }
  ElasticSlip<T, D> elastic() const { return {friction_.stiffness, threshold_}; }
  Vector elastic_slip() const {
    if (is_smoothed()) return {};
    Vector e = traction_;
    for (T& component : e) component = component / friction_.stiffness;
    return e;
  }
  /// Returns the argument of the potential: the slip and the elastic slip of the start.
  Vector whole(const Vector& slip) const {
    Vector all = elastic_slip();
    for (std::size_t i = 0; i < D; ++i) all[i] += slip[i];
    return all;
  }
  static T positive(const T& x) { return select(x > 0.0, x, T(0.0)); }
  static T larger(const T& a, const T& b) { return select(a > b, a, b); }
  static T length(const Vector& x) {
    using std::sqrt;
    return sqrt(inner(x, x));
  }

  const Friction& friction_;
  double creep_length_;
  Vector traction_;
  T threshold_;
};

/// Returns a vector of the tangent plane with the normal `from`, turned by the smallest rotation of that normal to
/// `to`.
template <class T, std::size_t D>
std::array<T, D> carried(std::array<T, D> vector, const std::array<T, D>& from, const std::array<T, D>& to) {
  const T turn = inner(to, vector) / (1.0 + inner(from, to));
  for (std::size_t i = 0; i < D; ++i) vector[i] -= turn * (from[i] + to[i]);
  return vector;
}

}  // namespace ixos
