#include "term/pair/pair_term.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <utility>

#include "state/history.hpp"
#include "term/pair/pair_action.hpp"
#include "term/pair/pair_approach.hpp"
#include "term/pair/pair_coupling.hpp"
#include "term/pair/pair_gradient.hpp"
#include "term/pair/pair_passage.hpp"

namespace ixos {
namespace {

double at(const Pack& value) { return value[0]; }

/// By patch: the patches of the same surface that it sees.
using VisibleLists = std::vector<std::vector<int>>;

template <std::size_t D>
class PairTerm final : public Interaction, public Admissibility, public Coupling, public SurfaceReport {
 public:
  using Share = typename PairPoints<D>::Share;
  using Places = typename PairPoints<D>::Places;
  using Contact = typename PairPoints<D>::Contact;
  using Contacts = typename PairPoints<D>::Contacts;
  using Times = typename PairPoints<D>::Times;

  PairTerm(const LocalMesh& mesh, PairSurfaces<D> surfaces, const Pattern& pattern, std::shared_ptr<const GapLaw> law,
           const PairOptions& options)
      : pattern_(pattern),
        points_(mesh, std::move(surfaces), std::move(law), options),
        gradient_(points_),
        coupling_(points_),
        approach_(points_, options.margin) {
    if (is_one_surface()) first_ = points_.visibility()->seen();
  }

  const Rule& followed(const Rule& rule) const override { return rule; }
  bool follows(Mean mean) const override {
    return mean != Mean::Exact && (points_.reacts() || mean != Mean::DiscreteGradient);
  }
  bool is_gradient(const Rule& rule) const override { return points_.reacts() && rule.is_gradient(); }
  bool has_friction() const override { return false; }
  bool has_time_derivative(const Rule&) const override { return true; }
  const Admissibility& admissibility() const override { return *this; }
  const SurfaceReport& reports() const override { return *this; }
  Coupling* coupling() override { return this; }
  const ObstacleMotion* motion() const override { return nullptr; }
  std::vector<std::string> parameters() const override { return {"Law Factor"}; }
  bool add_parameter_derivative(std::size_t parameter, const Segment& segment, const Rule& rule,
                                double* f) const override {
    return add_factor_derivative(parameter, segment, rule, f);
  }

  bool update_stencils(const double* u) override {
    points_.place(u, now_);
    return coupling_.update(now_);
  }
  std::vector<std::vector<int>> stencils() const override { return coupling_.stencils(); }

  bool has_state() const override { return true; }
  /// Another scene that resumes from the same displacement needs the patches that saw each other, although they are no
  /// history of a law: parts that overlap no longer face each other.
  bool outlives_scene() const override { return is_one_surface(); }
  void transfer(Record& record, TermHistories& histories) override {
    const bool other_scene = record.loading() && !record.same_scene();
    if (is_one_surface()) transfer_visibility(record, other_scene, histories.of(slot()).lists);
    if (!other_scene) coupling_.transfer(record);
  }

  void initialize(const KnownState& start, TermHistories& histories) const override {
    coupling_.begin_anew();
    points_.begin_anew();
    if (!is_one_surface()) return;
    TermHistory& history = histories.of(slot());
    if (auto seen = look(start, 0, {})) history.lists = *std::move(seen);
  }
  /// Decides which parts of a surface face each other. If these are others than in the last accepted step, the energy
  /// jumps at the start of the step.
  void begin_step(const StepStart& start, StepMemories& step) const override {
    auto& memory = step.of<Memory>(slot());
    points_.begin_step();
    memory.lost = 0;
    if (!is_one_surface()) {
      memory.guards = needs_positive_gaps();
      if (memory.guards) points_.place(start.state.u, memory.start);
      return;
    }
    const VisibleLists& before = start.histories->of(slot()).lists;
    auto seen = look(start.state, start.dt, before);
    memory.seen = seen ? *std::move(seen) : before;
    if (memory.seen == before) return;
    memory.lost = -energy({start.state.u, start.state.time, start.histories, &step});
    memory.lost += energy(start.place());
  }
  bool dissipates() const override { return is_one_surface(); }
  StepWork accept(const AcceptedStep& step, TermHistories& histories) const override {
    if (!is_one_surface()) return {};
    const auto& memory = step.step->of<Memory>(slot());
    histories.of(slot()).lists = memory.seen;
    return {memory.lost, 0};
  }

