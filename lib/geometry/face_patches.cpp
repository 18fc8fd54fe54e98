#include "geometry/face_patches.hpp"

#include <algorithm>
#include <stdexcept>

#include "geometry/curve_patches.hpp"

namespace ixos {
namespace {

/// The corners' parameters, 0 or 1, counter-clockwise.
constexpr std::array<std::array<std::size_t, 2>, 4> places{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};

using Powers = std::array<double, 16>;

/// The patch's nodes and polynomials while contributions are added.
struct Sum {
  std::vector<int> nodes;
  std::vector<Powers> polynomials;

  void add(int node, double factor, const Cubic& first, const Cubic& second) {
    auto found = std::find(nodes.begin(), nodes.end(), node);
    if (found == nodes.end()) {
      nodes.push_back(node);
      polynomials.push_back({});
      found = nodes.end() - 1;
    }
    Powers& polynomial = polynomials[static_cast<std::size_t>(found - nodes.begin())];
    for (std::size_t j = 0; j < 4; ++j)
      for (std::size_t i = 0; i < 4; ++i) polynomial[4 * j + i] += factor * first[i] * second[j];
  }
  void add(const NodeWeights& value, double factor, const Cubic& first, const Cubic& second) {
    for (std::size_t k = 0; k < value.nodes.size(); ++k) add(value.nodes[k], factor * value.weights[k], first, second);
  }
  SurfacePatch<3> patch() const {
    if (nodes.size() > SurfacePatch<3>::most) throw std::length_error("a patch has too many nodes");
    SurfacePatch<3> result;
    result.degree = 3;
    result.count = nodes.size();
    std::copy(nodes.begin(), nodes.end(), result.nodes.begin());
    std::vector<double> functions;
    for (const Powers& polynomial : polynomials)
      functions.insert(functions.end(), polynomial.begin(), polynomial.end());
    result.set_functions(functions);
    return result;
  }
};

}  // namespace

void NodeWeights::add(int node, double weight) {
  const auto found = std::find(nodes.begin(), nodes.end(), node);
  if (found != nodes.end()) {
    weights[static_cast<std::size_t>(found - nodes.begin())] += weight;
    return;
  }
  nodes.push_back(node);
  weights.push_back(weight);
}

void NodeWeights::add(const NodeWeights& own, double factor) {
  for (std::size_t k = 0; k < own.nodes.size(); ++k) add(own.nodes[k], factor * own.weights[k]);
}

double NodeWeights::weight(int node) const {
  const auto found = std::find(nodes.begin(), nodes.end(), node);
  return found == nodes.end() ? 0 : weights[static_cast<std::size_t>(found - nodes.begin())];
}

SurfacePatch<3> bilinear_patch(const std::array<int, 4>& corners) {
  SurfacePatch<3> patch;
  patch.count = 4;
  std::copy(corners.begin(), corners.end(), patch.nodes.begin());
  std::vector<double> functions;
  for (const auto& place : places) {
    const std::array<double, 2> a{place[0] == 0 ? 1.0 : 0.0, place[0] == 0 ? -1.0 : 1.0},
        b{place[1] == 0 ? 1.0 : 0.0, place[1] == 0 ? -1.0 : 1.0};
    for (const double by_second : b)
      for (const double by_first : a) functions.push_back(by_first * by_second);
  }
  patch.set_functions(functions);
  return patch;
}

SurfacePatch<3> bicubic_patch(const std::array<int, 4>& corners, const std::array<CornerDerivatives, 4>& derivatives,
                              const std::array<double, 2>& lengths) {
  constexpr std::array<Cubic, 2> values{start_value, end_value}, slopes{start_slope, end_slope};
  Sum sum;
  for (const int corner : corners) sum.add(corner, 0, start_value, start_value);  // they come first
  for (std::size_t c = 0; c < 4; ++c) {
    const std::size_t i = places[c][0], j = places[c][1];
    sum.add(corners[c], 1, values[i], values[j]);
    sum.add(derivatives[c].first, lengths[0], slopes[i], values[j]);
    sum.add(derivatives[c].second, lengths[1], values[i], slopes[j]);
    sum.add(derivatives[c].mixed, lengths[0] * lengths[1], slopes[i], slopes[j]);
  }
  return sum.patch();
}

SurfacePatch<3> bezier_patch(const std::array<int, 4>& corners, const std::array<NodeWeights, 16>& controls) {
  constexpr std::array<Cubic, 4> bernstein{{{1, -3, 3, -1}, {0, 3, -6, 3}, {0, 0, 3, -3}, {0, 0, 0, 1}}};
  Sum sum;
  for (const int corner : corners) sum.add(corner, 0, start_value, start_value);  // they come first
  for (std::size_t j = 0; j < 4; ++j)
    for (std::size_t i = 0; i < 4; ++i) sum.add(controls[4 * j + i], 1, bernstein[i], bernstein[j]);
  return sum.patch();
}

}  // namespace ixos
