/// Elastic laws behind one interface.
#pragma once
#include <cstddef>
#include <memory>
#include <stdexcept>
#include <type_traits>
#include <utility>

#include "base/pack.hpp"
#include "base/small_matrix.hpp"
#include "material/lame.hpp"
#include "material/point_law.hpp"
#include "material/revolved_law.hpp"
#include "material/strain.hpp"

namespace ixos {

/// A hyperelastic law at a pack of quadrature points: energy W per reference volume [E0] of the displacement gradient H
/// [-], in plane strain (D = 2) and in three dimensions. A law is a struct of member templates like LinearElastic;
/// ElasticLawOf puts it behind this interface. See NeoHooke for what each function computes.
class ElasticLaw {
 public:
  virtual ~ElasticLaw() = default;

  /// Return the law at many points, for kernels.
  virtual const PointLaw<PlaneSpace>& points(PlaneSpace) const = 0;
  virtual const PointLaw<SolidSpace>& points(SolidSpace) const = 0;
  virtual const PointLaw<RingSpace>& points(RingSpace) const = 0;

  /// Returns the elastic constants at small strains.
  virtual Lame lame() const = 0;
  /// Returns whether the law has a discrete gradient, for schemes that conserve energy by one.
  virtual bool has_discrete_gradient() const = 0;

  /// Returns whether states with J > 0 may be inadmissible.
  virtual bool has_limit() const = 0;
  /// Returns a number that is greater than 0 where H is admissible: J, or -1 beyond the limit of a law that has one.
  virtual Pack admissibility(const Small<Pack, 2>& h) const { return determinant(deformation_gradient(h)); }
  virtual Pack admissibility(const Small<Pack, 3>& h) const { return determinant(deformation_gradient(h)); }

  virtual Pack energy(const Small<Pack, 2>& h) const = 0;
  virtual Pack energy(const Small<Pack, 3>& h) const = 0;
  /// These return admissibility(h) and compute P. If that is not greater than 0, P is unusable.
  virtual Pack stress(const Small<Pack, 2>& h, Small<Pack, 2>& p) const = 0;
  virtual Pack stress(const Small<Pack, 3>& h, Small<Pack, 3>& p) const = 0;
  virtual Pack stress_and_moduli(const Small<Pack, 2>& h, Small<Pack, 2>& p, Small<Pack, 4>& moduli) const = 0;
  virtual Pack stress_and_moduli(const Small<Pack, 3>& h, Small<Pack, 3>& p, Small<Pack, 9>& moduli) const = 0;
  virtual Pack out_of_plane_stress(const Small<Pack, 2>& h) const = 0;
  /// These throw std::logic_error if the law has no discrete gradient.
  virtual void discrete_gradient(const Small<Pack, 2>& h0, const Small<Pack, 2>& h1, Small<Pack, 2>& p) const = 0;
  virtual void discrete_gradient(const Small<Pack, 3>& h0, const Small<Pack, 3>& h1, Small<Pack, 3>& p) const = 0;
  virtual void discrete_gradient_moduli(const Small<Pack, 2>& h0, const Small<Pack, 2>& h1,
                                        Small<Pack, 4>& moduli) const = 0;
  virtual void discrete_gradient_moduli(const Small<Pack, 3>& h0, const Small<Pack, 3>& h1,
                                        Small<Pack, 9>& moduli) const = 0;
};

/// A struct of member templates as an ElasticLaw. It says `has_discrete_gradient`, and may say `has_limit`.
template <class Law>
class ElasticLawOf final : public ElasticLaw {
 public:
  explicit ElasticLawOf(Law law)
      : law_(std::move(law)), plane_(law_), solid_(law_), ring_(typename RingLaw<Law>::type(law_)) {}
  const Law& law() const { return law_; }

  const PointLaw<PlaneSpace>& points(PlaneSpace) const override { return plane_; }
  const PointLaw<SolidSpace>& points(SolidSpace) const override { return solid_; }
  const PointLaw<RingSpace>& points(RingSpace) const override { return ring_; }

