#include "term/wall/friction_term.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "base/error.hpp"
#include "term/friction_interaction.hpp"
#include "term/wall/friction_points.hpp"
#include "term/wall/point_matrices.hpp"

namespace ixos {
namespace {

/// Sides of one element type.
template <class SideElement, class Law>
class FrictionTerm final : public FrictionInteraction {
  using Points = FrictionPoints<SideElement>;
  using Sides = typename Points::Sides;
  using Vector = typename Points::Vector;
  using Vectors = typename Sides::Vectors;
  using Response = typename Points::Response;
  using Memory = typename Points::Memory;
  using In = typename Points::In;
  using Matrix = Small<Pack, Points::D>;
  static constexpr std::size_t D = Points::D, N = Points::N;

 public:
  FrictionTerm(const LocalMesh& mesh, const std::vector<LocalSide>& sides, const Pattern& pattern, const Law& law,
               std::shared_ptr<const Obstacle> obstacle, const SurfaceOptions& options)
      : points_(mesh, sides, pattern, law, std::move(obstacle), options.points), sides_(points_.sides()) {
    points_.sides().scale(options.factor);
  }

  // The life over steps.
  void place(const Pattern& pattern) override { points_.sides().place(pattern); }
  void initialize(const KnownState&, TermHistories& histories) const override {
    histories.of(slot()) = points_.history();
  }
  void begin_step(const StepStart& start, StepMemories& step) const override {
    points_.begin(start.state.u, start.dt, start.histories->of(slot()), step.of<Memory>(slot()));
  }
  void begin_stage(const StageStart& start, StepMemories& step) const override {
    points_.set_length(start.length, step.of<Memory>(slot()));
  }
  StepWork accept(const AcceptedStep& step, TermHistories& histories) const override {
    return {points_.accept(step.states.back().u, step.dt, step.step->of<Memory>(slot()), histories.of(slot())), 0};
  }
  void transfer(Record& record, TermHistories& histories) override {
    TermHistory& history = histories.of(slot());
    history.points.front().values.transfer(record);
    if (record.loading()) history.last_step = {0, 0};
  }

  // Force and tangent.
  bool is_gradient(const Rule&) const override { return !points_.law().friction().current; }

  bool add_force(const Segment& segment, const Rule& rule, double* f) const override {
    add_force_with<SlipPart::Traction>(segment, rule, f, [](std::size_t, std::size_t, const Matrix&) {});
    return true;
  }

  void add_tangent(const Segment& segment, const Rule& rule, Tangent kind, double* values) const override {
    const In points = in(segment.histories, segment.step);
    std::vector<Matrix> matrices(sides_.quadrature().size());
    for (std::size_t b = 0; b < sides_.size(); ++b) {
      if (points.is_idle(b)) continue;
      const Ends ends(sides_, b, segment);
      for (std::size_t q = 0; q < matrices.size(); ++q) matrices[q] = stiffness(points, ends, b, q, rule, kind);
      sides_.scatter_tangent(b, matrices.data(), values);
    }
  }

  std::unique_ptr<KeptPoints> create_kept() const override { return std::make_unique<Kept>(); }

  /// Keeps the matrix of each quadrature point.
  bool add_force_and_keep(const Segment& segment, const Rule& rule, KeptPoints& kept, double* f) const override {
    auto& matrices = static_cast<Kept&>(kept).stiffness;
    const std::size_t points = sides_.quadrature().size();
    matrices.resize(sides_.size() * points);
    add_force_with<SlipPart::All>(segment, rule, f,
                                  [&](std::size_t b, std::size_t q, const Matrix& k) { matrices[b * points + q] = k; });
    return true;
  }

  void add_kept_tangent(const Segment& segment, const Rule& rule, Tangent kind, const KeptPoints& kept,
                        double* values) const override {
    if (kind != Tangent::Exact) return add_tangent(segment, rule, kind, values);
    const Matrix* matrices = static_cast<const Kept&>(kept).stiffness.data();
    const In points = in(segment.histories, segment.step);
    for (std::size_t b = 0; b < sides_.size(); ++b)
      if (!points.is_idle(b)) sides_.scatter_tangent(b, matrices + b * sides_.quadrature().size(), values);
  }

  /// An action has to be symmetric.
  std::unique_ptr<TangentAction> create_action() const override {
    if (points_.law().friction().current) return nullptr;
    return std::make_unique<Action>(*this);
  }

