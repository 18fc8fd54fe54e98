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
#include "material/strain.hpp"

namespace ixos {

/// A hyperelastic law at a pack of quadrature points: energy W per reference volume [E0] of the displacement gradient H
/// [-], in plane strain (D = 2) and in three dimensions. A law is a struct of member templates like LinearElastic;
/// ElasticLawOf puts it behind this interface. See NeoHooke for what each function computes.
class ElasticLaw {
 public:
  virtual ~ElasticLaw() = default;

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

/// Whether a struct of member templates defines its own admissibility(h), and says so by `has_limit`.
template <class Law, class = void>
struct HasLimit : std::false_type {};
template <class Law>
struct HasLimit<Law, std::void_t<decltype(Law::has_limit)>> : std::bool_constant<Law::has_limit> {};

/// A struct of member templates as an ElasticLaw. It says `has_discrete_gradient`, and may say `has_limit`.
template <class Law>
class ElasticLawOf final : public ElasticLaw {
 public:
  explicit ElasticLawOf(Law law) : law_(std::move(law)) {}
  const Law& law() const { return law_; }

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
};

template <class Law>
std::shared_ptr<const ElasticLaw> elastic_law(Law law) {
  return std::make_shared<ElasticLawOf<Law>>(std::move(law));
}

/// An ElasticLaw with the members of a law, for kernels.
class AnyElasticLaw {
 public:
  static constexpr bool can_invert = true;
  static constexpr bool has_spatial_tangent = false;
  static constexpr bool keeps_state = false;
  static constexpr bool has_limit = true;  ///< a law behind the interface may have one, see is_limited()

  explicit AnyElasticLaw(std::shared_ptr<const ElasticLaw> law)
      : lame(law->lame()), law_(std::move(law)), limited_(law_->has_limit()) {}

  Lame lame;

  bool is_limited() const { return limited_; }
  template <std::size_t D>
  Pack admissibility(const Small<Pack, D>& h) const {
    return limited_ ? law_->admissibility(h) : determinant(deformation_gradient(h));
  }
  template <std::size_t D>
  Pack energy(const Small<Pack, D>& h) const {
    return law_->energy(h);
  }
  template <std::size_t D>
  Pack stress(const Small<Pack, D>& h, Small<Pack, D>& p) const {
    return law_->stress(h, p);
  }
  template <std::size_t D>
  Pack stress_and_moduli(const Small<Pack, D>& h, Small<Pack, D>& p, Small<Pack, D * D>& moduli) const {
    return law_->stress_and_moduli(h, p, moduli);
  }
  template <std::size_t D>
  void discrete_gradient(const Small<Pack, D>& h0, const Small<Pack, D>& h1, Small<Pack, D>& p) const {
    law_->discrete_gradient(h0, h1, p);
  }
  template <std::size_t D>
  void discrete_gradient_moduli(const Small<Pack, D>& h0, const Small<Pack, D>& h1, Small<Pack, D * D>& moduli) const {
    law_->discrete_gradient_moduli(h0, h1, moduli);
  }
  Pack out_of_plane_stress(const Small<Pack, 2>& h) const { return law_->out_of_plane_stress(h); }

 private:
  std::shared_ptr<const ElasticLaw> law_;
  bool limited_;
};

/// Return the laws that are compiled into the element kernels.
std::shared_ptr<const ElasticLaw> neo_hooke(const Lame& lame);
std::shared_ptr<const ElasticLaw> linear_elastic(const Lame& lame);

}  // namespace ixos