  bool add_force(const Segment& segment, const Rule& rule, double* f) const override {
    check(rule);
    see(segment.histories, segment.step);
    if (rule.mean == Mean::DiscreteGradient) {
      coupling_.join();
      const double least = gradient_.add_force(segment, f);
      return !needs_positive_gaps() || least > 0;
    }
    const auto times = points_.contacts(points_.places(segment, rule), Share::Forces);
    for (std::size_t k = 0; k < rule.points.size(); ++k) add_force((*times)[k], rule.points[k].weight, f);
    return !needs_positive_gaps() ||
           std::all_of(times->begin(), times->end(), [](const Contacts& contacts) { return contacts.least_gap > 0; });
  }

  /// Leaves out patches that are not coupled, see PairCoupling.
  void add_tangent(const Segment& segment, const Rule& rule, Tangent kind, double* values) const override {
    check(rule);
    see(segment.histories, segment.step);
    const auto add = [&](const PairBlock& block) {
      if (coupling_.covers(block)) add_to_matrix<D>(block, pattern_, values);
    };
    if (rule.mean == Mean::DiscreteGradient)
      gradient_.for_each_block(segment, kind, add);
    else
      points_.for_each_block(segment, rule, kind, add);
  }

  /// Its linearize() throws std::logic_error unless the rule has points.
  std::unique_ptr<TangentAction> create_action() const override {
    return std::make_unique<PairAction<D>>(
        [this](const Segment& segment, const Rule& rule, Tangent kind, const auto& visit) {
          if (rule.mean != Mean::Points)
            throw std::logic_error("the action of a pair of surfaces is for rules with points");
          see(segment.histories, segment.step);
          points_.for_each_block(segment, rule, kind, visit);
        });
  }

  bool add_row_sums(const Segment& segment, double* sums) const override {
    see(segment.histories, segment.step);
    points_.for_each_block(segment, end_rule(), Tangent::Exact,
                           [&](const PairBlock& block) { ixos::add_row_sums<D>(block, sums); });
    return !needs_positive_gaps() || points_.contacts(segment.to, Share::Forces)->front().least_gap > 0;
  }

  double energy(const Place& here) const override {
    return sum(here, [&](const Contact& c) { return points_.measure(c) * at(points_.law().energy(c.projection.gap)); });
  }

  bool needs_positive_gaps() const override { return points_.is_positive(); }

  double admissible_step(const Segment& segment, const Rule& rule, const double* direction) const override {
    if (!needs_positive_gaps()) return 1;
    see(segment.histories, segment.step);
    const std::vector<Places>& times = points_.places(segment, rule);
    shares_.assign(times.size(), 1.0);  // that of the end
    for (std::size_t k = 0; k < rule.points.size(); ++k) shares_[k] = rule.points[k].to;
    points_.place_ways(direction, ways_);
    return approach_.free_step(times, ways_, shares_);
  }

  /// Throws std::logic_error: the mean over the path has no closed form.
  double mean_potential(const Segment&) const override {
    throw std::logic_error("the mean force between two surfaces has no closed form");
  }

