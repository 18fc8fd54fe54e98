/// Tangents from shape gradients and moduli, pair by pair of nodes.
#pragma once
#include <array>
#include <cstddef>

#include "base/small_matrix.hpp"
#include "element/displacement_gradient.hpp"
#include "material/meridian_moduli.hpp"
#include "material/spatial_tangent.hpp"

namespace ixos {

/// Adds dN_a,J A_iJkL dM_b,L to k_ai,bk, with `left` dN_a/dX_J and `right` dM_b/dX_L. If `symmetric`, left is right and
/// A is symmetric: the upper triangle of pairs is computed and mirrored. The function is inlined: a call for each
/// point, through memory, would cost small elements up to a third of their speed.
template <bool symmetric, class T, std::size_t L, std::size_t R, std::size_t D>
[[gnu::always_inline]] inline void add_contraction(const Small<T, L, D>& left, const Small<T, R, D>& right,
                                                   const Small<T, D * D>& moduli, Small<T, L * D, R * D>& k) {
  static_assert(!symmetric || L == R, "the same on both sides");
  for (std::size_t b = 0; b < R; ++b) {
    Small<T, D * D, D> product{};  // A_iJkL dM_b,L
    for (std::size_t r = 0; r < D * D; ++r)
      for (std::size_t c = 0; c < D; ++c)
        for (std::size_t l = 0; l < D; ++l) product[r][c] += moduli[r][c * D + l] * right[b][l];
    for (std::size_t a = 0; a < (symmetric ? b + 1 : L); ++a)
      for (std::size_t i = 0; i < D; ++i)
        for (std::size_t c = 0; c < D; ++c) {
          T sum = left[a][0] * product[i * D][c];
          for (std::size_t j = 1; j < D; ++j) sum += left[a][j] * product[i * D + j][c];
          k[a * D + i][b * D + c] += sum;
          if (symmetric && a != b) k[b * D + c][a * D + i] += sum;
        }
  }
}

/// Does the same in a body of revolution, where node a also has the hoop strain u_ar N_a/R. The moduli connect the
/// meridian components.
template <bool symmetric, class T, std::size_t L, std::size_t R>
[[gnu::always_inline]] inline void add_contraction(const RevolvedGradients<T, L>& left,
                                                   const RevolvedGradients<T, R>& right,
                                                   const Small<T, meridian_size>& moduli, Small<T, L * 2, R * 2>& k) {
  static_assert(!symmetric || L == R, "the same on both sides");
  constexpr std::size_t hoop = meridian_size - 1;
  for (std::size_t b = 0; b < R; ++b) {
    Small<T, meridian_size, 2> product;  // the stress due to a displacement of node b
    for (std::size_t r = 0; r < meridian_size; ++r) {
      for (std::size_t c = 0; c < 2; ++c)
        product[r][c] = moduli[r][2 * c] * right.plane[b][0] + moduli[r][2 * c + 1] * right.plane[b][1];
      product[r][0] += moduli[r][hoop] * right.hoop[b];
    }
    for (std::size_t a = 0; a < (symmetric ? b + 1 : L); ++a)
      for (std::size_t i = 0; i < 2; ++i)
        for (std::size_t c = 0; c < 2; ++c) {
          T sum = left.plane[a][0] * product[2 * i][c] + left.plane[a][1] * product[2 * i + 1][c];
          if (i == 0) sum += left.hoop[a] * product[hoop][c];
          k[a * 2 + i][b * 2 + c] += sum;
          if (symmetric && a != b) k[b * 2 + c][a * 2 + i] += sum;
        }
  }
}

/// The tangent at one quadrature and time point: shape gradients in the reference and in the deformed body, and the
/// material's coefficients times the weights.
template <class T, std::size_t N, std::size_t D>
struct SpatialPoint {
  Small<T, N, D> reference, current;
  SpatialTangent<T> moduli;
};

/// Number of points that add_products() takes at once: their gradients stay in the nearest cache.
constexpr std::size_t points_at_once = 8;

/// Adds to k_ai,bk the sum over points of mu (n_a . n_b) delta_ik + c g_bi g_ak + lambda g_ai g_bk, see SpatialTangent;
/// n and g are the shape gradients in the reference and the deformed body. Node pairs are the outer loop, so that sums
/// stay in registers; one triangle is computed and mirrored.
template <class T, std::size_t N, std::size_t D>
inline void add_products(const std::array<SpatialPoint<T, N, D>, points_at_once>& points, std::size_t count,
                         Small<T, N * D>& k) {
  for (std::size_t b = 0; b < N; ++b) {
    std::array<std::array<T, D>, points_at_once> n, c, l;
    for (std::size_t q = 0; q < count; ++q)
      for (std::size_t i = 0; i < D; ++i) {
        n[q][i] = points[q].moduli.mu * points[q].reference[b][i];
        c[q][i] = points[q].moduli.c * points[q].current[b][i];
        l[q][i] = points[q].moduli.lambda * points[q].current[b][i];
      }
    for (std::size_t a = 0; a <= b; ++a) {
      Small<T, D> sum{};
      T along(0.0);
      for (std::size_t q = 0; q < count; ++q) {
        const auto& reference = points[q].reference[a];
        const auto& current = points[q].current[a];
        for (std::size_t i = 0; i < D; ++i) {
          along += reference[i] * n[q][i];
          for (std::size_t j = 0; j < D; ++j) sum[i][j] += c[q][i] * current[j] + current[i] * l[q][j];
        }
      }
      for (std::size_t i = 0; i < D; ++i) sum[i][i] += along;
      for (std::size_t i = 0; i < D; ++i)
        for (std::size_t j = 0; j < D; ++j) {
          k[a * D + i][b * D + j] += sum[i][j];
          if (a != b) k[b * D + j][a * D + i] += sum[i][j];
        }
    }
  }
}

/// The tangent at one quadrature point: shape gradients and symmetric moduli times the weight.
template <class T, std::size_t N, std::size_t D>
struct ModuliPoint {
  Small<T, N, D> gradients;
  Small<T, D * D> moduli;
};

/// Number of points that add_contractions() takes at once.
constexpr std::size_t contractions_at_once = 4;

/// Does what add_contraction<true>() does for each point, node pairs in the outer loop as in add_products().
template <class T, std::size_t N, std::size_t D>
inline void add_contractions(const std::array<ModuliPoint<T, N, D>, contractions_at_once>& points, std::size_t count,
                             Small<T, N * D>& k) {
  for (std::size_t b = 0; b < N; ++b) {
    std::array<Small<T, D * D, D>, contractions_at_once> product;  // A_iJkL dN_b,L
    for (std::size_t q = 0; q < count; ++q) {
      const auto& right = points[q].gradients[b];
      for (std::size_t r = 0; r < D * D; ++r)
        for (std::size_t c = 0; c < D; ++c) {
          T sum = points[q].moduli[r][c * D] * right[0];
          for (std::size_t l = 1; l < D; ++l) sum += points[q].moduli[r][c * D + l] * right[l];
          product[q][r][c] = sum;
        }
    }
    for (std::size_t a = 0; a <= b; ++a) {
      Small<T, D> sum{};
      for (std::size_t q = 0; q < count; ++q) {
        const auto& left = points[q].gradients[a];
        for (std::size_t i = 0; i < D; ++i)
          for (std::size_t c = 0; c < D; ++c)
            for (std::size_t j = 0; j < D; ++j) sum[i][c] += left[j] * product[q][i * D + j][c];
      }
      for (std::size_t i = 0; i < D; ++i)
        for (std::size_t c = 0; c < D; ++c) {
          k[a * D + i][b * D + c] += sum[i][c];
          if (a != b) k[b * D + c][a * D + i] += sum[i][c];
        }
    }
  }
}

}  // namespace ixos
