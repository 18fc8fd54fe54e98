#include "fem/pyramid_functions.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ixos {

PyramidFunctions::PyramidFunctions(const std::array<double, 3>& xi) {
  const double x = xi[0], y = xi[1], z = xi[2];
  const double s = 1 - z;
  // At the apex, where p and q have no limit, every function's value and gradient does, with p = q = 0.
  const double p = s == 0 ? 0 : x / s, q = s == 0 ? 0 : y / s;
  std::size_t k = 0;
  const auto add = [&](double f, double dx, double dy, double dz) {
    value[k] = f;
    gradient[k++] = {dx, dy, dz};
  };
  add(1, 0, 0, 0);
  add(x, 1, 0, 0);
  add(y, 0, 1, 0);
  add(z, 0, 0, 1);
  add(x * x, 2 * x, 0, 0);
  add(x * y, y, x, 0);
  add(y * y, 0, 2 * y, 0);
  add(x * z, z, 0, x);
  add(y * z, 0, z, y);
  add(z * z, 0, 0, 2 * z);
  const double r = p * y;
  add(r, q, p, p * q);
  add(r * x, q * x + r, p * x, p * q * x);
  add(r * y, q * y, p * y + r, p * q * y);
  add(r * r, 2 * r * q, 2 * r * p, 2 * r * p * q);
  // With a = alpha s and b = beta s: z s^2 (1 - beta^2)(1 + sign alpha).
  const auto add_face = [&](bool along_x, double sign) {
    const double alpha = along_x ? p : q, beta = along_x ? q : p, b = along_x ? y : x;
    const double by_a = sign * z * s * (1 - beta * beta), by_b = -2 * z * b * (1 + sign * alpha);
    const double f = s * s * (1 - beta * beta) * (1 + sign * alpha);
    const double by_z = f - z * (2 * s * (1 + sign * alpha) - sign * s * (1 - beta * beta) * alpha);
    add(z * f, along_x ? by_a : by_b, along_x ? by_b : by_a, by_z);
  };
  add_face(false, -1);  // the triangle at y = -(1 - z): the function vanishes on the one opposite
  add_face(true, 1);
  add_face(false, 1);
  add_face(true, -1);
  const double across = (1 - p * p) * (1 - q * q);
  add(z * s * s * across, -2 * z * x * (1 - q * q), -2 * z * y * (1 - p * p),
      s * s * across - 2 * z * s * (1 - p * p * q * q));
}

/// Gauss-Jordan elimination with pivots, in extended precision.
template <std::size_t Count>
std::array<std::array<double, Count>, Count> pyramid_coefficients(
    const std::array<std::array<double, 3>, Count>& nodes) {
  std::array<std::array<long double, 2 * Count>, Count> rows{};  // functions at the nodes, by function; then unity
  for (std::size_t a = 0; a < Count; ++a) {
    const PyramidFunctions here(nodes[a]);
    for (std::size_t k = 0; k < Count; ++k) rows[k][a] = here.value[k];
    rows[a][Count + a] = 1;
  }
  for (std::size_t c = 0; c < Count; ++c) {
    std::size_t pivot = c;
    for (std::size_t k = c + 1; k < Count; ++k)
      if (std::abs(rows[k][c]) > std::abs(rows[pivot][c])) pivot = k;
    std::swap(rows[c], rows[pivot]);
    const long double scale = 1 / rows[c][c];
    for (long double& entry : rows[c]) entry *= scale;
    for (std::size_t k = 0; k < Count; ++k) {
      if (k == c) continue;
      const long double factor = rows[k][c];
      for (std::size_t j = 0; j < 2 * Count; ++j) rows[k][j] -= factor * rows[c][j];
    }
  }
  std::array<std::array<double, Count>, Count> result;
  for (std::size_t a = 0; a < Count; ++a)
    for (std::size_t k = 0; k < Count; ++k) result[a][k] = static_cast<double>(rows[a][Count + k]);
  return result;
}

template std::array<std::array<double, 14>, 14> pyramid_coefficients(const std::array<std::array<double, 3>, 14>&);
template std::array<std::array<double, 19>, 19> pyramid_coefficients(const std::array<std::array<double, 3>, 19>&);

}  // namespace ixos
