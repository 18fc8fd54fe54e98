// Interaction of a surface with an obstacle of any shape.
#include <algorithm>
#include <stdexcept>
#include <utility>
#include <vector>

#include "base/scratch.hpp"
#include "term/wall/curved_points.hpp"
#include "term/wall/side_action.hpp"
#include "term/wall/surface_terms.hpp"

namespace ixos {
namespace {

/// Sides in D dimensions.
template <std::size_t D>
class CurvedSurfaceTerm final : public SurfaceInteractionTerm<CurvedSurfaceTerm<D>>, private CurvedPoints<D> {
  using Points = CurvedPoints<D>;
  using Points::for_each_gap;
  using Points::for_each_place;
  using Points::is_allowed;
  using Points::laws_;
  using Points::obstacle_;
  using Points::sides_;
  using Points::stiffness;
  using Points::sum_over_points;
  using typename Points::Ends;
  using typename Points::Matrix;
  using typename Points::Sides;
  using Kept = KeptStiffness<Matrix>;
  friend SurfaceInteractionTerm<CurvedSurfaceTerm>;

 public:
  CurvedSurfaceTerm(const LocalMesh& mesh, const std::vector<LocalSide>& group, std::unique_ptr<Sides> sides,
                    const std::shared_ptr<const GapLaw>& law, std::shared_ptr<const Obstacle> obstacle, double margin)
      : Points(mesh, group, std::move(sides), law, std::move(obstacle)), margin_(margin) {}

  /// The exact mean follows the mean normal, whose force has no potential.
  bool is_gradient(const Rule& rule) const override { return rule.mean == Mean::Points; }

  void place(const Pattern& pattern) override { sides_->place(pattern); }

  bool add_force(const Segment& segment, const Rule& rule, double* f) const override {
    return add_force_with<Points::Traction>(segment, rule, f, [](std::size_t, std::size_t, const Matrix&) {});
  }

  void add_tangent(const Segment& segment, const Rule& rule, Tangent kind, double* values) const override {
    for_each_stiffness(segment, rule, kind, [&](std::size_t b, const Matrix* k) { sides_->add_tangent(b, k, values); });
  }

  std::unique_ptr<KeptPoints> create_kept() const override { return std::make_unique<Kept>(); }

  /// Keeps the matrix of each quadrature point.
  bool add_force_and_keep(const Segment& segment, const Rule& rule, KeptPoints& kept, double* f) const override {
    auto& matrices = static_cast<Kept&>(kept).stiffness;
    const std::size_t points = sides_->points();
    matrices.resize(sides_->size() * points);
    return add_force_with<Points::Traction | Points::Stiffness>(
        segment, rule, f, [&](std::size_t b, std::size_t q, const Matrix& k) { matrices[b * points + q] = k; });
  }

  void add_kept_tangent(const Segment& segment, const Rule& rule, Tangent kind, const KeptPoints& kept,
                        double* values) const override {
    if (kind != Tangent::Exact) return add_tangent(segment, rule, kind, values);
    const Matrix* matrices = static_cast<const Kept&>(kept).stiffness.data();
    for (std::size_t b = 0; b < sides_->size(); ++b) sides_->add_tangent(b, matrices + b * sides_->points(), values);
  }

  std::unique_ptr<TangentAction> create_action() const override {
    return std::make_unique<SideAction<Sides>>(
        *sides_, [this](const Segment& segment, const Rule& rule, Tangent kind, typename Sides::Matrices& matrices) {
          for_each_stiffness(segment, rule, kind, [&](std::size_t b, const Matrix* k) { matrices.set(b, k); });
        });
  }

  bool add_row_sums(const Segment& segment, double* sums) const override {
    const PointLaws::Kept laws = this->laws(segment.histories);
    const Rule rule = end_rule();
    Pack least_gap = 1.0;
    Ends ends(*sides_, Ends::Of::Places, {nullptr, nullptr, segment.to});
    Scratch<PackPoint> rows(sides_->points());
    for (std::size_t b = 0; b < sides_->size(); ++b) {
      ends.set(b);
      for (std::size_t q = 0; q < rows.size(); ++q) {
        const auto response = Points::template respond<Points::Traction | Points::Stiffness>(laws, ends, b, q, rule);
        least_gap = smaller(least_gap, response.least_gap);
        for (std::size_t i = 0; i < D; ++i) {
          Pack sum = 0.0;
          for (std::size_t j = 0; j < D; ++j) sum += std::experimental::abs(response.stiffness[i][j]);
          rows[q][i] = sides_->total_shape(q) * sum;
        }
      }
      sides_->add_row_sums(b, rows.data(), sums);
    }
    return is_allowed(least_gap);
  }

  double energy(const Place& at) const override {
    return sum_over_points(this->laws(at.histories), at.u,
                           [&](const GapLawAt& law, const PackPoint&, const ObstacleGap& found, const Pack& weight,
                               const Pack&) { return weight * law.energy(found.gap); });
  }

