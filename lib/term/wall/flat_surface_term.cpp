// Interaction of a surface with a half-space.
#include <algorithm>
#include <utility>
#include <vector>

#include "base/scratch.hpp"
#include "interaction/side_points.hpp"
#include "term/end_scratch.hpp"
#include "term/wall/point_laws.hpp"
#include "term/wall/side_action.hpp"
#include "term/wall/surface_terms.hpp"

namespace ixos {
namespace {

/// Sides in D dimensions.
template <std::size_t D>
class FlatSurfaceTerm final : public SurfaceInteractionTerm<FlatSurfaceTerm<D>> {
  friend SurfaceInteractionTerm<FlatSurfaceTerm>;
  using Sides = FlatWallSides<D>;

 public:
  FlatSurfaceTerm(const LocalMesh& mesh, const std::vector<LocalSide>& group, std::unique_ptr<Sides> sides,
                  const std::shared_ptr<const GapLaw>& law, double margin)
      : margin_(margin), sides_(std::move(sides)), laws_(mesh, group, sides_->reference_places(), law) {}

  void place(const Pattern& pattern) override { sides_->place(pattern); }

  bool add_force(const Segment& segment, const Rule& rule, double* f) const override {
    const PointLaws::Kept laws = this->laws(segment.histories);
    Pack least_gap = 1.0;
    Gaps gaps(*sides_, segment);
    Scratch<Pack> forces(sides_->points());
    for (std::size_t b = 0; b < sides_->size(); ++b) {
      Pack least_here(1e300);
      const bool acts = rule_tractions(laws.of(b), gaps.of(b), rule, forces.data(), least_here);
      least_gap = smaller(least_gap, least_here);
      if (!acts) continue;
      for (std::size_t q = 0; q < forces.size(); ++q) forces[q] = -(sides_->measure(b)[q] * forces[q]);
      sides_->add_forces(b, forces.data(), f);
    }
    return least(least_gap) > 0 || !this->needs_positive_gaps();
  }

  void add_tangent(const Segment& segment, const Rule& rule, Tangent kind, double* values) const override {
    for_each_stiffness(segment, rule, kind, [&](std::size_t b, const Pack* k, bool acts) {
      if (acts) sides_->add_tangent(b, k, values);
    });
  }

  std::unique_ptr<TangentAction> create_action() const override {
    return std::make_unique<SideAction<Sides>>(
        *sides_, [this](const Segment& segment, const Rule& rule, Tangent kind, typename Sides::Matrices& matrices) {
          for_each_stiffness(segment, rule, kind, [&](std::size_t b, const Pack* k, bool) { matrices.set(b, k); });
        });
  }

  bool add_row_sums(const Segment& segment, double* sums) const override {
    const PointLaws::Kept laws = this->laws(segment.histories);
    double least_gap = 1;
    Scratch<Pack> gap(sides_->points()), stiffness(gap.size());
    for (std::size_t b = 0; b < sides_->size(); ++b) {
      sides_->gaps(b, segment.to, gap.data());
      for (std::size_t q = 0; q < gap.size(); ++q) {
        least_gap = std::min(least_gap, least(gap[q]));
        stiffness[q] =
            sides_->total_shape(q) * sides_->measure(b)[q] * std::experimental::abs(laws.at(b, q).stiffness(gap[q]));
      }
      sides_->add_row_sums(b, stiffness.data(), sums);
    }
    return least_gap > 0 || !this->needs_positive_gaps();
  }

  double energy(const Place& at) const override {
    const PointLaws::Kept laws = this->laws(at.histories);
    Scratch<Pack> gap(sides_->points());
    Pack sum = 0.0;
    for (std::size_t b = 0; b < sides_->size(); ++b) {
      sides_->gaps(b, at.u, gap.data());
      Pack own = 0.0;
      for (std::size_t q = 0; q < gap.size(); ++q) own += sides_->measure(b)[q] * laws.at(b, q).energy(gap[q]);
      sum += sides_->owned(b) * own;
    }
    return total(sum);
  }

  double admissible_step(const Segment& segment, const Rule& rule, const double* direction) const override {
    if (!this->needs_positive_gaps()) return 1;
    Pack step = 1.0;
    Gaps gaps(*sides_, segment);
    Scratch<Pack> changes(sides_->points());
    for (std::size_t b = 0; b < sides_->size(); ++b) {
      sides_->gap_changes(b, direction, changes.data());
      step = smaller(step, ixos::admissible_step(gaps.of(b), changes.data(), rule, margin_, laws_.equilibrium_gap()));
    }
    return least(step);
  }

  double mean_potential(const Segment& segment) const override {
    const PointLaws::Kept laws = this->laws(segment.histories);
    Pack sum = 0.0;
    for_each_way(segment, [&](std::size_t b, std::size_t q, const Pack& from, const Pack& to) {
      sum += sides_->owned(b) * sides_->measure(b)[q] * laws.at(b, q).mean_potential(from, to);
    });
    return total(sum);
  }

  double gap_ratio(const Segment& way) const override {
    if (!this->needs_positive_gaps()) return 1;
    const double near = 10 * laws_.equilibrium_gap();
    double largest = 1;
    for_each_way(way, [&](std::size_t, std::size_t, const Pack& r0, const Pack& r1) {
      const Pack lesser = smaller(r0, r1);
      const Pack ratio = select(lesser < near, Pack((r0 + r1 - lesser) / lesser), Pack(1.0));
      largest = std::max(largest, -least(Pack(-ratio)));
    });
    return largest;
  }

