#include "term/pair/patch_slip.hpp"

#include <boost/container/static_vector.hpp>
#include <cmath>

#include "base/vector3.hpp"
#include "fem/quadrature.hpp"
#include "geometry/pair_gap.hpp"

namespace ixos {
namespace {

/// By node of a patch.
template <std::size_t D>
using Turns = boost::container::static_vector<Small<double, D>, SurfacePatch<D>::most>;

/// Returns a turned by a right angle.
Vec<2> across(const Vec<2>& a) { return {-a[1], a[0]}; }

/// Returns, by node of a patch, the derivative of -g w x n by its displacement, with the rotation w of the patch at the
/// closest point.
Turns<2> turns(const SurfacePatch<2>& patch, const SurfaceProjection<2>& projection) {
  const auto slopes = patch.shape(projection.xi).slopes;
  const Vec<2>& x = projection.frame.tangents[0];
  const Vec<2> way = -projection.gap / inner(x, x) * across(projection.normal), along = across(x);
  Turns<2> result(patch.count);
  for (std::size_t a = 0; a < patch.count; ++a)
    for (std::size_t i = 0; i < 2; ++i) result[a][i] = slopes[0][a] * way[i] * along;
  return result;
}

/// Returns P = I - n n^T.
template <std::size_t D>
Small<double, D> plane_across(const Vec<D>& n) {
  Small<double, D> plane;
  for (std::size_t i = 0; i < D; ++i)
    for (std::size_t j = 0; j < D; ++j) plane[i][j] = (i == j ? 1.0 : 0.0) - n[i] * n[j];
  return plane;
}

Vec<3> times(const Small<double, 3>& m, const Vec<3>& x) { return {inner(m[0], x), inner(m[1], x), inner(m[2], x)}; }

/// The points on the straight path at which the mean takes a derivative: it is a quadratic function of the change.
const Quadrature& path_points() {
  static const Quadrature gauss = gauss_legendre_unit(2);
  return gauss;
}

}  // namespace

void PatchSlip<2>::set(const SurfacePatch<2>::Weights& weights, std::size_t count, const Vec<2>& /*place*/,
                       const SurfacePatch<2>& patch, const SurfaceProjection<2>& projection) {
  plane_ = plane_across<2>(projection.normal);
  slips_.clear();
  const auto add = [&](double weight, Small<double, 2> slip) {
    for (std::size_t i = 0; i < 2; ++i) slip[i] = slip[i] + weight * plane_[i];
    slips_.push_back(slip);
  };
  for (std::size_t a = 0; a < count; ++a) add(weights[a], {});
  const auto of_projection = patch.weights(projection.xi);
  const auto turned = turns(patch, projection);
  for (std::size_t a = 0; a < patch.count; ++a) add(-of_projection[a], turned[a]);
}

PatchSlip<2>::Motion PatchSlip<2>::motion(const std::vector<int>& nodes, const double* u) const {
  Motion result{};
  for (std::size_t a = 0; a < nodes.size(); ++a) {
    const double* const own = u + 2 * static_cast<std::size_t>(nodes[a]);
    for (std::size_t i = 0; i < 2; ++i)
      for (std::size_t j = 0; j < 2; ++j) result[i] += slips_[a][i][j] * own[j];
  }
  return result;
}

void PatchSlip<2>::add_force(const std::vector<int>& nodes, double factor, const Motion& traction, double* f) const {
  const Vec<2> force = factor * traction;
  for (std::size_t a = 0; a < nodes.size(); ++a) {
    double* const at = f + 2 * static_cast<std::size_t>(nodes[a]);
    for (std::size_t i = 0; i < 2; ++i)
      for (std::size_t j = 0; j < 2; ++j) at[j] += slips_[a][i][j] * force[i];
  }
}

/// With the slip's derivatives B_a by node, the matrix is B_a^T C B_b.
void PatchSlip<2>::add_stiffness(double factor, const Moduli& moduli, std::vector<double>& k) const {
  const std::size_t count = slips_.size(), rows = 2 * count;
  boost::container::static_vector<Small<double, 2>, PairGap<2>::most> forces(count);
  for (std::size_t a = 0; a < count; ++a)
    for (std::size_t i = 0; i < 2; ++i)
      for (std::size_t l = 0; l < 2; ++l) forces[a][i] = forces[a][i] + factor * moduli[i][l] * slips_[a][l];
  for (std::size_t r = 0; r < rows; ++r)
    for (std::size_t c = 0; c < rows; ++c) {
      double sum = 0;
      for (std::size_t l = 0; l < 2; ++l) sum += slips_[r / 2][l][r % 2] * forces[c / 2][l][c % 2];
      k[r * rows + c] += sum;
    }
}

double PatchSlip<2>::squares(const std::vector<int>& nodes, const double* u) const {
  double square = 0;
  for (std::size_t a = 0; a < nodes.size(); ++a) {
    const double* const own = u + 2 * static_cast<std::size_t>(nodes[a]);
    for (std::size_t i = 0; i < 2; ++i)
      for (std::size_t j = 0; j < 2; ++j) square += std::pow(slips_[a][i][j] * own[j], 2);
  }
  return square;
}

void PatchSlip<3>::set(const SurfacePatch<3>::Weights& weights, std::size_t count, const Vec<3>& place,
                       const SurfacePatch<3>& patch, const SurfaceProjection<3>& projection) {
  plane_ = plane_across<3>(projection.normal);
  const auto shape = patch.shape(projection.xi);
  weights_.clear();
  for (std::size_t a = 0; a < count; ++a) weights_.push_back({weights[a], 0, 0});
  for (std::size_t a = 0; a < patch.count; ++a)
    weights_.push_back({-shape.value[a], shape.slopes[0][a], shape.slopes[1][a]});

  const Vec<3>&x = projection.frame.tangents[0], &y = projection.frame.tangents[1];
  const Vec<3> r = place - projection.frame.place, m = PlacedPatch<3>::normal(projection.frame);
  for (std::size_t i = 0; i < 3; ++i) {
    start_[i] = r[i];
    start_[3 + i] = x[i];
    start_[6 + i] = y[i];
  }
  const double xx = inner(x, x), xy = inner(x, y), yy = inner(y, y), det = xx * yy - xy * xy;
  const std::array<Vec<3>, 2> dual{1 / det * (yy * x - xy * y), 1 / det * (xx * y - xy * x)};
  const std::array<double, 2> rho{inner(r, dual[0]), inner(r, dual[1])};
  const Vec<3> of_normal = times(plane_, m);
  across_ = 1 / std::sqrt(det) * of_normal;
  for (std::size_t k = 0; k < 2; ++k) along_[k] = times(plane_, dual[k]);
  for (std::size_t k = 0; k < 2; ++k)
    for (std::size_t l = k; l < 2; ++l)
      stretch_[second_derivative(k, l)] =
          -0.25 * (rho[l] * along_[k] + rho[k] * along_[l]) - inner(r, m) / 2 * inner(dual[k], dual[l]) * of_normal;
}

PatchSlip<3>::Motion PatchSlip<3>::motion(const std::vector<int>& nodes, const double* u) const {
  Motion result{};
  for (std::size_t a = 0; a < nodes.size(); ++a) {
    const double* const own = u + 3 * static_cast<std::size_t>(nodes[a]);
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t i = 0; i < 3; ++i) result[3 * k + i] += weights_[a][k] * own[i];
  }
  return result;
}

