#include "support/beam_on_wall.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>

#include "fem/quadrature.hpp"

namespace ixos::test {
namespace {

using Vector = std::vector<double>;          // w_0, theta_0, w_1, theta_1, ...
using Row = std::array<double, 4>;           // of an element: w_1, theta_1, w_2, theta_2
using Block = std::array<double, 4>;         // 2 x 2, by rows
constexpr double least_gap_ratio = 0.8;      // of a Newton step
constexpr double newton_tolerance = 1e-8;    // step over r_eq
constexpr double trusted_step = 1e-4;        // over r_eq: below, the energy no longer resolves the descent
constexpr double sufficient_descent = 1e-4;  // Armijo's
constexpr int contact_pieces = 8;            // of an element, for the length of contact

/// Node i's diagonal block, and the one that couples it to node i + 1.
struct BlockTridiagonal {
  std::vector<Block> diagonal, upper;
};

/// Two-node elements with cubic deflection and quadratic rotation that satisfy equilibrium of the unloaded element
/// (Friedman and Kosmatka 1993): no locking. The shear strain is w' - theta.
class AdheringBeam {
 public:
  AdheringBeam(const BeamOnWall& beam, const VanDerWaals& law)
      : law_(law), adhering_(beam.adhering), elements_(static_cast<std::size_t>(beam.elements)) {
    h_ = beam.length / beam.elements;
    const double nu = beam.poissons_ratio;
    const double bending = beam.youngs_modulus / (1 - nu * nu) * std::pow(beam.height, 3) / 12;
    const double shear = beam.shear_correction * beam.youngs_modulus / (2 * (1 + nu)) * beam.height;
    phi_ = 12 * bending / (shear * h_ * h_);
    stiffness_ = {bending / h_, 12 * bending / (h_ * (1 + phi_))};
    modes_ = {Row{0, -1, 0, 1}, Row{-1 / h_, -0.5, 1 / h_, -0.5}};
    const Quadrature gauss = gauss_legendre_unit(5);
    for (std::size_t e = 0; e < elements_; ++e) {
      const double x = static_cast<double>(e) * h_;
      const double covered = std::min(1.0, (adhering_ - x) / h_);
      if (covered <= 0) break;
      for (std::size_t q = 0; q < gauss.points.size(); ++q)
        wall_.push_back({2 * e, covered * h_ * gauss.weights[q], deflection_shape(covered * gauss.points[q])});
    }
  }

  std::size_t size() const { return 2 * (elements_ + 1); }

  double elastic_energy(const Vector& u) const {
    double energy = 0;
    for (std::size_t i = 0; i + 2 < size(); i += 2)
      for (std::size_t m = 0; m < 2; ++m) energy += stiffness_[m] / 2 * std::pow(deformation(u, i, m), 2);
    return energy;
  }

  double interaction_energy(const Vector& u) const {
    double energy = 0;
    for (const WallPoint& p : wall_) energy += p.weight * law_.energy(gap(u, p));
    return energy;
  }

  double wall_force(const Vector& u) const {
    double force = 0;
    for (const WallPoint& p : wall_) force += p.weight * law_.traction(gap(u, p));
    return force;
  }

  double contact_length(const Vector& u) const {
    double length = 0;
    for (std::size_t e = 0; e < elements_; ++e) {
      const double covered = std::min(1.0, (adhering_ - static_cast<double>(e) * h_) / h_);
      if (covered <= 0) break;
      double before = 0;
      for (int piece = 0; piece <= contact_pieces; ++piece) {
        const double excess = law_.equilibrium_gap() - law_.adhesion_gap() +
                              dot(deflection_shape(covered * piece / contact_pieces), u, 2 * e);
        const double least = std::min(before, excess), largest = std::max(before, excess);
        if (piece > 0 && least < 0)
          length += covered * h_ / contact_pieces * (largest <= 0 ? 1.0 : least / (least - largest));
        before = excess;
      }
    }
    return length;
  }

