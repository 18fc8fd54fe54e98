#include "term/pair/pair_slip.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/vector3.hpp"
#include "term/slip_history.hpp"

namespace ixos {
namespace {

constexpr auto width = static_cast<std::size_t>(pack_width);

/// Returns the gap beyond which the threshold vanishes, to rounding.
double reach(const Friction& friction, double cutoff, double range) {
  const bool fades = friction.type == FrictionType::ConstantStress && friction.sharpness > 0;
  return std::min(range, fades ? cutoff + 40 / friction.sharpness : cutoff);
}

/// Orthonormal vectors at two places of a patch, which its rotation maps onto each other.
template <std::size_t D>
using Triads = std::array<Small<double, D>, 2>;

Small<double, 2> triad(const PlacedPatch<2>::Frame& frame) {
  return {1 / length(frame.tangents[0]) * frame.tangents[0], PlacedPatch<2>::normal(frame)};
}
Triads<2> triads(const PlacedPatch<2>::Frame& from, const PlacedPatch<2>::Frame& to) {
  return {triad(from), triad(to)};
}
/// The rotation is the polar factor of the linear map of the tangents and the normal.
Triads<3> triads(const PlacedPatch<3>::Frame& from, const PlacedPatch<3>::Frame& to) {
  const Vec<3>&x = from.tangents[0], &y = from.tangents[1];
  const Vec<3> along = 1 / length(x) * x, normal = PlacedPatch<3>::normal(from), across = cross(normal, along);
  // The map takes `along` to a and `across` to b.
  const Vec<3> a = 1 / length(x) * to.tangents[0], b = 1 / inner(y, across) * (to.tangents[1] - inner(y, along) * a);
  const Vec<3> end_normal = PlacedPatch<3>::normal(to), sum = a - cross(end_normal, b);
  const Vec<3> end_along = 1 / length(sum) * sum;
  const Small<double, 3> start{along, across, normal}, end{end_along, cross(end_normal, end_along), end_normal};
  return {start, end};
}

template <std::size_t D>
Vec<D> turned(const Vec<D>& vector, const Small<double, D>& from, const Small<double, D>& to) {
  Vec<D> result{};
  for (std::size_t k = 0; k < D; ++k) result = result + inner(vector, from[k]) * to[k];
  return result;
}

/// Returns whether two patches have a node in common.
bool meet(const SurfacePatch<3>& a, const SurfacePatch<3>& b) {
  const auto end = b.nodes.begin() + static_cast<std::ptrdiff_t>(b.count);
  return std::any_of(a.nodes.begin(), a.nodes.begin() + static_cast<std::ptrdiff_t>(a.count),
                     [&](int node) { return std::find(b.nodes.begin(), end, node) != end; });
}

}  // namespace

template <std::size_t D>
PairSlip<D>::PairSlip(const LocalMesh& mesh, PairSurfaces<D> surfaces, std::shared_ptr<const GapLaw> law,
                      const FrictionLaw& friction, const PairOptions& options)
    : friction_(friction),
      range_(reach(friction.friction(), friction.cutoff(), law->range())),
      points_(mesh, std::move(surfaces), std::move(law), options),
      nothing_(mesh, points_.secondary().sides_of_patches(), points_.points_of_a_patch(), D + 3) {}

template <std::size_t D>
TermHistory PairSlip<D>::history() const {
  return slip_history(D, nothing_, points_.places_along_sides());
}

template <std::size_t D>
double PairSlip<D>::kept(const TermHistory& history, std::size_t patch, std::size_t point, std::size_t number) {
  return history.points.front().values(patch / width, point, number)[patch % width];
}
template <std::size_t D>
void PairSlip<D>::keep(TermHistory& history, std::size_t patch, std::size_t point, std::size_t number, double value) {
  history.points.front().values(patch / width, point, number)[patch % width] = value;
}
template <std::size_t D>
Vec<D> PairSlip<D>::kept_traction(const TermHistory& history, const typename PairPoints<D>::Contact& contact) {
  Vec<D> t;
  for (std::size_t i = 0; i < D; ++i) t[i] = kept(history, contact.patch, contact.point, i);
  return t;
}

template <std::size_t D>
std::shared_ptr<const typename PairPoints<D>::Times> PairSlip<D>::contacts(const double* u) const {
  return points_.contacts(u, PairPoints<D>::Share::All, range_);
}

template <std::size_t D>
SurfaceProjection<D> PairSlip<D>::projection_of(const typename PairPoints<D>::Contacts& at,
                                                const typename PairPoints<D>::Contact& contact) const {
  const SurfaceProjection<D>& projection = contact.projection;
  if constexpr (D == 3) {
    if (!projection.fixed[0] && !projection.fixed[1]) return projection;
    const auto& patches = points_.primary().patches;
    const double farthest = std::abs(projection.gap) + 1e-10 * length(projection.frame.tangents[0]);
    for (const int other : at.candidates(contact)) {
      if (other >= projection.patch) break;
      if (!meet(patches[static_cast<std::size_t>(other)], patches[static_cast<std::size_t>(projection.patch)]))
        continue;
      ProjectionGuess<D> guess;
      guess.patch = other;
      const SurfaceProjection<D> own =
          at.primary->nearest_on(guess, contact.place, std::numeric_limits<double>::infinity());
      if (std::abs(own.gap) <= farthest) return own;
    }
  }
  return projection;
}

template <std::size_t D>
void PairSlip<D>::set(const typename PairPoints<D>::Contacts& at, const typename PairPoints<D>::Contact& contact,
                      const TermHistory& history, Point& point) const {
  point.contact = contact;
  point.contact.projection = projection_of(at, contact);
  const SurfaceProjection<D>& projection = point.contact.projection;
  const auto nodes = points_.nodes_of(point.contact);
  point.nodes.assign(nodes.begin(), nodes.end());
  point.map.set(points_.weights(contact), points_.secondary().patches[contact.patch].count, contact.place,
                points_.primary().patches[static_cast<std::size_t>(projection.patch)], projection);
  point.traction = kept_traction(history, contact);
  point.threshold = friction_.threshold_at(contact.projection.gap);
}

template <std::size_t D>
const typename PairSlip<D>::Points& PairSlip<D>::near(const double* u, const TermHistory& history) const {
  const auto times = contacts(u);
  std::size_t used = 0;
  for (const auto& contact : times->front().all) {
    if (contact.projection.patch < 0 || !(contact.projection.gap < range_))
      continue;  // a gap that is no number has no friction
    const Vec<D> kept = kept_traction(history, contact);
    if (friction_.threshold_at(contact.projection.gap) > 0 || inner(kept, kept) > 0) {
      if (used == near_.size()) near_.emplace_back();
      set(times->front(), contact, history, near_[used++]);
    }
  }
  near_.resize(used);
  return near_;
}

template <std::size_t D>
void PairSlip<D>::begin(const double* u, double length, const TermHistory& history, Memory& step) const {
  near(u, history);
  step.acting.swap(near_);
  for (Point& point : step.acting) point.start = motion(point, u);
  set_length(length, step);
}

/// The traction goes along with the primary surface, then with the tangent plane from the first closest point to the
/// last one.
template <std::size_t D>
double PairSlip<D>::accept(const double* u, double length, const Memory& step, TermHistory& history) const {
  const auto times = contacts(u);
  const auto& end = times->front();
  double sum = 0, work = 0, lag = 0;
  for (const Point& point : step.acting) {
    const auto& contact = point.contact;
    const auto* const now = end.find(contact.patch, contact.point);
    const bool has_projection = now != nullptr && now->projection.patch >= 0;
    const double threshold = has_projection ? friction_.threshold_at(now->projection.gap) : 0.0;
    const auto left = this->step(point, creep_length(length)).end(slip(point, u), threshold);
    const SurfacePatch<D>& patch = points_.primary().patches[static_cast<std::size_t>(contact.projection.patch)];
    const auto [from, to] =
        triads(contact.projection.frame, patch.placed(patch.among(end.places.primary)).frame(contact.projection.xi));
    const Vec<D> normal = turned<D>(contact.projection.normal, from, to);
    const Vec<D> traction =
        carried(turned<D>(left.traction, from, to), normal, has_projection ? now->projection.normal : normal);
    for (std::size_t i = 0; i < D; ++i) keep(history, contact.patch, contact.point, i, traction[i]);
    const auto add = [&](SurfaceNumber which, double value) {
      keep(history, contact.patch, contact.point, place_of(which),
           number(history, contact.patch, contact.point, which) + value);
    };
    add(SurfaceNumber::Slip, left.slip);
    add(SurfaceNumber::Dissipated, left.work);
    keep(history, contact.patch, contact.point, place_of(SurfaceNumber::Sliding), left.slid);
    if (!points_.counts(contact.patch)) continue;
    sum += points_.measure(contact) * left.work;
    work += points_.measure(contact) * left.slip * point.threshold;
    lag += points_.measure(contact) * left.slip * (threshold - point.threshold);
  }
  history.last_step = {work, lag};
  return sum;
}

template <std::size_t D>
void PairSlip<D>::report(const double* u, const TermHistory& history, FrictionReport& report) const {
  report.work += history.last_step[0];
  report.lag += history.last_step[1];
  const auto times = contacts(u);
  for (std::size_t s = 0; s < points_.secondary().patches.size(); ++s) {
    if (!points_.counts(s)) continue;
    for (std::size_t q = 0; q < points_.points_of_a_patch(); ++q) {
      const typename PairPoints<D>::Contact contact{s, q, 0};
      if (points_.measure(contact) > 0)
        report.sliding += points_.area(contact) * number(history, s, q, SurfaceNumber::Sliding);
    }
  }
  for (const auto& contact : times->front().all) {
    if (!points_.counts(contact.patch) || contact.projection.patch < 0 || !(points_.measure(contact) > 0)) continue;
    if (!(contact.projection.gap < friction_.cutoff() && friction_.threshold_at(contact.projection.gap) > 0)) continue;
    const double area = points_.area(contact);
    report.acting += area;
    report.sticking += area * (1 - number(history, contact.patch, contact.point, SurfaceNumber::Sliding));
    report.slip += area * number(history, contact.patch, contact.point, SurfaceNumber::Slip);
  }
}

template class PairSlip<2>;
template class PairSlip<3>;

}  // namespace ixos