PatchSlip<3>::Vectors PatchSlip<3>::vectors(const Motion& change) const {
  const Motion now = start_ + change;
  Vectors result;
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t i = 0; i < 3; ++i) result[k][i] = now[3 * k + i];
  return result;
}

void PatchSlip<3>::add_derivative(double factor, const Vectors& at, Derivative& sum) const {
  const auto& [r, x, y] = at;
  const Vec<3> by_r = cross(x, y), by_x = cross(y, r), by_y = cross(r, x);  // of v
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      sum[0][i][j] += factor * (along_[0][i] * x[j] + along_[1][i] * y[j] + across_[i] * by_r[j]);
      sum[1][i][j] +=
          factor * (along_[0][i] * r[j] + 2 * (stretch_[0][i] * x[j] + stretch_[1][i] * y[j]) + across_[i] * by_x[j]);
      sum[2][i][j] +=
          factor * (along_[1][i] * r[j] + 2 * (stretch_[1][i] * x[j] + stretch_[2][i] * y[j]) + across_[i] * by_y[j]);
    }
}

PatchSlip<3>::Derivative PatchSlip<3>::derivative(const Motion& change, SlipKind kind) const {
  Derivative result{};
  if (kind == SlipKind::At) {
    add_derivative(1, vectors(change), result);
  } else {
    const Quadrature& path = path_points();
    for (std::size_t q = 0; q < path.points.size(); ++q)
      add_derivative(path.weights[q], vectors(path.points[q] * change), result);
  }
  return result;
}

