/// A rigid body that moves by its own dynamics.
#pragma once
#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "base/turn.hpp"

namespace ixos {

/// Mass, place and freedom of a rigid body. Places and axes are those of the reference configuration, in which its axes
/// are those of space. In two dimensions third components are 0, and the body turns about z. A body of an axisymmetric
/// model moves along y; its mass is that of the whole body.
struct RigidBodyOptions {
  std::string name{};
  double mass = 0;                 ///< [E0 T0^2 L0^(D-2)], 0 for a body in equilibrium
  Small<double, 3> inertia{};      ///< about the centre [E0 T0^2 L0^D], symmetric; only [2][2] counts in 2D
  std::array<double, 3> centre{};  ///< of mass [L0]
  std::array<bool, 3> translates{true, true, true};  ///< along x, y, z; false: held
  std::array<bool, 3> turns{true, true, true};       ///< about them; in 3D all, one or none; in 2D [2] counts
  double length = 0;  ///< [L0] makes a displacement of an angle; 0: from mass and inertia, or 1
};

/// The numbers of a rigid body at the end of local arrays, RigidBody::numbers of them. A displacement has
/// - the translation T of the centre [L0];
/// - l w [L0]: the rotation since the start of the step, cayley_turn(w); in an accepted state it is 0;
/// - the rotation at the start of the step, as a quaternion less that of no rotation, (q0 - 1, q1, q2, q3).
/// All numbers of a body in its place are 0, and rows of schemes apply: the quaternion does not change within a step. A
/// velocity has T', and l times the spin in the body's axes; an acceleration likewise. The length l makes displacements
/// of all unknowns.
///
/// Within a step, the rates of l w in an array of a stage are those of w in schemes whose rows stand for rates, and
/// the spin in schemes that balance momentum over the step (see begin_body_steps()).
class RigidBody {
 public:
  static constexpr std::size_t numbers = 10, turning = 3, attitude = 6;

  /// Throws InputError if a number is out of range: a mass or a length below 0, an inertia that no body has (not
  /// symmetric, not positive, a moment above the sum of the others), turns about two axes of three.
  RigidBody(const RigidBodyOptions& options, int dimension, bool axisymmetric);

  const RigidBodyOptions& options() const { return options_; }
  const std::string& name() const { return options_.name; }
  double mass() const { return options_.mass; }
  const std::array<double, 3>& centre() const { return options_.centre; }
  double length() const { return length_; }
  bool turns() const { return !free_.empty() && free_.back() >= turning; }
  /// Returns about how many axes it turns: 0, 1 or 3.
  std::size_t axes() const;
  /// Returns the directions of its unknowns, each a position among its numbers: 0 to 2 translations, 3 to 5 rotations
  /// about the axes.
  const std::vector<std::size_t>& free() const { return free_; }

  /// Returns w of a displacement's numbers.
  std::array<double, 3> rotation(const double* u) const { return scaled(1 / length_, triple(u + turning)); }
  /// Returns the turn since the reference configuration, and that at the start of the step.
  Turn turn(const double* u) const;
  static Turn turn_at_start(const double* u);
  /// Returns J x, J the inertia in the body's axes.
  template <class T>
  std::array<T, 3> times_inertia(const std::array<T, 3>& x) const {
    std::array<T, 3> result{};
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) result[i] += x[j] * options_.inertia[i][j];
    return result;
  }
  /// Adds `factor` times the mass times x to y, by number: forces from accelerations.
  void add_inertia(double factor, const double* x, double* y) const;
  /// Sets x to the solution of that for y; 0 for what is held.
  void solve_inertia(const double* y, double* x) const;
  /// Makes the end of a step the start of one: the rotation passes into the quaternion.
  void begin_step(double* u) const;
  /// Returns the rotation vector of an accepted displacement, of a length of at most half a turn [rad], and the spin in
  /// space [1/T0].
  std::array<double, 3> rotation_vector(const double* u) const;
  std::array<double, 3> spin_in_space(const double* u, const double* v) const { return turned(turn(u), spin(v)); }
  /// Returns the kinetic energy, the linear momentum, and the angular momentum about the origin [E0 L0^D, ...].
  double kinetic_energy(const double* v) const;
  std::array<double, 3> momentum(const double* v) const { return scaled(mass(), triple(v)); }
  std::array<double, 3> angular_momentum(const double* u, const double* v) const;
  /// Returns the spin in the body's axes of a velocity's numbers.
  std::array<double, 3> spin(const double* v) const { return scaled(1 / length_, triple(v + turning)); }

  static std::array<double, 3> triple(const double* x) { return {x[0], x[1], x[2]}; }

 private:
  RigidBodyOptions options_;
  double length_ = 1;
  std::vector<std::size_t> free_;
};

}  // namespace ixos
