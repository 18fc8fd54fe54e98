#include "term/pair/pair_points.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "base/vector3.hpp"
#include "fem/revolved.hpp"
#include "geometry/patch_points.hpp"

namespace ixos {
namespace {

/// Returns the factor at a place X with the parameters xi of a patch, whose corners' nodal factors count linearly. At a
/// corner that is no node it is their mean, as it is in the side.
template <std::size_t D>
double factor_at(const SurfaceFactor& factor, const Vec<D>& x, const PatchParameters<D>& xi,
                 const SurfacePatch<D>& patch, const std::vector<int>& nodes) {
  double value = 1;
  if (factor.of_place) {
    std::array<double, 3> place{};
    std::copy(x.begin(), x.end(), place.begin());
    value *= factor.of_place(place);
  }
  if (factor.of_node.empty()) return value;
  const auto at = [&](std::size_t corner) {
    const auto at_corner = patch.corner(corner);
    double sum = 0;
    for (const int node : at_corner)
      sum += factor.of_node[static_cast<std::size_t>(nodes[static_cast<std::size_t>(node)])];
    return sum / static_cast<double>(at_corner.size());
  };
  if constexpr (D == 2)
    return value * ((1 - xi[0]) * at(0) + xi[0] * at(1));
  else
    return value *
           ((1 - xi[1]) * ((1 - xi[0]) * at(0) + xi[0] * at(1)) + xi[1] * ((1 - xi[0]) * at(3) + xi[0] * at(2)));
}

/// Returns the overlaps on which the law acts beyond its range, at the points of all patches.
template <std::size_t D>
PairOverlap<D> overlap_of(const GapLaw& law, const PairOptions& options, int along) {
  PairOverlap<D> result;
  if (law.domain() == GapDomain::Positive) return result;
  result.depth = options.depth;
  for (const PatchPoint<D>& point : patch_points<D>(along)) result.points.push_back(point.xi);
  return result;
}

/// Returns length or area for a change of the parameters.
double stretch(const PlacedPatch<2>::Frame& frame) { return length(frame.tangents[0]); }
double stretch(const PlacedPatch<3>::Frame& frame) { return length(cross(frame.tangents[0], frame.tangents[1])); }

}  // namespace

template <std::size_t D>
PairPoints<D>::PairPoints(const LocalMesh& mesh, PairSurfaces<D> surfaces, std::shared_ptr<const GapLaw> law,
                          const PairOptions& options)
    : coordinates_(mesh.coordinates),
      surfaces_(std::move(surfaces)),
      law_(std::move(law)),
      range_(law_->range()),
      share_(options.share),
      reacts_(options.reacts),
      overlap_(overlap_of<D>(*law_, options, surfaces_.secondary.points_along(options.points))),
      owns_secondary_(patches_with_own_nodes(surfaces_.secondary, mesh)),
      owns_primary_(patches_with_own_nodes(surfaces_.primary, mesh)),
      search_(surfaces_, law_->equilibrium_gap(), overlap_) {
  along_ = secondary().points_along(options.points);
  const std::vector<PatchPoint<D>> on_a_patch = patch_points<D>(along_);
  per_patch_ = on_a_patch.size();
  const std::vector<double> rest(coordinates_.size(), 0.0);
  const std::vector<Vec<D>> x = places(rest.data()).secondary;
  const bool self = options.exclusion > 0;
  if (self) {
    visibility_ = std::make_unique<SelfVisibility<D>>(secondary().patches, x, options.exclusion, range_);
    visibility_->see(visibility_->find(x, range_));
  }
  for (const SurfacePatch<D>& patch : secondary().patches) {
    const PlacedPatch<D> own = patch.placed(patch.among(x));
    for (const PatchPoint<D>& point : on_a_patch) {
      const PatchParameters<D>& xi = point.xi;
      const auto frame = own.frame(xi);
      double area = point.weight * stretch(frame);
      if (mesh.axisymmetric) area *= circumference(frame.place[0]);
      const double factor =
          factor_at(options.factor, frame.place, xi, patch, secondary().nodes) * share_ / (self ? 2 : 1);
      points_.push_back({patch.weights(xi), factor * area, area});
    }
  }
}

template <std::size_t D>
std::vector<std::array<double, 3>> PairPoints<D>::places_along_sides() const {
  std::vector<std::array<double, 3>> places;
  for (const PatchPoint<D>& point : patch_points<D>(along_)) {
    places.emplace_back();
    for (std::size_t i = 0; i + 1 < D; ++i) places.back()[i] = 2 * point.xi[i] - 1;
  }
  return places;
}

template <std::size_t D>
void PairPoints<D>::combine(double rest, const NodeParts& parts, Places& at) const {
  combine_places<D>(secondary().nodes, coordinates_, rest, parts, at.secondary);
  combine_places<D>(primary().nodes, coordinates_, rest, parts, at.primary);
}

template <std::size_t D>
typename PairPoints<D>::Places PairPoints<D>::places(const double* u) const {
  Places result;
  place(u, result);
  return result;
}

template <std::size_t D>
void PairPoints<D>::place(const double* u, Places& at) const {
  combine(1, {{{1, u}, {0, nullptr}, {0, nullptr}}}, at);
}

template <std::size_t D>
void PairPoints<D>::place(const Segment& segment, const RulePoint& point, Places& at) const {
  combine(1, {{{point.to, segment.to}, {point.from, segment.from}, {point.velocity, segment.velocity}}}, at);
}

template <std::size_t D>
void PairPoints<D>::place_ways(const double* direction, Places& ways) const {
  combine(0, {{{1, direction}, {0, nullptr}, {0, nullptr}}}, ways);
}

template <std::size_t D>
const std::vector<typename PairPoints<D>::Places>& PairPoints<D>::places(const Segment& segment,
                                                                         const Rule& rule) const {
  std::vector<Places>& result = memory_.at_rule;
  const std::size_t count = rule.points.size();
  const bool with_end = is_positive() && !rule.has_end();
  result.resize(count + (with_end ? 1 : 0));
  for (std::size_t k = 0; k < count; ++k) place(segment, rule.points[k], result[k]);
  if (with_end) place(segment.to, result.back());
  return result;
}

template <std::size_t D>
std::shared_ptr<const PairNeighbours> PairPoints<D>::neighbours(const std::vector<const Places*>& times,
                                                                double range) const {
  if (!visibility_ || !std::all_of(times.begin(), times.end(), [](const Places* x) { return x->is_finite(); }))
    return search_.cover(times, range);
  if (seen_version_ == visibility_->version()) return seen_;
  auto seen = std::make_shared<PairNeighbours>();
  for (std::size_t s = 0; s < secondary().patches.size(); ++s) {
    if (visibility_->seen(s).empty()) continue;
    seen->secondary.push_back(s);
    seen->primary.push_back(visibility_->seen(s));
  }
  if (overlap_.depth > 0) seen->deep.assign(seen->secondary.size(), 1);
  std::vector<int> all(primary().patches.size());
  std::iota(all.begin(), all.end(), 0);
  seen->together = patch_subset(std::move(all), primary().patches.size());
  seen_ = std::move(seen);
  seen_version_ = visibility_->version();
  return seen_;
}

/// Returns contacts that nobody holds.
template <std::size_t D>
std::shared_ptr<typename PairPoints<D>::Times> PairPoints<D>::unused(std::size_t count) const {
  for (const std::shared_ptr<Times>& times : memory_.times)
    if (times.use_count() == 1 && times->size() == count) return times;
  memory_.times.push_back(std::make_shared<Times>(count));
  return memory_.times.back();
}

template <std::size_t D>
std::shared_ptr<const typename PairPoints<D>::Times> PairPoints<D>::contacts(const double* u, Share share,
                                                                             double range) const {
  memory_.single.resize(1);
  place(u, memory_.single.front());
  return contacts(memory_.single, share, range);
}

template <std::size_t D>
std::shared_ptr<const typename PairPoints<D>::Times> PairPoints<D>::contacts(const std::vector<Places>& times,
                                                                             Share share, double range,
                                                                             const std::vector<Places>& also) const {
  if (range < 0) range = range_;
  std::vector<const Places*>& covered = memory_.covered;
  covered.clear();
  for (const std::vector<Places>* all : {&times, &also})
    for (const Places& places : *all) covered.push_back(&places);
  const std::shared_ptr<const PairNeighbours> near = neighbours(covered, range);
  const bool keeps = share != Share::Energies;
  const bool alike = keeps && last_ && last_share_ == share && last_range_ == range && last_->size() == times.size();
  if (alike && std::equal(times.begin(), times.end(), last_->begin(), [&](const Places& x, const Contacts& kept) {
        return kept.neighbours == near && kept.places.secondary == x.secondary && kept.places.primary == x.primary;
      }))
    return last_;
  const std::shared_ptr<Times> result = unused(times.size());
  for (std::size_t k = 0; k < times.size(); ++k) {
    Contacts& contacts = (*result)[k];
    contacts.places = times[k];
    contacts.neighbours = near;
    place_primary(contacts);
  }
  find_earlier_projections<D>(*result, alike && remembers_ ? last_.get() : nullptr, search_, law_->equilibrium_gap(),
                              memory_.earlier);
  std::vector<char>& looks = memory_.looks;
  looks.assign(near->secondary.size(), 1);
  if (share == Share::Forces)
    find_acting(*result, range, looks);
  else if (share == Share::Energies)
    std::transform(near->secondary.begin(), near->secondary.end(), looks.begin(),
                   [&](std::size_t s) { return counts(s) ? 1 : 0; });
  for (std::size_t k = 0; k < result->size(); ++k) {
    find_projections((*result)[k], memory_.earlier[k], looks, range);
    evaluate_law((*result)[k]);
  }
  if (keeps) {
    last_ = result;
    last_share_ = share;
    last_range_ = range;
  }
  return result;
}

template <std::size_t D>
void PairPoints<D>::evaluate_law(Contacts& contacts) const {
  constexpr auto width = static_cast<std::size_t>(pack_width);
  std::array<Contact*, width> acting;
  std::size_t lanes = 0;
  contacts.least_gap = std::numeric_limits<double>::infinity();
  const auto evaluate = [&]() {
    Pack gap(law_->equilibrium_gap());
    for (std::size_t lane = 0; lane < lanes; ++lane) gap[lane] = acting[lane]->projection.gap;
    const Pack traction = law_->traction(gap), stiffness = law_->stiffness(gap);
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      acting[lane]->traction = traction[lane];
      acting[lane]->stiffness = stiffness[lane];
      contacts.least_gap = std::min(contacts.least_gap, acting[lane]->projection.gap);
    }
    lanes = 0;
  };
  for (Contact& contact : contacts.all) {
    if (contact.projection.patch < 0) continue;
    acting[lanes++] = &contact;
    if (lanes == width) evaluate();
  }
  if (lanes > 0) evaluate();
}

