/// The prescribed motion of a rigid body.
#pragma once
#include <array>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include "base/turn.hpp"
#include "histories/time_function.hpp"

namespace ixos {

/// A function of time times a factor. Without a function it is zero.
struct MotionShare {
  double factor;
  std::shared_ptr<const TimeFunction> motion;
};

/// The translations and the rotation of a rigid body. Functions that are null stand still.
struct RigidMotionOptions {
  std::vector<std::shared_ptr<const TimeFunction>> translation{};  ///< [L0]; empty, or one for each direction
  std::shared_ptr<const TimeFunction> angle{};                     ///< [rad]; about z in 2D
  std::vector<double> axis{};   ///< of the rotation, of any length; given in 3D if there is an angle, otherwise empty
  std::vector<double> point{};  ///< through which the axis goes, in the reference configuration [L0]; empty: the origin
};

/// The place of a rigid body at a time, x = P + T + R (X - P), and its rates. The body's point that is at x moves with
/// T' + spin n x (x - P - T).
struct RigidPose {
  std::array<double, 3> point{};          ///< P [L0]
  std::array<double, 3> translation{};    ///< T [L0]
  std::array<double, 3> velocity{};       ///< T' [L0/T0]
  std::array<double, 3> axis{0, 0, 1.0};  ///< n, a unit vector, about which R turns
  double angle = 0;                       ///< of R [rad]
  double spin = 0;                        ///< the angle's rate [rad/T0]
  Turn turn{};                            ///< R - I
  std::array<double, 3> step{};           ///< w of the rotation since the step's start; of a body that moves by itself

  /// Returns R v - v for the rotation R by `by` about the pose's axis, without cancellation at small angles.
  std::array<double, 3> turning(double by, const std::array<double, 3>& v) const;
};

/// u(X, t) = T(t) + (R(t) - I) r with r = X - P. R turns about the axis n through P by any angle. Rodrigues' formula
/// (1840) makes u a sum of functions of time times factors, whose derivatives in time are exact:
///   u = sum_i T_i e_i + sin(angle) n x r + (1 - cos(angle)) n x (n x r).
/// Hence the axis moves with T and keeps its direction.
class RigidMotion {
 public:
  /// Throws InputError if a vector does not have `dimension` finite components, if the axis is zero, or if an axis is
  /// given where none is used, or missing.
  RigidMotion(int dimension, const RigidMotionOptions& options);

  int dimension() const { return dimension_; }
  /// Returns the functions of time of all displacements.
  std::vector<std::shared_ptr<const TimeFunction>> functions() const;
  /// Returns whether some function moves it.
  bool moves() const { return !functions_.empty() || sine_ != nullptr; }
  bool turns() const { return sine_ != nullptr; }
  /// Returns whether it translates along direction i.
  bool translates(std::size_t i) const;
  /// Returns component i of the displacement of the point X, without parts that are zero throughout.
  std::vector<MotionShare> displacement(const double* x, int i) const;
  /// Returns component i of the displacement's derivative by a parameter s of a curve in the body, from dX/ds.
  std::vector<MotionShare> displacement_derivative(const double* dx, int i) const;
  /// Returns the present place of P [L0]; the third component is 0 in 2D.
  std::array<double, 3> point_at(double time) const;
  RigidPose pose(double time) const;

 private:
  using Vector = std::array<double, 3>;
  std::vector<MotionShare> shares(const Vector& r, int i, bool translates) const;

  int dimension_;
  std::vector<std::pair<std::size_t, std::shared_ptr<const TimeFunction>>> functions_;  ///< by direction
  std::shared_ptr<const TimeFunction> angle_, sine_, versine_;                          ///< all null without rotation
  Vector axis_{0, 0, 1};                                                                ///< a unit vector
  Vector point_{};
};

/// Returns the functions sin f and 1 - cos f, and the function whose value is the rate of f and whose rate is the
/// acceleration of f (its acceleration is not known: NaN).
std::shared_ptr<const TimeFunction> sine_of(std::shared_ptr<const TimeFunction> f);
std::shared_ptr<const TimeFunction> versine_of(std::shared_ptr<const TimeFunction> f);
std::shared_ptr<const TimeFunction> rate_of(std::shared_ptr<const TimeFunction> f);

}  // namespace ixos