  Vector gradient(const Vector& u) const {
    Vector g(size(), 0.0);
    for (std::size_t i = 0; i + 2 < size(); i += 2)
      for (std::size_t m = 0; m < 2; ++m) add(stiffness_[m] * deformation(u, i, m), modes_[m], g, i);
    for (const WallPoint& p : wall_) add(-p.weight * law_.traction(gap(u, p)), p.shape, g, p.first);
    return g;
  }

  /// The shift adds to the stiffness of the wall.
  BlockTridiagonal tangent(const Vector& u, double shift) const {
    BlockTridiagonal k{std::vector<Block>(elements_ + 1), std::vector<Block>(elements_)};
    for (std::size_t e = 0; e < elements_; ++e)
      for (std::size_t m = 0; m < 2; ++m) add(stiffness_[m], modes_[m], k, e);
    for (const WallPoint& p : wall_) add(p.weight * (law_.stiffness(gap(u, p)) + shift), p.shape, k, p.first / 2);
    return k;
  }

  /// The largest share of the step that is admissible at every point of the wall.
  double admissible_share(const Vector& u, const Vector& step) const {
    double share = 1;
    for (const WallPoint& p : wall_) {
      const double r = gap(u, p), change = dot(p.shape, step, p.first);
      const double least = least_gap_ratio * std::min(r, law_.equilibrium_gap());
      if (r + share * change < least) share = (r - least) / -change;
    }
    return share;
  }

 private:
  struct WallPoint {
    std::size_t first;  ///< unknown of the element
    double weight;
    Row shape;
  };

  Row deflection_shape(double s) const {
    const double s2 = s * s, s3 = s2 * s, f = 1 / (1 + phi_);
    return {f * (2 * s3 - 3 * s2 - phi_ * s + 1 + phi_), f * h_ * (s3 - (2 + phi_ / 2) * s2 + (1 + phi_ / 2) * s),
            -f * (2 * s3 - 3 * s2 - phi_ * s), f * h_ * (s3 - (1 - phi_ / 2) * s2 - phi_ / 2 * s)};
  }

  static double dot(const Row& row, const Vector& u, std::size_t first) {
    return row[0] * u[first] + row[1] * u[first + 1] + row[2] * u[first + 2] + row[3] * u[first + 3];
  }

  static void add(double factor, const Row& row, Vector& g, std::size_t first) {
    for (std::size_t a = 0; a < 4; ++a) g[first + a] += factor * row[a];
  }

  static void add(double factor, const Row& row, BlockTridiagonal& k, std::size_t node) {
    for (std::size_t a = 0; a < 2; ++a)
      for (std::size_t b = 0; b < 2; ++b) {
        k.diagonal[node][2 * a + b] += factor * row[a] * row[b];
        k.upper[node][2 * a + b] += factor * row[a] * row[2 + b];
        k.diagonal[node + 1][2 * a + b] += factor * row[2 + a] * row[2 + b];
      }
  }

  /// The change of rotation, or the chord's rotation over the mean one: differences first, which lose no digits where
  /// the beam moves far as a rigid body.
  double deformation(const Vector& u, std::size_t first, std::size_t mode) const {
    if (mode == 0) return u[first + 3] - u[first + 1];
    return (u[first + 2] - u[first]) / h_ - (u[first + 1] + u[first + 3]) / 2;
  }

  double gap(const Vector& u, const WallPoint& p) const { return law_.equilibrium_gap() + dot(p.shape, u, p.first); }

