#include "model/body_supports.hpp"

#include <memory>
#include <utility>

#include "base/error.hpp"
#include "model/supports.hpp"

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

}  // namespace

void support_body(Model& model, const std::string& body, const RigidMotion& base, const GripSupport& support) {
  model.check_open();
  const std::size_t number = model.rigid_bodies().find(body);
  if (base.turns()) throw InputError("the base of the rigid body \"" + body + "\" turns; it may translate only");
  Supports supports = make_supports(
      model, "the rigid body \"" + body + "\"", support.stiffness, support.damping, base,
      [&](const std::vector<double>& coefficients) { return driven_ends(model, number, base, coefficients); });
  if (supports.springs || supports.dashpots)
    model.add_supports(body, std::move(supports.springs), std::move(supports.dashpots));
}

}  // namespace ixos