  Lame lame() const override { return law_.lame; }
  bool has_discrete_gradient() const override { return Law::has_discrete_gradient; }
  bool has_limit() const override { return HasLimit<Law>::value; }
  Pack admissibility(const Small<Pack, 2>& h) const override { return admissible<2>(h); }
  Pack admissibility(const Small<Pack, 3>& h) const override { return admissible<3>(h); }

  Pack energy(const Small<Pack, 2>& h) const override { return law_.energy(h); }
  Pack energy(const Small<Pack, 3>& h) const override { return law_.energy(h); }
  Pack stress(const Small<Pack, 2>& h, Small<Pack, 2>& p) const override { return law_.stress(h, p); }
  Pack stress(const Small<Pack, 3>& h, Small<Pack, 3>& p) const override { return law_.stress(h, p); }
  Pack stress_and_moduli(const Small<Pack, 2>& h, Small<Pack, 2>& p, Small<Pack, 4>& moduli) const override {
    return law_.stress_and_moduli(h, p, moduli);
  }
  Pack stress_and_moduli(const Small<Pack, 3>& h, Small<Pack, 3>& p, Small<Pack, 9>& moduli) const override {
    return law_.stress_and_moduli(h, p, moduli);
  }
  Pack out_of_plane_stress(const Small<Pack, 2>& h) const override { return law_.out_of_plane_stress(h); }
  void discrete_gradient(const Small<Pack, 2>& h0, const Small<Pack, 2>& h1, Small<Pack, 2>& p) const override {
    discrete<2>(h0, h1, p);
  }
  void discrete_gradient(const Small<Pack, 3>& h0, const Small<Pack, 3>& h1, Small<Pack, 3>& p) const override {
    discrete<3>(h0, h1, p);
  }
  void discrete_gradient_moduli(const Small<Pack, 2>& h0, const Small<Pack, 2>& h1,
                                Small<Pack, 4>& moduli) const override {
    discrete_moduli<2>(h0, h1, moduli);
  }
  void discrete_gradient_moduli(const Small<Pack, 3>& h0, const Small<Pack, 3>& h1,
                                Small<Pack, 9>& moduli) const override {
    discrete_moduli<3>(h0, h1, moduli);
  }

 private:
  template <std::size_t D>
  Pack admissible(const Small<Pack, D>& h) const {
    if constexpr (HasLimit<Law>::value)
      return law_.admissibility(h);
    else
      return ElasticLaw::admissibility(h);
  }
  template <std::size_t D>
  void discrete(const Small<Pack, D>& h0, const Small<Pack, D>& h1, Small<Pack, D>& p) const {
    if constexpr (Law::has_discrete_gradient)
      law_.discrete_gradient(h0, h1, p);
    else
      throw std::logic_error("the elastic law has no discrete gradient");
  }
  template <std::size_t D>
  void discrete_moduli(const Small<Pack, D>& h0, const Small<Pack, D>& h1, Small<Pack, D * D>& moduli) const {
    if constexpr (Law::has_discrete_gradient)
      law_.discrete_gradient_moduli(h0, h1, moduli);
    else
      throw std::logic_error("the elastic law has no discrete gradient");
  }

  Law law_;
  PointLawOf<Law, PlaneSpace> plane_;
  PointLawOf<Law, SolidSpace> solid_;
  PointLawOf<typename RingLaw<Law>::type, RingSpace> ring_;
};

template <class Law>
std::shared_ptr<const ElasticLaw> elastic_law(Law law) {
  return std::make_shared<ElasticLawOf<Law>>(std::move(law));
}

/// An ElasticLaw in a space, for kernels.
template <class Space>
class AnyLaw {
 public:
  explicit AnyLaw(std::shared_ptr<const ElasticLaw> law)
      : law_(std::move(law)), points_(&law_->points(Space{})), lame(law_->lame()) {}

  const ElasticLaw& law() const { return *law_; }
  const PointLaw<Space>& points() const { return *points_; }

 private:
  std::shared_ptr<const ElasticLaw> law_;
  const PointLaw<Space>* points_;

 public:
  Lame lame;
};

}  // namespace ixos
