#include "term/lagrange_patches.hpp"

#include <stdexcept>

#include "fem/contact_elements.hpp"
#include "fem/contact_hexahedra.hpp"

namespace ixos {
namespace {

/// Returns, by node of the edge, the coefficients of its polynomial on [0, 1] by power.
template <int Order>
std::vector<std::vector<double>> edge_polynomials() {
  using Edge = LagrangeEdge<Order>;
  std::vector<std::vector<double>> result;
  const auto place = [](std::size_t a) { return (1 + Edge::node(a)) / 2; };
  for (std::size_t a = 0; a < Edge::nodes; ++a) {
    std::vector<double> polynomial{1};  // the product of (t - t_b)/(t_a - t_b)
    for (std::size_t b = 0; b < Edge::nodes; ++b) {
      if (b == a) continue;
      const double span = place(a) - place(b);
      std::vector<double> next(polynomial.size() + 1, 0.0);
      for (std::size_t k = 0; k < polynomial.size(); ++k) {
        next[k] -= polynomial[k] * place(b) / span;
        next[k + 1] += polynomial[k] / span;
      }
      polynomial = std::move(next);
    }
    result.push_back(polynomial);
  }
  return result;
}

template <std::size_t D, int Order>
SurfacePatch<D> patch_of(const std::vector<int>& nodes) {
  static const std::vector<std::vector<double>> polynomials = edge_polynomials<Order>();
  SurfacePatch<D> patch;
  patch.degree = Order;
  patch.count = nodes.size();
  std::copy(nodes.begin(), nodes.end(), patch.nodes.begin());
  for (std::size_t a = 0; a < nodes.size(); ++a) {
    if constexpr (D == 2) {
      patch.coefficients.insert(patch.coefficients.end(), polynomials[a].begin(), polynomials[a].end());
    } else {
      const auto [i, j] = LagrangeFace<Order>::factors(a);
      for (const double by_second : polynomials[j])
        for (const double by_first : polynomials[i]) patch.coefficients.push_back(by_first * by_second);
    }
  }
  return patch;
}

}  // namespace

template <std::size_t D>
SurfacePatch<D> lagrange_patch(const std::vector<int>& nodes) {
  for (const int order : {2, 3, 4}) {
    const auto along = static_cast<std::size_t>(order) + 1;
    if (nodes.size() != (D == 2 ? along : along * along)) continue;
    if (order == 2) return patch_of<D, 2>(nodes);
    if (order == 3) return patch_of<D, 3>(nodes);
    return patch_of<D, 4>(nodes);
  }
  throw std::logic_error("no side has that number of nodes");
}

template SurfacePatch<2> lagrange_patch<2>(const std::vector<int>&);
template SurfacePatch<3> lagrange_patch<3>(const std::vector<int>&);

}  // namespace ixos
