#include "term/pair_points.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "fem/quadrature.hpp"
#include "interaction/placed_curves.hpp"

namespace ixos {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

bool any_owned(const CurveSegment& segment, const SideCurves& curves, int owned_nodes) {
  for (std::size_t a = 0; a < segment.count; ++a)
    if (curves.nodes[static_cast<std::size_t>(segment.nodes[a])] < owned_nodes) return true;
  return false;
}

double factor_at(const SurfaceFactor& factor, const Planar& x, double t, int first, int second) {
  double value = 1;
  if (factor.of_place) value *= factor.of_place({x[0], x[1], 0});
  if (!factor.of_node.empty())
    value *= (1 - t) * factor.of_node[static_cast<std::size_t>(first)] +
             t * factor.of_node[static_cast<std::size_t>(second)];
  return value;
}

CurveSegment::Points points_of(const CurveSegment& segment, const std::vector<Planar>& x) {
  CurveSegment::Points result{};
  for (std::size_t a = 0; a < segment.count; ++a) result[a] = x[static_cast<std::size_t>(segment.nodes[a])];
  return result;
}

}  // namespace

PairPoints::PairPoints(const LocalMesh& mesh, SideCurves secondary, SideCurves primary,
                       std::shared_ptr<const GapLaw> law, const PairOptions& options)
    : coordinates_(mesh.coordinates),
      secondary_(std::move(secondary)),
      primary_(std::move(primary)),
      law_(std::move(law)),
      range_(law_->range()),
      per_segment_(static_cast<std::size_t>(options.points > 0 ? options.points : 5)) {
  const Quadrature gauss = gauss_legendre_unit(static_cast<int>(per_segment_));
  const std::vector<double> rest(coordinates_.size(), 0.0);
  const std::vector<Planar> x = secondary_.places(mesh, rest.data());
  const bool has_primary =
      std::any_of(primary_.nodes.begin(), primary_.nodes.end(), [&](int node) { return node < mesh.owned_nodes; });
  for (const CurveSegment& segment : secondary_.segments) {
    const CurveSegment::Points own = points_of(segment, x);
    const auto node = [&](std::size_t a) { return secondary_.nodes[static_cast<std::size_t>(segment.nodes[a])]; };
    for (std::size_t q = 0; q < per_segment_; ++q) {
      const double t = gauss.points[q];
      const double area = gauss.weights[q] * length(segment.sum(segment.slopes(t), own));
      const CurveSegment::Weights weights = segment.weights(t);
      const double factor = factor_at(options.factor, segment.sum(weights, own), t, node(0), node(1));
      points_.push_back({weights, factor * area, area});
    }
    adds_to_own_.push_back(has_primary || any_owned(segment, secondary_, mesh.owned_nodes) ? 1 : 0);
  }
}

bool PairPoints::Places::is_finite() const {
  double sum = 0;
  for (const auto* x : {&secondary, &primary})
    for (const Planar& place : *x) sum += 0 * (place[0] + place[1]);
  return sum == 0;
}

PairPoints::Places PairPoints::combine(double rest,
                                       const std::array<std::pair<double, const double*>, 3>& parts) const {
  Places result;
  for (const bool first : {true, false}) {
    std::vector<Planar>& x = first ? result.secondary : result.primary;
    const std::vector<int>& nodes = (first ? secondary_ : primary_).nodes;
    x.reserve(nodes.size());
    for (const int node : nodes) {
      Planar place{};
      for (std::size_t i = 0; i < 2; ++i) {
        const std::size_t dof = 2 * static_cast<std::size_t>(node) + i;
        double moved = 0;
        for (const auto& [share, values] : parts)
          if (values != nullptr && share != 0) moved += share * values[dof];
        place[i] = rest * coordinates_[dof] + moved;
      }
      x.push_back(place);
    }
  }
  return result;
}

PairPoints::Places PairPoints::places(const double* u) const {
  return combine(1, {{{1, u}, {0, nullptr}, {0, nullptr}}});
}

PairPoints::Places PairPoints::places(const Segment& segment, const RulePoint& point) const {
  return combine(1, {{{point.to, segment.to}, {point.from, segment.from}, {point.velocity, segment.velocity}}});
}

