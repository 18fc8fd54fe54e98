#include "rule/row.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ixos {
namespace {

Row single(std::size_t state, const Row::Known& coefficients) {
  Row row;
  row.known.resize(state + 1);
  row.known[state] = coefficients;
  return row;
}

}  // namespace

Row unknown_displacement() { return {1.0, {}}; }
Row displacement(std::size_t state) { return single(state, {1, 0, 0}); }
Row velocity(std::size_t state) { return single(state, {0, 1, 0}); }
Row acceleration(std::size_t state) { return single(state, {0, 0, 1}); }

Row operator+(Row left, const Row& right) {
  left.unknown += right.unknown;
  if (left.known.size() < right.known.size()) left.known.resize(right.known.size());
  for (std::size_t j = 0; j < right.known.size(); ++j) {
    left.known[j].u += right.known[j].u;
    left.known[j].v += right.known[j].v;
    left.known[j].a += right.known[j].a;
  }
  return left;
}

Row operator-(Row left, const Row& right) { return std::move(left) + (-1.0) * right; }

Row operator*(double factor, Row row) {
  row.unknown *= factor;
  for (Row::Known& k : row.known) k = {factor * k.u, factor * k.v, factor * k.a};
  return row;
}

Row operator/(Row row, double divisor) { return (1 / divisor) * std::move(row); }

double Row::magnitude() const {
  double largest = std::abs(unknown);
  for (const Known& k : known) largest = std::max({largest, std::abs(k.u), std::abs(k.v), std::abs(k.a)});
  return largest;
}

double Row::on_monomial(int degree, double c, const std::vector<double>& known_times) const {
  const auto u = [degree](double t) { return degree == 0 ? 1.0 : std::pow(t, degree); };
  const auto v = [degree](double t) { return degree == 0 ? 0.0 : degree == 1 ? 1.0 : 2 * t; };
  const double a = degree == 2 ? 2.0 : 0.0;
  double sum = unknown * u(c);
  for (std::size_t j = 0; j < known.size(); ++j)
    sum += known[j].u * u(known_times[j]) + known[j].v * v(known_times[j]) + known[j].a * a;
  return sum;
}

}  // namespace ixos
