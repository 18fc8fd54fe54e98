#include "term/pair_points.hpp"

#include <algorithm>
#include <cmath>

#include "base/vector3.hpp"
#include "fem/quadrature.hpp"

namespace ixos {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

template <std::size_t D>
bool any_owned(const SurfacePatch<D>& patch, const SurfacePatches<D>& surface, int owned_nodes) {
  for (std::size_t a = 0; a < patch.count; ++a)
    if (surface.nodes[static_cast<std::size_t>(patch.nodes[a])] < owned_nodes) return true;
  return false;
}

template <std::size_t D>
typename SurfacePatch<D>::Points points_of(const SurfacePatch<D>& patch, const std::vector<Vec<D>>& x) {
  typename SurfacePatch<D>::Points result{};
  for (std::size_t a = 0; a < patch.count; ++a) result[a] = x[static_cast<std::size_t>(patch.nodes[a])];
  return result;
}

/// Returns the factor at a place X with the parameters xi of a patch, whose corners' nodal factors count linearly.
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
    return factor.of_node[static_cast<std::size_t>(nodes[static_cast<std::size_t>(patch.nodes[corner])])];
  };
  if constexpr (D == 2)
    return value * ((1 - xi[0]) * at(0) + xi[0] * at(1));
  else
    return value *
           ((1 - xi[1]) * ((1 - xi[0]) * at(0) + xi[0] * at(1)) + xi[1] * ((1 - xi[0]) * at(3) + xi[0] * at(2)));
}

/// Returns length or area for a change of the parameters.
double stretch(const PlacedPatch<2>::Frame& frame) { return length(frame.tangents[0]); }
double stretch(const PlacedPatch<3>::Frame& frame) { return length(cross(frame.tangents[0], frame.tangents[1])); }

}  // namespace

template <std::size_t D>
PairPoints<D>::PairPoints(const LocalMesh& mesh, PairSurfaces<D> surfaces, std::shared_ptr<const GapLaw> law,
                          const PairOptions& options)
    : coordinates_(mesh.coordinates),
      secondary_(std::move(surfaces.secondary)),
      primary_(std::move(surfaces.primary)),
      law_(std::move(law)),
      range_(law_->range()) {
  const std::size_t n = static_cast<std::size_t>(options.points > 0 ? options.points : 5);
  per_patch_ = D == 2 ? n : n * n;
  const Quadrature gauss = gauss_legendre_unit(static_cast<int>(n));
  const std::vector<double> rest(coordinates_.size(), 0.0);
  const std::vector<Vec<D>> x = places(rest.data()).secondary;
  const bool self = options.exclusion > 0;
  if (self) {
    sight_ = std::make_unique<SelfSight<D>>(secondary_.patches, x, options.exclusion, range_);
    sight_->look(x, range_);
  }
  const bool has_primary =
      std::any_of(primary_.nodes.begin(), primary_.nodes.end(), [&](int node) { return node < mesh.owned_nodes; });
  for (const SurfacePatch<D>& patch : secondary_.patches) {
    const PlacedPatch<D> own = patch.placed(points_of(patch, x));
    for (std::size_t q = 0; q < per_patch_; ++q) {
      PatchParameters<D> xi{gauss.points[q % n]};
      double weight = gauss.weights[q % n];
      if constexpr (D == 3) {
        xi[1] = gauss.points[q / n];
        weight *= gauss.weights[q / n];
      }
      const auto frame = own.frame(xi);
      const double area = weight * stretch(frame);
      const double factor = factor_at(options.factor, frame.place, xi, patch, secondary_.nodes) / (self ? 2 : 1);
      points_.push_back({patch.weights(xi), factor * area, area});
    }
    adds_to_own_.push_back(has_primary || any_owned(patch, secondary_, mesh.owned_nodes) ? 1 : 0);
  }
}

template <std::size_t D>
bool PairPoints<D>::Places::is_finite() const {
  double sum = 0;
  for (const auto* x : {&secondary, &primary})
    for (const Vec<D>& place : *x)
      for (const double component : place) sum += 0 * component;
  return sum == 0;
}

