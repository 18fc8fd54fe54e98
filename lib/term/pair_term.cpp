#include "term/pair_term.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "term/pair_action.hpp"

namespace ixos {
namespace {

using Share = PairPoints::Share;
using Contact = PairPoints::Contact;
using Contacts = PairPoints::Contacts;
using Block = PairPoints::Block;

double at(const Pack& value) { return value[0]; }

class PairTerm final : public Interaction {
 public:
  PairTerm(const LocalMesh& mesh, SideCurves secondary, SideCurves primary, const Pattern& pattern,
           std::shared_ptr<const GapLaw> law, const PairOptions& options)
      : pattern_(pattern),
        points_(mesh, std::move(secondary), std::move(primary), std::move(law), options),
        margin_(options.margin) {}

  bool needs_positive_gaps() const override { return points_.is_positive(); }
  bool follows(Mean mean) const override { return mean == Mean::Points; }

  bool add_force(const Segment& segment, const Rule& rule, double* f) const override {
    check(rule);
    double least = std::numeric_limits<double>::infinity();
    for (const RulePoint& point : rule.points) {
      const Contacts contacts = points_.contacts(points_.places(segment, point), Share::Forces);
      least = std::min(least, contacts.least_gap);
      for (const Contact& contact : contacts.all) {
        if (contact.foot.segment < 0) continue;
        const PairGap gap = points_.gap_of(contacts, contact);
        const PairGap::Vector gradient = gap.gradient();
        const auto nodes = points_.nodes_of(contact);
        const double factor = -point.weight * points_.measure(contact) * contact.traction;
        for (std::size_t r = 0; r < 2 * gap.nodes(); ++r)
          f[2 * static_cast<std::size_t>(nodes[r / 2]) + r % 2] += factor * gradient[r];
      }
    }
    if (!needs_positive_gaps()) return true;
    if (!rule.has_end()) least = std::min(least, points_.contacts(points_.places(segment.to), Share::Forces).least_gap);
    return least > 0;
  }

  void add_tangent(const Segment& segment, const Rule& rule, Tangent kind, double* values) const override {
    check(rule);
    points_.for_each_block(segment, rule, kind, [&](const Block& block) {
      for (std::size_t a = 0; a < block.count; ++a)
        for (std::size_t b = 0; b < block.count; ++b) {
          const int offset = pattern_.offset(block.nodes[a], block.nodes[b]);
          if (offset < 0) continue;
          const int stride = pattern_.stride(block.nodes[a]);
          for (int i = 0; i < 2; ++i)
            for (int j = 0; j < 2; ++j)
              values[offset + i * stride + j] +=
                  block.k[2 * a + static_cast<std::size_t>(i)][2 * b + static_cast<std::size_t>(j)];
        }
    });
  }

  std::unique_ptr<TangentAction> create_action() const override { return std::make_unique<PairAction>(points_); }