  /// The path can pass nearer than its ends, so its middle counts, too.
  double gap_ratio(const Segment& way) const override {
    if (!needs_positive_gaps()) return 1;
    see(way.histories, way.step);
    const double near = 10 * points_.law().equilibrium_gap();
    path_.resize(3);
    points_.place(way.from, path_[0]);
    points_.place(way, {1, 0.5, 0, 0.5}, path_[1]);
    points_.place(way.to, path_[2]);
    const auto at_times = points_.contacts(path_, Share::Energies);
    double largest = 1;
    for (std::size_t p = 0; p < at_times->front().all.size(); ++p) {
      double least = std::numeric_limits<double>::infinity(), most = 0;
      for (const Contacts& contacts : *at_times) {
        const SurfaceProjection<D>& projection = contacts.all[p].projection;
        const double gap = std::min(projection.gap, points_.law().range());
        least = std::min(least, gap);
        most = std::max(most, gap);
      }
      if (least < near) largest = std::max(largest, most / std::max(least, 1e-6 * most));
    }
    return largest;
  }

  double rounding(const Place& here) const override {
    const GapLaw& law = points_.law();
    return sum(here, [&](const Contact& c) {
      const double near = std::min(c.projection.gap, law.equilibrium_gap());  // a step may lead there
      const double force = points_.measure(c) * (at(law.magnitude(c.projection.gap)) +
                                                 std::abs(at(law.stiffness(near))) * 2 * length(c.place));
      return 2 * force * force;  // on both surfaces
    });
  }

  bool is_clear(const Place& here) const override {
    see(here.histories, here.step);
    points_.place(here.u, now_);
    return approach_.is_clear(now_, guarded_start(here.step));
  }
  LowestPoint lowest_point(const Place& here) const override {
    see(here.histories, here.step);
    points_.place(here.u, now_);
    return approach_.lowest_point(now_, guarded_start(here.step));
  }

  /// A law that needs positive gaps leaves that to lowest_point(), which looks at the way of the step.
  LowestPoint passage(const Segment& way) const override {
    if (needs_positive_gaps()) return {};
    see(way.histories, way.step);
    path_.resize(2);
    points_.place(way.from, path_[0]);
    points_.place(way.to, path_[1]);
    return find_passage(points_, path_[0], path_[1]);
  }

  void add_nodal_measure(CountedSides& counted, double* measure) const override {
    points_.count(counted, [&](std::size_t patch) {
      for (std::size_t q = 0; q < points_.points_of_a_patch(); ++q) {
        const Contact contact{patch, q, 0};
        add_weighted(contact, points_.area(contact), measure);
      }
    });
  }

  bool has(SurfaceNumber number) const override { return number == SurfaceNumber::Pressure; }
  void add_nodal(SurfaceNumber number, const Place& here, double* force) const override {
    if (!has(number)) return;
    see(here.histories, here.step);
    const auto times = points_.contacts(here.u, Share::Forces);
    for (const Contact& contact : times->front().all)
      add_weighted(contact, points_.passes() * points_.measure(contact) * contact.traction, force);
  }

  void lower_nodal_gap(const Place& here, double* gap) const override {
    for_each_node(here, [&](std::size_t node, const SurfaceProjection<D>& projection) {
      if (!(gap[node] <= projection.gap)) gap[node] = projection.gap;
    });
  }

  void lower_facing_gap(const Place& here, double* gap) const override {
    if (is_one_surface()) return;
    const Places x = points_.places(here.u);
    const PlacedSurface<D> secondary(points_.secondary().patches, x.secondary);
    for (std::size_t i = 0; i < x.primary.size(); ++i) {
      const auto node = static_cast<std::size_t>(points_.primary().nodes[i]);
      const double own = secondary.nearest(x.primary[i]).gap;
      if (!(gap[node] <= own)) gap[node] = own;
    }
  }

  void set_nodal_normal(const Place& here, double* normal) const override {
    for_each_node(here, [&](std::size_t node, const SurfaceProjection<D>& projection) {
      for (std::size_t i = 0; i < D; ++i) normal[D * node + i] = projection.normal[i];
    });
  }

