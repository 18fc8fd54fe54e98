/// A piece of a surface whose places are polynomials, linear in the places of its nodes.
#pragma once
#include <array>
#include <boost/container/static_vector.hpp>
#include <cstddef>
#include <vector>

#include "base/vec.hpp"

namespace ixos {

/// The parameters of a patch, each in [0, 1]: one in the plane, two in space.
template <std::size_t D>
using PatchParameters = std::array<double, D - 1>;

/// Returns the number of second derivatives of `parameters` parameters, and the place of the one by k and l.
constexpr std::size_t second_derivatives(std::size_t parameters) { return parameters * (parameters + 1) / 2; }
constexpr std::size_t second_derivative(std::size_t k, std::size_t l) { return k + l; }

/// A patch at places of its nodes: x(xi) = sum_j c_j xi^j, tensor powers of the parameters up to `degree` each, those
/// of the first parameter fastest [L0].
template <std::size_t D>
struct PlacedPatch {
  static constexpr std::size_t parameters = D - 1;
  static constexpr std::size_t most = D == 2 ? 5 : 25;  ///< powers, for degree 4
  /// A place with its derivatives by the parameters, the second ones as second_derivative() says.
  struct Frame {
    Vec<D> place{};
    std::array<Vec<D>, parameters> tangents{};
    std::array<Vec<D>, second_derivatives(parameters)> bends{};
  };

  int degree = 1;
  std::array<Vec<D>, most> coefficients{};

  Vec<D> at(const PatchParameters<D>& xi) const;
  Frame frame(const PatchParameters<D>& xi) const;
  /// Returns the outward unit normal.
  Vec<D> normal(const PatchParameters<D>& xi) const { return normal(frame(xi)); }
  static Vec<D> normal(const Frame& frame);
  /// Returns points whose convex hull contains the patch, Bernstein's.
  boost::container::static_vector<Vec<D>, most> hull() const;
};

/// A patch x(xi) = sum_a N_a(xi) x_a whose weights N_a are polynomials that sum to 1. In the plane its body is on the
/// left of the direction of growing xi. In space the tangents by the first and the second parameter and the outward
/// normal are right-handed.
template <std::size_t D>
struct SurfacePatch {
  static constexpr std::size_t parameters = D - 1;
  static constexpr std::size_t most = D == 2 ? 6 : 42;  ///< nodes
  static constexpr std::size_t sides = 2 * parameters;  ///< side 2k: parameter k is 0, side 2k + 1: it is 1
  static constexpr std::size_t corners = D == 2 ? 2 : 4;
  /// The nodes, by their numbers in the surface and ascending, whose mean a corner is in a flat side.
  using Corner = boost::container::static_vector<int, 4>;
  using Weights = std::array<double, most>;
  using Points = std::array<Vec<D>, most>;
  /// The weights with their derivatives by the parameters.
  struct Shape {
    Weights value{};
    std::array<Weights, parameters> slopes{};
  };

  std::array<int, most> nodes{};  ///< the first `count` count
  std::size_t count = 0;
  std::size_t side_corners =
      corners;  ///< the first nodes: corners of the cell's side of which the patch is all, or part
  std::vector<Corner> split_corners;  ///< of a part of a side; of a whole side empty, its corners are the first nodes
  int degree = 1;                     ///< of the weights in each parameter, at most 4
  std::vector<double> coefficients;   ///< by power, as in PlacedPatch, and node
  /// By side: true if the next patch has the same tangent plane at the whole side, false at a kink or a free rim.
  std::array<bool, sides> smooth{};
  /// By side: the patch beyond it; -1 at a free rim.
  std::array<int, sides> neighbours{};

  /// Returns a corner; they go around the patch. It tells the corner from others of the surface.
  Corner corner(std::size_t number) const {
    return split_corners.empty() ? Corner{nodes[number]} : split_corners[number];
  }
  std::size_t powers() const { return coefficients.size() / count; }
  /// Sets the coefficients from those by node and power, once the nodes are set.
  void set_functions(const std::vector<double>& by_node);
  Weights weights(const PatchParameters<D>& xi) const;
  Shape shape(const PatchParameters<D>& xi) const;
  /// Returns a bound on the sum of |N_a| at a point of the patch: no point moves by more than this times the largest
  /// displacement of a node. It is the largest sum of the weights' Bernstein coefficients.
  double amplification() const;
  /// Returns the patch's own nodes' vectors from those of its surface.
  Points among(const std::vector<Vec<D>>& x) const;
  /// Returns the patch at places of its nodes, in their order.
  PlacedPatch<D> placed(const Points& x) const;
};

extern template struct PlacedPatch<2>;
extern template struct PlacedPatch<3>;
extern template struct SurfacePatch<2>;
extern template struct SurfacePatch<3>;

}  // namespace ixos
