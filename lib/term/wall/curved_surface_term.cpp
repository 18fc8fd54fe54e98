// Interaction of a surface with an obstacle of any shape.
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "interaction/damage_law.hpp"
#include "term/wall/curved_points.hpp"
#include "term/wall/point_matrices.hpp"
#include "term/wall/surface_terms.hpp"

namespace ixos {
namespace {

/// Sides of one element type.
template <class SideElement, class Law>
class CurvedSurfaceTerm final : public InteractionOverSteps<CurvedSurfaceTerm<SideElement, Law>, Law>,
                                private CurvedPoints<SideElement, Law> {
  using Points = CurvedPoints<SideElement, Law>;
  using Points::D;
  using Points::for_each_gap;
  using Points::is_allowed;
  using Points::laws_;
  using Points::obstacle_;
  using Points::sides_;
  using Points::stiffness;
  using Points::sum_over_points;
  using typename Points::Ends;
  using typename Points::Matrix;
  using typename Points::Sides;
  static constexpr std::size_t N = Sides::N;
  using Vectors = typename Sides::Vectors;
  friend InteractionOverSteps<CurvedSurfaceTerm, Law>;
  friend SurfaceInteractionTerm<CurvedSurfaceTerm, Law>;

 public:
  CurvedSurfaceTerm(const LocalMesh& mesh, const std::vector<LocalSide>& sides, const Pattern& pattern, const Law& law,
                    std::shared_ptr<const Obstacle> obstacle, const SurfaceOptions& options)
      : Points(mesh, sides, pattern, law, std::move(obstacle), options.points), margin_(options.margin) {
    sides_.scale(options.factor);
  }

  /// The exact mean follows the mean normal, whose force has no potential.
  bool is_gradient(const Rule& rule) const override { return rule.mean == Mean::Points; }

  void place(const Pattern& pattern) override { sides_.place(pattern); }

  bool add_force(const Segment& segment, const Rule& rule, double* f) const override {
    return add_force_with<Points::Traction>(segment, rule, f, [](std::size_t, std::size_t, const Matrix&) {});
  }

  void add_tangent(const Segment& segment, const Rule& rule, Tangent kind, double* values) const override {
    const auto& laws = this->laws(segment.histories);
    std::vector<Matrix> matrices(sides_.quadrature().size());
    for (std::size_t b = 0; b < sides_.size(); ++b) {
      const Ends ends(sides_, b, segment);
      for (std::size_t q = 0; q < matrices.size(); ++q) matrices[q] = stiffness(laws, ends, b, q, rule, kind);
      sides_.scatter_tangent(b, matrices.data(), values);
    }
  }

  std::unique_ptr<KeptPoints> create_kept() const override { return std::make_unique<Kept>(); }

  /// Keeps the matrix of each quadrature point.
  bool add_force_and_keep(const Segment& segment, const Rule& rule, KeptPoints& kept, double* f) const override {
    auto& matrices = static_cast<Kept&>(kept).stiffness;
    const std::size_t points = sides_.quadrature().size();
    matrices.resize(sides_.size() * points);
    return add_force_with<Points::Traction | Points::Stiffness>(
        segment, rule, f, [&](std::size_t b, std::size_t q, const Matrix& k) { matrices[b * points + q] = k; });
  }

  void add_kept_tangent(const Segment& segment, const Rule& rule, Tangent kind, const KeptPoints& kept,
                        double* values) const override {
    if (kind != Tangent::Exact) return add_tangent(segment, rule, kind, values);
    const Matrix* matrices = static_cast<const Kept&>(kept).stiffness.data();
    for (std::size_t b = 0; b < sides_.size(); ++b)
      sides_.scatter_tangent(b, matrices + b * sides_.quadrature().size(), values);
  }

  std::unique_ptr<TangentAction> create_action() const override { return std::make_unique<Action>(*this); }

  bool add_row_sums(const Segment& segment, double* sums) const override {
    const auto& laws = this->laws(segment.histories);
    const Rule rule = end_rule();
    Pack least_gap = 1.0;
    for (std::size_t b = 0; b < sides_.size(); ++b) {
      const Ends ends(sides_, b, {nullptr, nullptr, segment.to});
      Vectors rows{};
      for (std::size_t q = 0; q < sides_.quadrature().size(); ++q) {
        const auto& shape = sides_.quadrature().value[q];
        const auto response = Points::template respond<Points::Traction | Points::Stiffness>(laws, ends, b, q, rule);
        least_gap = smaller(least_gap, response.least_gap);
        double total_shape = 0;
        for (double value : shape) total_shape += std::abs(value);
        for (std::size_t i = 0; i < D; ++i) {
          Pack sum = 0.0;
          for (std::size_t j = 0; j < D; ++j) sum += std::experimental::abs(response.stiffness[i][j]);
          for (std::size_t a = 0; a < N; ++a) rows[a][i] += (std::abs(shape[a]) * total_shape) * sum;
        }
      }
      sides_.batches().scatter_force(b, rows, sums);
    }
    return is_allowed(least_gap);
  }

  double energy(const Place& at) const override {
    return sum_over_points(this->laws(at.histories), at.u,
                           [&](const auto& law, const PackPoint&, const Sight& sight, const Pack& weight, const Pack&) {
                             return weight * law.energy(sight.gap);
                           });
  }

  double admissible_step(const Segment& segment, const Rule& rule, const double* direction) const override {
    if (!this->needs_positive_gaps()) return 1;
    Pack step = 1.0;
    for (std::size_t b = 0; b < sides_.size(); ++b) {
      const Ends ends(sides_, b, segment);
      const Vectors change = sides_.change_of(b, direction);
      for (std::size_t q = 0; q < sides_.quadrature().size(); ++q) {
        const PackPoint d = sides_.interpolate(q, change);
        const auto restrict_to = [&](const PackPoint& x, double share) {
          PackPoint way;
          for (std::size_t i = 0; i < 3; ++i) way[i] = share * d[i];
          const Pack least_gap = margin_ * smaller(obstacle_->gap(x), laws_.whole().equilibrium_gap());
          step = smaller(step, obstacle_->admissible_step(x, way, least_gap));
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

  double gap_ratio(const Segment& way) const override {
    if (!this->needs_positive_gaps()) return 1;
    const double near = 10 * laws_.whole().equilibrium_gap();
    double largest = 1;
    for (std::size_t b = 0; b < sides_.size(); ++b) {
      const Ends ends(sides_, b, {way.from, nullptr, way.to});
      for (std::size_t q = 0; q < sides_.quadrature().size(); ++q) {
        const PackPoint start = ends.from(q), end = ends.to(q);
        const Pack r0 = obstacle_->gap(start), r1 = obstacle_->gap(end), lesser = smaller(r0, r1);
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

  double rounding(const Place& at) const override {
    return sum_over_points(
        this->laws(at.histories), at.u,
        [&](const auto& law, const PackPoint& x, const Sight& sight, const Pack& weight, const Pack&) {
          const Pack near = smaller(sight.gap, laws_.whole().equilibrium_gap());  // a step may lead there
          const Pack force =
              weight * (law.magnitude(sight.gap) + std::experimental::abs(law.stiffness(near)) * obstacle_->size_at(x));
          return force * force;
        });
  }

  LowestPoint lowest_point(const Place& at) const override {
    return sides_.lowest_point(at.u, [&](std::size_t b) {
      return [this, x = sides_.places_of(b, at.u)](const auto& shape) {
        return obstacle_->gap(Sides::interpolate(shape, x));
      };
    });
  }

  LowestPoint passage(const Segment& way) const override { return Points::find_passage(way.from, way.to); }

  void add_nodal_measure(CountedSides& counted, double* measure) const override {
    sides_.add_nodal_measure(counted, measure);
  }

  void lower_nodal_gap(const Place& at, double* gap) const override {
    for (std::size_t b = 0; b < sides_.size(); ++b)
      sides_.lower_nodal(b, sides_.nodal_gaps(b, at.u, [&](const PackPoint& x) { return obstacle_->at(x); }), gap);
  }

  void set_nodal_normal(const Place& at, double* normal) const override {
    for (std::size_t b = 0; b < sides_.size(); ++b)
      sides_.set_nodal(
          b, sides_.nodal_normals(b, at.u, [&](const PackPoint& x) { return obstacle_->gap_and_normal(x); }), normal);
  }

  void report(const Place& at, InteractionReport& report) const override {
    report.force.resize(D, 0.0);
    report.measure += sum_over_points(
        this->laws(at.histories), at.u,
        [&](const auto& law, const PackPoint&, const Sight& sight, const Pack& weight, const Pack& area) {
          report.least_gap = std::min(report.least_gap, least(sight.gap));
          const Pack force = weight * law.traction(sight.gap);
          for (std::size_t i = 0; i < D; ++i) report.force[i] += total(Pack(force * sight.normal[i]));
          return select(sight.gap < laws_.whole().adhesion_gap(), area, Pack(0.0));
        });
  }

 private:
  struct Kept final : KeptPoints {
    std::vector<Matrix> stiffness;  ///< batches x quadrature points
  };

  /// See InteractionOverSteps.
  void add_nodal_pressure(const Place& at, double* force) const {
    const auto& laws = this->laws(at.histories);
    for (std::size_t b = 0; b < sides_.size(); ++b) {
      const Ends ends(sides_, b, {nullptr, nullptr, at.u});
      std::array<Pack, N> sums{};
      for (std::size_t q = 0; q < sides_.quadrature().size(); ++q) {
        const Pack traction = sides_.measure(b)[q] * laws.at(b, q).traction(obstacle_->gap(ends.to(q)));
        sides_.add_weighted(b, q, traction, sums);
      }
      sides_.add_nodal(b, sums, force);
    }
  }

  /// Adds the force and calls keep(batch, point, stiffness).
  template <int What, class Keep>
  bool add_force_with(const Segment& segment, const Rule& rule, double* f, const Keep& keep) const {
    const auto& laws = this->laws(segment.histories);
    Pack least_gap = 1.0;
    for (std::size_t b = 0; b < sides_.size(); ++b) {
      const Ends ends(sides_, b, segment);
      Vectors force{};
      for (std::size_t q = 0; q < sides_.quadrature().size(); ++q) {
        const auto response = Points::template respond<What>(laws, ends, b, q, rule);
        least_gap = smaller(least_gap, response.least_gap);
        keep(b, q, response.stiffness);
        const auto& shape = sides_.quadrature().value[q];
        for (std::size_t a = 0; a < N; ++a)
          for (std::size_t i = 0; i < D; ++i) force[a][i] -= shape[a] * response.traction[i];
      }
      sides_.batches().scatter_force(b, force, f);
    }
    return is_allowed(least_gap);
  }

  class Action final : public TangentAction {
   public:
    explicit Action(const CurvedSurfaceTerm& term) : term_(term), stiffness_(term.sides_) {}

    void linearize(const Segment& segment, const Rule& rule, Tangent kind, const LinearPart&) override {
      const auto& laws = term_.laws(segment.histories);
      for (std::size_t b = 0; b < term_.sides_.size(); ++b) {
        const Ends ends(term_.sides_, b, segment);
        for (std::size_t q = 0; q < term_.sides_.quadrature().size(); ++q)
          stiffness_(b, q) = term_.stiffness(laws, ends, b, q, rule, kind);
      }
    }
    void add_product(const double* x, double* y) const override { stiffness_.add_product(x, y); }
    void add_diagonal(double* d) const override { stiffness_.add_diagonal(d); }
    bool has_coarse() const override { return term_.sides_.may_be_coarsened(); }
    void add_coarse(const CoarseSpace& coarse, double* values) const override { stiffness_.add_coarse(coarse, values); }

   private:
    const CurvedSurfaceTerm& term_;
    PointMatrices<SideElement> stiffness_;
  };

  double margin_;
};

}  // namespace

Interactions make_curved_terms(const LocalMesh& mesh, const std::vector<LocalSide>& sides, const Pattern& pattern,
                               const std::shared_ptr<const GapLaw>& law,
                               const std::shared_ptr<const Obstacle>& obstacle, const SurfaceOptions& options) {
  if (const auto* own = dynamic_cast<const GapLawOf<DamageLaw>*>(law.get()))
    return make_terms<CurvedSurfaceTerm>(mesh, sides, pattern, own->law(), obstacle, options);
  return make_terms<CurvedSurfaceTerm>(mesh, sides, pattern, AnyGapLaw(law), obstacle, options);
}

}  // namespace ixos
