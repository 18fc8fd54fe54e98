#include "term/pair/dense_pairs.hpp"

#include <algorithm>

namespace ixos {
namespace {

template <std::size_t D>
using Packs = std::array<Pack, D>;

template <std::size_t D>
using Square = std::array<double, D * D>;

template <std::size_t D>
Pack inner_pack(const Packs<D>& a, const Packs<D>& b) {
  Pack sum = a[0] * b[0];
  for (std::size_t i = 1; i < D; ++i) sum += a[i] * b[i];
  return sum;
}

/// A pack of the second surface's points, as the first surface's point sees it.
template <std::size_t D>
struct Seen {
  Packs<D> d, area;  ///< x1 - x2, a2
  Pack both;         ///< a1 . a2
  typename PairKernel<D>::template Values<Pack> w;

  Seen(const PairKernel<D>& kernel, const Packs<D>& place, const Packs<D>& own_area,
       const typename SurfaceElements<D>::Placed& second, std::size_t k) {
    for (std::size_t i = 0; i < D; ++i) {
      d[i] = place[i] - second.places[i][k];
      area[i] = second.areas[i][k];
    }
    both = inner_pack<D>(own_area, area);
    w = kernel.at(inner_pack<D>(d, d));
  }
};

template <std::size_t D>
Packs<D> spread(const Vec<D>& x) {
  Packs<D> result;
  for (std::size_t i = 0; i < D; ++i) result[i] = x[i];
  return result;
}

/// Returns the lanes of packs as points.
template <std::size_t D>
std::vector<Vec<D>> points_of(const std::array<std::vector<Pack>, D>& packs, std::size_t count) {
  std::vector<Vec<D>> result(count);
  for (std::size_t q = 0; q < count; ++q)
    for (std::size_t i = 0; i < D; ++i)
      result[q][i] = packs[i][q / static_cast<std::size_t>(pack_width)][q % static_cast<std::size_t>(pack_width)];
  return result;
}

/// matrix += factor a^T b
template <std::size_t D>
void add_outer(double factor, const Vec<D>& a, const Vec<D>& b, Square<D>& matrix) {
  for (std::size_t i = 0; i < D; ++i)
    for (std::size_t j = 0; j < D; ++j) matrix[D * i + j] += factor * a[i] * b[j];
}

template <std::size_t D>
Square<D> product(const Square<D>& a, const Square<D>& b) {
  Square<D> result{};
  for (std::size_t i = 0; i < D; ++i)
    for (std::size_t k = 0; k < D; ++k)
      for (std::size_t j = 0; j < D; ++j) result[D * i + j] += a[D * i + k] * b[D * k + j];
  return result;
}

template <std::size_t D>
Square<D> transposed(const Square<D>& a) {
  Square<D> result;
  for (std::size_t i = 0; i < D; ++i)
    for (std::size_t j = 0; j < D; ++j) result[D * i + j] = a[D * j + i];
  return result;
}

/// Adds a block of the nodes with these numbers to a matrix of `size` rows.
template <std::size_t D>
void add_to(std::vector<double>& matrix, std::size_t size, std::size_t row, std::size_t column, double factor,
            const Square<D>& block) {
  for (std::size_t i = 0; i < D; ++i)
    for (std::size_t j = 0; j < D; ++j) matrix[(D * row + i) * size + D * column + j] += factor * block[D * i + j];
}

}  // namespace

template <std::size_t D>
double DensePairs<D>::energy(const PairPlaces<D>& places, const std::vector<char>& acts) const {
  const Placed first = first_.at(places.secondary), second = second_.at(places.primary);
  double result = 0;
  for (std::size_t q = 0; q < first.place.size(); ++q) {
    if (acts[first_.points()[q].patch] == 0) continue;
    const Packs<D> place = spread<D>(first.place[q]), area = spread<D>(first.area[q]);
    Pack sum(0.0);
    for (std::size_t k = 0; k < second_.packs(); ++k) {
      const Seen<D> seen(kernel_, place, area, second, k);
      sum += seen.both * seen.w.value;
    }
    result += total(sum);
  }
  return result;
}

template <std::size_t D>
typename DensePairs<D>::Gradient DensePairs<D>::at_points(const Placed& first, const Placed& second,
                                                          const std::vector<char>& acts) const {
  const std::size_t packs = second_.packs();
  std::array<std::vector<Pack>, D> place2, area2;
  for (std::size_t i = 0; i < D; ++i) {
    place2[i].assign(packs, Pack(0.0));
    area2[i].assign(packs, Pack(0.0));
  }
  Gradient result;
  result.place1.assign(first.place.size(), Vec<D>{});
  result.area1 = result.place1;
  for (std::size_t q = 0; q < first.place.size(); ++q) {
    if (acts[first_.points()[q].patch] == 0) continue;
    const Packs<D> place = spread<D>(first.place[q]), area = spread<D>(first.area[q]);
    Packs<D> by_place = spread<D>(Vec<D>{}), by_area = by_place;
    for (std::size_t k = 0; k < packs; ++k) {
      const Seen<D> seen(kernel_, place, area, second, k);
      const Pack slope = seen.both * seen.w.slope;
      for (std::size_t i = 0; i < D; ++i) {
        by_place[i] += slope * seen.d[i];
        place2[i][k] -= slope * seen.d[i];
        by_area[i] += seen.w.value * seen.area[i];
        area2[i][k] += seen.w.value * area[i];
      }
    }
    for (std::size_t i = 0; i < D; ++i) {
      result.place1[q][i] = total(by_place[i]);
      result.area1[q][i] = total(by_area[i]);
    }
  }
  result.place2 = points_of<D>(place2, second.place.size());
  result.area2 = points_of<D>(area2, second.place.size());
  return result;
}

template <std::size_t D>
Vec<D> DensePairs<D>::force(const PairPlaces<D>& places, const std::vector<char>& acts) const {
  const Gradient gradient = at_points(first_.at(places.secondary), second_.at(places.primary), acts);
  Vec<D> result{};
  for (const Vec<D>& own : gradient.place1) result = result - own;
  return result;
}

template <std::size_t D>
std::vector<Vec<D>> DensePairs<D>::gradient(const PairPlaces<D>& places, const std::vector<char>& acts) const {
  const Placed first = first_.at(places.secondary), second = second_.at(places.primary);
  const Gradient gradient = at_points(first, second, acts);
  std::vector<Vec<D>> result = first_.at_nodes(first, gradient.place1, gradient.area1);
  const std::vector<Vec<D>> other = second_.at_nodes(second, gradient.place2, gradient.area2);
  result.insert(result.end(), other.begin(), other.end());
  return result;
}

template <std::size_t D>
void DensePairs<D>::add_own(const SurfaceElements<D>& surface, const Placed& placed, const Sums& sums, double factor,
                            std::size_t start, std::vector<double>& matrix) const {
  const std::size_t size = D * (first_.surface().nodes.size() + second_.surface().nodes.size());
  for (std::size_t q = 0; q < placed.place.size(); ++q) {
    const typename SurfaceElements<D>::Point& point = surface.points()[q];
    const SurfacePatch<D>& patch = surface.surface().patches[point.patch];
    const std::vector<Matrix> slopes = surface.area_slopes(placed, q);
    for (std::size_t a = 0; a < patch.count; ++a)
      for (std::size_t b = 0; b < patch.count; ++b) {
        Matrix block{};
        const Matrix right = product<D>(sums.mixed[q], slopes[b]);
        const Matrix left = transposed<D>(product<D>(sums.mixed[q], slopes[a]));
        for (std::size_t k = 0; k < D * D; ++k)
          block[k] = point.value[a] * (point.value[b] * sums.places[q][k] + right[k]) + point.value[b] * left[k];
        if constexpr (D == 3) {  // the area is bilinear
          const double both = point.slopes[0][a] * point.slopes[1][b] - point.slopes[0][b] * point.slopes[1][a];
          const Matrix turn = cross_matrix(sums.by_area[q]);
          for (std::size_t k = 0; k < D * D; ++k) block[k] -= both * turn[k];
        }
        add_to<D>(matrix, size, start + static_cast<std::size_t>(patch.nodes[a]),
                  start + static_cast<std::size_t>(patch.nodes[b]), factor, block);
      }
  }
}

template <std::size_t D>
void DensePairs<D>::add_hessian(const PairPlaces<D>& places, const std::vector<char>& acts, Tangent kind, double factor,
                                std::vector<double>& matrix) const {
  const Placed first = first_.at(places.secondary), second = second_.at(places.primary);
  const std::size_t start = first_.surface().nodes.size(), size = D * (start + second_.surface().nodes.size());
  Sums sums1(first.place.size()), sums2(second.place.size());
  std::vector<std::vector<Matrix>> slopes2;
  for (std::size_t p = 0; p < second.place.size(); ++p) slopes2.push_back(second_.area_slopes(second, p));
  const std::size_t per_patch = second_.points_of_a_patch();
  std::vector<Matrix> by_place, by_area;  // d2E/dx1 dx_b, d2E/da1 dx_b of the nodes b of a patch
  for (std::size_t q = 0; q < first.place.size(); ++q) {
    const typename SurfaceElements<D>::Point& own = first_.points()[q];
    if (acts[own.patch] == 0) continue;
    const SurfacePatch<D>& patch1 = first_.surface().patches[own.patch];
    const std::vector<Matrix> slopes1 = first_.area_slopes(first, q);
    const Vec<D>&x1 = first.place[q], &a1 = first.area[q];
    for (std::size_t s = 0; s < second_.surface().patches.size(); ++s) {
      const SurfacePatch<D>& patch2 = second_.surface().patches[s];
      by_place.assign(patch2.count, Matrix{});
      by_area.assign(patch2.count, Matrix{});
      for (std::size_t p = s * per_patch; p < (s + 1) * per_patch; ++p) {
        const Vec<D> d = x1 - second.place[p];
        const Vec<D>& a2 = second.area[p];
        const double both = inner(a1, a2), square = inner(d, d);
        const auto w = kernel_.at(square);
        Matrix direct{};
        if (kind == Tangent::Convex) {
          add_outer<D>(std::max(both * (w.slope + w.bend * square), 0.0) / square, d, d, direct);
        } else {
          add_outer<D>(both * w.bend, d, d, direct);
          for (std::size_t i = 0; i < D; ++i) direct[(D + 1) * i] += both * w.slope;
          add_outer<D>(w.slope, d, a2, sums1.mixed[q]);
          add_outer<D>(-w.slope, d, a1, sums2.mixed[p]);
          sums1.by_area[q] = sums1.by_area[q] + w.value * a2;
          sums2.by_area[p] = sums2.by_area[p] + w.value * a1;
        }
        for (std::size_t k = 0; k < D * D; ++k) {
          sums1.places[q][k] += direct[k];
          sums2.places[p][k] += direct[k];
        }
        for (std::size_t b = 0; b < patch2.count; ++b) {
          const double value = second_.points()[p].value[b];
          for (std::size_t k = 0; k < D * D; ++k) by_place[b][k] -= value * direct[k];
          if (kind == Tangent::Convex) continue;
          Vec<D> turned{};  // of a1 . da2
          for (std::size_t i = 0; i < D; ++i)
            for (std::size_t j = 0; j < D; ++j) turned[j] += a1[i] * slopes2[p][b][D * i + j];
          add_outer<D>(w.slope, d, turned, by_place[b]);
          add_outer<D>(-value * w.slope, a2, d, by_area[b]);
          for (std::size_t k = 0; k < D * D; ++k) by_area[b][k] += w.value * slopes2[p][b][k];
        }
      }
      for (std::size_t a = 0; a < patch1.count; ++a)
        for (std::size_t b = 0; b < patch2.count; ++b) {
          Matrix block = product<D>(transposed<D>(slopes1[a]), by_area[b]);
          for (std::size_t k = 0; k < D * D; ++k) block[k] += own.value[a] * by_place[b][k];
          const auto row = static_cast<std::size_t>(patch1.nodes[a]);
          const std::size_t column = start + static_cast<std::size_t>(patch2.nodes[b]);
          add_to<D>(matrix, size, row, column, factor, block);
          add_to<D>(matrix, size, column, row, factor, transposed<D>(block));
        }
    }
  }
  add_own(first_, first, sums1, factor, 0, matrix);
  add_own(second_, second, sums2, factor, start, matrix);
}

template class DensePairs<2>;
template class DensePairs<3>;

}  // namespace ixos
