#include "geometry/pair_gap.hpp"

#include "base/vector3.hpp"

namespace ixos {
namespace {

template <std::size_t N>
using Square = std::array<std::array<double, N>, N>;

/// Returns the inverse of the leading block of 1 or 2 rows.
template <std::size_t N>
Square<N> inverse(const Square<N>& m, std::size_t rows) {
  Square<N> result{};
  if (rows == 1) result[0][0] = 1 / m[0][0];
  if constexpr (N == 2)
    if (rows == 2) {
      const double det = m[0][0] * m[1][1] - m[0][1] * m[1][0];
      result = {{{m[1][1] / det, -m[0][1] / det}, {-m[1][0] / det, m[0][0] / det}}};
    }
  return result;
}

/// Returns unit vectors across the unit normal n and the tangent, which is zero if there is none.
std::array<Vec<2>, 1> vectors_across(const Vec<2>& n, const Vec<2>&) { return {{{-n[1], n[0]}}}; }
std::array<Vec<3>, 2> vectors_across(const Vec<3>& n, const Vec<3>& tangent) {
  if (length(tangent) > 0) {
    const Vec<3> m = cross(n, tangent);
    return {(1 / length(m)) * m, Vec<3>{}};
  }
  const std::size_t least = std::abs(n[0]) < std::abs(n[1]) ? (std::abs(n[0]) < std::abs(n[2]) ? 0 : 2)
                                                            : (std::abs(n[1]) < std::abs(n[2]) ? 1 : 2);
  Vec<3> axis{};
  axis[least] = 1;
  const Vec<3> m = cross(n, axis), first = (1 / length(m)) * m;
  return {first, cross(n, first)};
}

}  // namespace

template <std::size_t D>
PairGap<D>::PairGap(const typename SurfacePatch<D>::Weights& weights, std::size_t count, const SurfacePatch<D>& patch,
                    const SurfaceProjection<D>& projection)
    : nodes_(count + patch.count), normal_(projection.normal), gap_(projection.gap) {
  const auto shape = patch.shape(projection.xi);
  for (std::size_t a = 0; a < count; ++a) s_[a] = weights[a];
  for (std::size_t a = 0; a < patch.count; ++a) s_[count + a] = -shape.value[a];
  const auto& frame = projection.frame;
  std::array<std::size_t, parameters> number{};
  for (std::size_t k = 0; k < parameters; ++k) {
    if (projection.fixed[k]) continue;
    for (std::size_t a = 0; a < patch.count; ++a) d_[free_][count + a] = shape.slopes[k][a];
    tangents_[free_] = frame.tangents[k];
    number[free_++] = k;
  }
  Square<parameters> metric{}, divisor{};
  for (std::size_t k = 0; k < free_; ++k)
    for (std::size_t l = 0; l < free_; ++l) {
      bend_[k][l] = inner(frame.bends[second_derivative(number[k], number[l])], normal_);
      metric[k][l] = inner(tangents_[k], tangents_[l]);
      divisor[k][l] = metric[k][l] - gap_ * bend_[k][l];
    }
  inverse_metric_ = inverse(metric, free_);
  inverse_ = inverse(divisor, free_);
  if (free_ < parameters) {
    const auto vectors = vectors_across(normal_, free_ > 0 ? tangents_[0] : Vec<D>{});
    for (std::size_t k = 0; k < parameters - free_; ++k) across_[k] = vectors[k];
  }
}

template <std::size_t D>
typename PairGap<D>::Vector PairGap<D>::gradient() const {
  Vector result;  // beyond the nodes it stays unset
  for (std::size_t a = 0; a < nodes_; ++a)
    for (std::size_t i = 0; i < D; ++i) result[D * a + i] = s_[a] * normal_[i];
  return result;
}

/// All terms are products of few vectors: K = V Q V^T, with the columns of V the gradient, p_k, c_k and S m. Each of
/// these is a sum of weights times vectors.
template <std::size_t D>
typename PairGap<D>::Moduli PairGap<D>::moduli(double along, double across) const {
  using Column = std::array<Vec<D>, D>;  // by derivative
  std::array<Column, 1 + 2 * parameters> v{};
  Square<1 + 2 * parameters> q{};
  std::size_t columns = 1;
  v[0][0] = normal_;
  q[0][0] = along;
  if (across != 0) {
    const std::size_t p = 1, c = 1 + free_;
    for (std::size_t k = 0; k < free_; ++k)
      for (std::size_t l = 0; l < free_; ++l) {
        v[p + k][0] = v[p + k][0] + inverse_[k][l] * tangents_[l];
        v[p + k][l + 1] = v[p + k][l + 1] + (inverse_[k][l] * gap_) * normal_;
      }
    for (std::size_t k = 0; k < free_; ++k) {
      v[c + k][k + 1] = normal_;
      for (std::size_t l = 0; l < free_; ++l)
        for (std::size_t d = 0; d < D; ++d) v[c + k][d] = v[c + k][d] + bend_[k][l] * v[p + l][d];
      q[c + k][p + k] = q[p + k][c + k] = -across;
      for (std::size_t l = 0; l < free_; ++l) {
        q[p + k][p + l] = across * bend_[k][l];
        q[c + k][c + l] = across * gap_ * inverse_metric_[k][l];
      }
    }
    columns += 2 * free_;
    for (std::size_t k = 0; k < parameters - free_; ++k, ++columns) {
      v[columns][0] = across_[k];
      q[columns][columns] = across / gap_;
    }
  }
  Moduli m{};
  for (std::size_t r = 0; r < columns; ++r) {
    Column w{};
    for (std::size_t l = 0; l < columns; ++l)
      for (std::size_t d = 0; d < D; ++d) w[d] = w[d] + q[r][l] * v[l][d];
    for (std::size_t i = 0; i < D * D; ++i)
      for (std::size_t j = 0; j < D * D; ++j) m[i][j] += v[r][i / D][i % D] * w[j / D][j % D];
  }
  return m;
}

template <std::size_t D>
void PairGap<D>::add(double along, double across, double* matrix) const {
  const Moduli m = moduli(along, across);
  for (std::size_t a = 0; a < nodes_; ++a)
    for (std::size_t i = 0; i < D; ++i, matrix += D * nodes_) {
      std::array<double, D * D> row{};
      for (std::size_t k = 0; k < D; ++k)
        for (std::size_t c = 0; c < D * D; ++c) row[c] += weight(k, a) * m[D * k + i][c];
      for (std::size_t b = 0; b < nodes_; ++b)
        for (std::size_t l = 0; l < D; ++l)
          for (std::size_t j = 0; j < D; ++j) matrix[D * b + j] += row[D * l + j] * weight(l, b);
    }
}

template class PairGap<2>;
template class PairGap<3>;

}  // namespace ixos