PairPoints::Places PairPoints::ways(const double* direction) const {
  return combine(0, {{{1, direction}, {0, nullptr}, {0, nullptr}}});
}

PairPoints::Contacts PairPoints::contacts(Places places, Share share) const {
  Contacts result;
  result.places = std::move(places);
  const bool finite = result.places.is_finite();
  std::unique_ptr<PlacedCurves> curves;
  if (finite) curves = std::make_unique<PlacedCurves>(primary_.segments, result.places.primary);
  for (std::size_t s = 0; s < secondary_.segments.size(); ++s) {
    if (share == Share::Energies ? !counts(s) : adds_to_own_[s] == 0) continue;
    const CurveSegment& segment = secondary_.segments[s];
    const CurveSegment::Points x = points_of(segment, result.places.secondary);
    for (std::size_t q = 0; q < per_segment_; ++q) {
      Contact contact{s, q, segment.sum(points_[s * per_segment_ + q].weights, x), {}};
      if (finite)
        contact.foot = curves->nearest(contact.place, range_);
      else
        contact.foot = {0, nan, -1, nan, {nan, nan}};
      result.all.push_back(contact);
    }
  }
  evaluate_law(result);
  return result;
}

void PairPoints::evaluate_law(Contacts& contacts) const {
  constexpr auto width = static_cast<std::size_t>(pack_width);
  std::vector<Contact>& all = contacts.all;
  for (std::size_t first = 0; first < all.size(); first += width) {
    const std::size_t lanes = std::min(width, all.size() - first);
    Pack gap(law_->equilibrium_gap());
    for (std::size_t lane = 0; lane < lanes; ++lane)
      if (all[first + lane].foot.segment >= 0) gap[lane] = all[first + lane].foot.gap;
    const Pack traction = law_->traction(gap), stiffness = law_->stiffness(gap);
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      Contact& contact = all[first + lane];
      if (contact.foot.segment < 0) continue;
      contact.traction = traction[lane];
      contact.stiffness = stiffness[lane];
      contacts.least_gap = std::min(contacts.least_gap, contact.foot.gap);
    }
  }
}

PairGap PairPoints::gap_of(const Contacts& contacts, const Contact& contact) const {
  const CurveSegment& foot = primary_.segments[static_cast<std::size_t>(contact.foot.segment)];
  return {weights(contact), secondary_.segments[contact.segment].count, foot, points_of(foot, contacts.places.primary),
          contact.foot};
}

std::array<int, PairGap::most> PairPoints::nodes_of(const Contact& contact) const {
  std::array<int, PairGap::most> result{};
  std::size_t n = 0;
  const auto append = [&](const SideCurves& curves, const CurveSegment& segment) {
    for (std::size_t a = 0; a < segment.count; ++a)
      result[n++] = curves.nodes[static_cast<std::size_t>(segment.nodes[a])];
  };
  append(secondary_, secondary_.segments[contact.segment]);
  append(primary_, primary_.segments[static_cast<std::size_t>(contact.foot.segment)]);
  return result;
}

/// The convex kind leaves out what is negative, and the gap's second derivatives inside sides, which are indefinite.
void PairPoints::add(const Contacts& contacts, const Contact& contact, double factor, Tangent kind,
                     std::vector<Block>& blocks) const {
  if (contact.foot.segment < 0) return;
  const PairGap gap = gap_of(contacts, contact);
  auto block =
      std::find_if(blocks.begin(), blocks.end(), [&](const Block& own) { return own.primary == contact.foot.segment; });
  if (block == blocks.end()) {
    blocks.push_back({contact.foot.segment, gap.nodes(), nodes_of(contact)});
    block = blocks.end() - 1;
  }
  double along = contact.stiffness, across = -contact.traction;
  if (kind == Tangent::Convex) {
    along = std::max(along, 0.0);
    across = gap.is_round() && across * contact.foot.gap > 0 ? across : 0;
  }
  gap.add(factor * measure(contact) * along, factor * measure(contact) * across, block->k);
}

}  // namespace ixos