  bool add_row_sums(const Segment& segment, double* sums) const override {
    const Contacts contacts = points_.contacts(points_.places(segment.to), Share::Forces);
    points_.for_each_block({nullptr, nullptr, segment.to}, end_rule(), Tangent::Exact, [&](const Block& block) {
      for (std::size_t r = 0; r < 2 * block.count; ++r)
        for (std::size_t c = 0; c < 2 * block.count; ++c)
          sums[2 * static_cast<std::size_t>(block.nodes[r / 2]) + r % 2] += std::abs(block.k[r][c]);
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
    const PairPoints::Places ways = points_.ways(direction);
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
        const SurfaceFoot& foot = contacts.all[p].foot;
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
    const PairPoints::Places x = points_.places(u);
    LowestPoint lowest;
    lower(points_.secondary(), x.secondary, PlacedCurves(points_.primary().segments, x.primary), lowest);
    lower(points_.primary(), x.primary, PlacedCurves(points_.secondary().segments, x.secondary), lowest);
    return lowest;
  }

  void add_nodal_measure(CountedSides& counted, double* measure) const override {
    std::vector<char> counts(points_.secondary().segments.size());
    for (std::size_t s = 0; s < counts.size(); ++s)
      counts[s] = counted.insert(points_.secondary().sides[s]).second ? 1 : 0;
    for (std::size_t s = 0; s < counts.size(); ++s)
      for (std::size_t q = 0; counts[s] != 0 && q < points_.points_of_a_segment(); ++q) {
        const Contact contact{s, q, {}, {}};
        add_weighted(contact, points_.area(contact), measure);
      }
  }

  void add_nodal_pressure(const double* u, double* force) const override {
    const Contacts contacts = points_.contacts(points_.places(u), Share::Forces);
    for (const Contact& contact : contacts.all)
      add_weighted(contact, points_.measure(contact) * contact.traction, force);
  }

  void lower_nodal_gap(const double* u, double* gap) const override {
    for_each_node(u, [&](std::size_t node, const SurfaceFoot& foot) {
      if (!(gap[node] <= foot.gap)) gap[node] = foot.gap;
    });
  }

  void set_nodal_normal(const double* u, double* normal) const override {
    for_each_node(u, [&](std::size_t node, const SurfaceFoot& foot) {
      for (std::size_t i = 0; i < 2; ++i) normal[2 * node + i] = foot.normal[i];
    });
  }

  void report(const double* u, InteractionReport& report) const override {
    report.force.resize(2, 0.0);
    report.measure += sum(u, [&](const Contact& c) {
      report.least_gap = std::min(report.least_gap, c.foot.gap);
      for (std::size_t i = 0; i < 2; ++i) report.force[i] += points_.measure(c) * c.traction * c.foot.normal[i];
      return c.foot.gap < points_.law().adhesion_gap() ? points_.area(c) : 0.0;
    });
  }

 private:
  static void check(const Rule& rule) {
    if (rule.mean != Mean::Points) throw std::logic_error("a pair of surfaces follows rules with points only");
  }

  /// Returns the sum of visit(contact) over the points with feet that count on this rank.
  template <class Visit>
  double sum(const double* u, const Visit& visit) const {
    const Contacts contacts = points_.contacts(points_.places(u), Share::Energies);
    double result = 0;
    for (const Contact& contact : contacts.all)
      if (contact.foot.segment >= 0) result += visit(contact);
    return result;
  }

  /// Calls visit(local node, foot) for the nodes of the secondary surface.
  template <class Visit>
  void for_each_node(const double* u, const Visit& visit) const {
    const PairPoints::Places x = points_.places(u);
    const PlacedCurves curves(points_.primary().segments, x.primary);
    for (std::size_t i = 0; i < x.secondary.size(); ++i)
      visit(static_cast<std::size_t>(points_.secondary().nodes[i]), curves.nearest(x.secondary[i]));
  }

  void add_weighted(const Contact& contact, double value, double* by_node) const {
    const CurveSegment& segment = points_.secondary().segments[contact.segment];
    for (std::size_t a = 0; a < segment.count; ++a)
      by_node[points_.secondary().nodes[static_cast<std::size_t>(segment.nodes[a])]] +=
          points_.weights(contact)[a] * value;
  }

  /// Lowers the lowest point to the nodes and the middles of the sides of one surface before the other.
  static void lower(const SideCurves& curves, const std::vector<Planar>& x, const PlacedCurves& other,
                    LowestPoint& lowest) {
    const auto look = [&](const Planar& place) {
      const SurfaceFoot foot = other.nearest(place);
      if (!(foot.gap < lowest.gap)) return;
      lowest.gap = foot.gap;
      lowest.place = {place[0], place[1], 0};
    };
    const PlacedCurves own(curves.segments, x);
    for (const Planar& place : x) look(place);
    for (std::size_t s = 0; s < curves.segments.size(); ++s)
      look(curves.segments[s].sum(curves.segments[s].weights(0.5), own.points(static_cast<int>(s))));
  }

  /// Returns the largest s in [0, most] for which the gaps at places + s share ways surely have the margin.
  double free_step(PairPoints::Places x, PairPoints::Places ways, double share, double most = 1) const {
    for (auto* way : {&ways.secondary, &ways.primary})
      for (Planar& w : *way) w = (most * share) * w;
    std::vector<double> least;
    double done = 0;
    for (int part = 0; part < 8 && done < 1; ++part) {
      const Contacts contacts = points_.contacts(x, Share::Forces);
      if (least.empty())
        for (const Contact& c : contacts.all)
          least.push_back(margin_ * std::min(c.foot.gap, points_.law().equilibrium_gap()));
      const PlacedCurves curves(points_.primary().segments, x.primary);
      double own = 1 - done;
      PairPoints::Places rest = ways;
      for (std::size_t p = 0; p < contacts.all.size(); ++p) {
        const Contact& c = contacts.all[p];
        const CurveSegment& segment = points_.secondary().segments[c.segment];
        Planar way{};
        for (std::size_t a = 0; a < segment.count; ++a)
          way = way + points_.weights(c)[a] * ways.secondary[static_cast<std::size_t>(segment.nodes[a])];
        own = std::min(own, curves.free_share(c.place, way, ways.primary, least[p]));
      }
      done += own;
      if (own == 0) break;
      for (const bool first : {true, false}) {
        std::vector<Planar>& places = first ? x.secondary : x.primary;
        const std::vector<Planar>& way = first ? ways.secondary : ways.primary;
        for (std::size_t i = 0; i < places.size(); ++i) places[i] = places[i] + own * way[i];
      }
    }
    return most * std::min(done, 1.0);
  }

  const Pattern& pattern_;
  PairPoints points_;
  double margin_;
};

}  // namespace

std::unique_ptr<Interaction> make_pair_term(const LocalMesh& mesh, SideCurves secondary, SideCurves primary,
                                            const Pattern& pattern, std::shared_ptr<const GapLaw> law,
                                            const PairOptions& options) {
  return std::make_unique<PairTerm>(mesh, std::move(secondary), std::move(primary), pattern, std::move(law), options);
}

}  // namespace ixos