  /// Throws InputError for smoothed friction, whose stiffness follows from the length of the step.
  bool add_row_sums(const Segment& segment, double* sums) const override {
    if (points_.law().friction().type == FrictionType::Smoothed)
      throw InputError("smoothed friction has no longest stable step; use an implicit scheme");
    for (std::size_t b = 0; b < sides_.size(); ++b) {
      const Vectors to = sides_.change_of(b, segment.to);
      Vectors rows{};
      for (std::size_t q = 0; q < sides_.quadrature().size(); ++q) {
        const auto& shape = sides_.quadrature().value[q];
        double total_shape = 0;
        for (double value : shape) total_shape += std::abs(value);
        // A row of the projector onto the tangent plane has at most this sum, as has a unit vector.
        const Pack bound = (total_shape * std::sqrt(double(D))) * sides_.measure(b)[q] *
                           points_.largest_stiffness(b, q, points_.at(q, to));
        for (std::size_t a = 0; a < N; ++a)
          for (std::size_t i = 0; i < D; ++i) rows[a][i] += std::abs(shape[a]) * bound;
      }
      sides_.batches().scatter_force(b, rows, sums);
    }
    return true;
  }

  double energy(const Place& at) const override {
    const In points = in(at.histories, at.step);
    return sum_over_points(points, at.u, [&](std::size_t b, std::size_t q, const Vector& u, const Pack& weight) {
      return weight * points.energy(b, q, u);
    });
  }
  double mean_potential(const Segment& segment) const override {
    const In points = in(segment.histories, segment.step);
    return sum_over_points(points, segment.to, [&](std::size_t b, std::size_t q, const Vector& u, const Pack& weight) {
      return weight * points.mean_potential(b, q, u);
    });
  }

  bool needs_positive_gaps() const override { return points_.law().needs_positive_gaps(); }

  double rounding(const Place& at) const override {
    const In points = in(at.histories, at.step);
    return sum_over_points(points, at.u, [&](std::size_t b, std::size_t q, const Vector& u, const Pack& weight) {
      const Pack stiffness = weight * points.acting_stiffness(b, q, u);
      return stiffness * stiffness * inner(u, u);
    });
  }

  void report(const Place& at, InteractionReport& report) const override {
    report.force.resize(D, 0.0);
    const In points = in(at.histories, at.step);
    sum_over_points(points, at.u, [&](std::size_t b, std::size_t q, const Vector& u, const Pack& weight) {
      const Vector traction = points.template respond<SlipPart::Traction>(b, q, u, SlipKind::At).traction;
      for (std::size_t i = 0; i < D; ++i) report.force[i] -= total(Pack(weight * traction[i]));
      return Pack(0.0);
    });
  }

  void add_nodal_measure(CountedSides& counted, double* measure) const override {
    sides_.add_nodal_measure(counted, measure);
  }

  void add_nodal(SurfaceNumber number, const Place& at, double* by_node) const override {
    if (!has(number)) return;
    const In points = in(at.histories, at.step);
    const bool is_work = number == SurfaceNumber::Dissipated;  // the interaction's factor scales it
    for (std::size_t b = 0; b < sides_.size(); ++b) {
      const auto& weight = is_work ? sides_.measure(b) : sides_.area(b);
      std::array<Pack, N> sums{};
      for (std::size_t q = 0; q < sides_.quadrature().size(); ++q)
        sides_.add_weighted(b, q, weight[q] * points.number(b, q, number), sums);
      sides_.add_nodal(b, sums, by_node);
    }
  }

  void report_friction(const Place& at, FrictionReport& report) const override {
    in(at.histories, at.step).report(at.u, report);
  }

 protected:
  TermHistory create_history() const override { return points_.history(); }
  std::unique_ptr<StepMemory> create_memory() const override { return std::make_unique<Memory>(); }

 private:
  /// Returns the points with what they keep.
  In in(const TermHistories* histories, const StepMemories* step) const {
    if (histories == nullptr) throw std::logic_error("friction needs the histories of a state");
    return {points_, histories->of(slot()), step != nullptr ? &step->of<Memory>(slot()) : nullptr};
  }

  /// Nodal displacements of one batch at the ends of the segment.
  struct Ends {
    Ends(const Sides& sides, std::size_t b, const Segment& segment) {
      to = sides.change_of(b, segment.to);
      if (segment.from != nullptr) from = sides.change_of(b, segment.from);
      if (segment.velocity != nullptr) velocity = sides.change_of(b, segment.velocity);
    }
    Vectors to{}, from{}, velocity{};
  };

  struct Kept final : KeptPoints {
    std::vector<Matrix> stiffness;  ///< batches x quadrature points; batches without friction have none
  };

