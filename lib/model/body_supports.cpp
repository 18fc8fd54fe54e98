#include "model/body_supports.hpp"

#include <algorithm>
#include <memory>
#include <utility>

#include "base/error.hpp"
#include "model/support_numbers.hpp"
#include "term/support/springs.hpp"

namespace ixos {
namespace {

/// Returns the driven ends of a body's translations: on the first rank.
DrivenEnds driven_ends(const Model& model, std::size_t number, const RigidMotion& base,
                       const std::vector<double>& coefficients) {
  const RigidBody& body = model.rigid_bodies()[number];
  DrivenEnds ends;
  ends.first_global = model.space().first_global();
  const auto to = std::make_shared<Constraints>();
  const int first = ends.first_global + static_cast<int>(RigidBodies::first(number));
  for (const std::size_t i : body.free()) {
    if (i >= coefficients.size() || coefficients[i] == 0 || model.space().comm()->getRank() > 0) continue;
    const int dof = first + static_cast<int>(i);
    ends.dofs.push_back(dof);
    ends.coefficients.push_back(coefficients[i]);
    to->add(dof, base.displacement(body.centre().data(), static_cast<int>(i)));
  }
  ends.to = to;
  return ends;
}

/// Adds the loads of the driven ends, one for each motion: all ranks add the same ones.
template <class History>
void add_driving_loads(Model& model, const DrivenEnds& ends, std::size_t number, const RigidMotion& base,
                       const History& history) {
  const RigidBody& body = model.rigid_bodies()[number];
  const int first = ends.first_global + static_cast<int>(RigidBodies::first(number));
  for (const auto& function : base.functions()) {
    std::vector<double> forces(static_cast<std::size_t>(model.space().local()), 0.0);
    for (std::size_t k = 0; k < ends.dofs.size(); ++k)
      for (const MotionShare& share : base.displacement(body.centre().data(), ends.dofs[k] - first))
        if (share.motion == function)
          forces[static_cast<std::size_t>(ends.dofs[k])] += ends.coefficients[k] * share.factor;
    model.loads().add(std::move(forces), history(function));
  }
}

}  // namespace

void support_body(Model& model, const std::string& body, const RigidMotion& base, const GripSupport& support) {
  model.check_open();
  const std::size_t number = model.rigid_bodies().find(body);
  if (base.turns()) throw InputError("the base of the rigid body \"" + body + "\" turns; it may translate only");
  const std::vector<double> stiffness = support_numbers("stiffness", support.stiffness, model.mesh());
  const std::vector<double> damping = support_numbers("damping", support.damping, model.mesh());
  if (!damping.empty() && model.mass() == nullptr)
    throw InputError("the rigid body \"" + body +
                     "\" has a damping, but without inertia there are no velocities; use the damping 0");
  const auto local = static_cast<std::size_t>(model.space().local());
  std::unique_ptr<Springs> springs;
  std::unique_ptr<Dashpots> dashpots;
  if (!stiffness.empty()) {
    springs = std::make_unique<Springs>(driven_ends(model, number, base, stiffness), model.pattern(), local);
    add_driving_loads(model, springs->ends(), number, base, [](const auto& f) { return f; });
  }
  if (!damping.empty()) {
    dashpots = std::make_unique<Dashpots>(driven_ends(model, number, base, damping), model.pattern(), local);
    add_driving_loads(model, dashpots->ends(), number, base, [](const auto& f) { return rate_of(f); });
  }
  if (springs || dashpots) model.add_supports(body, std::move(springs), std::move(dashpots));
}

}  // namespace ixos
