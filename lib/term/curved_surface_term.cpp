// Interaction of a surface with an obstacle of any shape.
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "term/curved_points.hpp"
#include "term/surface_terms.hpp"

namespace ixos {
namespace {

/// Sides of one element type.
template <class SideElement>
class CurvedSurfaceTerm final : public Interaction, private CurvedPoints<SideElement> {
  using Points = CurvedPoints<SideElement>;
  using Points::D;
  using Points::law_;
  using Points::obstacle_;
  using Points::sides_;
  using Points::stiffness;
  using Points::sum_over_points;
  using typename Points::Ends;
  using typename Points::Matrix;
  using typename Points::Sides;
  static constexpr std::size_t N = Sides::N;
  using Vectors = typename Sides::Vectors;

 public:
  CurvedSurfaceTerm(const LocalMesh& mesh, const std::vector<LocalSide>& sides, const Pattern& pattern,
                    const std::shared_ptr<const GapLaw>& law, std::shared_ptr<const Obstacle> obstacle,
                    const SurfaceOptions& options)
      : Points(mesh, sides, pattern, law, std::move(obstacle), options.points), margin_(options.margin) {}

  bool needs_positive_gaps() const override { return law_.domain == GapDomain::Positive; }

  /// The exact mean follows the mean normal, whose force has no potential.
  bool is_gradient(const Rule& rule) const override { return rule.mean == Mean::Points; }

  void place(const Pattern& pattern) override { sides_.place(pattern); }

  bool add_force(const Segment& segment, const Rule& rule, double* f) const override {
    Pack least_gap = 1.0;
    for (std::size_t b = 0; b < sides_.size(); ++b) {
      const Ends ends(sides_, b, segment);
      Vectors force{};
      for (std::size_t q = 0; q < sides_.quadrature().size(); ++q) {
        std::array<Pack, D> traction{};
        for (const RulePoint& point : rule.points) {
          const Sight sight = obstacle_->at(ends.at(q, point));
          least_gap = smaller(least_gap, sight.gap);
          const Pack pressure = point.weight * law_.traction(sight.gap);
          for (std::size_t i = 0; i < D; ++i) traction[i] += pressure * sight.normal[i];
        }
        const PackPoint to = ends.to(q);
        const Pack end_gap = obstacle_->at(to).gap;
        least_gap = smaller(least_gap, end_gap);
        if (rule.mean != Mean::Points) {
          const PackPoint from = ends.from(q);
          const Pack pressure = law_.mean_traction(obstacle_->at(from).gap, end_gap);
          const MeanSight mean = obstacle_->mean(from, to);
          for (std::size_t i = 0; i < D; ++i) traction[i] += pressure * mean.normal[i];
        }
        const auto& shape = sides_.quadrature().value[q];
        for (std::size_t a = 0; a < N; ++a)
          for (std::size_t i = 0; i < D; ++i) force[a][i] -= shape[a] * (sides_.measure(b)[q] * traction[i]);
      }
      sides_.batches().scatter_force(b, force, f);
    }
    return least(least_gap) > 0 || !needs_positive_gaps();
  }

  void add_tangent(const Segment& segment, const Rule& rule, Tangent kind, double* values) const override {
    for (std::size_t b = 0; b < sides_.size(); ++b) {
      const Ends ends(sides_, b, segment);
      Small<Pack, N * D> tangent{};
      for (std::size_t q = 0; q < sides_.quadrature().size(); ++q) {
        const auto& shape = sides_.quadrature().value[q];
        const Matrix k = stiffness(ends, b, q, rule, kind);
        for (std::size_t a = 0; a < N; ++a)
          for (std::size_t c = 0; c < N; ++c)
            for (std::size_t i = 0; i < D; ++i)
              for (std::size_t j = 0; j < D; ++j) tangent[a * D + i][c * D + j] += (shape[a] * shape[c]) * k[i][j];
      }
      sides_.batches().scatter_tangent(b, tangent, values);
    }
  }

  std::unique_ptr<TangentAction> create_action() const override { return std::make_unique<Action>(*this); }

