#include "term/pair_term.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <utility>

#include "term/pair_action.hpp"
#include "term/pair_coupling.hpp"
#include "term/pair_gradient.hpp"

namespace ixos {
namespace {

double at(const Pack& value) { return value[0]; }

template <std::size_t D>
class PairTerm final : public Interaction {
 public:
  static constexpr std::size_t corners = D == 2 ? 2 : 4;  ///< of a patch
  using Share = typename PairPoints<D>::Share;
  using Places = typename PairPoints<D>::Places;
  using Contact = typename PairPoints<D>::Contact;
  using Contacts = typename PairPoints<D>::Contacts;

  PairTerm(const LocalMesh& mesh, PairSurfaces<D> surfaces, const Pattern& pattern, std::shared_ptr<const GapLaw> law,
           const PairOptions& options)
      : pattern_(pattern),
        points_(mesh, std::move(surfaces), std::move(law), options),
        coupling_(points_),
        margin_(options.margin) {}

  bool needs_positive_gaps() const override { return points_.is_positive(); }
  bool follows(Mean mean) const override { return mean != Mean::Exact; }

  bool couples_anew() const override { return true; }
  bool update_stencils(const double* u) override { return coupling_.update(points_.places(u)); }
  std::vector<std::vector<int>> stencils() const override { return coupling_.stencils(); }
  bool has_state() const override { return true; }
  void transfer(Record& record) override {
    if (points_.sight() != nullptr) {
      SelfSight<D>::transfer(record, seen_);
      points_.sight()->set_seen(seen_);
    }
    coupling_.transfer(record);
  }

  void initialize(const KnownState& start) override {
    coupling_.begin_anew();
    start_.reset();
    if (points_.sight() == nullptr) return;
    look(start, 0);
    seen_ = points_.sight()->seen();
  }
  /// Decides which parts of a surface face each other. If these are others than in the last accepted step, the energy
  /// jumps at the start of the step.
  void begin_step(const KnownState& start, double, double dt) override {
    if (points_.sight() == nullptr) {
      if (needs_positive_gaps()) start_ = points_.places(start.u);
      return;
    }
    look(start, dt);
    lost_ = 0;
    if (points_.sight()->seen() == seen_) return;
    lost_ = -energy(start.u);
    std::vector<std::vector<int>> seen = points_.sight()->seen();
    points_.sight()->set_seen(seen_);
    lost_ += energy(start.u);
    points_.sight()->set_seen(std::move(seen));
  }
  bool dissipates() const override { return points_.sight() != nullptr; }
  double accept(const AcceptedStep&) override {
    start_.reset();
    if (points_.sight() == nullptr) return 0;
    seen_ = points_.sight()->seen();
    return std::exchange(lost_, 0.0);
  }

  bool add_force(const Segment& segment, const Rule& rule, double* f) const override {
    check(rule);
    if (rule.mean == Mean::DiscreteGradient) {
      coupling_.join();
      const double least = PairGradient<D>(points_).add_force(segment, f);
      return !needs_positive_gaps() || least > 0;
    }
    double least = std::numeric_limits<double>::infinity();
    for (const RulePoint& point : rule.points)
      least =
          std::min(least, add_force(points_.contacts(points_.places(segment, point), Share::Forces), point.weight, f));
    return is_admissible(segment, rule, least);
  }

  std::unique_ptr<KeptPoints> create_kept() const override { return std::make_unique<Kept>(); }

  bool add_force_and_keep(const Segment& segment, const Rule& rule, KeptPoints& kept, double* f) const override {
    if (rule.mean == Mean::DiscreteGradient) return add_force(segment, rule, f);
    check(rule);
    std::vector<Contacts>& times = dynamic_cast<Kept&>(kept).times;
    times.clear();
    double least = std::numeric_limits<double>::infinity();
    for (const RulePoint& point : rule.points) {
      times.push_back(points_.contacts(points_.places(segment, point), Share::Forces));
      least = std::min(least, add_force(times.back(), point.weight, f));
    }
    return is_admissible(segment, rule, least);
  }

  /// Leaves out nodes that are not coupled, see PairCoupling.
  void add_tangent(const Segment& segment, const Rule& rule, Tangent kind, double* values) const override {
    check(rule);
    const auto add = [&](const PairBlock& block) { add_to_matrix(block, values); };
    if (rule.mean == Mean::DiscreteGradient)
      PairGradient<D>(points_).for_each_block(segment, kind, add);
    else
      points_.for_each_block(segment, rule, kind, add);
  }