template <std::size_t D>
typename PairPoints<D>::Places PairPoints<D>::combine(
    double rest, const std::array<std::pair<double, const double*>, 3>& parts) const {
  Places result;
  for (const bool first : {true, false}) {
    std::vector<Vec<D>>& x = first ? result.secondary : result.primary;
    const std::vector<int>& nodes = (first ? secondary_ : primary_).nodes;
    x.reserve(nodes.size());
    for (const int node : nodes) {
      Vec<D> place{};
      for (std::size_t i = 0; i < D; ++i) {
        const std::size_t dof = D * static_cast<std::size_t>(node) + i;
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

template <std::size_t D>
typename PairPoints<D>::Places PairPoints<D>::places(const double* u) const {
  return combine(1, {{{1, u}, {0, nullptr}, {0, nullptr}}});
}

template <std::size_t D>
typename PairPoints<D>::Places PairPoints<D>::places(const Segment& segment, const RulePoint& point) const {
  return combine(1, {{{point.to, segment.to}, {point.from, segment.from}, {point.velocity, segment.velocity}}});
}

template <std::size_t D>
typename PairPoints<D>::Places PairPoints<D>::ways(const double* direction) const {
  return combine(0, {{{1, direction}, {0, nullptr}, {0, nullptr}}});
}

template <std::size_t D>
PlacedPatch<D> PairPoints<D>::placed(std::size_t patch, const Places& places) const {
  const SurfacePatch<D>& own = secondary_.patches[patch];
  return own.placed(points_of(own, places.secondary));
}

template <std::size_t D>
typename PairPoints<D>::Contacts PairPoints<D>::contacts(Places places, Share share, double range) const {
  if (range < 0) range = range_;
  Contacts result;
  result.places = std::move(places);
  if (result.places.is_finite())
    result.primary = std::make_unique<PlacedSurface<D>>(primary_.patches, result.places.primary);
  int guess = -1;
  for (std::size_t s = 0; s < secondary_.patches.size(); ++s) {
    if (share == Share::Energies ? !counts(s) : adds_to_own_[s] == 0) continue;
    const SurfacePatch<D>& patch = secondary_.patches[s];
    const typename SurfacePatch<D>::Points x = points_of(patch, result.places.secondary);
    const bool far = result.primary && std::isfinite(range) &&
                     (sight_ ? sight_->seen(s).empty() : result.primary->near(patch.placed(x).hull(), range).empty());
    for (std::size_t q = 0; q < per_patch_; ++q) {
      Contact contact{s, q};
      const auto& weights = points_[s * per_patch_ + q].weights;
      for (std::size_t a = 0; a < patch.count; ++a) contact.place = contact.place + weights[a] * x[a];
      if (!result.primary) {
        contact.foot.patch = 0;
        contact.foot.gap = nan;
        contact.foot.normal.fill(nan);
      } else if (!far) {
        contact.foot = nearest(*result.primary, s, contact.place, range, guess);
        guess = contact.foot.patch;
      }
      result.all.push_back(contact);
    }
  }
  evaluate_law(result);
  return result;
}

template <std::size_t D>
void PairPoints<D>::evaluate_law(Contacts& contacts) const {
  constexpr auto width = static_cast<std::size_t>(pack_width);
  std::vector<Contact*> acting;
  for (Contact& contact : contacts.all)
    if (contact.foot.patch >= 0) acting.push_back(&contact);
  for (std::size_t first = 0; first < acting.size(); first += width) {
    const std::size_t lanes = std::min(width, acting.size() - first);
    Pack gap(law_->equilibrium_gap());
    for (std::size_t lane = 0; lane < lanes; ++lane) gap[lane] = acting[first + lane]->foot.gap;
    const Pack traction = law_->traction(gap), stiffness = law_->stiffness(gap);
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      Contact& contact = *acting[first + lane];
      contact.traction = traction[lane];
      contact.stiffness = stiffness[lane];
      contacts.least_gap = std::min(contacts.least_gap, contact.foot.gap);
    }
  }
}

template <std::size_t D>
PairGap<D> PairPoints<D>::gap_of(const Contacts& contacts, const Contact& contact) const {
  const SurfacePatch<D>& patch = primary_.patches[static_cast<std::size_t>(contact.foot.patch)];
  const std::size_t count = secondary_.patches[contact.patch].count;
  if (contacts.primary)
    return {weights(contact), count, patch, contacts.primary->patch(contact.foot.patch), contact.foot};
  PlacedPatch<D> none;
  none.degree = patch.degree;
  for (Vec<D>& coefficient : none.coefficients) coefficient.fill(nan);
  return {weights(contact), count, patch, none, contact.foot};
}

template <std::size_t D>
std::vector<int> PairPoints<D>::nodes_of(std::size_t secondary, int primary) const {
  std::vector<int> result;
  const auto append = [&](const SurfacePatches<D>& surface, const SurfacePatch<D>& patch) {
    for (std::size_t a = 0; a < patch.count; ++a)
      result.push_back(surface.nodes[static_cast<std::size_t>(patch.nodes[a])]);
  };
  append(secondary_, secondary_.patches[secondary]);
  append(primary_, primary_.patches[static_cast<std::size_t>(primary)]);
  return result;
}

/// The convex kind leaves out what is negative, and the gap's second derivatives inside sides, which are indefinite.
template <std::size_t D>
void PairPoints<D>::add(const Contacts& contacts, const Contact& contact, double factor, Tangent kind,
                        std::vector<PairBlock>& blocks, std::size_t& used) const {
  if (contact.foot.patch < 0) return;
  double along = contact.stiffness, across = -contact.traction;
  const PairGap<D> gap = gap_of(contacts, contact);
  if (kind == Tangent::Convex) {
    along = std::max(along, 0.0);
    across = gap.is_round() && across * contact.foot.gap > 0 ? across : 0;
  }
  std::size_t b = 0;
  while (b < used && blocks[b].primary != contact.foot.patch) ++b;
  if (b == used) {
    if (used == blocks.size()) blocks.emplace_back();
    blocks[b].primary = contact.foot.patch;
    blocks[b].nodes = nodes_of(contact);
    blocks[b].k.assign(D * D * gap.nodes() * gap.nodes(), 0.0);
    ++used;
  }
  gap.add(factor * measure(contact) * along, factor * measure(contact) * across, blocks[b].k.data());
}

template class PairPoints<2>;
template class PairPoints<3>;

}  // namespace ixos