  bool add_row_sums(const Segment& segment, double* sums) const override {
    Pack least_gap = 1.0;
    for (std::size_t b = 0; b < sides_.size(); ++b) {
      const Ends ends(sides_, b, {nullptr, nullptr, segment.to});
      Vectors rows{};
      for (std::size_t q = 0; q < sides_.quadrature().size(); ++q) {
        const auto& shape = sides_.quadrature().value[q];
        least_gap = smaller(least_gap, obstacle_->at(ends.to(q)).gap);
        const Matrix k = stiffness(ends, b, q, end_rule(), Tangent::Exact);
        double total_shape = 0;
        for (double value : shape) total_shape += std::abs(value);
        for (std::size_t i = 0; i < D; ++i) {
          Pack sum = 0.0;
          for (std::size_t j = 0; j < D; ++j) sum += std::experimental::abs(k[i][j]);
          for (std::size_t a = 0; a < N; ++a) rows[a][i] += (std::abs(shape[a]) * total_shape) * sum;
        }
      }
      sides_.batches().scatter_force(b, rows, sums);
    }
    return least(least_gap) > 0 || !needs_positive_gaps();
  }

  double energy(const double* u) const override {
    return sum_over_points(
        u, [&](const PackPoint&, const Sight& sight, const Pack& weight) { return weight * law_.energy(sight.gap); });
  }

  double admissible_step(const Segment& segment, const Rule& rule, const double* direction) const override {
    if (!needs_positive_gaps()) return 1;
    Pack step = 1.0;
    for (std::size_t b = 0; b < sides_.size(); ++b) {
      const Ends ends(sides_, b, segment);
      const Vectors change = sides_.change_of(b, direction);
      for (std::size_t q = 0; q < sides_.quadrature().size(); ++q) {
        const PackPoint d = sides_.interpolate(q, change);
        const auto restrict_to = [&](const PackPoint& x, double share) {
          PackPoint way;
          for (std::size_t i = 0; i < 3; ++i) way[i] = share * d[i];
          const Pack gap = obstacle_->at(x).gap;
          step = smaller(step, obstacle_->admissible_step(x, way, margin_ * smaller(gap, law_.equilibrium_gap())));
        };
        restrict_to(ends.to(q), 1);
        // A path that is straight can cut through a convex obstacle between two ends outside.
        for (const RulePoint& point : rule.points) restrict_to(ends.at(q, point), point.to);
      }
    }
    return least(select(step > 0.0, step, Pack(0.0)));
  }

  /// Throws std::logic_error: see is_gradient().
  double mean_potential(const Segment&) const override {
    throw std::logic_error("the exact mean before a curved obstacle has no potential");
  }

  bool has_mean_potential() const override { return false; }

  double gap_ratio(const double* from, const double* to) const override {
    if (!needs_positive_gaps()) return 1;
    const double near = 10 * law_.equilibrium_gap();
    double largest = 1;
    for (std::size_t b = 0; b < sides_.size(); ++b) {
      const Ends ends(sides_, b, {from, nullptr, to});
      for (std::size_t q = 0; q < sides_.quadrature().size(); ++q) {
        const PackPoint start = ends.from(q), end = ends.to(q);
        const Pack r0 = obstacle_->at(start).gap, r1 = obstacle_->at(end).gap, lesser = smaller(r0, r1);
        // The straight path can pass nearer than its ends. If it leads through the obstacle, its ratio is large but
        // finite, because its logarithm sets the next step.
        const Pack nearest = smaller(lesser, obstacle_->least_gap(start, end));
        const Pack divisor = std::experimental::max(nearest, Pack(1e-6 * lesser));
        const Pack ratio = select(nearest < near, Pack((r0 + r1 - lesser) / divisor), Pack(1.0));
        largest = std::max(largest, -least(Pack(-ratio)));
      }
    }
    return largest;
  }

  double rounding(const double* u) const override {
    return sum_over_points(u, [&](const PackPoint& x, const Sight& sight, const Pack& weight) {
      const Pack force = weight * (law_.magnitude(sight.gap) +
                                   std::experimental::abs(law_.stiffness(sight.gap)) * obstacle_->size_at(x));
      return force * force;
    });
  }

  LowestPoint lowest_point(const double* u) const override {
    return sides_.lowest_point(u, [&](std::size_t b) {
      return [this, x = sides_.places_of(b, u)](const auto& shape) {
        return obstacle_->at(Sides::interpolate(shape, x)).gap;
      };
    });
  }

  void add_nodal_measure(CountedSides& counted, double* measure) const override {
    sides_.add_nodal_measure(counted, measure);
  }

