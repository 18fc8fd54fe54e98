#include "rigid/body_sight.hpp"

#include "rigid/cayley.hpp"

namespace ixos {
namespace {

using Triple = std::array<double, 3>;

}  // namespace

BodySight BodySight::at(const Turn& turn, const Triple& step, double to) {
  BodySight sight;
  sight.forces_ = sight.pose_ = turn;
  sight.step_ = step;
  sight.to_ = to;
  return sight;
}

BodySight BodySight::between(const Turn& start, const Turn& end, const Triple& step) {
  BodySight sight = at(end, step, 1);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) sight.forces_[i][j] = (start[i][j] + end[i][j]) / 2;
  sight.mean_ = true;
  return sight;
}

Triple BodySight::to_rotation(const Triple& x) const {
  const Triple in_body = turned_back(forces_, x);
  return mean_ ? in_body : cayley_force(step_, in_body);
}

Small<double, 3> BodySight::matrix() const {
  Small<double, 3> result{};
  for (std::size_t k = 0; k < 3; ++k) {
    const Triple column = to_rotation(basis_vector(k));
    for (std::size_t i = 0; i < 3; ++i) result[i][k] = column[i];
  }
  return result;
}

Triple BodySight::turning(std::size_t k) const {
  return turned(pose_, scaled(to_, cayley_spin(step_, basis_vector(k))));
}

Triple BodySight::to_rotation_by(std::size_t k, const Triple& x) const {
  const Triple spin = scaled(to_, cayley_spin(step_, basis_vector(k)));
  const Triple in_body = turned_back(pose_, x), turning = cross(in_body, spin);
  if (mean_) return scaled(0.5, turning);
  // H^T x = (x + w x x/2)/(1 + |w|^2/4)
  const double factor = 1 / (1 + dot(step_, step_) / 4);
  Triple result = cayley_force(step_, turning);
  result = sum(result, cross(basis_vector(k), in_body), to_ * factor / 2);
  return sum(result, cayley_force(step_, in_body), -to_ * factor * step_[k] / 2);
}

}  // namespace ixos
