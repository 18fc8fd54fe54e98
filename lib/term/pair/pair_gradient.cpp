#include "term/pair/pair_gradient.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace ixos {
template <std::size_t D>
PairGradient<D>::PairGradient(const PairPoints<D>& points) : points_(points) {
  const GapLaw& law = points.law();
  const double equilibrium = law.equilibrium_gap();
  stiffness_ = 3 * std::abs(law.stiffness(equilibrium)[0]);
  if (stiffness_ == 0) stiffness_ = 3 * law.magnitude(equilibrium)[0] / equilibrium;
  std::set<typename SurfacePatch<D>::Corner> kinks;
  for (const SurfacePatch<D>& patch : points.primary().patches)
    for (std::size_t side = 0; side < patch.smooth.size(); ++side)
      for (std::size_t corner = 0; corner < corners && !patch.smooth[side]; ++corner)
        if (at_end(corner, side / 2) == (side % 2 == 1)) kinks.insert(patch.corner(corner));
  // Across the sides within a triangle the tangents turn, and b_j is not the same on both.
  for (const SurfacePatch<D>& patch : points.primary().patches)
    for (const auto& corner : patch.split_corners)
      if (corner.size() == 3) kinks.insert(corner);
  for (const SurfacePatch<D>& patch : points.primary().patches) {
    kinks_.emplace_back();
    for (std::size_t corner = 0; corner < corners; ++corner)
      kinks_.back()[corner] = kinks.count(patch.corner(corner)) > 0;
  }
}

/// Between the corners, 0 or 1, f is bilinear, so that it is the same on both sides of an edge; a bubble lifts it
/// inside.
template <std::size_t D>
void PairGradient<D>::fade(std::size_t patch, const PatchParameters<D>& xi, Point& point) const {
  double rest = 0, bubble = 1;  // 1 - f on the edges
  PatchParameters<D> rest_slopes{}, bubble_slopes{};
  for (std::size_t corner = 0; corner < corners; ++corner) {
    if (!kinks_[patch][corner]) continue;
    double share = 1;
    for (std::size_t k = 0; k + 1 < D; ++k) share *= at_end(corner, k) ? xi[k] : 1 - xi[k];
    rest += share;
    for (std::size_t k = 0; k + 1 < D; ++k) {
      double slope = at_end(corner, k) ? 1 : -1;
      for (std::size_t l = 0; l + 1 < D; ++l)
        if (l != k) slope *= at_end(corner, l) ? xi[l] : 1 - xi[l];
      rest_slopes[k] += slope;
    }
  }
  for (std::size_t k = 0; k + 1 < D; ++k) bubble *= 4 * xi[k] * (1 - xi[k]);
  for (std::size_t k = 0; k + 1 < D; ++k) {
    bubble_slopes[k] = 4 - 8 * xi[k];
    for (std::size_t l = 0; l + 1 < D; ++l)
      if (l != k) bubble_slopes[k] *= 4 * xi[l] * (1 - xi[l]);
  }
  point.f = 1 - rest * (1 - bubble);
  for (std::size_t k = 0; k + 1 < D; ++k) point.f_slopes[k] = rest * bubble_slopes[k] - rest_slopes[k] * (1 - bubble);
}

/// Returns S, in the order of the contact's nodes.
template <std::size_t D>
typename PairGradient<D>::Weights PairGradient<D>::weights_of(const Contact& contact) const {
  const SurfacePatch<D>& patch = points_.primary().patches[static_cast<std::size_t>(contact.projection.patch)];
  const typename SurfacePatch<D>::Weights &own = points_.weights(contact), n = patch.weights(contact.projection.xi);
  Weights s(own.begin(), own.begin() + static_cast<std::ptrdiff_t>(points_.secondary().patches[contact.patch].count));
  for (std::size_t a = 0; a < patch.count; ++a) s.push_back(-n[a]);
  return s;
}

