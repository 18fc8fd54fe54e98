// The middles of edges on a smooth surface through nodes.
#include "geometry/edge_middles.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace ixos {
namespace {

/// A grid of n by n squares of side 1/n, cut into triangles or not, and shifted so that no square is one.
struct Grid {
  int n;
  std::vector<EdgeMiddles::Face> faces;
  std::vector<Vec<3>> x;

  Grid(int count, bool cut) : n(count) {
    const auto node = [this](int i, int j) { return i + (n + 1) * j; };
    for (int j = 0; j <= n; ++j)
      for (int i = 0; i <= n; ++i)
        x.push_back({(i + 0.2 * std::sin(3.0 * j)) / n, (j + 0.15 * std::cos(2.0 * i)) / n, 0});
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) {
        const int a = node(i, j), b = node(i + 1, j), c = node(i + 1, j + 1), d = node(i, j + 1);
        if (!cut || (i + j) % 3 == 0) {
          faces.push_back({a, b, c, d});
        } else if ((i + j) % 3 == 1) {
          faces.insert(faces.end(), {{a, b, c}, {a, c, d}});
        } else {
          faces.insert(faces.end(), {{a, b, d}, {b, c, d}});
        }
      }
  }
};

Vec<3> place(const NodeWeights& weights, const std::vector<Vec<3>>& x) {
  Vec<3> sum{};
  for (std::size_t k = 0; k < weights.nodes.size(); ++k)
    sum = sum + weights.weights[k] * x[static_cast<std::size_t>(weights.nodes[k])];
  return sum;
}

/// A flat surface that is bent to a quadratic function of its coordinates has the middles of that, also beside its rim,
/// where the curves along the rim are parabolas or pieces of them.
TEST(EdgeMiddlesTest, QuadraticMotionsOfAFlatSurfaceComeBack) {
  for (const bool cut : {false, true}) {
    const Grid grid(6, cut);
    const EdgeMiddles middles(grid.faces, grid.x);
    const auto bent = [](const Vec<3>& x) -> Vec<3> {
      return {x[0] + 0.3 * x[0] * x[1], 2 * x[1] - x[0] * x[0], 0.7 * x[0] * x[0] - 0.4 * x[0] * x[1] + x[1] * x[1]};
    };
    std::vector<Vec<3>> y;
    for (const Vec<3>& x : grid.x) y.push_back(bent(x));
    int inner_edges = 0;
    for (const EdgeMiddles::Face& face : grid.faces)
      for (std::size_t k = 0; k < face.size(); ++k) {
        const int a = face[k], b = face[(k + 1) % face.size()];
        const auto is_rim = [&](int node) {
          const int i = node % (grid.n + 1), j = node / (grid.n + 1);
          return i == 0 || i == grid.n || j == 0 || j == grid.n;
        };
        if (is_rim(a) && is_rim(b)) continue;  // nodes of the rim are not on one line
        ++inner_edges;
        const Vec<3> middle = 0.5 * (grid.x[static_cast<std::size_t>(a)] + grid.x[static_cast<std::size_t>(b)]);
        EXPECT_LT(length(place(middles.middle(a, b), grid.x) - middle), 1e-13) << "flat";
        EXPECT_LT(length(place(middles.middle(a, b), y) - bent(middle)), 1e-12);
      }
    EXPECT_GT(inner_edges, 100);
  }
}

/// Weights do not change with the unit, or when the surface is turned and moved.
TEST(EdgeMiddlesTest, UnitsAndRotationsDoNotMatter) {
  Grid grid(4, true);
  for (Vec<3>& x : grid.x) x[2] = 0.2 * x[0] * x[0] - 0.1 * x[1];
  Grid turned = grid;
  const double c = std::cos(0.7), s = std::sin(0.7);
  for (Vec<3>& x : turned.x) x = {1e-9 * (c * x[0] - s * x[2]) + 5e-9, 1e-9 * x[1], 1e-9 * (s * x[0] + c * x[2])};
  const EdgeMiddles here(grid.faces, grid.x), there(turned.faces, turned.x);
  for (const EdgeMiddles::Face& face : grid.faces) {
    const NodeWeights own = here.middle(face[0], face[1]), other = there.middle(face[0], face[1]);
    double sum = 0;
    ASSERT_EQ(own.nodes.size(), other.nodes.size());
    for (const int node : own.nodes) {
      EXPECT_NEAR(own.weight(node), other.weight(node), 1e-9);
      sum += own.weight(node);
    }
    EXPECT_NEAR(sum, 1, 1e-13);
  }
}

/// Two flat halves that meet in a sharp edge stay flat, and the edge straight.
TEST(EdgeMiddlesTest, CreasesStay) {
  Grid grid(6, true);
  for (Vec<3>& x : grid.x) x[0] = std::round(6 * x[0]) / 6;  // its lines along y are straight
  for (Vec<3>& x : grid.x)
    if (x[0] > 0.5) x = {0.5, x[1], x[0] - 0.5};
  const EdgeMiddles middles(grid.faces, grid.x);
  for (const EdgeMiddles::Face& face : grid.faces)
    for (std::size_t k = 0; k < face.size(); ++k) {
      const Vec<3> middle = place(middles.middle(face[k], face[(k + 1) % face.size()]), grid.x);
      EXPECT_NEAR(std::min(std::abs(middle[2]), std::abs(middle[0] - 0.5)), 0, 1e-13);
    }
}

}  // namespace
}  // namespace ixos