  /// Adds the force and calls keep(batch, point, exact stiffness).
  template <SlipPart part, class Keep>
  void add_force_with(const Segment& segment, const Rule& rule, double* f, const Keep& keep) const {
    const In points = in(segment.histories, segment.step);
    for (std::size_t b = 0; b < sides_.size(); ++b) {
      if (points.is_idle(b)) continue;
      const Ends ends(sides_, b, segment);
      Vectors force{};
      for (std::size_t q = 0; q < sides_.quadrature().size(); ++q) {
        const Response response = respond<part>(points, ends, b, q, rule, Tangent::Exact);
        keep(b, q, response.stiffness);
        const auto& shape = sides_.quadrature().value[q];
        for (std::size_t a = 0; a < N; ++a)
          for (std::size_t i = 0; i < D; ++i) force[a][i] += shape[a] * response.traction[i];
      }
      sides_.batches().scatter_force(b, force, f);
    }
  }

  Matrix stiffness(const In& points, const Ends& ends, std::size_t b, std::size_t q, const Rule& rule,
                   Tangent kind) const {
    return respond<SlipPart::All>(points, ends, b, q, rule, kind).stiffness;
  }

  /// Returns the traction and the stiffness at a point by the rule that friction follows, times the measure. The convex
  /// stiffness leaves out that of the threshold.
  template <SlipPart part>
  Response respond(const In& points, const Ends& ends, std::size_t b, std::size_t q, const Rule& asked,
                   Tangent tangent) const {
    const Rule& rule = followed(asked);
    Response sum;
    const auto add = [&](const Vector& u, SlipKind kind, double weight, double slope_weight) {
      const Response here = points.template respond<part>(b, q, u, kind, tangent);
      for (std::size_t i = 0; i < D; ++i) {
        sum.traction[i] += (weight * sides_.measure(b)[q]) * here.traction[i];
        for (std::size_t j = 0; part == SlipPart::All && j < D; ++j)
          sum.stiffness[i][j] += (slope_weight * sides_.measure(b)[q]) * here.stiffness[i][j];
      }
    };
    const Vector to = points_.at(q, ends.to);
    if (rule.mean != Mean::Points) add(to, SlipKind::Mean, 1, 1);
    for (const RulePoint& point : rule.points) {
      Vector u;
      for (std::size_t i = 0; i < D; ++i) u[i] = point.to * to[i];
      const auto add_share = [&](double share, const Vectors& nodal) {
        if (share == 0) return;
        const Vector other = points_.at(q, nodal);
        for (std::size_t i = 0; i < D; ++i) u[i] += share * other[i];
      };
      add_share(point.from, ends.from);
      add_share(point.velocity, ends.velocity);
      add(u, SlipKind::At, point.weight, point.weight * point.to);
    }
    return sum;
  }

  /// Returns the sum of visit(batch, quadrature point, displacement, weight) over the sides that count on this rank and
  /// have friction.
  template <class Visit>
  double sum_over_points(const In& points, const double* u, const Visit& visit) const {
    Pack sum = 0.0;
    for (std::size_t b = 0; b < sides_.size(); ++b) {
      if (points.is_idle(b)) continue;
      const Vectors nodal = sides_.change_of(b, u);
      for (std::size_t q = 0; q < sides_.quadrature().size(); ++q)
        sum += visit(b, q, points_.at(q, nodal), Pack(sides_.owned(b) * sides_.measure(b)[q]));
    }
    return total(sum);
  }

  class Action final : public TangentAction {
   public:
    explicit Action(const FrictionTerm& term) : term_(term), stiffness_(term.sides_) {}

    void linearize(const Segment& segment, const Rule& rule, Tangent kind, const LinearPart&) override {
      const In points = term_.in(segment.histories, segment.step);
      for (std::size_t b = 0; b < term_.sides_.size(); ++b) {
        const Ends ends(term_.sides_, b, segment);
        for (std::size_t q = 0; q < term_.sides_.quadrature().size(); ++q)
          stiffness_(b, q) = points.is_idle(b) ? Matrix{} : term_.stiffness(points, ends, b, q, rule, kind);
      }
    }
    void add_product(const double* x, double* y) const override { stiffness_.add_product(x, y); }
    void add_diagonal(double* d) const override { stiffness_.add_diagonal(d); }
    bool has_coarse() const override { return term_.sides_.may_be_coarsened(); }
    void add_coarse(const CoarseSpace& coarse, double* values) const override { stiffness_.add_coarse(coarse, values); }

   private:
    const FrictionTerm& term_;
    PointMatrices<SideElement> stiffness_;
  };

  Points points_;
  const Sides& sides_;
};

}  // namespace

Interactions make_friction_terms(const LocalMesh& mesh, const std::vector<LocalSide>& sides, const Pattern& pattern,
                                 const FrictionLaw& law, const std::shared_ptr<const Obstacle>& obstacle,
                                 const SurfaceOptions& options) {
  return make_terms<FrictionTerm>(mesh, sides, pattern, law, obstacle, options);
}

}  // namespace ixos