template <std::size_t D>
PairGap<D> PairPoints<D>::gap_of(const Contact& contact) const {
  return {weights(contact), secondary().patches[contact.patch].count,
          primary().patches[static_cast<std::size_t>(contact.projection.patch)], contact.projection};
}

template <std::size_t D>
typename PairPoints<D>::Nodes PairPoints<D>::nodes_of(std::size_t secondary, int primary) const {
  Nodes result;
  const auto append = [&](const SurfacePatches<D>& surface, const SurfacePatch<D>& patch) {
    for (std::size_t a = 0; a < patch.count; ++a)
      result.push_back(surface.nodes[static_cast<std::size_t>(patch.nodes[a])]);
  };
  append(surfaces_.secondary, surfaces_.secondary.patches[secondary]);
  append(surfaces_.primary, surfaces_.primary.patches[static_cast<std::size_t>(primary)]);
  return result;
}

/// The convex kind leaves out what is negative, and the gap's second derivatives inside sides, which are indefinite.
template <std::size_t D>
void PairPoints<D>::add(const Contact& contact, double factor, Tangent kind, std::vector<OpenBlock>& blocks,
                        std::size_t& used) const {
  if (contact.projection.patch < 0) return;
  double along = contact.stiffness, across = -contact.traction;
  const PairGap<D> gap = gap_of(contact);
  if (kind == Tangent::Convex) {
    along = std::max(along, 0.0);
    across = gap.is_round() && across * contact.projection.gap > 0 ? across : 0;
  }
  std::size_t b = 0;
  while (b < used && blocks[b].block.primary != contact.projection.patch) ++b;
  if (b == used) {
    if (used == blocks.size()) blocks.emplace_back();
    blocks[b].block.secondary = contact.patch;
    blocks[b].block.primary = contact.projection.patch;
    const Nodes nodes = nodes_of(contact);
    blocks[b].block.nodes.assign(nodes.begin(), nodes.end());
    blocks[b].sums.begin(secondary().patches[contact.patch].count,
                         primary().patches[static_cast<std::size_t>(contact.projection.patch)].count);
    ++used;
  }
  blocks[b].sums.add(gap, factor * measure(contact) * along, factor * measure(contact) * across);
}

template class PairPoints<2>;
template class PairPoints<3>;

}  // namespace ixos
