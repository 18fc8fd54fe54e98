#include "interaction/curve_patches.hpp"

namespace ixos {
namespace {

/// Adds factor * polynomial to the coefficients.
void add(Cubic& sum, double factor, const Cubic& polynomial) {
  for (std::size_t k = 0; k < 4; ++k) sum[k] += factor * polynomial[k];
}

}  // namespace

SurfacePatch<2> straight_patch(int a, int b) {
  SurfacePatch<2> patch;
  patch.nodes = {a, b};
  patch.count = 2;
  patch.set_functions({1, -1, 0, 1});
  return patch;
}

std::array<double, 3> parabola_slope(double before, double after) {
  const double back = after / (before * (before + after)), ahead = before / (after * (before + after));
  return {-back, back - ahead, ahead};
}

SurfacePatch<2> smooth_patch(const std::array<int, 4>& nodes, const std::array<double, 3>& lengths) {
  // By place 0 to 3 along the curve.
  std::array<Cubic, 4> by_place{};
  add(by_place[1], 1, start_value);
  add(by_place[2], 1, end_value);
  const double own = lengths[1];
  const auto add_tangent = [&](const Cubic& tangent, std::size_t before, double l0, double l1) {
    const std::array<double, 3> slope = parabola_slope(l0, l1);
    for (std::size_t k = 0; k < 3; ++k) add(by_place[before + k], own * slope[k], tangent);
  };
  const auto add_chord = [&](const Cubic& tangent) {
    add(by_place[1], -1, tangent);
    add(by_place[2], 1, tangent);
  };
  if (nodes[0] >= 0)
    add_tangent(start_slope, 0, lengths[0], own);
  else
    add_chord(start_slope);
  if (nodes[3] >= 0)
    add_tangent(end_slope, 1, own, lengths[2]);
  else
    add_chord(end_slope);
  SurfacePatch<2> patch;
  patch.degree = 3;
  std::vector<double> functions;
  for (const std::size_t place : {1U, 2U, 0U, 3U}) {
    if (nodes[place] < 0) continue;
    patch.nodes[patch.count++] = nodes[place];
    for (const double coefficient : by_place[place]) functions.push_back(coefficient);
  }
  patch.set_functions(functions);
  patch.smooth = {nodes[0] >= 0, nodes[3] >= 0};
  return patch;
}

}  // namespace ixos
