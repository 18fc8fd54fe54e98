#include "model/supports.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/error.hpp"

namespace ixos {
namespace {

/// Returns the coefficients by direction; none if all are 0.
std::vector<double> support_numbers(const char* what, std::vector<double> values, const LocalMesh& mesh) {
  const int dimension = mesh.dimension;
  if (values.empty()) return values;
  if (values.size() != static_cast<std::size_t>(dimension))
    throw InputError(
        fmt::format("the {} has {} components, but the mesh has {} dimensions", what, values.size(), dimension));
  for (const double value : values)
    if (!(value >= 0 && std::isfinite(value)))
      throw InputError(fmt::format("the {} has the component {}; each must be finite and at least 0", what, value));
  if (mesh.axisymmetric && values[0] != 0)
    throw InputError(fmt::format(
        "the {} has the radial component {}; on an axisymmetric mesh it acts along y only: use 0", what, values[0]));
  if (std::all_of(values.begin(), values.end(), [](double value) { return value == 0; })) values.clear();
  return values;
}

/// Adds the loads sum_k (coefficient factor_k) history(motion_k), one for each motion.
template <class History>
void add_driving_loads(Model& model, const DrivenEnds& ends, const RigidMotion& motion, const History& history) {
  for (const auto& function : motion.functions()) {
    std::vector<double> forces(static_cast<std::size_t>(model.space().local()), 0.0);
    for (std::size_t k = 0; k < ends.dofs.size(); ++k)
      for (const MotionShare& share : ends.to->shares(ends.dofs[k]))
        if (share.motion == function)
          forces[static_cast<std::size_t>(ends.dofs[k])] += ends.coefficients[k] * share.factor;
    model.loads().add(std::move(forces), history(function));
  }
}

}  // namespace

Supports make_supports(Model& model, const std::string& part, const std::vector<double>& stiffness,
                       const std::vector<double>& damping, const RigidMotion& motion,
                       const std::function<DrivenEnds(const std::vector<double>&)>& ends) {
  const std::vector<double> elastic = support_numbers("stiffness", stiffness, model.mesh());
  const std::vector<double> viscous = support_numbers("damping", damping, model.mesh());
  if (!viscous.empty() && model.mass() == nullptr)
    throw InputError(part + " has a damping, but without inertia there are no velocities; use the damping 0");
  const auto local = static_cast<std::size_t>(model.space().local());
  Supports supports;
  if (!elastic.empty()) {
    supports.springs = std::make_unique<Springs>(ends(elastic), model.pattern(), local);
    add_driving_loads(model, supports.springs->ends(), motion, [](const auto& f) { return f; });
  }
  if (!viscous.empty()) {
    supports.dashpots = std::make_unique<Dashpots>(ends(viscous), model.pattern(), local);
    add_driving_loads(model, supports.dashpots->ends(), motion, [](const auto& f) { return rate_of(f); });
  }
  return supports;
}

}  // namespace ixos
