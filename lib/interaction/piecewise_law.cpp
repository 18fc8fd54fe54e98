#include "interaction/piecewise_law.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "fem/quadrature.hpp"

namespace ixos {
namespace {

/// Returns minus the mean traction of a piece's polynomial over gaps from a to r, (psi(r) - psi(a))/(r - a), by
/// Simpson's rule, which is exact.
double energy_slope(const TractionPiece& piece, double a, double r) {
  return -(piece.traction(a) + 4 * piece.traction((a + r) / 2) + piece.traction(r)) / 6;
}

}  // namespace

void add_mean_potential(const TractionPiece& piece, double level, double e0, double r0, double from, double to,
                        double& sum) {
  if (from == to) return;
  constexpr int points = 12;
  static const Quadrature gauss = gauss_legendre_unit(points);
  const double way = to - from;
  if (std::abs(from - r0) < std::abs(way)) {
    // The polynomial's own quotient is a cubic polynomial. The difference of its energy at r0 from e0 gives a
    // logarithm.
    sum += way / 2 *
           (energy_slope(piece, r0, from + detail::low * way) + energy_slope(piece, r0, from + detail::high * way));
    if (from != r0) sum += (level + piece.energy(r0) - e0) * std::log((to - r0) / (from - r0));
    return;
  }
  for (std::size_t q = 0; q < gauss.points.size(); ++q) {
    const double r = from + gauss.points[q] * way;
    sum += gauss.weights[q] * way * (level + piece.energy(r) - e0) / (r - r0);
  }
}

PiecewiseLaw::PiecewiseLaw(std::vector<TractionPiece> pieces, double equilibrium_gap, double adhesion_gap)
    : pieces_(std::move(pieces)),
      energy_(pieces_.size()),
      equilibrium_gap_(equilibrium_gap),
      adhesion_gap_(adhesion_gap) {
  double energy = 0;  // at the end of piece i
  for (std::size_t i = pieces_.size(); i-- > 0;) {
    energy_[i] = energy - pieces_[i].energy(pieces_[i].end);
    if (i > 0) energy = energy_[i] + pieces_[i].energy(start(i));
  }
  // A continuous traction that is positive somewhere is so at the start of a piece, or in front of the first end.
  repels_ = traction(pieces_.front().end - 1) > 0;
  for (std::size_t i = 1; i < pieces_.size(); ++i) repels_ = repels_ || pieces_[i].traction(start(i)) > 0;
}

double PiecewiseLaw::start(std::size_t i) const {
  return i == 0 ? -std::numeric_limits<double>::infinity() : pieces_[i - 1].end;
}

// The integral of (psi(r) - psi(r0))/(r - r0) from r0 to r1, one piece after the other.
double PiecewiseLaw::potential(double r0, double r1) const {
  const double at_start = energy(r0);
  double sum = 0;
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    const PathPart<double> part = part_of(i, r0, r1);
    add_mean_potential(pieces_[i], energy_[i], at_start, r0, part.from, part.to, sum);
  }
  // Beyond the range.
  const double from = std::max(r0, range()), to = std::max(r1, range());
  if (at_start != 0 && from != to) sum -= at_start * std::log((to - r0) / (from - r0));
  return sum;
}

PiecewiseLaw constant_attraction(double strength, double range, double ramp) {
  const double end = range + ramp, width = 2 * ramp;
  // With u = -x/width, x from the end: S = u^2 (3 - 2 u).
  const TractionPiece flat{range - ramp, range - ramp, {-strength, 0, 0, 0}};
  const TractionPiece fall{end, end, {0, 0, -3 * strength / (width * width), -2 * strength / (width * width * width)}};
  return {{flat, fall}, range, range - ramp};
}

}  // namespace ixos