  void add_kept_tangent(const Segment& segment, const Rule& rule, Tangent kind, const KeptPoints& kept,
                        double* values) const override {
    if (rule.mean == Mean::DiscreteGradient) return add_tangent(segment, rule, kind, values);
    points_.for_each_block(dynamic_cast<const Kept&>(kept).times, rule, kind,
                           [&](const PairBlock& block) { add_to_matrix(block, values); });
  }

  std::unique_ptr<TangentAction> create_action() const override { return std::make_unique<PairAction<D>>(points_); }

  bool add_row_sums(const Segment& segment, double* sums) const override {
    const Contacts contacts = points_.contacts(points_.places(segment.to), Share::Forces);
    points_.for_each_block({nullptr, nullptr, segment.to}, end_rule(), Tangent::Exact, [&](const PairBlock& block) {
      const std::size_t size = D * block.nodes.size();
      for (std::size_t r = 0; r < size; ++r)
        for (std::size_t c = 0; c < size; ++c)
          sums[D * static_cast<std::size_t>(block.nodes[r / D]) + r % D] += std::abs(block.k[r * size + c]);
    });
    return !needs_positive_gaps() || contacts.least_gap > 0;
  }

  double energy(const double* u) const override {
    return sum(u, [&](const Contact& c) { return points_.measure(c) * at(points_.law().energy(c.foot.gap)); });
  }

  /// Follows the surfaces along the step in up to 8 parts, each as long as no gap can have fallen to its least one: the
  /// bound of a part does not know the direction of the motion.
  double admissible_step(const Segment& segment, const Rule& rule, const double* direction) const override {
    if (!needs_positive_gaps()) return 1;
    const Places ways = points_.ways(direction);
    double step = free_step(points_.places(segment.to), ways, 1);
    if (segment.from != nullptr || segment.velocity != nullptr)
      for (const RulePoint& point : rule.points)
        if (point.to != 0) step = free_step(points_.places(segment, point), ways, point.to, step);
    return step;
  }

  /// Throws std::logic_error: the mean over the path has no closed form.
  double mean_potential(const Segment&) const override {
    throw std::logic_error("the mean force between two surfaces has no closed form");
  }

  /// The path can pass nearer than its ends, so its middle counts, too.
  double gap_ratio(const double* from, const double* to) const override {
    if (!needs_positive_gaps()) return 1;
    const double near = 10 * points_.law().equilibrium_gap();
    const Segment segment{from, nullptr, to};
    std::array<Contacts, 3> at_times;
    for (std::size_t i = 0; i < 3; ++i) {
      const double share = 0.5 * static_cast<double>(i);
      at_times[i] = points_.contacts(points_.places(segment, {1, 1 - share, 0, share}), Share::Energies);
    }
    double largest = 1;
    for (std::size_t p = 0; p < at_times[0].all.size(); ++p) {
      double least = std::numeric_limits<double>::infinity(), most = 0;
      for (const Contacts& contacts : at_times) {
        const SurfaceFoot<D>& foot = contacts.all[p].foot;
        const double gap = std::min(foot.gap, points_.law().range());
        least = std::min(least, gap);
        most = std::max(most, gap);
      }
      if (least < near) largest = std::max(largest, most / std::max(least, 1e-6 * most));
    }
    return largest;
  }

  double rounding(const double* u) const override {
    const GapLaw& law = points_.law();
    return sum(u, [&](const Contact& c) {
      const double near = std::min(c.foot.gap, law.equilibrium_gap());  // a step may lead there
      const double force = points_.measure(c) *
                           (at(law.magnitude(c.foot.gap)) + std::abs(at(law.stiffness(near))) * 2 * length(c.place));
      return force * force;
    });
  }

  LowestPoint lowest_point(const double* u) const override {
    const Places x = points_.places(u);
    const PlacedSurface<D> secondary(points_.secondary().patches, x.secondary),
        primary(points_.primary().patches, x.primary);
    LowestPoint lowest;
    if (points_.sight() != nullptr) {
      lower_to_itself(secondary, lowest);
      return lowest;
    }
    lower(points_.secondary().patches, x.secondary, secondary, primary, lowest);
    lower(points_.primary().patches, x.primary, primary, secondary, lowest);
    if (start_) lower_on_the_way(*start_, x, lowest);
    return lowest;
  }

