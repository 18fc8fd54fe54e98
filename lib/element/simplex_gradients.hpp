/// Gradients of quadratic triangles and tetrahedra at one point beside each corner.
#pragma once
#include <array>
#include <cmath>
#include <cstddef>

#include "base/pack.hpp"
#include "base/small_matrix.hpp"
#include "fem/shape_table.hpp"

namespace ixos {

/// Computes what TabulatedGradients computes, without values, for the rule whose point q has the barycentric
/// coordinates alpha at corner q and beta at the others. With u = sum_k l_k (2 l_k - 1) u_k + sum_{j<k} 4 l_j l_k u_jk
/// the derivative by l_k at point q is
///
///   g_k = (4 beta - 1) u_k + 4 beta sum_j u_jk + 4 (alpha - beta) (u_k if k = q, else u_qk),
///
/// of which only the last term depends on the point, and du/dxi_d = g_{d+1} - g_0: in space 44 operations a component,
/// where the table takes 120. Element::edges lists the corners of the nodes between corners.
template <class Element>
struct QuadraticSimplexGradients {
  static constexpr std::size_t D = Element::dimension;
  static constexpr std::size_t N = Element::nodes;
  static constexpr std::size_t corners = D + 1;

  /// The two coordinates of a table's points.
  struct Points {
    double alpha = 0, beta = 0;
    bool serves = false;  ///< whether its points are such ones

    explicit Points(const ShapeTable<Element>& table) {
      if (table.size() != corners) return;
      serves = true;
      for (std::size_t q = 0; q < corners; ++q) {
        const auto l = Element::barycentric(table.point[q]);
        if (q == 0) {
          alpha = l[0];
          beta = l[1];
        }
        for (std::size_t k = 0; k < corners; ++k) serves = serves && std::abs(l[k] - (k == q ? alpha : beta)) < 1e-14;
      }
    }
  };

  template <class T>
  static void evaluate(const Points& points, const Small<T, N, D>& u, Small<T, D>* gradients) {
    const double at_corner = 4 * points.beta - 1, at_edge = 4 * points.beta, own = 4 * (points.alpha - points.beta);
    for (std::size_t i = 0; i < D; ++i) {
      std::array<T, corners> common;
      for (std::size_t k = 0; k < corners; ++k) {
        T sum(0);
        for (std::size_t j = 0; j < corners; ++j)
          if (j != k) sum += u[between[j][k]][i];
        common[k] = at_corner * u[k][i] + at_edge * sum;
      }
      for (std::size_t q = 0; q < corners; ++q) {
        const T first = common[0] + own * u[between[q][0]][i];
        for (std::size_t d = 0; d < D; ++d) gradients[q][i][d] = common[d + 1] + own * u[between[q][d + 1]][i] - first;
      }
    }
  }

  template <class T>
  static void integrate(const Points& points, const Small<T, D>* stresses, Small<T, N, D>& f) {
    const double at_corner = 4 * points.beta - 1, at_edge = 4 * points.beta, own = 4 * (points.alpha - points.beta);
    for (std::size_t i = 0; i < D; ++i) {
      std::array<std::array<T, corners>, corners> by_coordinate;  // of each point
      std::array<T, corners> sum;
      for (std::size_t k = 0; k < corners; ++k) sum[k] = T(0);
      for (std::size_t q = 0; q < corners; ++q) {
        T all(0);
        for (std::size_t d = 0; d < D; ++d) {
          by_coordinate[q][d + 1] = stresses[q][i][d];
          all += stresses[q][i][d];
        }
        by_coordinate[q][0] = -all;
        for (std::size_t k = 0; k < corners; ++k) sum[k] += by_coordinate[q][k];
      }
      for (std::size_t k = 0; k < corners; ++k) {
        f[k][i] += at_corner * sum[k] + own * by_coordinate[k][k];
        for (std::size_t j = 0; j < k; ++j)
          f[between[j][k]][i] += at_edge * (sum[j] + sum[k]) + own * (by_coordinate[j][k] + by_coordinate[k][j]);
      }
    }
  }

 private:
  /// By two corners: the node between them, or the corner.
  static constexpr std::array<std::array<std::size_t, corners>, corners> find_between() {
    std::array<std::array<std::size_t, corners>, corners> result{};
    for (std::size_t k = 0; k < corners; ++k) result[k][k] = k;
    for (std::size_t e = 0; e < Element::edges.size(); ++e) {
      result[Element::edges[e][0]][Element::edges[e][1]] = corners + e;
      result[Element::edges[e][1]][Element::edges[e][0]] = corners + e;
    }
    return result;
  }
  static constexpr std::array<std::array<std::size_t, corners>, corners> between = find_between();
};

}  // namespace ixos
