// Interaction of a surface with a half-space.
#include <algorithm>
#include <cmath>

#include "interaction/damage_law.hpp"
#include "interaction/surface_kernel.hpp"
#include "interaction/van_der_waals.hpp"
#include "term/child_matrices.hpp"
#include "term/corner_matrices.hpp"
#include "term/wall/flat_sides.hpp"
#include "term/wall/point_laws.hpp"
#include "term/wall/surface_terms.hpp"

namespace ixos {
namespace {

/// Sides of one element type.
template <class SideElement, class Law>
class FlatSurfaceTerm final : public InteractionOverSteps<FlatSurfaceTerm<SideElement, Law>, Law> {
  using Laws = PointLaws<Law>;
  using Kernel = SurfaceKernel<SideElement, typename Laws::OfBatch>;
  using Sides = FlatSides<SideElement>;
  static constexpr std::size_t D = Sides::D;
  static constexpr std::size_t N = Sides::N;
  using Nodal = typename Sides::Nodal;
  friend InteractionOverSteps<FlatSurfaceTerm, Law>;
  friend SurfaceInteractionTerm<FlatSurfaceTerm, Law>;

 public:
  FlatSurfaceTerm(const LocalMesh& mesh, const std::vector<LocalSide>& sides, const Pattern& pattern, const Law& law,
                  const HalfSpace& wall, const SurfaceOptions& options)
      : margin_(options.margin),
        sides_(mesh, sides, pattern, wall, options.points),
        laws_(mesh, sides, sides_.quadrature().size(), law) {
    sides_.scale(options.factor);
  }

  void place(const Pattern& pattern) override { sides_.place(pattern); }

  bool add_force(const Segment& segment, const Rule& rule, double* f) const override {
    const auto& laws = this->laws(segment.histories);
    Pack least_gap = 1.0;
    for (std::size_t b = 0; b < sides_.size(); ++b) {
      const Gaps gaps(sides_, b, segment);
      Nodal along{};
      least_gap = smaller(least_gap, Kernel::add_force(laws.of(b), sides_.quadrature(), sides_.measure(b),
                                                       gaps.segment(), rule, along));
      sides_.batches().scatter_force(b, sides_.from_normal(along), f);
    }
    return least(least_gap) > 0 || !this->needs_positive_gaps();
  }

  void add_tangent(const Segment& segment, const Rule& rule, Tangent kind, double* values) const override {
    const auto& laws = this->laws(segment.histories);
    for (std::size_t b = 0; b < sides_.size(); ++b) {
      const Gaps gaps(sides_, b, segment);
      Small<Pack, N> along{};
      Kernel::add_tangent(laws.of(b), sides_.quadrature(), sides_.measure(b), gaps.segment(), rule,
                          kind == Tangent::Convex, along);
      Small<Pack, N * D> tangent;
      sides_.spread(along, tangent);
      sides_.batches().scatter_tangent(b, tangent, values);
    }
  }

  std::unique_ptr<TangentAction> create_action() const override { return std::make_unique<Action>(*this); }

  bool add_row_sums(const Segment& segment, double* sums) const override {
    const auto& laws = this->laws(segment.histories);
    double least_gap = 1;
    for (std::size_t b = 0; b < sides_.size(); ++b) {
      const Nodal gap = sides_.gaps_of(b, segment.to);
      Nodal rows{};
      for (std::size_t q = 0; q < sides_.quadrature().size(); ++q) {
        const auto& shape = sides_.quadrature().value[q];
        const Pack r = Kernel::interpolate(shape, gap);
        least_gap = std::min(least_gap, least(r));
        double total_shape = 0;
        for (double value : shape) total_shape += std::abs(value);
        const Pack stiffness = total_shape * sides_.measure(b)[q] * std::experimental::abs(laws.at(b, q).stiffness(r));
        for (std::size_t a = 0; a < N; ++a) rows[a] += std::abs(shape[a]) * stiffness;
      }
      // |n_i n_j| summed over j.
      double normal_sum = 0;
      for (std::size_t d = 0; d < D; ++d) normal_sum += std::abs(sides_.normal()[d]);
      Small<Pack, N, D> along;
      for (std::size_t a = 0; a < N; ++a)
        for (std::size_t d = 0; d < D; ++d) along[a][d] = rows[a] * (std::abs(sides_.normal()[d]) * normal_sum);
      sides_.batches().scatter_force(b, along, sums);
    }
    return least_gap > 0 || !this->needs_positive_gaps();
  }

  double energy(const Place& at) const override {
    const auto& laws = this->laws(at.histories);
    Pack sum = 0.0;
    for (std::size_t b = 0; b < sides_.size(); ++b)
      sum +=
          sides_.owned(b) * Kernel::energy(laws.of(b), sides_.quadrature(), sides_.measure(b), sides_.gaps_of(b, at.u));
    return total(sum);
  }

