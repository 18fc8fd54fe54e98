#include <algorithm>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "rule/straight_points.hpp"
#include "term/body/batch_ends.hpp"
#include "term/body/body_cells.hpp"
#include "term/body/elastic_terms.hpp"
#include "term/body/elasticity_in.hpp"
#include "term/body/kept_action.hpp"

namespace ixos {
namespace {

/// Returns a rule with one point whose tangent is that of a mean over a straight path, but for terms of second order in
/// the step; other rules as they are. The weight counts by the point's share of the end, so the point is the mean of
/// the rule's points with those shares as weights.
Rule tangent_at_one_point(const Rule& rule) {
  if (rule.mean != Mean::Points || !has_straight_points(rule)) return rule;
  double share = 0, place = 0;
  for (const RulePoint& point : rule.points) {
    share += point.weight * point.to;
    place += point.weight * point.to * point.to;
  }
  place /= share;
  return {{{share / place, 1 - place, 0, place}}};
}

/// The energy int W(H) dV. Neither the cells' type nor the law is compiled in.
template <class Space>
class StandardTerm final : public ElasticityIn<Space> {
  using Base = ElasticityIn<Space>;
  using Cells = BodyCells<Space>;
  using typename Base::Seen;
  using Gradient = typename Cells::Gradient;
  using Moduli = typename Cells::Moduli;
  static constexpr std::size_t G = Space::G, D = Cells::D;

 public:
  StandardTerm(std::unique_ptr<Cells> cells, std::shared_ptr<const ElasticLaw> law)
      : Base(std::move(law)), cells_(std::move(cells)) {}

  void place(const Pattern& pattern) override { cells_->place(pattern); }

  bool add_force(const Segment& segment, const Rule& rule, double* f) const override {
    return force(segment, rule, nullptr, f);
  }
  void add_tangent(const Segment& segment, const Rule& rule, Tangent, double* values) const override {
    add_tangent(segment, rule, nullptr, values);
  }

  std::unique_ptr<KeptPoints> create_kept() const override { return std::make_unique<Kept>(); }
  bool add_force_and_keep(const Segment& segment, const Rule& rule, KeptPoints& kept, double* f) const override {
    auto& numbers = static_cast<Kept&>(kept).numbers;
    numbers.resize(cells_->size() * kept_size(rule));
    return force(segment, rule, numbers.empty() ? nullptr : numbers.data(), f);
  }
  void add_kept_tangent(const Segment& segment, const Rule& rule, Tangent, const KeptPoints& kept,
                        double* values) const override {
    const auto& numbers = static_cast<const Kept&>(kept).numbers;
    const bool serves = kept_size(rule) > 0 && segment.iterate == nullptr;
    add_tangent(segment, rule, serves ? numbers.data() : nullptr, values);
  }

  bool add_row_sums(const Segment& segment, double* sums) const override {
    with_moduli(segment, end_rule(), [&](std::size_t b, const auto& moduli) { cells_->add_row_sums(b, moduli, sums); });
    return true;
  }
  void add_diagonal(const Segment& segment, double* diagonal) const override {
    with_moduli(segment, end_rule(),
                [&](std::size_t b, const auto& moduli) { cells_->add_diagonal(b, moduli, diagonal); });
  }

  /// Returns null in bodies of revolution.
  std::unique_ptr<TangentAction> create_action() const override {
    if constexpr (!Space::is_ring) return std::make_unique<Action>(*this);
    return nullptr;
  }

 protected:
  std::size_t cells() const override { return cells_->cells(); }
  void for_each_seen(const double* u, const std::function<void(const Seen&)>& visit) const override {
    Seen seen;
    seen.h.resize(cells_->points());
    for (std::size_t b = 0; b < cells_->size(); ++b) {
      cells_->gradients(b, u, seen.h.data());
      seen.volumes.assign(cells_->weights(b), cells_->weights(b) + cells_->points());
      seen.owned = cells_->owned(b);
      seen.first = Cells::number(b, 0);
      seen.lanes = cells_->lanes(b);
      visit(seen);
    }
  }

 private:
  /// The numbers that the law keeps, by batch, point and number.
  class Kept final : public KeptPoints {
   public:
    std::vector<Pack> numbers;
  };

  /// Returns how many packs a batch keeps of a force by that rule.
  std::size_t kept_size(const Rule& rule) const { return cells_->points() * this->points_law().kept_size(rule); }

  /// Returns whether all Jacobians are greater than 0.
  bool force(const Segment& segment, const Rule& rule, Pack* kept, double* f) const {
    const PointLaw<Space>& law = this->points_law();
    const std::size_t size = kept == nullptr ? 0 : kept_size(rule);
    BatchEnds<Space> ends(*cells_, segment);
    Scratch<Gradient> p(cells_->points());
    Pack least_jacobian = 1.0;
    for (std::size_t b = 0; b < cells_->size(); ++b) {
      least_jacobian =
          smaller(least_jacobian, law.stress(ends.of(b), rule, p.data(), kept == nullptr ? nullptr : kept + b * size));
      cells_->add_forces(b, p.data(), f);
    }
    return least(least_jacobian) > 0;
  }

