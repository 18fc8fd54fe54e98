#include "term/pair_slip.hpp"

#include <algorithm>
#include <boost/container/static_vector.hpp>
#include <cmath>
#include <utility>

#include "base/vector3.hpp"

namespace ixos {
namespace {

constexpr auto width = static_cast<std::size_t>(pack_width);

/// Returns the gap beyond which the threshold vanishes, to rounding.
double reach(const Friction& friction, double cutoff, double range) {
  const bool fades = friction.type == FrictionType::ConstantStress && friction.sharpness > 0;
  return std::min(range, fades ? cutoff + 40 / friction.sharpness : cutoff);
}

/// Orthonormal vectors that go along with a patch: its first tangent's direction, in space one across it, the normal.
template <std::size_t D>
Small<double, D> triad(const typename PlacedPatch<D>::Frame& frame) {
  const Vec<D> along = 1 / length(frame.tangents[0]) * frame.tangents[0], normal = PlacedPatch<D>::normal(frame);
  if constexpr (D == 2)
    return {along, normal};
  else
    return {along, cross(normal, along), normal};
}

template <std::size_t D>
Vec<D> turned(const Vec<D>& vector, const Small<double, D>& from, const Small<double, D>& to) {
  Vec<D> result{};
  for (std::size_t k = 0; k < D; ++k) result = result + inner(vector, from[k]) * to[k];
  return result;
}

/// By node of a patch.
template <std::size_t D>
using Turns = boost::container::static_vector<Small<double, D>, SurfacePatch<D>::most>;

/// Returns a turned by a right angle.
Vec<2> across(const Vec<2>& a) { return {-a[1], a[0]}; }

/// Returns, by node of a patch, the derivative of -g w x n by its displacement, with the rotation w of the patch at the
/// foot.
Turns<2> turns(const SurfacePatch<2>& patch, const SurfaceFoot<2>& foot) {
  const auto slopes = patch.shape(foot.xi).slopes;
  const Vec<2>& x = foot.frame.tangents[0];
  const Vec<2> way = -foot.gap / inner(x, x) * across(foot.normal), along = across(x);
  Turns<2> result(patch.count);
  for (std::size_t a = 0; a < patch.count; ++a)
    for (std::size_t i = 0; i < 2; ++i) result[a][i] = slopes[0][a] * way[i] * along;
  return result;
}
Turns<3> turns(const SurfacePatch<3>& patch, const SurfaceFoot<3>& foot) {
  const auto slopes = patch.shape(foot.xi).slopes;
  const Vec<3>&x = foot.frame.tangents[0], &y = foot.frame.tangents[1], &n = foot.normal;
  const double xx = inner(x, x), xy = inner(x, y), yy = inner(y, y), det = xx * yy - xy * xy;
  const Vec<3> m = PlacedPatch<3>::normal(foot.frame);
  const std::array<Vec<3>, 2> c{cross(m, 1 / det * (yy * x - xy * y)), cross(m, 1 / det * (xx * y - xy * x))};
  Turns<3> result(patch.count);
  for (std::size_t a = 0; a < patch.count; ++a) {
    const Vec<3> r = slopes[0][a] * c[0] + slopes[1][a] * c[1];
    // g n x w, w = (m . r/2) - r (m .)
    const Vec<3> by_r = foot.gap / 2 * cross(n, m), by_m = -foot.gap * cross(n, r);
    for (std::size_t i = 0; i < 3; ++i) result[a][i] = by_r[i] * r + by_m[i] * m;
  }
  return result;
}

}  // namespace

template <std::size_t D>
PairSlip<D>::PairSlip(const LocalMesh& mesh, PairSurfaces<D> surfaces, const std::vector<LocalSide>& sides,
                      std::shared_ptr<const GapLaw> law, const FrictionLaw& friction, const PairOptions& options)
    : friction_(friction),
      range_(reach(friction.friction(), friction.cutoff(), law->range())),
      points_(mesh, std::move(surfaces), std::move(law), options),
      stored_(mesh, sides, points_.points_of_a_patch(), D + 3) {}

template <std::size_t D>
void PairSlip<D>::clear() {
  stored_.clear();
  in_step_ = false;
  last_work_ = last_lag_ = 0;
}

template <std::size_t D>
void PairSlip<D>::transfer(Record& record) {
  stored_.transfer(record);
  if (!record.loading()) return;
  in_step_ = false;
  last_work_ = last_lag_ = 0;
}

template <std::size_t D>
double PairSlip<D>::stored(std::size_t patch, std::size_t point, std::size_t number) const {
  return stored_(patch / width, point, number)[patch % width];
}
template <std::size_t D>
void PairSlip<D>::store(std::size_t patch, std::size_t point, std::size_t number, double value) {
  stored_(patch / width, point, number)[patch % width] = value;
}
template <std::size_t D>
Vec<D> PairSlip<D>::stored_traction(const typename PairPoints<D>::Contact& contact) const {
  Vec<D> t;
  for (std::size_t i = 0; i < D; ++i) t[i] = stored(contact.patch, contact.point, i);
  return t;
}

template <std::size_t D>
std::shared_ptr<const typename PairPoints<D>::Times> PairSlip<D>::contacts(const double* u) const {
  return points_.contacts(u, PairPoints<D>::Share::All, range_);
}

template <std::size_t D>
void PairSlip<D>::set(const typename PairPoints<D>::Contact& contact, Point& point) const {
  const SurfacePatch<D>& patch = points_.primary().patches[static_cast<std::size_t>(contact.foot.patch)];
  const Vec<D>& n = contact.foot.normal;
  point.contact = contact;
  const auto nodes = points_.nodes_of(contact);
  point.nodes.assign(nodes.begin(), nodes.end());
  point.slips.clear();
  for (std::size_t i = 0; i < D; ++i)
    for (std::size_t j = 0; j < D; ++j) point.plane[i][j] = (i == j ? 1.0 : 0.0) - n[i] * n[j];
  const auto add = [&](double weight, Small<double, D> slip) {
    for (std::size_t i = 0; i < D; ++i) slip[i] = slip[i] + weight * point.plane[i];
    point.slips.push_back(slip);
  };
  for (std::size_t a = 0; a < points_.secondary().patches[contact.patch].count; ++a)
    add(points_.weights(contact)[a], {});
  const auto weights = patch.weights(contact.foot.xi);
  const auto turned = turns(patch, contact.foot);
  for (std::size_t a = 0; a < patch.count; ++a) add(-weights[a], turned[a]);
  point.traction = stored_traction(contact);
  point.threshold = friction_.threshold_at(contact.foot.gap);
}

template <std::size_t D>
const typename PairSlip<D>::Points& PairSlip<D>::near(const double* u) const {
  const auto times = contacts(u);
  std::size_t used = 0;
  for (const auto& contact : times->front().all) {
    if (contact.foot.patch < 0 || !(contact.foot.gap < range_)) continue;  // a gap that is no number has no friction
    const Vec<D> kept = stored_traction(contact);
    if (friction_.threshold_at(contact.foot.gap) > 0 || inner(kept, kept) > 0) {
      if (used == near_.size()) near_.emplace_back();
      set(contact, near_[used++]);
    }
  }
  near_.resize(used);
  return near_;
}

template <std::size_t D>
void PairSlip<D>::begin(const double* u, double length) {
  near(u);
  acting_.swap(near_);
  for (Point& point : acting_) point.start = relative(point, u);
  set_length(length);
  in_step_ = true;
}

template <std::size_t D>
Vec<D> PairSlip<D>::relative(const Point& point, const double* u) const {
  Vec<D> result{};
  for (std::size_t a = 0; a < point.nodes.size(); ++a) {
    const double* const own = u + D * static_cast<std::size_t>(point.nodes[a]);
    for (std::size_t i = 0; i < D; ++i)
      for (std::size_t j = 0; j < D; ++j) result[i] += point.slips[a][i][j] * own[j];
  }
  return result;
}

template <std::size_t D>
void PairSlip<D>::add_force(const Point& point, const Vec<D>& traction, double* f) const {
  const Vec<D> force = points_.measure(point.contact) * traction;
  for (std::size_t a = 0; a < point.nodes.size(); ++a) {
    double* const at = f + D * static_cast<std::size_t>(point.nodes[a]);
    for (std::size_t i = 0; i < D; ++i)
      for (std::size_t j = 0; j < D; ++j) at[j] += point.slips[a][i][j] * force[i];
  }
}

/// With the slip's derivatives B_a by node, the matrix is B_a^T C B_b.
template <std::size_t D>
void PairSlip<D>::add_stiffness(const Point& point, const Small<double, D>& stiffness, std::vector<double>& k) const {
  const std::size_t count = point.nodes.size(), size = D * count;
  const double w = points_.measure(point.contact);
  boost::container::static_vector<Small<double, D>, PairGap<D>::most> forces(count);
  for (std::size_t a = 0; a < count; ++a)
    for (std::size_t i = 0; i < D; ++i)
      for (std::size_t l = 0; l < D; ++l) forces[a][i] = forces[a][i] + w * stiffness[i][l] * point.slips[a][l];
  for (std::size_t r = 0; r < size; ++r)
    for (std::size_t c = 0; c < size; ++c) {
      double sum = 0;
      for (std::size_t l = 0; l < D; ++l) sum += point.slips[r / D][l][r % D] * forces[c / D][l][c % D];
      k[r * size + c] += sum;
    }
}

/// The traction goes along with the primary surface, then with the tangent plane from the first foot to the last one.
template <std::size_t D>
double PairSlip<D>::accept(const double* u) {
  const auto times = contacts(u);
  const auto& end = times->front();
  double sum = 0;
  last_work_ = last_lag_ = 0;
  for (const Point& point : acting_) {
    const auto& contact = point.contact;
    const auto* const now = end.find(contact.patch, contact.point);
    const bool has_foot = now != nullptr && now->foot.patch >= 0;
    const double threshold = has_foot ? friction_.threshold_at(now->foot.gap) : 0.0;
    const auto left = step(point).end(slip(point, u), threshold);
    const SurfacePatch<D>& patch = points_.primary().patches[static_cast<std::size_t>(contact.foot.patch)];
    const auto from = triad<D>(contact.foot.frame),
               to = triad<D>(patch.placed(patch.among(end.places.primary)).frame(contact.foot.xi));
    const Vec<D> normal = turned<D>(contact.foot.normal, from, to);
    const Vec<D> traction = carried(turned<D>(left.traction, from, to), normal, has_foot ? now->foot.normal : normal);
    for (std::size_t i = 0; i < D; ++i) store(contact.patch, contact.point, i, traction[i]);
    const auto add = [&](FrictionNumber which, double value) {
      store(contact.patch, contact.point, place_of(which), number(contact.patch, contact.point, which) + value);
    };
    add(FrictionNumber::Slip, left.slip);
    add(FrictionNumber::Dissipated, left.work);
    store(contact.patch, contact.point, place_of(FrictionNumber::Sliding), left.slid);
    if (!points_.counts(contact.patch)) continue;
    sum += points_.measure(contact) * left.work;
    last_work_ += points_.measure(contact) * left.slip * point.threshold;
    last_lag_ += points_.measure(contact) * left.slip * (threshold - point.threshold);
  }
  in_step_ = false;
  return sum;
}

template <std::size_t D>
void PairSlip<D>::report(const double* u, FrictionReport& report) const {
  report.work += last_work_;
  report.lag += last_lag_;
  const auto times = contacts(u);
  for (std::size_t s = 0; s < points_.secondary().patches.size(); ++s) {
    if (!points_.counts(s)) continue;
    for (std::size_t q = 0; q < points_.points_of_a_patch(); ++q) {
      const typename PairPoints<D>::Contact contact{s, q, 0};
      if (points_.measure(contact) > 0) report.sliding += points_.area(contact) * number(s, q, FrictionNumber::Sliding);
    }
  }
  for (const auto& contact : times->front().all) {
    if (!points_.counts(contact.patch) || contact.foot.patch < 0 || !(points_.measure(contact) > 0)) continue;
    if (!(contact.foot.gap < friction_.cutoff() && friction_.threshold_at(contact.foot.gap) > 0)) continue;
    const double area = points_.area(contact);
    report.acting += area;
    report.sticking += area * (1 - number(contact.patch, contact.point, FrictionNumber::Sliding));
    report.slip += area * number(contact.patch, contact.point, FrictionNumber::Slip);
  }
}

template class PairSlip<2>;
template class PairSlip<3>;

}  // namespace ixos