template <std::size_t D>
typename PairGradient<D>::Step PairGradient<D>::take(const Segment& segment) const {
  places_.resize(3);
  points_.place(segment.from, places_[0]);
  points_.place(segment.to, places_[1]);
  points_.place(segment, {1, 0.5, 0, 0.5}, places_[2]);
  // A point that is within the law's range at one end has a closest point at the mean places, too.
  double way = 0;
  const auto grow = [&](const std::vector<Vec<D>>& a, const std::vector<Vec<D>>& b) {
    for (std::size_t i = 0; i < a.size(); ++i) way = std::max(way, length(b[i] - a[i]));
  };
  grow(places_[0].secondary, places_[1].secondary);
  grow(places_[0].primary, places_[1].primary);
  const auto times = points_.contacts(places_, PairPoints<D>::Share::Forces, points_.law().range() + 4 * way);
  return {times, (*times)[0], (*times)[1], (*times)[2]};
}

/// Returns whether the point has a force.
template <std::size_t D>
bool PairGradient<D>::evaluate(const Step& step, std::size_t number, Point& point) const {
  const Contact &start = step.start.all[number], &end = step.end.all[number], &mean = step.mean.all[number];
  if (mean.projection.patch < 0 || (!points_.acts(start.projection) && !points_.acts(end.projection))) return false;
  const GapLaw& law = points_.law();
  const double g0 = points_.acts(start.projection) ? start.projection.gap : law.range();
  const double g1 = points_.acts(end.projection) ? end.projection.gap : law.range();
  point.at_end = &end;
  point.at_mean = &mean;
  point.d = end.place - start.place;
  const SurfacePatch<D>& patch = points_.primary().patches[static_cast<std::size_t>(mean.projection.patch)];
  const typename SurfacePatch<D>::Shape n = patch.shape(mean.projection.xi);
  std::array<Vec<D>, D - 1> turns{};  // of the tangents
  for (std::size_t a = 0; a < patch.count; ++a) {
    const auto node = static_cast<std::size_t>(patch.nodes[a]);
    const Vec<D> way = step.end.places.primary[node] - step.start.places.primary[node];
    point.d = point.d - n.value[a] * way;
    for (std::size_t j = 0; j + 1 < D; ++j) turns[j] = turns[j] + n.slopes[j][a] * way;
  }
  const Vec<D>& m = mean.projection.normal;
  point.r = mean.projection.gap * m;
  point.a = inner(m, point.d);
  // The closest point's way is that of its weights.
  const Vec<D> projection_way = end.place - start.place - point.d;
  const SurfacePatch<D>& own = points_.secondary().patches[mean.patch];
  double sum = 0;
  point.size = 0;
  point.corner.resize(own.side_corners);
  for (std::size_t k = 0; k < own.side_corners; ++k) {
    const auto node = static_cast<std::size_t>(own.nodes[k]);
    const Vec<D>& before = step.start.places.secondary[node];
    Corner& corner = point.corner[k];
    corner.r = step.mean.places.secondary[node] - mean.projection.frame.place;
    corner.d = step.end.places.secondary[node] - before - projection_way;
    corner.w = inner(corner.r, corner.d);
    point.size += inner(before - start.place, before - start.place);
    sum += corner.w * corner.w;
  }
  point.v = point.a * point.a + sum / point.size;
  point.along.clear();
  fade(static_cast<std::size_t>(mean.projection.patch), mean.projection.xi, point);
  for (std::size_t j = 0; j + 1 < D; ++j) {
    if (mean.projection.fixed[j]) continue;
    const Vec<D>& t = mean.projection.frame.tangents[j];
    const double change = inner(t, point.d) + inner(point.r, turns[j]), square = inner(t, t),
                 b = point.f * change / square;
    point.along.push_back({j, t, turns[j], change, square, b});
    point.v += b * change;
  }
  point.traction = law.mean_traction(g0, g1)[0];
  point.mean_slope = points_.acts(end.projection) ? static_cast<double>(law.mean_stiffness(g0, g1)[0]) : 0.0;
  const double off = g1 - g0 - point.a;
  point.by_gap = points_.acts(end.projection) ? point.mean_slope * off - point.traction : 0.0;
  share(-point.traction * off, point);
  return true;
}