  double admissible_step(const Segment& segment, const Rule& rule, const double* direction) const override {
    if (!this->needs_positive_gaps()) return 1;
    Pack step = 1.0;
    for (std::size_t b = 0; b < sides_.size(); ++b) {
      const Gaps gaps(sides_, b, segment);
      step = smaller(step,
                     Kernel::admissible_step(sides_.quadrature(), gaps.segment(), rule, sides_.change_of(b, direction),
                                             margin_, laws_.whole().equilibrium_gap()));
    }
    return least(step);
  }

  double mean_potential(const Segment& segment) const override {
    const auto& laws = this->laws(segment.histories);
    Pack sum = 0.0;
    for (std::size_t b = 0; b < sides_.size(); ++b) {
      const Nodal from = sides_.gaps_of(b, segment.from), to = sides_.gaps_of(b, segment.to);
      for (std::size_t q = 0; q < sides_.quadrature().size(); ++q)
        sum += sides_.owned(b) * sides_.measure(b)[q] *
               laws.at(b, q).mean_potential(Kernel::interpolate(sides_.quadrature().value[q], from),
                                            Kernel::interpolate(sides_.quadrature().value[q], to));
    }
    return total(sum);
  }

  double gap_ratio(const Segment& way) const override {
    if (!this->needs_positive_gaps()) return 1;
    const double near = 10 * laws_.whole().equilibrium_gap();
    double largest = 1;
    for (std::size_t b = 0; b < sides_.size(); ++b) {
      const Nodal start = sides_.gaps_of(b, way.from), end = sides_.gaps_of(b, way.to);
      for (std::size_t q = 0; q < sides_.quadrature().size(); ++q) {
        const Pack r0 = Kernel::interpolate(sides_.quadrature().value[q], start);
        const Pack r1 = Kernel::interpolate(sides_.quadrature().value[q], end);
        const Pack lesser = smaller(r0, r1);
        const Pack ratio = select(lesser < near, Pack((r0 + r1 - lesser) / lesser), Pack(1.0));
        largest = std::max(largest, -least(Pack(-ratio)));
      }
    }
    return largest;
  }

  double rounding(const Place& at) const override {
    const auto& laws = this->laws(at.histories);
    Pack sum = 0.0;
    for (std::size_t b = 0; b < sides_.size(); ++b) {
      const Nodal gap = sides_.gaps_of(b, at.u);
      for (std::size_t q = 0; q < sides_.quadrature().size(); ++q) {
        const Pack force =
            sides_.measure(b)[q] * laws.at(b, q).magnitude(Kernel::interpolate(sides_.quadrature().value[q], gap));
        sum += sides_.owned(b) * force * force;
      }
    }
    return total(sum);
  }

  LowestPoint lowest_point(const Place& at) const override {
    return sides_.lowest_point(at.u, [&](std::size_t b) {
      return [gap = sides_.gaps_of(b, at.u)](const auto& shape) { return Kernel::interpolate(shape, gap); };
    });
  }
  /// The law of a flat wall notices what is beyond it.
  LowestPoint passage(const Segment&) const override { return {}; }

  void add_nodal_measure(CountedSides& counted, double* measure) const override {
    sides_.add_nodal_measure(counted, measure);
  }

  void lower_nodal_gap(const Place& at, double* gap) const override {
    for (std::size_t b = 0; b < sides_.size(); ++b) sides_.lower_nodal(b, sides_.gaps_of(b, at.u), gap);
  }

  void set_nodal_normal(const Place&, double* normal) const override {
    Nodal ones;
    ones.fill(1.0);
    for (std::size_t b = 0; b < sides_.size(); ++b) sides_.set_nodal(b, sides_.from_normal(ones), normal);
  }

  void report(const Place& at, InteractionReport& report) const override {
    const auto& laws = this->laws(at.histories);
    report.force.resize(D, 0.0);
    for (std::size_t b = 0; b < sides_.size(); ++b) {
      const Nodal gap = sides_.gaps_of(b, at.u);
      for (std::size_t q = 0; q < sides_.quadrature().size(); ++q) {
        const Pack r = Kernel::interpolate(sides_.quadrature().value[q], gap);
        const Pack weight = sides_.owned(b) * sides_.measure(b)[q];
        report.least_gap = std::min(report.least_gap, least(r));
        report.measure +=
            total(select(r < laws_.whole().adhesion_gap(), Pack(sides_.owned(b) * sides_.area(b)[q]), Pack(0.0)));
        const double force = total(Pack(weight * laws.at(b, q).traction(r)));
        for (std::size_t d = 0; d < D; ++d) report.force[d] += force * sides_.normal()[d];
      }
    }
  }

 private:
  /// Keeps the matrix of each side along the wall's normal.
  class Action final : public TangentAction {
   public:
    explicit Action(const FlatSurfaceTerm& term) : term_(term), along_(term.sides_.size()) {}

    void linearize(const Segment& segment, const Rule& rule, Tangent kind, const LinearPart&) override {
      const auto& laws = term_.laws(segment.histories);
      for (std::size_t b = 0; b < along_.size(); ++b) {
        const Gaps gaps(term_.sides_, b, segment);
        along_[b] = {};
        Kernel::add_tangent(laws.of(b), term_.sides_.quadrature(), term_.sides_.measure(b), gaps.segment(), rule,
                            kind == Tangent::Convex, along_[b]);
      }
    }