  /// Calls visit(batch, moduli of its points) for all batches.
  template <class Visit>
  void with_moduli(const Segment& segment, const Rule& rule, const Visit& visit) const {
    BatchEnds<Space> ends(*cells_, segment);
    PointEnds<Pack, G> here;
    const typename Cells::ModuliOf moduli = [&](std::size_t first, std::size_t count, Moduli* a) {
      this->points_law().moduli(here.part(first, count), rule, a);
    };
    for (std::size_t b = 0; b < cells_->size(); ++b) {
      here = ends.of(b);
      visit(b, moduli);
    }
  }

  void add_tangent(const Segment& segment, const Rule& rule, const Pack* kept, double* values) const {
    const PointLaw<Space>& law = this->points_law();
    // With one time point in three dimensions the spatial form is twice as fast. Several time points share the
    // contraction of their mean moduli.
    if constexpr (D == 3)
      if (law.has_spatial_tangent() && rule.points.size() == 1 && rule.mean == Mean::Points)
        return add_spatial_tangent(segment, rule.points[0], kept, values);
    if (kept == nullptr)
      return with_moduli(segment, rule, [&](std::size_t b, const auto& moduli) {
        cells_->add_tangent(b, rule.is_gradient(), moduli, values);
      });
    const std::size_t size = law.kept_size(rule), batch = cells_->points() * size;
    BatchEnds<Space> ends(*cells_, segment);
    std::size_t b = 0;
    const typename Cells::ModuliOf moduli = [&](std::size_t first, std::size_t count, Moduli* a) {
      if (!law.kept_moduli(count, kept + b * batch + first * size, rule, a))
        law.moduli(ends.of(b).part(first, count), rule, a);
    };
    for (; b < cells_->size(); ++b) cells_->add_tangent(b, true, moduli, values);
  }

  void add_spatial_tangent(const Segment& segment, const RulePoint& point, const Pack* kept, double* values) const {
    const PointLaw<Space>& law = this->points_law();
    Rule rule;
    rule.points = {point};
    const std::size_t size = kept == nullptr ? 0 : law.kept_size(rule), batch = cells_->points() * size;
    BatchEnds<Space> ends(*cells_, segment);
    PointEnds<Pack, G> here;
    std::size_t b = 0;
    const std::function<void(std::size_t, std::size_t, SpatialState<Pack, G>*)> states =
        [&](std::size_t first, std::size_t count, SpatialState<Pack, G>* all) {
          if (size > 0)
            law.kept_spatial(count, kept + b * batch + first * size, all);
          else
            law.spatial(here.part(first, count), point, all);
        };
    for (; b < cells_->size(); ++b) {
      if (size == 0) here = ends.of(b);
      cells_->add_spatial_tangent(b, point.weight * point.to, states, values);
    }
  }

  class Action final : public KeptAction<Space> {
   public:
    explicit Action(const StandardTerm& term) : KeptAction<Space>(*term.cells_), term_(term) {}

    /// A mean over a straight path is evaluated at one point: with four, a product took up to four times as long. The
    /// solution does not change, as Newton's method corrects what is missing, of second order in the step.
    void linearize(const Segment& segment, const Rule& asked, Tangent, const LinearPart& linear) override {
      const Rule rule = tangent_at_one_point(asked);
      if (term_.points_law().has_spatial_tangent())
        keep_of(SpatialProduct<D>(term_.law()->lame(), rule, linear.rest, linear.inertia), segment);
      else
        keep_of(ModuliProduct<D>(rule, linear.rest, linear.inertia), segment);
    }

   private:
    template <class Product>
    void keep_of(const Product& product, const Segment& segment) {
      const Cells& cells = *term_.cells_;
      const PointLaw<Space>& law = term_.points_law();
      BatchEnds<Space> ends(cells, segment);
      this->keep(PointProduct<D>(product), [&](std::size_t b, NarrowPack* data) {
        const PointEnds<Pack, G> here = ends.of(b);
        for (std::size_t first = 0; first < here.size; first += Product::most)
          product.keep(law, here.part(first, std::min(Product::most, here.size - first)), cells.space_points(b) + first,
                       data + first * product.point_size());
      });
    }

    const StandardTerm& term_;
  };

  std::unique_ptr<Cells> cells_;
};

}  // namespace

std::unique_ptr<Elasticity> make_standard_term(const LocalMesh& mesh, const LocalBlock& block, const Pattern& pattern,
                                               const std::shared_ptr<const ElasticLaw>& law, int points) {
  return in_space_of(mesh, [&](auto space) -> std::unique_ptr<Elasticity> {
    return std::make_unique<StandardTerm<decltype(space)>>(make_body_cells(space, mesh, block, pattern, points), law);
  });
}

}  // namespace ixos
