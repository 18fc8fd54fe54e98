#include <algorithm>

#include "term/pair/pair_gradient.hpp"

namespace ixos {
namespace {

/// Numbers by node of a block, which has those of a secondary patch and of up to two primary ones, and by its degrees
/// of freedom.
template <std::size_t D, class T>
using ByNode = boost::container::static_vector<T, 3 * SurfacePatch<D>::most>;
template <std::size_t D, class T>
using ByDof = boost::container::static_vector<T, D * 3 * SurfacePatch<D>::most>;

/// Returns N_,jk of the patch's nodes, in the order of second_derivative(): the second derivatives of patches that have
/// a unit vector at a node, D nodes at a time.
template <std::size_t D>
std::array<typename SurfacePatch<D>::Weights, second_derivatives(D - 1)> bends_of(const SurfacePatch<D>& patch,
                                                                                  const PatchParameters<D>& xi) {
  std::array<typename SurfacePatch<D>::Weights, second_derivatives(D - 1)> result{};
  for (std::size_t a = 0; a < patch.count; a += D) {
    typename SurfacePatch<D>::Points units{};
    for (std::size_t i = 0; i < D && a + i < patch.count; ++i) units[a + i][i] = 1;
    const auto frame = patch.placed(units).frame(xi);
    for (std::size_t b = 0; b < result.size(); ++b)
      for (std::size_t i = 0; i < D && a + i < patch.count; ++i) result[b][a + i] = frame.bends[b][i];
  }
  return result;
}

}  // namespace

/// With the force w s_I t at node I, its derivative is w (ds_I t + s_I dt), and so for N_,j. Mean places move half as
/// far as the end's. With the parameters' changes dxi at the mean places and the position r = g m of the point from
/// its closest point, dr = S du/2 - x_k dxi_k, dm = (dr - m m . dr)/g and dd = S du - (N_,k dX) dxi_k, where dX is the
/// nodes' way in the step. Corners have dr and dd likewise, with their own weight in place of the point's.
template <std::size_t D>
void PairGradient<D>::set_block(const Step& step, const Point& point, PairBlock& block) const {
  const Contact &mean = *point.at_mean, &end = *point.at_end;
  const SurfacePatch<D>& secondary = points_.secondary().patches[mean.patch];
  const SurfacePatch<D>& patch = points_.primary().patches[static_cast<std::size_t>(mean.projection.patch)];
  const std::size_t count = secondary.count, size = count + patch.count;
  block.secondary = mean.patch;
  block.primary = mean.projection.patch;
  block.next = -1;
  const auto own_nodes = points_.nodes_of(mean);
  block.nodes.assign(own_nodes.begin(), own_nodes.end());
  ByNode<D, double> end_weights(size, 0.0);  // of the end's gap
  if (points_.acts(end.projection)) {
    if (end.projection.patch != mean.projection.patch) block.next = end.projection.patch;
    const SurfacePatch<D>& last = points_.primary().patches[static_cast<std::size_t>(end.projection.patch)];
    const auto nodes = points_.nodes_of(end);
    const typename SurfacePatch<D>::Weights n = last.weights(end.projection.xi);
    for (std::size_t a = 0; a < count; ++a) end_weights[a] = points_.weights(end)[a];
    for (std::size_t a = 0; a < last.count; ++a) {
      if (end.projection.patch == mean.projection.patch) {
        end_weights[count + a] = -n[a];
      } else {
        block.nodes.push_back(nodes[count + a]);
        end_weights.push_back(-n[a]);
      }
    }
  }
  const std::size_t all = block.nodes.size(), columns = D * all;
  const auto shape = patch.shape(mean.projection.xi);
  const Weights own_weights = weights_of(mean);
  ByNode<D, double> s(own_weights.begin(), own_weights.end());
  s.resize(all, 0.0);
  const Vec<D>& m = mean.projection.normal;
  const double g = mean.projection.gap;
  const auto& frame = mean.projection.frame;

  // Changes of the free parameters, as rows over the block's degrees of freedom.
  boost::container::static_vector<std::size_t, D - 1> free;
  for (std::size_t k = 0; k + 1 < D; ++k)
    if (!mean.projection.fixed[k]) free.push_back(k);
  std::array<std::array<double, D - 1>, D - 1> a{};
  for (std::size_t k = 0; k < free.size(); ++k)
    for (std::size_t l = 0; l < free.size(); ++l)
      a[k][l] = inner(frame.tangents[free[k]], frame.tangents[free[l]]) -
                g * inner(frame.bends[second_derivative(free[k], free[l])], m);
  std::array<ByDof<D, double>, D - 1> dxi;
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
  // N_,k dX and N_,kl dX: the closest point's own displacement, and that of its tangents, as its parameters change.
  const auto bends = bends_of(patch, mean.projection.xi);
  std::array<Vec<D>, second_derivatives(D - 1)> turn{};
  for (std::size_t b = 0; b < patch.count; ++b) {
    const auto node = static_cast<std::size_t>(patch.nodes[b]);
    const Vec<D> way = step.end.places.primary[node] - step.start.places.primary[node];
    for (std::size_t k = 0; k < turn.size(); ++k) turn[k] = turn[k] + bends[k][b] * way;
  }
  const Vec<D> t = point.force();
  Vec<D> on_projection = t;
  for (std::size_t k = 0; k < point.corner.size(); ++k) on_projection = on_projection + point.force(k);
  const double square = inner(point.d, point.d);
  ByDof<D, Vec<D>> dt(columns), d_on_projection(columns);
  std::array<ByDof<D, Vec<D>>, corners> d_corner;
  for (auto& row : d_corner) row.resize(columns);
  std::array<ByDof<D, Vec<D>>, D - 1> d_turn;
  for (auto& row : d_turn) row.resize(columns);
  for (std::size_t c = 0; c < columns; ++c) {
    const std::size_t node = c / D, i = c % D;
    // Changes of a relative position at the mean places and of its way in the step, by the weight of the node.
    const auto change = [&](double weight) {
      std::array<Vec<D>, 2> result{};
      result[0][i] = weight / 2;
      result[1][i] = weight;
      for (std::size_t k = 0; k < free.size(); ++k) {
        result[0] = result[0] - dxi[k][c] * frame.tangents[free[k]];
        result[1] = result[1] - dxi[k][c] * point.along[k].way;
      }
      return result;
    };
    const auto [dr, dd] = change(s[node]);
    const Vec<D> dm = g == 0 ? Vec<D>{} : 1 / g * (dr - inner(m, dr) * m);
    const double dg = end_weights[node] * end.projection.normal[i], da = inner(m, dd) + inner(point.d, dm);
    const double de = point.by_gap * dg + point.traction * da;
    std::array<std::array<Vec<D>, 2>, corners> at_corner;
    std::array<double, corners> dw{};
    double dv = 2 * point.a * da;
    for (std::size_t k = 0; k < point.corner.size(); ++k) {
      at_corner[k] = change(node < count ? (node == k ? 1.0 : 0.0) : s[node]);
      const Corner& corner = point.corner[k];
      dw[k] = inner(corner.d, at_corner[k][0]) + inner(corner.r, at_corner[k][1]);
      dv += 2 * corner.w * dw[k] / point.size;
    }
    double df = 0;
    for (std::size_t k = 0; k < free.size(); ++k) df += point.f_slopes[free[k]] * dxi[k][c];
    // The changes of f, and then of the tangents t_j and of b_j.
    std::array<Vec<D>, D - 1> d_tangent;
    std::array<double, D - 1> db{};
    for (std::size_t j = 0; j < free.size(); ++j) {
      const Along& along = point.along[j];
      const double slope = node < count || node >= size ? 0 : shape.slopes[free[j]][node - count];
      Vec<D> d_way{};
      d_tangent[j] = Vec<D>{};
      d_tangent[j][i] = slope / 2;
      d_way[i] = slope;
      for (std::size_t k = 0; k < free.size(); ++k) {
        const std::size_t both = second_derivative(free[j], free[k]);
        d_tangent[j] = d_tangent[j] + dxi[k][c] * frame.bends[both];
        d_way = d_way + dxi[k][c] * turn[both];
      }
      const double dq =
          inner(d_tangent[j], point.d) + inner(along.t, dd) + inner(dr, along.way) + inner(point.r, d_way);
      db[j] = (df * along.change + point.f * dq - 2 * along.b * inner(along.t, d_tangent[j])) / along.square;
      dv += db[j] * along.change + along.b * dq;
    }
    const double dc = point.c_by_e * de + point.c_by_v * dv;
    double drest = 0;
    if (point.rest != 0) drest = (de - dc * point.v - point.c * dv - 2 * point.rest * inner(point.d, dd)) / square;
    dt[c] = (point.mean_slope * dg + dc * point.a + point.c * da) * m + (point.c * point.a - point.traction) * dm +
            drest * point.d + point.rest * dd;
    for (std::size_t j = 0; j < free.size(); ++j) {
      const Along& along = point.along[j];
      const double dcb = dc * along.b + point.c * db[j];
      dt[c] = dt[c] + dcb * along.t + point.c * along.b * d_tangent[j];
      d_turn[j][c] = dcb * point.r + point.c * along.b * dr;
    }
    d_on_projection[c] = dt[c];
    for (std::size_t k = 0; k < point.corner.size(); ++k) {
      const Corner& corner = point.corner[k];
      d_corner[k][c] =
          1 / point.size * ((dc * corner.w + point.c * dw[k]) * corner.r + point.c * corner.w * at_corner[k][0]);
      d_on_projection[c] = d_on_projection[c] + d_corner[k][c];
    }
  }
  const double w = points_.measure(mean);
  block.k.assign(columns * columns, 0.0);
  for (std::size_t node = 0; node < size; ++node)
    for (std::size_t i = 0; i < D; ++i) {
      double* const row = block.k.data() + (D * node + i) * columns;
      for (std::size_t c = 0; c < columns; ++c) {
        double sum = s[node] * (node < count ? dt[c][i] : d_on_projection[c][i]);
        if (node < point.corner.size()) sum += d_corner[node][c][i];
        if (node >= count)
          for (std::size_t k = 0; k < free.size(); ++k) {
            sum += shape.slopes[free[k]][node - count] * (d_turn[k][c][i] - on_projection[i] * dxi[k][c]);
            const Vec<D> force = point.turn(point.along[k]);
            for (std::size_t l = 0; l < free.size(); ++l)
              sum += bends[second_derivative(free[k], free[l])][node - count] * force[i] * dxi[l][c];
          }
        row[c] = w * sum;
      }
    }
}

template void PairGradient<2>::set_block(const Step&, const Point&, PairBlock&) const;
template void PairGradient<3>::set_block(const Step&, const Point&, PairBlock&) const;

}  // namespace ixos
