#include "solve/descent_direction.hpp"

#include <NOX_Abstract_Group.H>

#include <new>

namespace ixos {
namespace {

constexpr int highest_level = 8;

}  // namespace

bool DescentDirection::compute(NOX::Abstract::Vector& direction, NOX::Abstract::Group& group,
                               const NOX::Solver::Generic& solver) {
  for (int level = 0; level <= highest_level; ++level) {
    problem_.relax_tangent(level);
    if (level > 0) {
      group.setX(group.getX());  // forgets the matrix
      group.computeF();
    }
    bool computed = false;
    try {
      computed = newton_.compute(direction, group, solver);
    } catch (const std::bad_alloc&) {
      throw;
    } catch (...) {
      problem_.relax_tangent(0);
      if (level == highest_level) throw;
      continue;
    }
    problem_.relax_tangent(0);
    if (!computed) continue;
    if (!problem_.is_gradient() || group.getF().innerProduct(direction) < 0) return true;
  }
  return true;  // at the bottom of the valley: rounding decides
}

}  // namespace ixos