  void add_nodal_pressure(const double* u, double* force) const override {
    for (std::size_t b = 0; b < sides_.size(); ++b) {
      const Ends ends(sides_, b, {nullptr, nullptr, u});
      std::array<Pack, N> sums{};
      for (std::size_t q = 0; q < sides_.quadrature().size(); ++q) {
        const Pack traction = sides_.measure(b)[q] * law_.traction(obstacle_->at(ends.to(q)).gap);
        for (std::size_t a = 0; a < N; ++a) sums[a] += sides_.quadrature().value[q][a] * traction;
      }
      sides_.add_nodal(b, sums, force);
    }
  }

  void lower_nodal_gap(const double* u, double* gap) const override {
    for (std::size_t b = 0; b < sides_.size(); ++b)
      sides_.lower_nodal(b, sides_.nodal_gaps(b, u, [&](const PackPoint& x) { return obstacle_->at(x); }), gap);
  }

  void report(const double* u, InteractionReport& report) const override {
    report.force.resize(D, 0.0);
    report.measure += sum_over_points(u, [&](const PackPoint&, const Sight& sight, const Pack& weight) {
      report.least_gap = std::min(report.least_gap, least(sight.gap));
      const Pack force = weight * law_.traction(sight.gap);
      for (std::size_t i = 0; i < D; ++i) report.force[i] += total(Pack(force * sight.normal[i]));
      return select(sight.gap < law_.adhesion_gap(), weight, Pack(0.0));
    });
  }

 private:
  /// Keeps the matrix of each quadrature point.
  class Action final : public TangentAction {
   public:
    explicit Action(const CurvedSurfaceTerm& term)
        : term_(term), points_(term.sides_.quadrature().size()), stiffness_(term.sides_.size() * points_) {}

    void linearize(const Segment& segment, const Rule& rule, Tangent kind, const LinearPart&) override {
      for (std::size_t b = 0; b < term_.sides_.size(); ++b) {
        const Ends ends(term_.sides_, b, segment);
        for (std::size_t q = 0; q < points_; ++q) stiffness_[b * points_ + q] = term_.stiffness(ends, b, q, rule, kind);
      }
    }

    void add_product(const double* x, double* y) const override {
      for (std::size_t b = 0; b < term_.sides_.size(); ++b) {
        const Vectors u = term_.sides_.change_of(b, x);
        Vectors f{};
        for (std::size_t q = 0; q < points_; ++q) {
          const auto& shape = term_.sides_.quadrature().value[q];
          const PackPoint at = term_.sides_.interpolate(q, u);
          for (std::size_t i = 0; i < D; ++i) {
            Pack force = 0.0;
            for (std::size_t j = 0; j < D; ++j) force += stiffness_[b * points_ + q][i][j] * at[j];
            for (std::size_t a = 0; a < N; ++a) f[a][i] += shape[a] * force;
          }
        }
        term_.sides_.batches().scatter_force(b, f, y);
      }
    }

    void add_diagonal(double* d) const override {
      for (std::size_t b = 0; b < term_.sides_.size(); ++b) {
        Vectors diagonal{};
        for (std::size_t q = 0; q < points_; ++q) {
          const auto& shape = term_.sides_.quadrature().value[q];
          for (std::size_t a = 0; a < N; ++a)
            for (std::size_t i = 0; i < D; ++i)
              diagonal[a][i] += (shape[a] * shape[a]) * stiffness_[b * points_ + q][i][i];
        }
        term_.sides_.batches().scatter_diagonal(b, diagonal, d);
      }
    }

   private:
    const CurvedSurfaceTerm& term_;
    std::size_t points_;
    std::vector<Matrix> stiffness_;  ///< batches x quadrature points
  };

  double margin_;
};

}  // namespace

Interactions make_curved_terms(const LocalMesh& mesh, const std::vector<LocalSide>& sides, const Pattern& pattern,
                               const std::shared_ptr<const GapLaw>& law,
                               const std::shared_ptr<const Obstacle>& obstacle, const SurfaceOptions& options) {
  Interactions terms;
  for_each_kind_of_side(mesh, sides, [&](auto side, const std::vector<LocalSide>& group) {
    using SideElement = typename decltype(side)::type;
    terms.push_back(std::make_unique<CurvedSurfaceTerm<SideElement>>(mesh, group, pattern, law, obstacle, options));
  });
  return terms;
}

}  // namespace ixos