    void add_product(const double* x, double* y) const override {
      for (std::size_t b = 0; b < along_.size(); ++b) {
        const Nodal change = term_.sides_.change_of(b, x);
        Nodal force{};
        for (std::size_t a = 0; a < N; ++a)
          for (std::size_t c = 0; c < N; ++c) force[a] += along_[b][a][c] * change[c];
        term_.sides_.batches().scatter_force(b, term_.sides_.from_normal(force), y);
      }
    }

    void add_diagonal(double* d) const override {
      for (std::size_t b = 0; b < along_.size(); ++b) {
        Small<Pack, N, D> diagonal;
        for (std::size_t a = 0; a < N; ++a)
          for (std::size_t i = 0; i < D; ++i)
            diagonal[a][i] = along_[b][a][a] * (term_.sides_.normal()[i] * term_.sides_.normal()[i]);
        term_.sides_.batches().scatter_diagonal(b, diagonal, d);
      }
    }

    bool has_coarse() const override { return term_.sides_.may_be_coarsened(); }

    void add_coarse(const CoarseSpace& coarse, double* values) const override {
      using Corners = typename CornerElement<SideElement>::type;
      if constexpr (is_linear_element<SideElement>) {
        add_child_matrices(
            term_.sides_.batches(), coarse, [this](std::size_t b) { return term_.sides_.owned(b); },
            [&](std::size_t b, const ChildShares<N>& shares, auto& k) {
              term_.sides_.spread(on_parents<N, 1>(shares, along_[b]), k);
            },
            values);
      } else if constexpr (std::is_void_v<Corners>) {
        if (!has_coarse()) TangentAction::add_coarse(coarse, values);
      } else {
        const auto set = [&](std::size_t b, auto& k) { term_.sides_.spread(on_corners<SideElement>(along_[b]), k); };
        add_corner_matrices<Corners::nodes>(term_.sides_.batches(), coarse, set, values);
      }
    }

   private:
    const FlatSurfaceTerm& term_;
    std::vector<Small<Pack, N>> along_;
  };

  /// Nodal gaps of one batch at the ends of the segment.
  class Gaps {
   public:
    Gaps(const Sides& sides, std::size_t b, const Segment& segment)
        : has_from_(segment.from != nullptr), has_velocity_(segment.velocity != nullptr) {
      to_ = sides.gaps_of(b, segment.to);
      if (has_from_) from_ = sides.gaps_of(b, segment.from);
      if (has_velocity_) velocity_ = sides.change_of(b, segment.velocity);
    }
    typename Kernel::template Segment<Pack> segment() const {
      return {has_from_ ? &from_ : nullptr, has_velocity_ ? &velocity_ : nullptr, &to_};
    }

   private:
    bool has_from_, has_velocity_;
    Nodal to_, from_, velocity_;
  };

  /// See InteractionOverSteps.
  void add_nodal_pressure(const Place& at, double* force) const {
    const auto& laws = this->laws(at.histories);
    for (std::size_t b = 0; b < sides_.size(); ++b) {
      const Nodal gap = sides_.gaps_of(b, at.u);
      Nodal sums{};
      for (std::size_t q = 0; q < sides_.quadrature().size(); ++q) {
        const Pack r = Kernel::interpolate(sides_.quadrature().value[q], gap);
        sides_.add_weighted(b, q, sides_.measure(b)[q] * laws.at(b, q).traction(r), sums);
      }
      sides_.add_nodal(b, sums, force);
    }
  }

  /// See InteractionOverSteps.
  template <class Visit>
  void for_each_gap(const double* u, const Visit& visit) const {
    for (std::size_t b = 0; b < sides_.size(); ++b) {
      const Nodal gap = sides_.gaps_of(b, u);
      for (std::size_t q = 0; q < sides_.quadrature().size(); ++q)
        visit(b, q, Kernel::interpolate(sides_.quadrature().value[q], gap),
              Pack(sides_.owned(b) * sides_.measure(b)[q]));
    }
  }

  double margin_;
  Sides sides_;
  Laws laws_;
};

}  // namespace

Interactions make_flat_terms(const LocalMesh& mesh, const std::vector<LocalSide>& sides, const Pattern& pattern,
                             const std::shared_ptr<const GapLaw>& law, const HalfSpace& wall,
                             const SurfaceOptions& options) {
  if (const auto* own = dynamic_cast<const GapLawOf<VanDerWaals>*>(law.get()))
    return make_terms<FlatSurfaceTerm>(mesh, sides, pattern, own->law(), wall, options);
  if (const auto* own = dynamic_cast<const GapLawOf<CutOff<VanDerWaals>>*>(law.get()))
    return make_terms<FlatSurfaceTerm>(mesh, sides, pattern, own->law(), wall, options);
  if (const auto* own = dynamic_cast<const GapLawOf<DamageLaw>*>(law.get()))
    return make_terms<FlatSurfaceTerm>(mesh, sides, pattern, own->law(), wall, options);
  return make_terms<FlatSurfaceTerm>(mesh, sides, pattern, AnyGapLaw(law), wall, options);
}

}  // namespace ixos
