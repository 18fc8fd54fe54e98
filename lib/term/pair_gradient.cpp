#include "term/pair_gradient.hpp"

#include <algorithm>
#include <cmath>

namespace ixos {

template <std::size_t D>
PairGradient<D>::PairGradient(const PairPoints<D>& points) : points_(points) {
  const GapLaw& law = points.law();
  const double equilibrium = law.equilibrium_gap();
  stiffness_ = std::abs(law.stiffness(equilibrium)[0]);
  if (stiffness_ == 0) stiffness_ = law.magnitude(equilibrium)[0] / equilibrium;
}

/// Returns S, in the order of the contact's nodes.
template <std::size_t D>
std::vector<double> PairGradient<D>::weights_of(const Contact& contact) const {
  const SurfacePatch<D>& patch = points_.primary().patches[static_cast<std::size_t>(contact.foot.patch)];
  const typename SurfacePatch<D>::Weights &own = points_.weights(contact), n = patch.weights(contact.foot.xi);
  std::vector<double> s(own.begin(),
                        own.begin() + static_cast<std::ptrdiff_t>(points_.secondary().patches[contact.patch].count));
  for (std::size_t a = 0; a < patch.count; ++a) s.push_back(-n[a]);
  return s;
}

template <std::size_t D>
typename PairGradient<D>::Step PairGradient<D>::take(const Segment& segment) const {
  using Places = typename PairPoints<D>::Places;
  std::vector<Places> places{points_.places(segment.from), points_.places(segment.to),
                             points_.places(segment, {1, 0.5, 0, 0.5})};
  // A point that is within the law's range at one end has a foot at the mean places, too.
  double way = 0;
  const auto grow = [&](const std::vector<Vec<D>>& a, const std::vector<Vec<D>>& b) {
    for (std::size_t i = 0; i < a.size(); ++i) way = std::max(way, length(b[i] - a[i]));
  };
  grow(places[0].secondary, places[1].secondary);
  grow(places[0].primary, places[1].primary);
  const auto times = points_.contacts(std::move(places), PairPoints<D>::Share::Forces, points_.law().range() + 4 * way);
  return {times, (*times)[0], (*times)[1], (*times)[2]};
}

/// Returns whether the point is within the law's range.
template <std::size_t D>
bool PairGradient<D>::acts(const Contact& contact) const {
  return contact.foot.patch >= 0 && !(std::abs(contact.foot.gap) >= points_.law().range());
}

/// Returns whether the point has a force.
template <std::size_t D>
bool PairGradient<D>::evaluate(const Step& step, std::size_t number, Point& point) const {
  const Contact &start = step.start.all[number], &end = step.end.all[number], &mean = step.mean.all[number];
  if (mean.foot.patch < 0 || (!acts(start) && !acts(end))) return false;
  const GapLaw& law = points_.law();
  const double g0 = acts(start) ? start.foot.gap : law.range();
  const double g1 = acts(end) ? end.foot.gap : law.range();
  point.at_end = &end;
  point.at_mean = &mean;
  point.d = end.place - start.place;
  const SurfacePatch<D>& patch = points_.primary().patches[static_cast<std::size_t>(mean.foot.patch)];
  const typename SurfacePatch<D>::Weights n = patch.weights(mean.foot.xi);
  for (std::size_t a = 0; a < patch.count; ++a) {
    const auto node = static_cast<std::size_t>(patch.nodes[a]);
    point.d = point.d - n[a] * (step.end.places.primary[node] - step.start.places.primary[node]);
  }
  point.along = inner(mean.foot.normal, point.d);
  point.traction = law.mean_traction(g0, g1)[0];
  point.mean_slope = acts(end) ? static_cast<double>(law.mean_stiffness(g0, g1)[0]) : 0.0;
  const double off = g1 - g0 - point.along, e = -point.traction * off;
  point.by_gap = acts(end) ? point.mean_slope * off - point.traction : 0.0;
  point.size = -point.traction;
  point.rest = point.c_by_e = point.c_by_a = 0;
  point.whole = length(point.d) > 1e-5 * law.equilibrium_gap();
  if (!point.whole || e == 0) return true;
  const double a = point.along, k = stiffness_;
  double c;
  if (k * a * a >= std::abs(e)) {
    c = e / a;
    point.c_by_e = 1 / a;
    point.c_by_a = -e / (a * a);
  } else {
    const double sign = e > 0 ? 1 : -1, ratio = k * a * a / e;
    c = k * a * (2 * sign - ratio);
    point.c_by_e = k * a * ratio / e;
    point.c_by_a = k * (2 * sign - 3 * ratio);
    point.rest = (e - c * a) / inner(point.d, point.d);
  }
  point.size += c;
  return true;
}

template <std::size_t D>
double PairGradient<D>::add_force(const Segment& segment, double* f) const {
  const Step step = take(segment);
  for (std::size_t i = 0; i < step.mean.all.size(); ++i) {
    Point point;
    if (!evaluate(step, i, point)) continue;
    const std::vector<int> nodes = points_.nodes_of(*point.at_mean);
    const std::vector<double> s = weights_of(*point.at_mean);
    const Vec<D> t = points_.measure(*point.at_mean) * point.force();
    for (std::size_t a = 0; a < nodes.size(); ++a)
      for (std::size_t k = 0; k < D; ++k) f[D * static_cast<std::size_t>(nodes[a]) + k] += s[a] * t[k];
  }
  return step.end.least_gap;
}

template <std::size_t D>
PairBlock PairGradient<D>::convex_block_of(const Point& point) const {
  const PairGap<D> gap = points_.gap_of(*point.at_mean);
  PairBlock block;
  block.secondary = point.at_mean->patch;
  block.primary = point.at_mean->foot.patch;
  block.nodes = points_.nodes_of(*point.at_mean);
  block.k.assign(D * D * gap.nodes() * gap.nodes(), 0.0);
  gap.add(points_.measure(*point.at_mean) * std::max(0.0, point.mean_slope) / 2, 0, block.k.data());
  return block;
}

/// With the force w s_I t at node I, its derivative is w (ds_I t + s_I dt). Mean places move half as far as the end's.
/// With the parameters' changes dxi at the mean places and the position r = g m of the point from its foot, dr = S du/2
/// - x_k dxi_k, dm = (dr - m m . dr)/g and dd = S du - (N_,k dX) dxi_k, where dX is the nodes' way in the step.
template <std::size_t D>
PairBlock PairGradient<D>::block_of(const Step& step, const Point& point) const {
  const Contact &mean = *point.at_mean, &end = *point.at_end;
  const SurfacePatch<D>& secondary = points_.secondary().patches[mean.patch];
  const SurfacePatch<D>& patch = points_.primary().patches[static_cast<std::size_t>(mean.foot.patch)];
  const std::size_t count = secondary.count, size = count + patch.count;
  PairBlock block;
  block.secondary = mean.patch;
  block.primary = mean.foot.patch;
  block.nodes = points_.nodes_of(mean);
  std::vector<double> end_weights(size, 0.0);  // of the end's gap, by node of the block
  if (acts(end)) {
    const SurfacePatch<D>& last = points_.primary().patches[static_cast<std::size_t>(end.foot.patch)];
    const std::vector<int> nodes = points_.nodes_of(end);
    const typename SurfacePatch<D>::Weights n = last.weights(end.foot.xi);
    for (std::size_t a = 0; a < count; ++a) end_weights[a] = points_.weights(end)[a];
    for (std::size_t a = 0; a < last.count; ++a) {
      if (end.foot.patch == mean.foot.patch) {
        end_weights[count + a] = -n[a];
      } else {
        block.nodes.push_back(nodes[count + a]);
        end_weights.push_back(-n[a]);
      }
    }
  }
  const std::size_t all = block.nodes.size(), columns = D * all;
  const auto shape = patch.shape(mean.foot.xi);
  std::vector<double> s = weights_of(mean);
  s.resize(all, 0.0);
  const Vec<D>& m = mean.foot.normal;
  const double g = mean.foot.gap;
  const auto& frame = mean.foot.frame;

  // Changes of the free parameters, as rows over the block's degrees of freedom.
  std::vector<std::size_t> free;
  for (std::size_t k = 0; k + 1 < D; ++k)
    if (!mean.foot.fixed[k]) free.push_back(k);
  std::array<std::array<double, D - 1>, D - 1> a{};
  for (std::size_t k = 0; k < free.size(); ++k)
    for (std::size_t l = 0; l < free.size(); ++l)
      a[k][l] = inner(frame.tangents[free[k]], frame.tangents[free[l]]) -
                g * inner(frame.bends[second_derivative(free[k], free[l])], m);
  std::array<std::vector<double>, D - 1> dxi;
  for (std::size_t k = 0; k < free.size(); ++k) dxi[k].assign(columns, 0.0);
  for (std::size_t node = 0; node < size; ++node)
    for (std::size_t i = 0; i < D; ++i) {
      std::array<double, D - 1> right{};
      for (std::size_t k = 0; k < free.size(); ++k) {
        const double slope = node < count ? 0 : shape.slopes[free[k]][node - count];
        right[k] = (s[node] * frame.tangents[free[k]][i] + g * slope * m[i]) / 2;
      }
      const std::size_t c = D * node + i;
      if (free.size() == 1) dxi[0][c] = right[0] / a[0][0];
      if (free.size() == 2) {
        const double det = a[0][0] * a[1][1] - a[0][1] * a[1][0];
        dxi[0][c] = (a[1][1] * right[0] - a[0][1] * right[1]) / det;
        dxi[D - 2][c] = (a[0][0] * right[1] - a[1][0] * right[0]) / det;
      }
    }
  // N_,k dX, the foot's own displacement as its parameters change.
  std::array<Vec<D>, D - 1> slide{};
  for (std::size_t k = 0; k < free.size(); ++k)
    for (std::size_t b = 0; b < patch.count; ++b) {
      const auto node = static_cast<std::size_t>(patch.nodes[b]);
      slide[k] =
          slide[k] + shape.slopes[free[k]][b] * (step.end.places.primary[node] - step.start.places.primary[node]);
    }
  const Vec<D> t = point.force();
  const double square = inner(point.d, point.d);
  std::array<std::vector<double>, D> dt;
  for (auto& row : dt) row.assign(columns, 0.0);
  for (std::size_t c = 0; c < columns; ++c) {
    const std::size_t node = c / D, i = c % D;
    Vec<D> dr{}, dd{};
    dr[i] = s[node] / 2;
    dd[i] = s[node];
    for (std::size_t k = 0; k < free.size(); ++k) {
      dr = dr - dxi[k][c] * frame.tangents[free[k]];
      dd = dd - dxi[k][c] * slide[k];
    }
    const Vec<D> dm = g == 0 ? Vec<D>{} : 1 / g * (dr - inner(m, dr) * m);
    const double dg = end_weights[node] * end.foot.normal[i], da = inner(m, dd) + inner(point.d, dm);
    const double de = point.by_gap * dg + point.traction * da, dc = point.c_by_e * de + point.c_by_a * da;
    double drest = 0;
    if (point.rest != 0)
      drest =
          (de - (point.size + point.traction) * da - point.along * dc - 2 * point.rest * inner(point.d, dd)) / square;
    for (std::size_t j = 0; j < D; ++j)
      dt[j][c] = (point.mean_slope * dg + dc) * m[j] + point.size * dm[j] + drest * point.d[j] + point.rest * dd[j];
  }
  const double w = points_.measure(mean);
  block.k.assign(columns * columns, 0.0);
  for (std::size_t node = 0; node < size; ++node)
    for (std::size_t i = 0; i < D; ++i) {
      double* const row = block.k.data() + (D * node + i) * columns;
      for (std::size_t c = 0; c < columns; ++c) {
        double sum = s[node] * dt[i][c];
        if (node >= count)
          for (std::size_t k = 0; k < free.size(); ++k) sum -= shape.slopes[free[k]][node - count] * t[i] * dxi[k][c];
        row[c] = w * sum;
      }
    }
  return block;
}

template <std::size_t D>
void PairGradient<D>::for_each_block(const Segment& segment, Tangent kind,
                                     const std::function<void(const PairBlock&)>& visit) const {
  const Step step = take(segment);
  if (!step.mean.primary) return;
  for (std::size_t i = 0; i < step.mean.all.size(); ++i) {
    Point point;
    if (evaluate(step, i, point)) visit(kind == Tangent::Convex ? convex_block_of(point) : block_of(step, point));
  }
}

template class PairGradient<2>;
template class PairGradient<3>;

}  // namespace ixos