Vec<3> PatchSlip<3>::slip(const Motion& change) const {
  const Derivative mean = derivative(change, SlipKind::Mean);
  Vec<3> result{};
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) result[i] += mean[k][i][j] * change[3 * k + j];
  return result;
}

PatchSlip<3>::Motion PatchSlip<3>::force(const Vec<3>& traction, const Motion& change, SlipKind kind) const {
  const Derivative by = derivative(change, kind);
  Motion result{};
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t l = 0; l < 3; ++l)
      for (std::size_t i = 0; i < 3; ++i) result[3 * k + i] += traction[l] * by[k][l][i];
  return result;
}

void PatchSlip<3>::add_bend(double factor, const Vec<3>& traction, const Vectors& at, Moduli& sum) const {
  // A block by two of the vectors is a multiple of I plus the matrix of w x.
  const auto add_entry = [&](std::size_t row, std::size_t column, double value, bool twice) {
    sum[row][column] += factor * value;
    if (twice) sum[column][row] += factor * value;
  };
  const auto add = [&](std::size_t k, std::size_t l, double multiple, const Vec<3>& w) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3, n = (i + 2) % 3;
      add_entry(3 * k + i, 3 * l + i, multiple, k != l);
      add_entry(3 * k + i, 3 * l + j, -w[n], k != l);
      add_entry(3 * k + j, 3 * l + i, w[n], k != l);
    }
  };
  const auto& [r, x, y] = at;
  const double volume = inner(traction, across_);
  add(0, 1, inner(traction, along_[0]), -volume * y);
  add(0, 2, inner(traction, along_[1]), volume * x);
  add(1, 1, 2 * inner(traction, stretch_[0]), {});
  add(1, 2, 2 * inner(traction, stretch_[1]), -volume * r);
  add(2, 2, 2 * inner(traction, stretch_[2]), {});
}

PatchSlip<3>::Moduli PatchSlip<3>::moduli(const SlipResponse<double, 3>& response, const Motion& change, SlipKind kind,
                                          Tangent tangent) const {
  const Derivative right = derivative(change, SlipKind::At),
                   left = kind == SlipKind::At ? right : derivative(change, SlipKind::Mean);
  Moduli result{};
  for (std::size_t n = 0; n < 3; ++n) {
    const Small<double, 3> by = product(response.stiffness, right[n]);
    for (std::size_t m = 0; m < 3; ++m)
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t l = 0; l < 3; ++l)
          for (std::size_t j = 0; j < 3; ++j) result[3 * m + i][3 * n + j] += left[m][l][i] * by[l][j];
  }
  if (tangent == Tangent::Convex) return result;
  if (kind == SlipKind::At) {
    add_bend(1, response.traction, vectors(change), result);
  } else {
    const Quadrature& path = path_points();
    for (std::size_t q = 0; q < path.points.size(); ++q)
      add_bend(path.weights[q] * path.points[q], response.traction, vectors(path.points[q] * change), result);
  }
  return result;
}

void PatchSlip<3>::add_force(const std::vector<int>& nodes, double factor, const Motion& force, double* f) const {
  const Motion scaled = factor * force;
  for (std::size_t a = 0; a < nodes.size(); ++a) {
    double* const at = f + 3 * static_cast<std::size_t>(nodes[a]);
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t i = 0; i < 3; ++i) at[i] += weights_[a][k] * scaled[3 * k + i];
  }
}

void PatchSlip<3>::add_stiffness(double factor, const Moduli& moduli, std::vector<double>& k) const {
  const std::size_t count = weights_.size();
  double* row = k.data();
  for (std::size_t a = 0; a < count; ++a)
    for (std::size_t i = 0; i < 3; ++i, row += 3 * count) {
      Motion own{};
      for (std::size_t l = 0; l < 3; ++l) own = own + factor * weights_[a][l] * moduli[3 * l + i];
      for (std::size_t b = 0; b < count; ++b)
        for (std::size_t l = 0; l < 3; ++l)
          for (std::size_t j = 0; j < 3; ++j) row[3 * b + j] += own[3 * l + j] * weights_[b][l];
    }
}

double PatchSlip<3>::squares(const std::vector<int>& nodes, const double* u) const {
  const Derivative by = derivative({}, SlipKind::At);
  double square = 0;
  for (std::size_t a = 0; a < nodes.size(); ++a) {
    const double* const own = u + 3 * static_cast<std::size_t>(nodes[a]);
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) {
        double slope = 0;
        for (std::size_t k = 0; k < 3; ++k) slope += weights_[a][k] * by[k][i][j];
        square += std::pow(slope * own[j], 2);
      }
  }
  return square;
}

}  // namespace ixos
