/// A matrix at each quadrature point of a surface, applied without the matrix of the whole.
#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <stdexcept>
#include <type_traits>
#include <vector>

#include "term/corner_matrices.hpp"
#include "term/galerkin_products.hpp"
#include "term/wall/curved_sides.hpp"

namespace ixos {

/// The operator sum N_a k N_c over the quadrature points, with a matrix k at each. The sides must outlive it.
template <class SideElement>
class PointMatrices final : public SideMatrices<Small<Pack, SideElement::dimension + 1>> {
  using Sides = CurvedSides<SideElement>;
  using Vectors = typename Sides::Vectors;
  static constexpr std::size_t D = Sides::D, N = Sides::N;

 public:
  using Matrix = Small<Pack, D>;

  explicit PointMatrices(const Sides& sides)
      : sides_(sides), points_(sides.quadrature().size()), k_(sides.size() * points_) {}

  void set(std::size_t b, const Matrix* k) override { std::copy_n(k, points_, &k_[b * points_]); }

  void add_product(const double* x, double* y) const override {
    for (std::size_t b = 0; b < sides_.size(); ++b) {
      const Vectors u = sides_.change_of(b, x);
      Vectors f{};
      for (std::size_t q = 0; q < points_; ++q) {
        const auto& shape = sides_.quadrature().value[q];
        const PackPoint at = sides_.interpolate(q, u);
        for (std::size_t i = 0; i < D; ++i) {
          Pack force = 0.0;
          for (std::size_t j = 0; j < D; ++j) force += k_[b * points_ + q][i][j] * at[j];
          for (std::size_t a = 0; a < N; ++a) f[a][i] += shape[a] * force;
        }
      }
      sides_.batches().scatter_force(b, f, y);
    }
  }

  void add_diagonal(double* d) const override {
    for (std::size_t b = 0; b < sides_.size(); ++b) {
      Vectors diagonal{};
      for (std::size_t q = 0; q < points_; ++q) {
        const auto& shape = sides_.quadrature().value[q];
        for (std::size_t a = 0; a < N; ++a)
          for (std::size_t i = 0; i < D; ++i) diagonal[a][i] += (shape[a] * shape[a]) * k_[b * points_ + q][i][i];
      }
      sides_.batches().scatter_diagonal(b, diagonal, d);
    }
  }

  void add_coarse(const CoarseSpace& coarse, double* values) const override {
    using Corners = typename CornerElement<SideElement>::type;
    if constexpr (is_linear_element<SideElement>) {
      add_galerkin_products(
          sides_.batches(), coarse, [this](std::size_t b) { return sides_.owned(b); },
          [&](std::size_t b, const Prolongation<N>& prolongation, Small<Pack, N * D>& k) {
            Small<Pack, N * D> own;
            Sides::sum_over_points(sides_.quadrature(), &k_[b * points_], own);
            k = galerkin_product<N, D>(prolongation, own);
          },
          values);
    } else if constexpr (std::is_void_v<Corners>) {
      if (!sides_.may_be_coarsened()) throw std::logic_error("enriched sides have no coarse space");
    } else {
      const ShapeTable<Corners> table(sides_.quadrature());
      add_corner_matrices<Corners::nodes>(
          sides_.batches(), coarse,
          [&](std::size_t b, Small<Pack, Corners::nodes * D>& k) {
            Sides::sum_over_points(table, &k_[b * points_], k);
          },
          values);
    }
  }

 private:
  const Sides& sides_;
  std::size_t points_;
  std::vector<Matrix> k_;  ///< batches x quadrature points
};

}  // namespace ixos