template <std::size_t D>
void PairGradient<D>::share(double e, Point& point) const {
  point.c = point.rest = point.c_by_e = point.c_by_v = 0;
  if (e == 0 || length(point.d) <= 1e-5 * points_.law().equilibrium_gap()) return;
  const double k = stiffness_, v = point.v;
  if (k * v >= std::abs(e)) {
    point.c = e / v;
    point.c_by_e = 1 / v;
    point.c_by_v = -e / (v * v);
  } else {
    const double sign = e > 0 ? 1 : -1, ratio = k * v / e;
    point.c = k * (2 * sign - ratio);
    point.c_by_e = k * ratio / e;
    point.c_by_v = -k * k / e;
    point.rest = (e - point.c * v) / inner(point.d, point.d);
  }
}

template <std::size_t D>
double PairGradient<D>::add_force(const Segment& segment, double* f) const {
  const Step step = take(segment);
  for (std::size_t i = 0; i < step.mean.all.size(); ++i) {
    Point point;
    if (!evaluate(step, i, point)) continue;
    const auto nodes = points_.nodes_of(*point.at_mean);
    const Weights s = weights_of(*point.at_mean);
    const double w = points_.measure(*point.at_mean);
    const std::size_t count = points_.secondary().patches[point.at_mean->patch].count;
    const auto add = [&](std::size_t a, const Vec<D>& force) {
      for (std::size_t j = 0; j < D; ++j) f[D * static_cast<std::size_t>(nodes[a]) + j] += w * force[j];
    };
    const Vec<D> own = point.force();
    Vec<D> all = own;
    for (std::size_t k = 0; k < point.corner.size(); ++k) {
      add(k, point.force(k));
      all = all + point.force(k);
    }
    for (std::size_t a = 0; a < nodes.size(); ++a) add(a, s[a] * (a < count ? own : all));
    if (point.c == 0) continue;
    const SurfacePatch<D>& patch = points_.primary().patches[static_cast<std::size_t>(point.at_mean->projection.patch)];
    const auto slopes = patch.shape(point.at_mean->projection.xi).slopes;
    for (const Along& j : point.along)
      for (std::size_t a = 0; a < patch.count; ++a) add(count + a, slopes[j.parameter][a] * point.turn(j));
  }
  return step.end.least_gap;
}

template <std::size_t D>
void PairGradient<D>::set_convex_block(const Point& point, PairBlock& block) const {
  const PairGap<D> gap = points_.gap_of(*point.at_mean);
  block.secondary = point.at_mean->patch;
  block.primary = point.at_mean->projection.patch;
  block.next = -1;
  const auto nodes = points_.nodes_of(*point.at_mean);
  block.nodes.assign(nodes.begin(), nodes.end());
  block.k.assign(D * D * gap.nodes() * gap.nodes(), 0.0);
  gap.add(points_.measure(*point.at_mean) * std::max(0.0, point.mean_slope) / 2, 0, block.k.data());
}

template <std::size_t D>
void PairGradient<D>::for_each_block(const Segment& segment, Tangent kind,
                                     const std::function<void(const PairBlock&)>& visit) const {
  const Step step = take(segment);
  if (!step.mean.primary) return;
  for (std::size_t i = 0; i < step.mean.all.size(); ++i) {
    Point point;
    if (!evaluate(step, i, point)) continue;
    if (kind == Tangent::Convex)
      set_convex_block(point, block_);
    else
      set_block(step, point, block_);
    visit(block_);
  }
}

template class PairGradient<2>;
template class PairGradient<3>;

}  // namespace ixos