  void add_nodal_measure(CountedSides& counted, double* measure) const override {
    for (std::size_t s = 0; s < points_.secondary().patches.size(); ++s) {
      if (!counted.insert(points_.secondary().sides[s]).second) continue;
      for (std::size_t q = 0; q < points_.points_of_a_patch(); ++q) {
        const Contact contact{s, q};
        add_weighted(contact, points_.area(contact), measure);
      }
    }
  }

  void add_nodal_pressure(const double* u, double* force) const override {
    const Contacts contacts = points_.contacts(points_.places(u), Share::Forces);
    for (const Contact& contact : contacts.all)
      add_weighted(contact, points_.passes() * points_.measure(contact) * contact.traction, force);
  }

  void lower_nodal_gap(const double* u, double* gap) const override {
    for_each_node(u, [&](std::size_t node, const SurfaceFoot<D>& foot) {
      if (!(gap[node] <= foot.gap)) gap[node] = foot.gap;
    });
  }

  void set_nodal_normal(const double* u, double* normal) const override {
    for_each_node(u, [&](std::size_t node, const SurfaceFoot<D>& foot) {
      for (std::size_t i = 0; i < D; ++i) normal[D * node + i] = foot.normal[i];
    });
  }

  void report(const double* u, InteractionReport& report) const override {
    report.force.resize(D, 0.0);
    report.measure += sum(u, [&](const Contact& c) {
      report.least_gap = std::min(report.least_gap, c.foot.gap);
      for (std::size_t i = 0; i < D; ++i) report.force[i] += points_.measure(c) * c.traction * c.foot.normal[i];
      return c.foot.gap < points_.law().adhesion_gap() ? points_.area(c) : 0.0;
    });
  }

 private:
  /// The contacts at the points of a rule.
  struct Kept final : KeptPoints {
    std::vector<Contacts> times;
  };

  /// Adds the forces times the weight. Returns the least gap.
  double add_force(const Contacts& contacts, double weight, double* f) const {
    for (const Contact& contact : contacts.all) {
      if (contact.foot.patch < 0) continue;
      const typename PairGap<D>::Vector gradient = points_.gap_of(contacts, contact).gradient();
      const std::vector<int> nodes = points_.nodes_of(contact);
      const double factor = -weight * points_.measure(contact) * contact.traction;
      for (std::size_t r = 0; r < D * nodes.size(); ++r)
        f[D * static_cast<std::size_t>(nodes[r / D]) + r % D] += factor * gradient[r];
    }
    return contacts.least_gap;
  }

  bool is_admissible(const Segment& segment, const Rule& rule, double least) const {
    if (!needs_positive_gaps()) return true;
    if (!rule.has_end()) least = std::min(least, points_.contacts(points_.places(segment.to), Share::Forces).least_gap);
    return least > 0;
  }

  void add_to_matrix(const PairBlock& block, double* values) const {
    const std::size_t size = D * block.nodes.size();
    for (std::size_t a = 0; a < block.nodes.size(); ++a)
      for (std::size_t b = 0; b < block.nodes.size(); ++b) {
        const int offset = pattern_.coupled_offset(block.nodes[a], block.nodes[b]);
        if (offset < 0) continue;
        const int stride = pattern_.stride(block.nodes[a]);
        for (std::size_t i = 0; i < D; ++i)
          for (std::size_t j = 0; j < D; ++j)
            values[offset + static_cast<int>(i) * stride + static_cast<int>(j)] +=
                block.k[(D * a + i) * size + D * b + j];
      }
  }

  static void check(const Rule& rule) {
    if (rule.mean == Mean::Exact) throw std::logic_error("a pair of surfaces has no mean in closed form");
  }

  /// Returns the sum of visit(contact) over the points with feet that count on this rank.
  template <class Visit>
  double sum(const double* u, const Visit& visit) const {
    const Contacts contacts = points_.contacts(points_.places(u), Share::Energies);
    double result = 0;
    for (const Contact& contact : contacts.all)
      if (contact.foot.patch >= 0) result += visit(contact);
    return result;
  }

