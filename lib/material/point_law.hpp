/// A law at the points of a pack of cells, behind one interface.
#pragma once
#include <cstddef>
#include <utility>

#include "base/pack.hpp"
#include "material/law_points.hpp"
#include "material/points.hpp"

namespace ixos {

/// The functions that element kernels call, once for many points. They add to nothing: results are set. Moduli are the
/// derivatives dP_iJ/dF_kL [E0] between the components that the space has, row by row. `kept`: kept_size() numbers for
/// each point, and `size` is a number of points.
template <class Space>
class PointLaw {
 public:
  static constexpr std::size_t G = Space::G, C = Space::C;
  using Ends = PointEnds<Pack, G>;
  using Gradient = Small<Pack, G>;
  using Moduli = Small<Pack, C>;

  virtual ~PointLaw() = default;

  /// Returns whether moduli() and spatial() see the iterate of a segment, see volume_excess().
  virtual bool has_mixed_steps() const = 0;
  /// Returns whether J <= 0 is inadmissible; whether states with J > 0 may be, too; whether spatial() is there.
  virtual bool can_invert() const = 0;
  virtual bool is_limited() const = 0;
  virtual bool has_spatial_tangent() const = 0;
  /// Returns a number that is greater than 0 where H is admissible: J, or -1 beyond the limit of a law that has one.
  virtual Pack admissibility(const Gradient& h) const = 0;
  /// Returns how many packs a point keeps of stress() by that rule, so that kept_moduli() or kept_spatial() need not
  /// compute them; 0 if the law keeps nothing.
  virtual std::size_t kept_size(const Rule& rule) const = 0;

  /// Computes the rule's first Piola-Kirchhoff stresses P [E0]: sums over its points with the weights, or the discrete
  /// gradient. `kept` may be null. Returns the least admissibility of the time points and of the segment's end.
  virtual Pack stress(const Ends& ends, const Rule& rule, Gradient* p, Pack* kept) const = 0;
  /// Computes the derivatives of these sums by H at the segment's end; symmetric unless the rule is a discrete
  /// gradient.
  virtual void moduli(const Ends& ends, const Rule& rule, Moduli* a) const = 0;
  /// Does the same from what stress() kept. Returns false if the points must be evaluated anew.
  virtual bool kept_moduli(std::size_t size, const Pack* kept, const Rule& rule, Moduli* a) const = 0;
  /// Compute F^-1 and the moduli in the deformed body at one time point, from the ends, or from what stress() kept by a
  /// rule with that point alone. Only if has_spatial_tangent().
  virtual void spatial(const Ends& ends, const RulePoint& point, SpatialState<Pack, G>* states) const = 0;
  virtual void kept_spatial(std::size_t size, const Pack* kept, SpatialState<Pack, G>* states) const = 0;

  /// Compute what these names say of single displacement gradients.
  virtual void energy(std::size_t size, const Gradient* h, Pack* w) const = 0;
  virtual void stress(std::size_t size, const Gradient* h, Gradient* p, Pack* admissible) const = 0;
  virtual void stress_and_moduli(std::size_t size, const Gradient* h, Gradient* p, Small<Pack, G * G>* a) const = 0;
  virtual void stress_and_space_moduli(std::size_t size, const Gradient* h, Gradient* p, Moduli* a) const = 0;
};

/// A struct of member templates behind it. Compiled once a law and space, for all elements. The loops of standard
/// elements are flattened: without that, g++ calls a function for each point.
template <class Law, class Space>
class PointLawOf final : public PointLaw<Space> {
  using Base = PointLaw<Space>;
  using Points = LawPoints<Law, Space>;
  using typename Base::Ends;
  using typename Base::Gradient;
  using typename Base::Moduli;
  static constexpr std::size_t G = Base::G;

 public:
  explicit PointLawOf(Law law) : law_(std::move(law)) {}

  bool can_invert() const override { return Points::can_invert(); }
  bool has_mixed_steps() const override { return Points::has_mixed_steps(); }
  bool is_limited() const override { return Points::is_limited(); }
  bool has_spatial_tangent() const override { return Points::has_spatial_tangent(); }
  Pack admissibility(const Gradient& h) const override { return points().admissibility(h); }
  std::size_t kept_size(const Rule& rule) const override { return Points::template kept_size<Pack>(rule); }

  [[gnu::flatten]] Pack stress(const Ends& ends, const Rule& rule, Gradient* p, Pack* kept) const override {
    return points().stress(ends, rule, p, kept);
  }
  [[gnu::flatten]] void moduli(const Ends& ends, const Rule& rule, Moduli* a) const override {
    points().moduli(ends, rule, a);
  }
  [[gnu::flatten]] bool kept_moduli(std::size_t size, const Pack* kept, const Rule& rule, Moduli* a) const override {
    return points().kept_moduli(size, kept, rule, a);
  }
  [[gnu::flatten]] void spatial(const Ends& ends, const RulePoint& point,
                                SpatialState<Pack, G>* states) const override {
    points().spatial(ends, point, states);
  }
  void kept_spatial(std::size_t size, const Pack* kept, SpatialState<Pack, G>* states) const override {
    points().kept_spatial(size, kept, states);
  }

  void energy(std::size_t size, const Gradient* h, Pack* w) const override { points().energy(size, h, w); }
  void stress(std::size_t size, const Gradient* h, Gradient* p, Pack* admissible) const override {
    points().stress(size, h, p, admissible);
  }
  void stress_and_moduli(std::size_t size, const Gradient* h, Gradient* p, Small<Pack, G * G>* a) const override {
    points().stress_and_moduli(size, h, p, a);
  }
  void stress_and_space_moduli(std::size_t size, const Gradient* h, Gradient* p, Moduli* a) const override {
    points().stress_and_space_moduli(size, h, p, a);
  }

 private:
  Points points() const { return Points(law_); }

  Law law_;
};

}  // namespace ixos
