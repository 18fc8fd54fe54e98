#include "geometry/curve_patches.hpp"

namespace ixos {
namespace {

/// Adds factor * polynomial to the coefficients.
void add(Cubic& sum, double factor, const Cubic& polynomial) {
  for (std::size_t k = 0; k < 4; ++k) sum[k] += factor * polynomial[k];
}

/// Returns the patch of N places, in an order that begins with the ends, and their weights; negative nodes are left
/// out.
template <std::size_t N>
SurfacePatch<2> cubic_patch(const std::array<int, N>& nodes, const std::array<std::size_t, N>& order,
                            const std::array<Cubic, N>& by_place, const std::array<bool, 2>& smooth) {
  SurfacePatch<2> patch;
  patch.degree = 3;
  std::vector<double> functions;
  for (const std::size_t place : order) {
    if (nodes[place] < 0) continue;
    patch.nodes[patch.count++] = nodes[place];
    functions.insert(functions.end(), by_place[place].begin(), by_place[place].end());
  }
  patch.set_functions(functions);
  patch.smooth = smooth;
  return patch;
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
  return cubic_patch<4>(nodes, {1, 2, 0, 3}, by_place, {nodes[0] >= 0, nodes[3] >= 0});
}

SurfacePatch<2> spline_patch(const std::array<int, 6>& nodes) {
  // The control points 1 to 4, by place of the nodes.
  using Control = std::array<double, 6>;
  std::array<Control, 4> controls{};
  const auto exists = [&](std::size_t place) { return nodes[place] >= 0; };
  for (std::size_t place = 1; place < 5; ++place) {
    Control& control = controls[place - 1];
    const bool inner = exists(place - 1) && exists(place + 1);
    control[place] = inner ? 4.0 / 3 : 1;
    if (inner) control[place - 1] = control[place + 1] = -1.0 / 6;
  }
  // Beyond an end the control polygon goes straight on.
  for (std::size_t k = 0; k < 6; ++k) {
    if (!exists(1)) controls[0][k] = 2 * controls[1][k] - controls[2][k];
    if (!exists(4)) controls[3][k] = 2 * controls[2][k] - controls[1][k];
  }
  constexpr std::array<Cubic, 4> functions{{{1, -3, 3, -1}, {4, 0, -6, 3}, {1, 3, 3, -3}, {0, 0, 0, 1}}};
  std::array<Cubic, 6> by_place{};
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t k = 0; k < 6; ++k) add(by_place[k], controls[i][k] / 6, functions[i]);
  return cubic_patch<6>(nodes, {2, 3, 1, 4, 0, 5}, by_place, {exists(1), exists(4)});
}

}  // namespace ixos