  VanDerWaals law_;
  double adhering_;
  std::size_t elements_;
  double h_;
  double phi_;                       ///< bending over shear stiffness of an element
  std::array<double, 2> stiffness_;  ///< of the two deformations
  std::array<Row, 2> modes_;
  std::vector<WallPoint> wall_;
};

/// Solves k x = b for all nodes but the last, whose x is 0. False where k is not positive definite.
bool solve(const BlockTridiagonal& k, const Vector& b, Vector& x) {
  const std::size_t n = k.upper.size();
  std::vector<Block> inverse(n);
  x = b;
  for (std::size_t i = 0; i < n; ++i) {
    Block d = k.diagonal[i];
    if (i > 0) {  // d -= u^T inverse u, x -= u^T inverse x
      const Block &u = k.upper[i - 1], &v = inverse[i - 1];
      for (std::size_t c = 0; c < 2; ++c) {
        const double p = u[c] * v[0] + u[2 + c] * v[2], q = u[c] * v[1] + u[2 + c] * v[3];
        d[2 * c] -= p * u[0] + q * u[2];
        d[2 * c + 1] -= p * u[1] + q * u[3];
        x[2 * i + c] -= p * x[2 * i - 2] + q * x[2 * i - 1];
      }
    }
    const double determinant = d[0] * d[3] - d[1] * d[2];
    if (!(d[0] > 0 && determinant > 0)) return false;
    inverse[i] = {d[3] / determinant, -d[1] / determinant, -d[2] / determinant, d[0] / determinant};
  }
  x[2 * n] = x[2 * n + 1] = 0;
  for (std::size_t i = n; i-- > 0;) {
    const Block &u = k.upper[i], &v = inverse[i];
    const double p = x[2 * i] - u[0] * x[2 * i + 2] - u[1] * x[2 * i + 3];
    const double q = x[2 * i + 1] - u[2] * x[2 * i + 2] - u[3] * x[2 * i + 3];
    x[2 * i] = v[0] * p + v[1] * q;
    x[2 * i + 1] = v[2] * p + v[3] * q;
  }
  return true;
}

Vector sum(const Vector& u, double share, const Vector& step) {
  Vector all(u);
  for (std::size_t i = 0; i < u.size(); ++i) all[i] += share * step[i];
  return all;
}

/// Descends to the equilibrium with the last node held.
void equilibrate(const AdheringBeam& beam, const VanDerWaals& law, Vector& u) {
  Vector step;
  const double scale = law.stiffness(law.equilibrium_gap());  // -13 times the least stiffness
  double last_shift = 1e-3 * scale;
  for (int iteration = 0; iteration < 1000; ++iteration) {
    const Vector g = beam.gradient(u);
    double shift = 0;  // Where the tangent is indefinite, near the least that mends it: more would creep off a fold.
    for (bool first = true; !solve(beam.tangent(u, shift), g, step); first = false) {
      shift = last_shift = first ? last_shift / 4 : 2 * shift;
      if (!(shift < scale)) throw std::runtime_error("beam on wall: indefinite where the wall is stiff");
    }
    double slope = 0, largest = 0;
    for (std::size_t i = 0; i < u.size(); ++i) {
      step[i] = -step[i];
      slope += g[i] * step[i];
      if (i % 2 == 0) largest = std::max(largest, std::abs(step[i]) / law.equilibrium_gap());
    }
    double share = beam.admissible_share(u, step);
    Vector next = sum(u, share, step);
    if (largest > trusted_step || shift > 0) {
      const double elastic = beam.elastic_energy(u), interaction = beam.interaction_energy(u);
      const double rounding = 1e-14 * (elastic + std::abs(interaction));
      const auto rises = [&] {
        return beam.elastic_energy(next) + beam.interaction_energy(next) >
               elastic + interaction + sufficient_descent * share * slope + rounding;
      };
      while (rises()) next = sum(u, share /= 2, step);
    }
    u.swap(next);
    if (largest < newton_tolerance && shift == 0) return;
  }
  throw std::runtime_error("beam on wall: Newton's method does not converge");
}

}  // namespace

std::vector<PullOff> peel(const BeamOnWall& beam, const VanDerWaals& law, double displacement_step,
                          double displacement_end) {
  const AdheringBeam model(beam, law);
  Vector u(model.size(), 0.0);
  const std::size_t end = u.size() - 2;
  std::vector<PullOff> states;
  const int steps = static_cast<int>(std::lround(displacement_end / displacement_step));
  for (int n = 0; n <= steps; ++n) {
    u[end] = n * displacement_step;
    equilibrate(model, law, u);
    states.push_back({u[end], model.gradient(u)[end], model.contact_length(u), model.elastic_energy(u),
                      model.interaction_energy(u), model.wall_force(u)});
    if (states.back().contact_length == 0) break;
  }
  return states;
}

}  // namespace ixos::test