  /// Calls visit(local node, foot) for the nodes of the secondary surface.
  template <class Visit>
  void for_each_node(const double* u, const Visit& visit) const {
    const Places x = points_.places(u);
    const PlacedSurface<D> primary(points_.primary().patches, x.primary);
    if (points_.sight() == nullptr) {
      for (std::size_t i = 0; i < x.secondary.size(); ++i)
        visit(static_cast<std::size_t>(points_.secondary().nodes[i]), primary.nearest(x.secondary[i]));
      return;
    }
    std::vector<SurfaceFoot<D>> feet(x.secondary.size());  // the nearest of those that the patches at a corner see
    for (std::size_t p = 0; p < points_.secondary().patches.size(); ++p)
      for (std::size_t c = 0; c < corners; ++c) {
        const auto node = static_cast<std::size_t>(points_.secondary().patches[p].nodes[c]);
        const SurfaceFoot<D> foot = points_.nearest(primary, p, x.secondary[node], points_.law().range());
        if (foot.patch >= 0 && foot.gap < feet[node].gap) feet[node] = foot;
      }
    for (std::size_t node = 0; node < feet.size(); ++node)
      if (feet[node].patch >= 0) visit(static_cast<std::size_t>(points_.secondary().nodes[node]), feet[node]);
  }

  /// Lets the sight look at the start of a step, as far as gaps can fall in it: by the law's range, or by twice the way
  /// of the fastest node.
  void look(const KnownState& start, double dt) {
    const Places x = points_.places(start.u);
    if (!x.is_finite()) return;
    double fastest = 0;
    if (start.v != nullptr)
      for (const Vec<D>& v : points_.ways(start.v).secondary) fastest = std::max(fastest, length(v));
    points_.sight()->look(x.secondary, std::max(points_.law().range(), 2 * dt * fastest));
  }

  /// Lowers the lowest point to the corners and middles of the patches of a surface before what they see of it.
  void lower_to_itself(const PlacedSurface<D>& surface, LowestPoint& lowest) const {
    for (std::size_t p = 0; p < points_.secondary().patches.size(); ++p)
      for (std::size_t i = 0; i < (D == 2 ? 3 : 9); ++i) {
        [[maybe_unused]] const std::size_t row = i / 3;
        PatchParameters<D> xi{0.5 * static_cast<double>(i % 3)};
        if constexpr (D == 3) xi[1] = 0.5 * static_cast<double>(row);
        const Vec<D> place = surface.patch(static_cast<int>(p)).at(xi);
        const SurfaceFoot<D> foot = points_.nearest(surface, p, place, points_.law().range());
        if (!(foot.gap < lowest.gap)) continue;
        lowest.gap = foot.gap;
        std::copy(place.begin(), place.end(), lowest.place.begin());
      }
  }

  /// Returns the point's place along its own patch at the given values of the surface's nodes.
  Vec<D> interpolate(const Contact& contact, const std::vector<Vec<D>>& values) const {
    const SurfacePatch<D>& patch = points_.secondary().patches[contact.patch];
    Vec<D> result{};
    for (std::size_t a = 0; a < patch.count; ++a)
      result = result + points_.weights(contact)[a] * values[static_cast<std::size_t>(patch.nodes[a])];
    return result;
  }

  void add_weighted(const Contact& contact, double value, double* by_node) const {
    const SurfacePatch<D>& patch = points_.secondary().patches[contact.patch];
    for (std::size_t a = 0; a < patch.count; ++a)
      by_node[points_.secondary().nodes[static_cast<std::size_t>(patch.nodes[a])]] +=
          points_.weights(contact)[a] * value;
  }

  /// Lowers the lowest point to the nodes and the middles of the sides of one surface before the other. A surface that
  /// crosses the other has a node no deeper than its longest side, or a middle.
  static void lower(const std::vector<SurfacePatch<D>>& patches, const std::vector<Vec<D>>& x,
                    const PlacedSurface<D>& own, const PlacedSurface<D>& other, LowestPoint& lowest) {
    const double longest = longest_side(patches, x);
    int guess = -1;
    const auto look = [&](const Vec<D>& place) {
      const SurfaceFoot<D> foot = other.nearest(place, std::max(std::abs(lowest.gap), longest), guess);
      guess = foot.patch;
      if (!(foot.gap < lowest.gap)) return;
      lowest.gap = foot.gap;
      std::copy(place.begin(), place.end(), lowest.place.begin());
    };
    for (const Vec<D>& place : x) look(place);
    PatchParameters<D> middle;
    middle.fill(0.5);
    for (std::size_t s = 0; s < patches.size(); ++s) look(own.patch(static_cast<int>(s)).at(middle));
  }