  void report(const Place& here, InteractionReport& report) const override {
    report.force.resize(D, 0.0);
    report.measure += sum(here, [&](const Contact& c) {
      report.least_gap = std::min(report.least_gap, c.projection.gap);
      for (std::size_t i = 0; i < D; ++i) report.force[i] += points_.measure(c) * c.traction * c.projection.normal[i];
      return c.projection.gap < points_.law().adhesion_gap() ? points_.area(c) : 0.0;
    });
  }
  void report_friction(const Place&, FrictionReport&) const override {}

 protected:
  TermHistory create_history() const override {
    TermHistory history;
    history.lists = first_;
    return history;
  }
  std::unique_ptr<StepMemory> create_memory() const override { return std::make_unique<Memory>(); }

 private:
  /// Decisions at the start of a step.
  struct Memory final : StepMemory {
    Places start;
    bool guards = false;  ///< bodies could pass through each other on the way from there
    VisibleLists seen;    ///< of one surface
    double lost = 0;      ///< energy that a change of it takes away at the start
  };

  bool is_one_surface() const { return points_.visibility() != nullptr; }
  const Places* guarded_start(const StepMemories* step) const {
    if (step == nullptr) return nullptr;
    const auto& memory = step->of<Memory>(slot());
    return memory.guards ? &memory.start : nullptr;
  }
  /// Lets the points see what a surface sees of itself in a step or a state.
  void see(const TermHistories* histories, const StepMemories* step) const {
    if (!is_one_surface()) return;
    if (step == nullptr && histories == nullptr)
      throw std::logic_error("a surface that interacts with itself needs the histories of a state");
    points_.visibility()->see(step != nullptr ? step->of<Memory>(slot()).seen : histories->of(slot()).lists);
  }
  /// If the record is that of another surface, loading into another scene changes nothing.
  static void transfer_visibility(Record& record, bool other_scene, VisibleLists& seen) {
    if (!other_scene) return SelfVisibility<D>::transfer(record, seen);
    VisibleLists own = seen;
    try {
      SelfVisibility<D>::transfer(record, own);
    } catch (const InputError&) {  // on all ranks alike
      return;
    }
    seen = std::move(own);
  }

  /// Adds the forces times the weight.
  void add_force(const Contacts& contacts, double weight, double* f) const {
    for (const Contact& contact : contacts.all) {
      if (contact.projection.patch < 0) continue;
      const Vec<D> force = (-weight * points_.measure(contact) * contact.traction) * contact.projection.normal;
      const SurfacePatch<D>& patch = points_.primary().patches[static_cast<std::size_t>(contact.projection.patch)];
      add_to_nodes(points_.secondary(), contact.patch, points_.weights(contact), force, f);
      if (!points_.reacts()) continue;
      add_to_nodes(points_.primary(), static_cast<std::size_t>(contact.projection.patch),
                   patch.weights(contact.projection.xi), -1 * force, f);
    }
  }
  static void add_to_nodes(const SurfacePatches<D>& surface, std::size_t patch,
                           const typename SurfacePatch<D>::Weights& weights, const Vec<D>& force, double* f) {
    const SurfacePatch<D>& own = surface.patches[patch];
    for (std::size_t a = 0; a < own.count; ++a) {
      double* const at_node = f + D * static_cast<std::size_t>(surface.nodes[static_cast<std::size_t>(own.nodes[a])]);
      for (std::size_t i = 0; i < D; ++i) at_node[i] += weights[a] * force[i];
    }
  }

  static void check(const Rule& rule) {
    if (rule.mean == Mean::Exact) throw std::logic_error("a pair of surfaces has no mean in closed form");
  }

  /// Returns the sum of visit(contact) over the points with closest points that count on this rank.
  template <class Visit>
  double sum(const Place& here, const Visit& visit) const {
    see(here.histories, here.step);
    const auto times = points_.contacts(here.u, Share::Energies);
    double result = 0;
    for (const Contact& contact : times->front().all)
      if (contact.projection.patch >= 0) result += visit(contact);
    return result;
  }

