#include "term/pair/pair_friction.hpp"

#include <cmath>
#include <stdexcept>
#include <utility>

#include "base/error.hpp"
#include "term/friction_interaction.hpp"
#include "term/pair/pair_action.hpp"
#include "term/pair/pair_slip.hpp"

namespace ixos {
namespace {

template <std::size_t D>
class PairFriction final : public FrictionInteraction {
  using Point = typename PairSlip<D>::Point;
  using Motion = typename PairSlip<D>::Motion;
  using Moduli = typename PairSlip<D>::Moduli;
  using Memory = typename PairSlip<D>::Memory;

 public:
  PairFriction(const LocalMesh& mesh, PairSurfaces<D> surfaces, const Pattern& pattern,
               std::shared_ptr<const GapLaw> law, const FrictionLaw& friction, const PairOptions& options)
      : pattern_(pattern), slip_(mesh, std::move(surfaces), std::move(law), friction, options) {}

  // The life over steps.
  void initialize(const KnownState&, TermHistories& histories) const override {
    histories.of(slot()) = slip_.history();
  }
  void begin_step(const StepStart& start, StepMemories& step) const override {
    slip_.begin(start.state.u, start.dt, start.histories->of(slot()), step.of<Memory>(slot()));
  }
  void begin_stage(const StageStart& start, StepMemories& step) const override {
    slip_.set_length(start.length, step.of<Memory>(slot()));
  }
  StepWork accept(const AcceptedStep& step, TermHistories& histories) const override {
    return {slip_.accept(step.states.back().u, step.dt, step.step->of<Memory>(slot()), histories.of(slot())), 0};
  }
  void transfer(Record& record, TermHistories& histories) override {
    TermHistory& history = histories.of(slot());
    history.points.front().values.transfer(record);
    if (record.loading()) history.last_step = {0, 0};
  }

  // Force and tangent.
  bool is_gradient(const Rule& rule) const override { return D == 2 || followed(rule).mean == Mean::Points; }

  bool add_force(const Segment& segment, const Rule& rule, double* f) const override {
    for (const Point& point : acting(segment.end()))
      slip_.add_force(point, respond<SlipPart::Traction>(point, segment, rule, Tangent::Exact).force, f);
    return true;
  }
  void add_tangent(const Segment& segment, const Rule& rule, Tangent kind, double* values) const override {
    for_each_block(segment, rule, kind, [&](const PairBlock& block) { add_to_matrix<D>(block, pattern_, values); });
  }
  std::unique_ptr<TangentAction> create_action() const override {
    return std::make_unique<PairAction<D>>([this](const Segment& segment, const Rule& rule, Tangent kind,
                                                  const auto& visit) { for_each_block(segment, rule, kind, visit); });
  }

  /// Throws InputError for smoothed friction, whose stiffness follows from the length of the step.
  bool add_row_sums(const Segment& segment, double* sums) const override {
    const Friction& friction = slip_.friction().friction();
    if (friction.type == FrictionType::Smoothed)
      throw InputError("smoothed friction has no longest stable step; use an implicit scheme");
    SlipResponse<double, D> spring;
    for (std::size_t i = 0; i < D; ++i) spring.stiffness[i][i] = friction.stiffness;
    for (const Point& point : slip_.near(segment.to, history(segment.histories))) {
      begin_block(point);
      slip_.add_stiffness(point, point.map.moduli(spring, {}, SlipKind::At, Tangent::Convex), block_.k);
      ixos::add_row_sums<D>(block_, sums);
    }
    return true;
  }

  double energy(const Place& at) const override {
    const Memory* const step = memory(at.step);
    return sum(at, [&](const Point& point) {
      return step != nullptr ? slip_.step(point, step->creep_length).energy(slip_.slip(point, at.u))
                             : slip_.step(point, 0).stored_energy();
    });
  }
  double mean_potential(const Segment& segment) const override {
    const Memory& step = segment.step->of<Memory>(slot());
    return sum(segment.end(), [&](const Point& point) {
      return slip_.step(point, step.creep_length).mean_potential(slip_.slip(point, segment.to));
    });
  }