  double rounding(const Place& at) const override {
    const PointLaws::Kept laws = this->laws(at.histories);
    Pack sum = 0.0;
    for_each_point(at.u, [&](std::size_t b, std::size_t q, const Pack& gap) {
      const Pack force = sides_->measure(b)[q] * laws.at(b, q).magnitude(gap);
      sum += sides_->owned(b) * force * force;
    });
    return total(sum);
  }

  LowestPoint lowest_point(const Place& at) const override { return sides_->lowest_gap(at.u); }
  /// The law of a flat wall notices what is beyond it.
  LowestPoint passage(const Segment&) const override { return {}; }

  void add_nodal_measure(CountedSides& counted, double* measure) const override {
    sides_->add_nodal_measure(counted, measure);
  }
  void lower_nodal_gap(const Place& at, double* gap) const override { sides_->lower_nodal_gaps(at.u, gap); }
  void set_nodal_normal(const Place&, double* normal) const override { sides_->set_nodal_normals(normal); }

  void report(const Place& at, InteractionReport& report) const override {
    const PointLaws::Kept laws = this->laws(at.histories);
    report.force.resize(D, 0.0);
    for_each_point(at.u, [&](std::size_t b, std::size_t q, const Pack& r) {
      const Pack& owned = sides_->owned(b);
      report.least_gap = std::min(report.least_gap, least(r));
      report.measure += total(select(r < laws_.adhesion_gap(), Pack(owned * sides_->area(b)[q]), Pack(0.0)));
      const double force = total(Pack(owned * sides_->measure(b)[q] * laws.at(b, q).traction(r)));
      for (std::size_t d = 0; d < D; ++d) report.force[d] += force * sides_->normal()[d];
    });
  }

 private:
  /// The gaps of one batch after another at the ends of a segment.
  class Gaps {
   public:
    Gaps(const Sides& sides, const Segment& segment) : sides_(sides), ends_(sides.points(), segment) {}

    GapEnds<Pack> of(std::size_t b) {
      ends_.set([&](const double* u, Pack* r) { sides_.gaps(b, u, r); },
                [&](const double* change, Pack* r) { sides_.gap_changes(b, change, r); });
      return {ends_.size(), ends_.to(), ends_.from(), ends_.velocity()};
    }

   private:
    const Sides& sides_;
    EndScratch<Pack> ends_;
  };

  /// Calls visit(batch, stiffnesses of its points times the measure, whether one of them may differ from zero).
  template <class Visit>
  void for_each_stiffness(const Segment& segment, const Rule& rule, Tangent kind, const Visit& visit) const {
    const PointLaws::Kept laws = this->laws(segment.histories);
    Gaps gaps(*sides_, segment);
    Scratch<Pack> k(sides_->points());
    for (std::size_t b = 0; b < sides_->size(); ++b) {
      const bool acts = rule_stiffnesses(laws.of(b), gaps.of(b), rule, kind == Tangent::Convex, k.data());
      for (std::size_t q = 0; q < k.size(); ++q) k[q] = sides_->measure(b)[q] * k[q];
      visit(b, k.data(), acts);
    }
  }

  /// Calls visit(batch, quadrature point, gap).
  template <class Visit>
  void for_each_point(const double* u, const Visit& visit) const {
    Scratch<Pack> gap(sides_->points());
    for (std::size_t b = 0; b < sides_->size(); ++b) {
      sides_->gaps(b, u, gap.data());
      for (std::size_t q = 0; q < gap.size(); ++q) visit(b, q, gap[q]);
    }
  }

  /// Calls visit(batch, quadrature point, gap at the start, gap at the end).
  template <class Visit>
  void for_each_way(const Segment& way, const Visit& visit) const {
    Scratch<Pack> from(sides_->points()), to(from.size());
    for (std::size_t b = 0; b < sides_->size(); ++b) {
      sides_->gaps(b, way.from, from.data());
      sides_->gaps(b, way.to, to.data());
      for (std::size_t q = 0; q < to.size(); ++q) visit(b, q, from[q], to[q]);
    }
  }

  /// See SurfaceInteractionTerm.
  void add_nodal_pressure(const Place& at, double* force) const {
    const PointLaws::Kept laws = this->laws(at.histories);
    Scratch<Pack> gap(sides_->points()), pressure(gap.size());
    for (std::size_t b = 0; b < sides_->size(); ++b) {
      sides_->gaps(b, at.u, gap.data());
      for (std::size_t q = 0; q < gap.size(); ++q) pressure[q] = sides_->measure(b)[q] * laws.at(b, q).traction(gap[q]);
      sides_->add_weighted_nodal(b, pressure.data(), force);
    }
  }

  /// See SurfaceInteractionTerm.
  template <class Visit>
  void for_each_gap(const double* u, const Visit& visit) const {
    for_each_point(u, [&](std::size_t b, std::size_t q, const Pack& gap) {
      visit(b, q, gap, Pack(sides_->owned(b) * sides_->measure(b)[q]));
    });
  }

  double margin_;
  std::unique_ptr<Sides> sides_;
  PointLaws laws_;
};

}  // namespace

Interactions make_flat_terms(const LocalMesh& mesh, const std::vector<LocalSide>& sides, const Pattern& pattern,
                             const std::shared_ptr<const GapLaw>& law, const HalfSpace& wall,
                             const SurfaceOptions& options) {
  const auto make_sides = [&](const SideGroup& group, auto dimension) {
    return make_flat_sides<dimension.value>(mesh, group, pattern, wall, options.points);
  };
  return make_terms<FlatSurfaceTerm>(mesh, sides, options, make_sides, law, options.margin);
}

}  // namespace ixos
