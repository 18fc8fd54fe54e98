#include "term/wall/friction_term.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "base/error.hpp"
#include "base/scratch.hpp"
#include "term/friction_interaction.hpp"
#include "term/wall/friction_points.hpp"
#include "term/wall/side_action.hpp"
#include "term/wall/side_ends.hpp"

namespace ixos {
namespace {

/// Sides in D dimensions.
template <std::size_t D>
class FrictionTerm final : public FrictionInteraction {
  using Points = FrictionPoints<D>;
  using Sides = CurvedWallSides<D>;
  using Vector = typename Points::Vector;
  using Response = typename Points::Response;
  using Memory = typename Points::Memory;
  using In = typename Points::In;
  using Ends = SideEnds<D>;
  using Matrix = Small<Pack, D>;
  using Kept = KeptStiffness<Matrix>;

 public:
  FrictionTerm(const LocalMesh& mesh, const std::vector<LocalSide>& group, std::unique_ptr<Sides> sides,
               const FrictionLaw& law, std::shared_ptr<const Obstacle> obstacle)
      : points_(mesh, group, std::move(sides), law, std::move(obstacle)), sides_(points_.sides()) {}

  // The life over steps.
  void place(const Pattern& pattern) override { sides_.place(pattern); }
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
    for_each_stiffness(points, segment, rule, kind,
                       [&](std::size_t b, const Matrix* k) { sides_.add_tangent(b, k, values); });
  }

  std::unique_ptr<KeptPoints> create_kept() const override { return std::make_unique<Kept>(); }

  /// Keeps the matrix of each quadrature point.
  bool add_force_and_keep(const Segment& segment, const Rule& rule, KeptPoints& kept, double* f) const override {
    auto& matrices = static_cast<Kept&>(kept).stiffness;
    const std::size_t points = sides_.points();
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
      if (!points.is_idle(b)) sides_.add_tangent(b, matrices + b * sides_.points(), values);
  }

  /// An action has to be symmetric.
  std::unique_ptr<TangentAction> create_action() const override {
    if (points_.law().friction().current) return nullptr;
    return std::make_unique<SideAction<Sides>>(
        sides_, [this](const Segment& segment, const Rule& rule, Tangent kind, typename Sides::Matrices& matrices) {
          linearize(segment, rule, kind, matrices);
        });
  }

  /// Throws InputError for smoothed friction, whose stiffness follows from the length of the step.
  bool add_row_sums(const Segment& segment, double* sums) const override {
    if (points_.law().friction().type == FrictionType::Smoothed)
      throw InputError("smoothed friction has no longest stable step; use an implicit scheme");
    Scratch<PackPoint> at(sides_.points()), rows(at.size());
    for (std::size_t b = 0; b < sides_.size(); ++b) {
      sides_.changes(b, segment.to, at.data());
      for (std::size_t q = 0; q < at.size(); ++q) {
        // A row of the projector onto the tangent plane has at most this sum, as has a unit vector.
        rows[q].fill((sides_.total_shape(q) * std::sqrt(double(D))) * sides_.measure(b)[q] *
                     points_.largest_stiffness(b, q, Points::first(at[q])));
      }
      sides_.add_row_sums(b, rows.data(), sums);
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
    Scratch<Pack> values(sides_.points());
    for (std::size_t b = 0; b < sides_.size(); ++b) {
      const Pack* weight = is_work ? sides_.measure(b) : sides_.area(b);
      for (std::size_t q = 0; q < values.size(); ++q) values[q] = weight[q] * points.number(b, q, number);
      sides_.add_weighted_nodal(b, values.data(), by_node);
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

  /// Adds the force and calls keep(batch, point, exact stiffness).
  template <SlipPart part, class Keep>
  void add_force_with(const Segment& segment, const Rule& rule, double* f, const Keep& keep) const {
    const In points = in(segment.histories, segment.step);
    Ends ends(sides_, Ends::Of::Displacements, segment);
    Scratch<PackPoint> forces(sides_.points());
    for (std::size_t b = 0; b < sides_.size(); ++b) {
      if (points.is_idle(b)) continue;
      ends.set(b);
      for (std::size_t q = 0; q < forces.size(); ++q) {
        const Response response = respond<part>(points, ends, b, q, rule, Tangent::Exact);
        keep(b, q, response.stiffness);
        for (std::size_t i = 0; i < D; ++i) forces[q][i] = response.traction[i];
      }
      sides_.add_forces(b, forces.data(), f);
    }
  }

  /// Calls visit(batch, stiffnesses of its points) for the batches that have friction.
  template <class Visit>
  void for_each_stiffness(const In& points, const Segment& segment, const Rule& rule, Tangent kind,
                          const Visit& visit) const {
    Ends ends(sides_, Ends::Of::Displacements, segment);
    Scratch<Matrix> k(sides_.points());
    for (std::size_t b = 0; b < sides_.size(); ++b) {
      if (points.is_idle(b)) continue;
      ends.set(b);
      for (std::size_t q = 0; q < k.size(); ++q)
        k[q] = respond<SlipPart::All>(points, ends, b, q, rule, kind).stiffness;
      visit(b, k.data());
    }
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
    if (rule.mean != Mean::Points) add(Points::first(ends.to(q)), SlipKind::Mean, 1, 1);
    for (const RulePoint& point : rule.points)
      add(Points::first(ends.at(q, point)), SlipKind::At, point.weight, point.weight * point.to);
    return sum;
  }

  /// Returns the sum of visit(batch, quadrature point, displacement, weight) over the sides that count on this rank and
  /// have friction.
  template <class Visit>
  double sum_over_points(const In& points, const double* u, const Visit& visit) const {
    Pack sum = 0.0;
    Scratch<PackPoint> here(sides_.points());
    for (std::size_t b = 0; b < sides_.size(); ++b) {
      if (points.is_idle(b)) continue;
      sides_.changes(b, u, here.data());
      for (std::size_t q = 0; q < here.size(); ++q)
        sum += visit(b, q, Points::first(here[q]), Pack(sides_.owned(b) * sides_.measure(b)[q]));
    }
    return total(sum);
  }

  /// Sets the matrices of all batches.
  void linearize(const Segment& segment, const Rule& rule, Tangent kind, typename Sides::Matrices& matrices) const {
    const In points = in(segment.histories, segment.step);
    const std::vector<Matrix> none(sides_.points());
    for (std::size_t b = 0; b < sides_.size(); ++b)
      if (points.is_idle(b)) matrices.set(b, none.data());
    for_each_stiffness(points, segment, rule, kind, [&](std::size_t b, const Matrix* k) { matrices.set(b, k); });
  }

  Points points_;
  Sides& sides_;
};

}  // namespace

Interactions make_friction_terms(const LocalMesh& mesh, const std::vector<LocalSide>& sides, const Pattern& pattern,
                                 const FrictionLaw& law, const std::shared_ptr<const Obstacle>& obstacle,
                                 const SurfaceOptions& options) {
  const auto make_sides = [&](const SideGroup& group, auto dimension) {
    return make_curved_sides<dimension.value>(mesh, group, pattern, options.points);
  };
  return make_terms<FrictionTerm>(mesh, sides, options, make_sides, law, obstacle);
}

}  // namespace ixos
