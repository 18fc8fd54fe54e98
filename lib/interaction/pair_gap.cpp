#include "interaction/pair_gap.hpp"

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
                    const PlacedPatch<D>& placed, const SurfaceFoot<D>& foot)
    : nodes_(count + patch.count), normal_(foot.normal), gap_(foot.gap) {
  const auto shape = patch.shape(foot.xi);
  for (std::size_t a = 0; a < count; ++a) s_[a] = weights[a];
  for (std::size_t a = 0; a < patch.count; ++a) s_[count + a] = -shape.value[a];
  const auto frame = placed.frame(foot.xi);
  std::array<std::size_t, parameters> number{};
  for (std::size_t k = 0; k < parameters; ++k) {
    if (foot.fixed[k]) continue;
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

/// All terms are products of few vectors: K = V Q V^T, with the columns of V the gradient, p_k, c_k and S m.
template <std::size_t D>
void PairGap<D>::add(double along, double across, double* matrix) const {
  constexpr std::size_t most_columns = 1 + 2 * parameters;
  const std::size_t size = D * nodes_;
  std::array<Vector, most_columns> v;
  Square<most_columns> q{};
  std::size_t columns = 1;
  v[0] = gradient();
  q[0][0] = along;
  if (across != 0) {
    std::array<std::size_t, parameters> p{}, c{};
    for (std::size_t k = 0; k < free_; ++k) {
      p[k] = columns++;
      c[k] = columns++;
    }
    for (std::size_t k = 0; k < free_; ++k) {
      Vector& own = v[p[k]];
      for (std::size_t a = 0; a < nodes_; ++a)
        for (std::size_t i = 0; i < D; ++i) {
          double sum = 0;
          for (std::size_t l = 0; l < free_; ++l)
            sum += inverse_[k][l] * (s_[a] * tangents_[l][i] + gap_ * d_[l][a] * normal_[i]);
          own[D * a + i] = sum;
        }
    }
    for (std::size_t k = 0; k < free_; ++k) {
      Vector& own = v[c[k]];
      for (std::size_t a = 0; a < nodes_; ++a)
        for (std::size_t i = 0; i < D; ++i) {
          double sum = d_[k][a] * normal_[i];
          for (std::size_t l = 0; l < free_; ++l) sum += bend_[k][l] * v[p[l]][D * a + i];
          own[D * a + i] = sum;
        }
      q[c[k]][p[k]] = q[p[k]][c[k]] = -across;
      for (std::size_t l = 0; l < free_; ++l) {
        q[p[k]][p[l]] = across * bend_[k][l];
        q[c[k]][c[l]] = across * gap_ * inverse_metric_[k][l];
      }
    }
    for (std::size_t k = 0; k < parameters - free_; ++k) {
      Vector& own = v[columns];
      for (std::size_t a = 0; a < nodes_; ++a)
        for (std::size_t i = 0; i < D; ++i) own[D * a + i] = s_[a] * across_[k][i];
      q[columns][columns] = across / gap_;
      ++columns;
    }
  }
  for (std::size_t r = 0; r < size; ++r) {
    std::array<double, most_columns> w{};
    for (std::size_t k = 0; k < columns; ++k)
      for (std::size_t l = 0; l < columns; ++l) w[l] += v[k][r] * q[k][l];
    double* const row = matrix + r * size;
    for (std::size_t l = 0; l < columns; ++l) {
      const double factor = w[l];
      const double* const own = v[l].data();
      for (std::size_t s = 0; s < size; ++s) row[s] += factor * own[s];
    }
  }
}

template class PairGap<2>;
template class PairGap<3>;

}  // namespace ixos