  bool needs_positive_gaps() const override { return slip_.points().is_positive(); }

  double rounding(const Place& at) const override {
    const Memory* const step = memory(at.step);
    if (step == nullptr) return 0;  // the traction is constant
    return sum(at, [&](const Point& point) {
      const double stiffness = slip_.step(point, step->creep_length).acting_stiffness(slip_.slip(point, at.u));
      const double square = point.map.squares(point.nodes, at.u);
      return slip_.points().measure(point.contact) * stiffness * stiffness * square;  // sum() has the other measure
    });
  }

  void report(const Place& at, InteractionReport& report) const override {
    report.force.resize(D, 0.0);
    sum(at, [&](const Point& point) {
      const Vec<D> traction =
          PatchSlip<D>::on_point(respond<SlipPart::Traction>(point, segment_at(at), end_rule(), Tangent::Exact).force);
      for (std::size_t i = 0; i < D; ++i) report.force[i] -= slip_.points().measure(point.contact) * traction[i];
      return 0.0;
    });
  }

  void add_nodal_measure(CountedSides& counted, double* measure) const override {
    const PairPoints<D>& points = slip_.points();
    points.count(counted, [&](std::size_t patch) {
      for_each_point(patch, [&](const Contact& contact) { add_weighted(contact, points.area(contact), measure); });
    });
  }

  void add_nodal(SurfaceNumber number, const Place& at, double* by_node) const override {
    if (!has(number)) return;
    const TermHistory& kept = history(at.histories);
    const PairPoints<D>& points = slip_.points();
    const bool is_work = number == SurfaceNumber::Dissipated;  // the interaction's factor scales it
    for (std::size_t s = 0; s < points.secondary().patches.size(); ++s)
      for_each_point(s, [&](const Contact& contact) {
        const double weight = is_work ? points.measure(contact) : points.area(contact);
        add_weighted(contact, weight * slip_.number(kept, s, contact.point, number), by_node);
      });
  }
  void report_friction(const Place& at, FrictionReport& report) const override {
    slip_.report(at.u, history(at.histories), report);
  }

 protected:
  TermHistory create_history() const override { return slip_.history(); }
  std::unique_ptr<StepMemory> create_memory() const override { return std::make_unique<Memory>(); }

 private:
  using Contact = typename PairPoints<D>::Contact;

  const TermHistory& history(const TermHistories* histories) const {
    if (histories == nullptr) throw std::logic_error("friction needs the histories of a state");
    return histories->of(slot());
  }
  const Memory* memory(const StepMemories* step) const { return step != nullptr ? &step->of<Memory>(slot()) : nullptr; }
  const typename PairSlip<D>::Points& acting(const Place& at) const {
    return slip_.acting(at.u, history(at.histories), memory(at.step));
  }

  template <class Visit>
  void for_each_point(std::size_t patch, const Visit& visit) const {
    for (std::size_t q = 0; q < slip_.points().points_of_a_patch(); ++q) visit(Contact{patch, q, 0});
  }
  void add_weighted(const Contact& contact, double value, double* by_node) const {
    const SurfacePatches<D>& surface = slip_.points().secondary();
    const SurfacePatch<D>& patch = surface.patches[contact.patch];
    for (std::size_t a = 0; a < patch.count; ++a)
      by_node[surface.nodes[static_cast<std::size_t>(patch.nodes[a])]] += slip_.points().weights(contact)[a] * value;
  }

  /// Returns the sum of measure times visit(point) over the points that count on this rank.
  template <class Visit>
  double sum(const Place& at, const Visit& visit) const {
    double result = 0;
    for (const Point& point : acting(at))
      if (slip_.points().counts(point.contact.patch)) result += slip_.points().measure(point.contact) * visit(point);
    return result;
  }