  /// Calls visit(local node, closest point) for the nodes of the secondary surface.
  template <class Visit>
  void for_each_node(const Place& here, const Visit& visit) const {
    see(here.histories, here.step);
    const Places x = points_.places(here.u);
    const PlacedSurface<D> primary(points_.primary().patches, x.primary);
    if (points_.visibility() == nullptr) {
      for (std::size_t i = 0; i < x.secondary.size(); ++i) {
        SurfaceProjection<D> projection = primary.nearest(x.secondary[i]);
        points_.count_below_rim(projection);
        visit(static_cast<std::size_t>(points_.secondary().nodes[i]), projection);
      }
      return;
    }
    std::vector<SurfaceProjection<D>> projections(
        x.secondary.size());  // the nearest of those that the patches at a corner see
    for (std::size_t p = 0; p < points_.secondary().patches.size(); ++p)
      for (std::size_t c = 0; c < SurfacePatch<D>::corners; ++c) {
        const auto corner = points_.secondary().patches[p].corner(c);
        if (corner.size() > 1) continue;  // no node
        const auto node = static_cast<std::size_t>(corner.front());
        const SurfaceProjection<D> projection = points_.nearest_seen(primary, p, x.secondary[node]);
        if (projection.patch >= 0 && projection.gap < projections[node].gap) projections[node] = projection;
      }
    for (std::size_t node = 0; node < projections.size(); ++node)
      if (projections[node].patch >= 0)
        visit(static_cast<std::size_t>(points_.secondary().nodes[node]), projections[node]);
  }

  /// Returns what patches see at the start of a step, as far as gaps can fall in it: by the law's range, or by twice
  /// the way of the fastest node. Returns nothing if a place is no number.
  std::optional<VisibleLists> look(const KnownState& start, double dt, const VisibleLists& before) const {
    const Places x = points_.places(start.u);
    if (!x.is_finite()) return std::nullopt;
    double fastest = 0;
    if (start.v != nullptr) {
      points_.place_ways(start.v, ways_);
      for (const Vec<D>& v : ways_.secondary) fastest = std::max(fastest, length(v));
    }
    return points_.visibility()->find(x.secondary, std::max(points_.law().range(), 2 * dt * fastest),
                                      needs_positive_gaps() ? nullptr : &before);
  }

  void add_weighted(const Contact& contact, double value, double* by_node) const {
    const SurfacePatch<D>& patch = points_.secondary().patches[contact.patch];
    for (std::size_t a = 0; a < patch.count; ++a)
      by_node[points_.secondary().nodes[static_cast<std::size_t>(patch.nodes[a])]] +=
          points_.weights(contact)[a] * value;
  }

  VisibleLists first_;  ///< of one surface, without a past
  const Pattern& pattern_;
  PairPoints<D> points_;
  PairGradient<D> gradient_;
  mutable PairCoupling<D> coupling_;  ///< learns from the force which nodes its tangent needs
  PairApproach<D> approach_;
  // Memory, so that steps need no new one.
  mutable std::vector<double> shares_;
  mutable Places now_, ways_;
  mutable std::vector<Places> path_;
};

}  // namespace

template <std::size_t D>
std::unique_ptr<Interaction> make_pair_term(const LocalMesh& mesh, PairSurfaces<D> surfaces, const Pattern& pattern,
                                            std::shared_ptr<const GapLaw> law, const PairOptions& options) {
  return std::make_unique<PairTerm<D>>(mesh, std::move(surfaces), pattern, std::move(law), options);
}

template std::unique_ptr<Interaction> make_pair_term(const LocalMesh&, PairSurfaces<2>, const Pattern&,
                                                     std::shared_ptr<const GapLaw>, const PairOptions&);
template std::unique_ptr<Interaction> make_pair_term(const LocalMesh&, PairSurfaces<3>, const Pattern&,
                                                     std::shared_ptr<const GapLaw>, const PairOptions&);

}  // namespace ixos
