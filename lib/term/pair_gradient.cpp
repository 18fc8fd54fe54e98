#include "term/pair_gradient.hpp"

#include <algorithm>
#include <cmath>

namespace ixos {

template <std::size_t D>
PairGradient<D>::PairGradient(const PairPoints<D>& points) : points_(points) {
  const GapLaw& law = points.law();
  const double equilibrium = law.equilibrium_gap();
  stiffness_ = 3 * std::abs(law.stiffness(equilibrium)[0]);
  if (stiffness_ == 0) stiffness_ = 3 * law.magnitude(equilibrium)[0] / equilibrium;
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
  // The foot's way is that of its weights.
  const Vec<D> foot_way = end.place - start.place - point.d;
  const SurfacePatch<D>& own = points_.secondary().patches[mean.patch];
  point.size = point.v = 0;
  for (std::size_t k = 0; k < corners; ++k) {
    const auto node = static_cast<std::size_t>(own.nodes[k]);
    const Vec<D>& before = step.start.places.secondary[node];
    Corner& corner = point.corner[k];
    corner.r = step.mean.places.secondary[node] - mean.foot.frame.place;
    corner.d = step.end.places.secondary[node] - before - foot_way;
    corner.w = inner(corner.r, corner.d);
    point.size += inner(before - start.place, before - start.place);
    point.v += corner.w * corner.w;
  }
  point.v /= point.size;
  point.traction = law.mean_traction(g0, g1)[0];
  point.mean_slope = acts(end) ? static_cast<double>(law.mean_stiffness(g0, g1)[0]) : 0.0;
  const double off = g1 - g0 - inner(mean.foot.normal, point.d), e = -point.traction * off;
  point.by_gap = acts(end) ? point.mean_slope * off - point.traction : 0.0;
  point.c = point.rest = point.c_by_e = point.c_by_v = 0;
  if (e == 0 || length(point.d) <= 1e-5 * law.equilibrium_gap()) return true;
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
    const double w = points_.measure(*point.at_mean);
    const std::size_t count = points_.secondary().patches[point.at_mean->patch].count;
    const auto add = [&](std::size_t a, const Vec<D>& force) {
      for (std::size_t j = 0; j < D; ++j) f[D * static_cast<std::size_t>(nodes[a]) + j] += w * force[j];
    };
    const Vec<D> own = point.force();
    Vec<D> all = own;
    for (std::size_t k = 0; k < corners; ++k) {
      add(k, point.force(k));
      all = all + point.force(k);
    }
    for (std::size_t a = 0; a < nodes.size(); ++a) add(a, s[a] * (a < count ? own : all));
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
/// - x_k dxi_k, dm = (dr - m m . dr)/g and dd = S du - (N_,k dX) dxi_k, where dX is the nodes' way in the step. Corners
/// have dr and dd likewise, with their own weight in place of the point's.
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
  Vec<D> on_foot = t;
  for (std::size_t k = 0; k < corners; ++k) on_foot = on_foot + point.force(k);
  const double square = inner(point.d, point.d);
  std::vector<Vec<D>> dt(columns), d_on_foot(columns);
  std::array<std::vector<Vec<D>>, corners> d_corner;
  for (auto& row : d_corner) row.resize(columns);
  for (std::size_t c = 0; c < columns; ++c) {
    const std::size_t node = c / D, i = c % D;
    // Changes of a relative position at the mean places and of its way in the step, by the weight of the node.
    const auto change = [&](double weight) {
      std::array<Vec<D>, 2> result{};
      result[0][i] = weight / 2;
      result[1][i] = weight;
      for (std::size_t k = 0; k < free.size(); ++k) {
        result[0] = result[0] - dxi[k][c] * frame.tangents[free[k]];
        result[1] = result[1] - dxi[k][c] * slide[k];
      }
      return result;
    };
    const auto [dr, dd] = change(s[node]);
    const Vec<D> dm = g == 0 ? Vec<D>{} : 1 / g * (dr - inner(m, dr) * m);
    const double dg = end_weights[node] * end.foot.normal[i], da = inner(m, dd) + inner(point.d, dm);
    const double de = point.by_gap * dg + point.traction * da;
    std::array<std::array<Vec<D>, 2>, corners> at_corner;
    std::array<double, corners> dw{};
    double dv = 0;
    for (std::size_t k = 0; k < corners; ++k) {
      at_corner[k] = change(node < count ? (node == k ? 1.0 : 0.0) : s[node]);
      const Corner& corner = point.corner[k];
      dw[k] = inner(corner.d, at_corner[k][0]) + inner(corner.r, at_corner[k][1]);
      dv += 2 * corner.w * dw[k] / point.size;
    }
    const double dc = point.c_by_e * de + point.c_by_v * dv;
    double drest = 0;
    if (point.rest != 0) drest = (de - dc * point.v - point.c * dv - 2 * point.rest * inner(point.d, dd)) / square;
    dt[c] = (point.mean_slope * dg) * m - point.traction * dm + drest * point.d + point.rest * dd;
    d_on_foot[c] = dt[c];
    for (std::size_t k = 0; k < corners; ++k) {
      const Corner& corner = point.corner[k];
      d_corner[k][c] =
          1 / point.size * ((dc * corner.w + point.c * dw[k]) * corner.r + point.c * corner.w * at_corner[k][0]);
      d_on_foot[c] = d_on_foot[c] + d_corner[k][c];
    }
  }
  const double w = points_.measure(mean);
  block.k.assign(columns * columns, 0.0);
  for (std::size_t node = 0; node < size; ++node)
    for (std::size_t i = 0; i < D; ++i) {
      double* const row = block.k.data() + (D * node + i) * columns;
      for (std::size_t c = 0; c < columns; ++c) {
        double sum = s[node] * (node < count ? dt[c][i] : d_on_foot[c][i]);
        if (node < corners) sum += d_corner[node][c][i];
        if (node >= count)
          for (std::size_t k = 0; k < free.size(); ++k)
            sum -= shape.slopes[free[k]][node - count] * on_foot[i] * dxi[k][c];
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
