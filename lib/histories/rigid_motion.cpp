#include "histories/rigid_motion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "base/error.hpp"
#include "base/vector3.hpp"

namespace ixos {
namespace {

using Vector = std::array<double, 3>;

/// Returns the vector; zeros if it is empty.
Vector vector_of(const char* what, const std::vector<double>& x, int dimension) {
  Vector result{};
  if (x.empty()) return result;
  if (x.size() != static_cast<std::size_t>(dimension))
    throw InputError(fmt::format("{} has {} components, but the mesh has {} dimensions", what, x.size(), dimension));
  for (const double value : x)
    if (!std::isfinite(value))
      throw InputError(fmt::format("{} has the component {}, which is not finite", what, value));
  std::copy(x.begin(), x.end(), result.begin());
  return result;
}

Vector unit_axis(const std::vector<double>& axis, bool turns, int dimension) {
  if (dimension == 2) {
    if (!axis.empty()) throw InputError("an axis is given, but a body in two dimensions turns about z; remove it");
    return {0, 0, 1};
  }
  if (!turns) {
    if (!axis.empty()) throw InputError("an axis is given, but no rotation about it");
    return {0, 0, 1};
  }
  if (axis.empty()) throw InputError("a rotation in three dimensions needs an axis");
  Vector n = vector_of("the axis", axis, dimension);
  const double length = std::hypot(n[0], n[1], n[2]);
  if (!(length > 0)) throw InputError("the axis is {0, 0, 0}; it must have a direction");
  for (double& value : n) value /= length;
  return n;
}

}  // namespace

std::shared_ptr<const TimeFunction> sine_of(std::shared_ptr<const TimeFunction> f) {
  return function_of_time([f = std::move(f)](double time) {
    const TimeValue x = f->at(time);
    const double sin = std::sin(x.value), cos = std::cos(x.value);
    return TimeValue{sin, cos * x.rate, cos * x.acceleration - sin * x.rate * x.rate};
  });
}

std::shared_ptr<const TimeFunction> versine_of(std::shared_ptr<const TimeFunction> f) {
  return function_of_time([f = std::move(f)](double time) {
    const TimeValue x = f->at(time);
    const double sin = std::sin(x.value), cos = std::cos(x.value), half = std::sin(x.value / 2);
    // 1 - cos f cancels at small angles.
    return TimeValue{2 * half * half, sin * x.rate, sin * x.acceleration + cos * x.rate * x.rate};
  });
}

std::shared_ptr<const TimeFunction> rate_of(std::shared_ptr<const TimeFunction> f) {
  return function_of_time([f = std::move(f)](double time) {
    const TimeValue x = f->at(time);
    return TimeValue{x.rate, x.acceleration, std::numeric_limits<double>::quiet_NaN()};
  });
}

Vector RigidPose::turning(double by, const Vector& v) const {
  const Vector once = cross(axis, v), twice = cross(axis, once);
  const double sin = std::sin(by), half = std::sin(by / 2);
  Vector result;
  for (std::size_t i = 0; i < 3; ++i) result[i] = sin * once[i] + 2 * half * half * twice[i];
  return result;
}

RigidMotion::RigidMotion(int dimension, const RigidMotionOptions& options)
    : dimension_(dimension),
      axis_(unit_axis(options.axis, options.angle != nullptr, dimension)),
      point_(vector_of("the point", options.point, dimension)) {
  if (!options.translation.empty() && options.translation.size() != static_cast<std::size_t>(dimension))
    throw InputError(fmt::format("the translation has {} functions of time, but the mesh has {} dimensions",
                                 options.translation.size(), dimension));
  for (std::size_t i = 0; i < options.translation.size(); ++i)
    if (options.translation[i]) functions_.emplace_back(i, options.translation[i]);
  if (!options.angle) return;
  angle_ = options.angle;
  sine_ = sine_of(options.angle);
  versine_ = versine_of(options.angle);
}

std::vector<std::shared_ptr<const TimeFunction>> RigidMotion::functions() const {
  std::vector<std::shared_ptr<const TimeFunction>> all;
  for (const auto& [direction, function] : functions_)
    if (std::find(all.begin(), all.end(), function) == all.end()) all.push_back(function);
  if (sine_) all.insert(all.end(), {sine_, versine_});
  return all;
}

bool RigidMotion::translates(std::size_t i) const {
  return std::any_of(functions_.begin(), functions_.end(), [i](const auto& entry) { return entry.first == i; });
}

std::vector<MotionShare> RigidMotion::shares(const Vector& r, int i, bool translates) const {
  std::vector<MotionShare> result;
  const auto component = static_cast<std::size_t>(i);
  if (translates)
    for (const auto& [direction, function] : functions_)
      if (direction == component) result.push_back({1.0, function});
  if (!sine_) return result;
  const Vector once = cross(axis_, r), twice = cross(axis_, once);
  if (once[component] != 0) result.push_back({once[component], sine_});
  if (twice[component] != 0) result.push_back({twice[component], versine_});
  return result;
}

std::vector<MotionShare> RigidMotion::displacement(const double* x, int i) const {
  Vector r{};
  for (std::size_t j = 0; j < static_cast<std::size_t>(dimension_); ++j) r[j] = x[j] - point_[j];
  return shares(r, i, true);
}

std::vector<MotionShare> RigidMotion::displacement_derivative(const double* dx, int i) const {
  Vector r{};
  std::copy_n(dx, dimension_, r.begin());
  return shares(r, i, false);
}

std::array<double, 3> RigidMotion::point_at(double time) const {
  Vector place = point_;
  for (const auto& [direction, function] : functions_) place[direction] += function->at(time).value;
  return place;
}

RigidPose RigidMotion::pose(double time) const {
  RigidPose pose;
  pose.point = point_;
  pose.axis = axis_;
  for (const auto& [direction, function] : functions_) {
    const TimeValue value = function->at(time);
    pose.translation[direction] += value.value;
    pose.velocity[direction] += value.rate;
  }
  if (!angle_) return pose;
  const TimeValue angle = angle_->at(time);
  pose.angle = angle.value;
  pose.spin = angle.rate;
  pose.turn = turn_about(axis_, angle.value);
  return pose;
}

}  // namespace ixos
