#include "rigid/rigid_body.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "rigid/cayley.hpp"

namespace ixos {
namespace {

using Triple = std::array<double, 3>;

/// Returns whether no eigenvalue of a symmetric matrix is below -tolerance times its trace.
bool is_not_negative(Small<double, 3> m, double tolerance) {
  const double trace = m[0][0] + m[1][1] + m[2][2];
  for (std::size_t i = 0; i < 3; ++i) m[i][i] += tolerance * trace;
  double minors[3] = {m[0][0], m[0][0] * m[1][1] - m[0][1] * m[1][0], determinant(m)};
  return std::all_of(minors, minors + 3, [](double minor) { return minor > 0; });
}

void check_inertia(const RigidBodyOptions& options) {
  const Small<double, 3>& j = options.inertia;
  const auto refuse = [&](const char* why) {
    throw InputError(fmt::format("the rigid body \"{}\" has an inertia that no body has: {}", options.name, why));
  };
  const double trace = j[0][0] + j[1][1] + j[2][2];
  if (!std::isfinite(trace)) refuse("it is not finite");
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < i; ++k)
      if (!(std::abs(j[i][k] - j[k][i]) <= 1e-12 * trace)) refuse("it is not symmetric");
  if (!(trace > 0) || !is_not_negative(j, 1e-12)) refuse("its moments must be positive");
  Small<double, 3> euler{};  // the integral of rho x x^T
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) euler[i][k] = (i == k ? trace / 2 : 0) - j[i][k];
  if (!is_not_negative(euler, 1e-9)) refuse("a moment about an axis is at most the sum of those about the other two");
}

}  // namespace

RigidBody::RigidBody(const RigidBodyOptions& options, int dimension, bool axisymmetric) : options_(options) {
  const auto refuse = [&](const std::string& why) {
    throw InputError(fmt::format("the rigid body \"{}\" {}", options.name, why));
  };
  if (!(options.mass >= 0) || !std::isfinite(options.mass))
    refuse(fmt::format("has the mass {}; it must be at least 0", options.mass));
  if (!(options.length >= 0) || !std::isfinite(options.length))
    refuse(fmt::format("has the length {}; it must be at least 0", options.length));
  for (const double x : options.centre)
    if (!std::isfinite(x)) refuse("has a centre that is not finite");
  const auto d = static_cast<std::size_t>(dimension);
  for (std::size_t i = axisymmetric ? 1 : 0; i < d; ++i)
    if (options.translates[i]) free_.push_back(i);
  const bool solid = dimension == 3;
  const std::size_t axes = static_cast<std::size_t>(std::count(options.turns.begin(), options.turns.end(), true));
  if (solid && axes == 2) refuse("turns about two axes of three; hold one more, or none");
  for (std::size_t i = solid ? 0 : 2; i < 3 && !axisymmetric; ++i)
    if (options.turns[i]) free_.push_back(turning + i);
  if (!turns()) return;
  if (solid && options.mass > 0) check_inertia(options);
  if (!solid && options.mass > 0 && !(options.inertia[2][2] > 0 && std::isfinite(options.inertia[2][2])))
    refuse(fmt::format("turns and has the inertia {}; it must be above 0", options.inertia[2][2]));
  const double trace =
      solid ? options.inertia[0][0] + options.inertia[1][1] + options.inertia[2][2] : 2 * options.inertia[2][2];
  if (options.length > 0)
    length_ = options.length;
  else if (options.mass > 0)
    length_ = std::sqrt(trace / (2 * options.mass));
}

std::size_t RigidBody::axes() const {
  return static_cast<std::size_t>(
      std::count_if(free_.begin(), free_.end(), [](std::size_t i) { return i >= turning; }));
}

Turn RigidBody::turn_at_start(const double* u) {
  const Triple q = triple(u + attitude + 1);
  const double q0 = 1 + u[attitude];
  const Small<double, 3> once = axial_matrix(q), twice = product(once, once);
  Turn result;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) result[i][j] = 2 * (q0 * once[i][j] + twice[i][j]);
  return result;
}

Turn RigidBody::turn(const double* u) const {
  const Triple w = rotation(u);
  return w == Triple{} ? turn_at_start(u) : compose(turn_at_start(u), cayley_turn(w));
}

void RigidBody::add_inertia(double factor, const double* x, double* y) const {
  for (std::size_t i = 0; i < 3; ++i) y[i] += factor * mass() * x[i];
  const Triple force = times_inertia(spin(x));
  for (std::size_t i = 0; i < 3; ++i) y[turning + i] += factor / length_ * force[i];
}

void RigidBody::solve_inertia(const double* y, double* x) const {
  std::fill_n(x, numbers, 0.0);
  for (const std::size_t i : free_)
    if (i < turning) x[i] = y[i] / mass();
  const double square = length_ * length_;
  if (axes() == 1) {
    const std::size_t k = free_.back() - turning;
    x[turning + k] = y[turning + k] * square / options_.inertia[k][k];
  } else if (axes() == 3) {
    const Small<double, 3> solution = inverse(options_.inertia, determinant(options_.inertia));
    const Triple acceleration = times(solution, triple(y + turning));
    for (std::size_t k = 0; k < 3; ++k) x[turning + k] = square * acceleration[k];
  }
}

void RigidBody::begin_step(double* u) const {
  const Triple half = scaled(0.5, rotation(u)), q = triple(u + attitude + 1);
  if (half == Triple{}) return;
  // The product of quaternions with (1, w/2), and its norm taken out: rounding lets it grow.
  const double q0 = 1 + u[attitude];
  const Triple vector = sum(sum(q, half, q0), cross(q, half));
  const double scalar = q0 - dot(q, half);
  const double norm = std::sqrt(scalar * scalar + dot(vector, vector));
  u[attitude] = scalar / norm - 1;
  for (std::size_t i = 0; i < 3; ++i) {
    u[attitude + 1 + i] = vector[i] / norm;
    u[turning + i] = 0;
  }
}

std::array<double, 3> RigidBody::rotation_vector(const double* u) const {
  const Triple q = triple(u + attitude + 1);
  const double q0 = 1 + u[attitude], length = std::sqrt(dot(q, q));
  if (length == 0) return {};
  return scaled(2 * std::atan2(q0 < 0 ? -length : length, std::abs(q0)) / length, q);
}

double RigidBody::kinetic_energy(const double* v) const {
  const Triple velocity = triple(v), own = spin(v);
  return (mass() * dot(velocity, velocity) + dot(own, times_inertia(own))) / 2;
}

std::array<double, 3> RigidBody::angular_momentum(const double* u, const double* v) const {
  const Triple place = sum(options_.centre, triple(u));
  return sum(cross(place, momentum(v)), turned(turn(u), times_inertia(spin(v))));
}

}  // namespace ixos