  /// Sets the block to zero, of the point's patches.
  void begin_block(const Point& point) const {
    block_.secondary = point.contact.patch;
    block_.primary = point.contact.projection.patch;
    block_.nodes.assign(point.nodes.begin(), point.nodes.end());
    block_.k.assign(D * D * point.nodes.size() * point.nodes.size(), 0.0);
  }

  /// Calls visit(block) for each pair of patches with points that friction acts on.
  void for_each_block(const Segment& segment, const Rule& rule, Tangent kind,
                      const std::function<void(const PairBlock&)>& visit) const {
    bool any = false;
    for (const Point& point : acting(segment.end())) {
      if (!any || block_.secondary != point.contact.patch || block_.primary != point.contact.projection.patch) {
        if (any) visit(block_);
        begin_block(point);
        any = true;
      }
      slip_.add_stiffness(point, respond<SlipPart::All>(point, segment, rule, kind).moduli, block_.k);
    }
    if (any) visit(block_);
  }

  /// The force of a point by its Motion, and the derivative.
  struct Response {
    Motion force{};
    Moduli moduli{};
  };

  /// Returns the response by the rule that friction follows.
  template <SlipPart part>
  Response respond(const Point& point, const Segment& segment, const Rule& asked, Tangent tangent) const {
    const Rule& rule = followed(asked);
    Response result;
    const Memory* const memory = this->memory(segment.step);
    const auto step = slip_.step(point, memory != nullptr ? memory->creep_length : 0);
    const auto add = [&](const Motion& motion, SlipKind kind, double weight, double slope_weight) {
      const Motion change = memory != nullptr ? motion - point.start : Motion{};
      SlipResponse<double, D> here{point.traction, {}, {}};
      if (memory != nullptr) here = step.template respond<part>(point.map.slip(change), point.map.plane(), kind);
      result.force = result.force + weight * point.map.force(here.traction, change, kind);
      if constexpr (part == SlipPart::All) {
        const Moduli moduli = point.map.moduli(here, change, kind, tangent);
        for (std::size_t i = 0; i < moduli.size(); ++i) result.moduli[i] = result.moduli[i] + slope_weight * moduli[i];
      }
    };
    const Motion to = slip_.motion(point, segment.to);
    if (rule.mean != Mean::Points) add(to, SlipKind::Mean, 1, 1);
    for (const RulePoint& at : rule.points) {
      Motion moved = at.to * to;
      if (at.from != 0) moved = moved + at.from * slip_.motion(point, segment.from);
      if (at.velocity != 0) moved = moved + at.velocity * slip_.motion(point, segment.velocity);
      add(moved, SlipKind::At, at.weight, at.weight * at.to);
    }
    return result;
  }

  const Pattern& pattern_;
  PairSlip<D> slip_;
  mutable PairBlock block_;  ///< memory
};

}  // namespace

template <std::size_t D>
std::unique_ptr<Interaction> make_pair_friction(const LocalMesh& mesh, PairSurfaces<D> surfaces, const Pattern& pattern,
                                                std::shared_ptr<const GapLaw> law, const FrictionLaw& friction,
                                                const PairOptions& options) {
  return std::make_unique<PairFriction<D>>(mesh, std::move(surfaces), pattern, std::move(law), friction, options);
}

template std::unique_ptr<Interaction> make_pair_friction(const LocalMesh&, PairSurfaces<2>, const Pattern&,
                                                         std::shared_ptr<const GapLaw>, const FrictionLaw&,
                                                         const PairOptions&);
template std::unique_ptr<Interaction> make_pair_friction(const LocalMesh&, PairSurfaces<3>, const Pattern&,
                                                         std::shared_ptr<const GapLaw>, const FrictionLaw&,
                                                         const PairOptions&);

}  // namespace ixos