  double admissible_step(const Segment& segment, const Rule& rule, const double* direction) const override {
    if (!this->needs_positive_gaps()) return 1;
    Pack step = 1.0;
    Ends ends(*sides_, Ends::Of::Places, segment);
    Scratch<PackPoint> changes(sides_->points());
    for (std::size_t b = 0; b < sides_->size(); ++b) {
      ends.set(b);
      sides_->changes(b, direction, changes.data());
      for (std::size_t q = 0; q < changes.size(); ++q) {
        const auto restrict_to = [&](const PackPoint& x, double share) {
          PackPoint way;
          for (std::size_t i = 0; i < 3; ++i) way[i] = share * changes[q][i];
          const Pack least_gap = margin_ * smaller(obstacle_->gap(x), laws_.equilibrium_gap());
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
    const double near = 10 * laws_.equilibrium_gap();
    double largest = 1;
    Ends ends(*sides_, Ends::Of::Places, {way.from, nullptr, way.to});
    for (std::size_t b = 0; b < sides_->size(); ++b) {
      ends.set(b);
      for (std::size_t q = 0; q < sides_->points(); ++q) {
        const PackPoint &start = ends.from(q), &end = ends.to(q);
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
        [&](const GapLawAt& law, const PackPoint& x, const ObstacleGap& found, const Pack& weight, const Pack&) {
          const Pack near = smaller(found.gap, laws_.equilibrium_gap());  // a step may lead there
          const Pack force =
              weight * (law.magnitude(found.gap) + std::experimental::abs(law.stiffness(near)) * obstacle_->size_at(x));
          return force * force;
        });
  }

  LowestPoint lowest_point(const Place& at) const override {
    return sides_->lowest_gap(at.u, [this](const PackPoint& x) { return obstacle_->gap(x); });
  }

  LowestPoint passage(const Segment& way) const override { return Points::find_passage(way.from, way.to); }

  void add_nodal_measure(CountedSides& counted, double* measure) const override {
    sides_->add_nodal_measure(counted, measure);
  }
  void lower_nodal_gap(const Place& at, double* gap) const override {
    sides_->lower_nodal_gaps(
        at.u, [this](const PackPoint& x) { return obstacle_->at(x); }, gap);
  }
  void set_nodal_normal(const Place& at, double* normal) const override {
    sides_->set_nodal_normals(
        at.u, [this](const PackPoint& x) { return obstacle_->gap_and_normal(x); }, normal);
  }

  void report(const Place& at, InteractionReport& report) const override {
    report.force.resize(D, 0.0);
    report.measure += sum_over_points(
        this->laws(at.histories), at.u,
        [&](const GapLawAt& law, const PackPoint&, const ObstacleGap& found, const Pack& weight, const Pack& area) {
          report.least_gap = std::min(report.least_gap, least(found.gap));
          const Pack force = weight * law.traction(found.gap);
          for (std::size_t i = 0; i < D; ++i) report.force[i] += total(Pack(force * found.normal[i]));
          return select(found.gap < laws_.adhesion_gap(), area, Pack(0.0));
        });
  }

 private:
  /// See SurfaceInteractionTerm.
  void add_nodal_pressure(const Place& at, double* force) const {
    const PointLaws::Kept laws = this->laws(at.histories);
    Scratch<PackPoint> x(sides_->points());
    Scratch<Pack> pressure(x.size());
    for (std::size_t b = 0; b < sides_->size(); ++b) {
      sides_->places(b, at.u, x.data());
      for (std::size_t q = 0; q < x.size(); ++q)
        pressure[q] = sides_->measure(b)[q] * laws.at(b, q).traction(obstacle_->gap(x[q]));
      sides_->add_weighted_nodal(b, pressure.data(), force);
    }
  }

  /// Adds the force and calls keep(batch, point, stiffness).
  template <int What, class Keep>
  bool add_force_with(const Segment& segment, const Rule& rule, double* f, const Keep& keep) const {
    const PointLaws::Kept laws = this->laws(segment.histories);
    Pack least_gap = 1.0;
    Ends ends(*sides_, Ends::Of::Places, segment);
    Scratch<PackPoint> forces(sides_->points());
    for (std::size_t b = 0; b < sides_->size(); ++b) {
      ends.set(b);
      for (std::size_t q = 0; q < forces.size(); ++q) {
        const auto response = Points::template respond<What>(laws, ends, b, q, rule);
        least_gap = smaller(least_gap, response.least_gap);
        keep(b, q, response.stiffness);
        for (std::size_t i = 0; i < 3; ++i) forces[q][i] = -response.traction[i];
      }
      sides_->add_forces(b, forces.data(), f);
    }
    return is_allowed(least_gap);
  }

  /// Calls visit(batch, stiffnesses of its points).
  template <class Visit>
  void for_each_stiffness(const Segment& segment, const Rule& rule, Tangent kind, const Visit& visit) const {
    const PointLaws::Kept laws = this->laws(segment.histories);
    Ends ends(*sides_, Ends::Of::Places, segment);
    Scratch<Matrix> k(sides_->points());
    for (std::size_t b = 0; b < sides_->size(); ++b) {
      ends.set(b);
      for (std::size_t q = 0; q < k.size(); ++q) k[q] = stiffness(laws, ends, b, q, rule, kind);
      visit(b, k.data());
    }
  }

  double margin_;
};

}  // namespace

Interactions make_curved_terms(const LocalMesh& mesh, const std::vector<LocalSide>& sides, const Pattern& pattern,
                               const std::shared_ptr<const GapLaw>& law,
                               const std::shared_ptr<const Obstacle>& obstacle, const SurfaceOptions& options) {
  const auto make_sides = [&](const SideGroup& group, auto dimension) {
    return make_curved_sides<dimension.value>(mesh, group, pattern, options.points);
  };
  return make_terms<CurvedSurfaceTerm>(mesh, sides, options, make_sides, law, obstacle, options.margin);
}

}  // namespace ixos