  /// Lowers the lowest point to those between the start of a step and its end: a scheme that looks at the end only can
  /// find a state in which the bodies have passed through each other. Looks as often as the bodies move by the longest
  /// side of a surface relative to each other, at most 10,000 times.
  void lower_on_the_way(const Places& from, const Places& to, LowestPoint& lowest) const {
    const std::size_t own = from.secondary.size(), other = from.primary.size();
    Vec<D> mean{};
    const auto for_each_way = [&](const auto& visit) {
      for (std::size_t i = 0; i < own; ++i) visit(to.secondary[i] - from.secondary[i]);
      for (std::size_t i = 0; i < other; ++i) visit(to.primary[i] - from.primary[i]);
    };
    for_each_way([&](const Vec<D>& way) { mean = mean + 1 / static_cast<double>(own + other) * way; });
    double motion = 0;
    for_each_way([&](const Vec<D>& way) { motion = std::max(motion, 2 * length(way - mean)); });
    const double side = std::max(longest_side(points_.secondary().patches, from.secondary),
                                 longest_side(points_.primary().patches, from.primary));
    if (!(motion > side)) return;
    const int looks = static_cast<int>(std::min(1e4, motion / side));
    for (int k = 1; k <= looks; ++k) {
      const double share = k / (looks + 1.0);
      Places between = from;
      for (std::size_t i = 0; i < own; ++i)
        between.secondary[i] = between.secondary[i] + share * (to.secondary[i] - from.secondary[i]);
      for (std::size_t i = 0; i < other; ++i)
        between.primary[i] = between.primary[i] + share * (to.primary[i] - from.primary[i]);
      const PlacedSurface<D> secondary(points_.secondary().patches, between.secondary),
          primary(points_.primary().patches, between.primary);
      lower(points_.secondary().patches, between.secondary, secondary, primary, lowest);
      lower(points_.primary().patches, between.primary, primary, secondary, lowest);
    }
  }

  /// Returns the largest distance of a patch's nodes from its first one.
  static double longest_side(const std::vector<SurfacePatch<D>>& patches, const std::vector<Vec<D>>& x) {
    double longest = 0;
    for (const SurfacePatch<D>& patch : patches)
      for (std::size_t a = 0; a < patch.count; ++a)
        longest = std::max(
            longest, length(x[static_cast<std::size_t>(patch.nodes[a])] - x[static_cast<std::size_t>(patch.nodes[0])]));
    return longest;
  }

  /// Returns the largest s in [0, most] for which the gaps at places + s share ways surely have the margin.
  double free_step(Places x, Places ways, double share, double most = 1) const {
    for (auto* way : {&ways.secondary, &ways.primary})
      for (Vec<D>& w : *way) w = (most * share) * w;
    std::vector<double> least;
    double done = 0;
    for (int part = 0; part < 8 && done < 1; ++part) {
      const Contacts contacts = points_.contacts(x, Share::Forces);
      if (least.empty())
        for (const Contact& c : contacts.all)
          least.push_back(margin_ * std::min(c.foot.gap, points_.law().equilibrium_gap()));
      if (!contacts.primary) return most;  // places are no numbers, which shows in the force
      const double fastest = contacts.primary->fastest(ways.primary);
      double own = 1 - done;
      for (std::size_t p = 0; p < contacts.all.size(); ++p) {
        const Contact& c = contacts.all[p];
        const Vec<D> way = interpolate(c, ways.secondary);
        const double gap = c.foot.patch < 0 ? points_.law().range() : c.foot.gap;
        if (gap - least[p] >= own * (length(way) + fastest)) continue;
        own = std::min(
            own, contacts.primary->free_share(c.place, way, ways.primary, fastest, least[p], points_.seen(c.patch)));
      }
      done += own;
      if (own == 0) break;
      for (const bool first : {true, false}) {
        std::vector<Vec<D>>& places = first ? x.secondary : x.primary;
        const std::vector<Vec<D>>& way = first ? ways.secondary : ways.primary;
        for (std::size_t i = 0; i < places.size(); ++i) places[i] = places[i] + own * way[i];
      }
    }
    return most * std::min(done, 1.0);
  }

  const Pattern& pattern_;
  PairPoints<D> points_;
  mutable PairCoupling<D> coupling_;  ///< learns from the force which nodes its tangent needs
  double margin_;
  std::optional<Places> start_;         ///< of a step that is under way
  std::vector<std::vector<int>> seen_;  ///< what patches saw of their own surface in the last accepted step
  double lost_ = 0;                     ///< energy that a change of it takes away at the start of the step
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
