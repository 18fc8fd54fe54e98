#include "model/material.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "base/error.hpp"

namespace ixos {

std::string why_no_branches(const Material& material) {
  if (material.formulation != Formulation::Enhanced) return "";
  return "Enhanced elements solve for their modes with the elastic law alone; use Standard or Mean Dilatation elements";
}

void check_material(const Material& material, bool inertia) {
  const auto refuse = [&](const std::string& why) {
    throw InputError("the material of block \"" + material.block + "\" " + why);
  };
  if (!material.law) refuse("has no elastic law");
  if (inertia && !(material.density > 0 && std::isfinite(material.density)))
    refuse(fmt::format("has the density {}; it must be greater than 0 and finite", material.density));
  for (const auto& [value, name] :
       {std::pair(material.mass_damping, "mass damping"), std::pair(material.stiffness_damping, "stiffness damping"),
        std::pair(material.viscosity, "viscosity")})
    if (!(value >= 0 && std::isfinite(value)))
      refuse(fmt::format("has the {} {}; it must be at least 0 and finite", name, value));
  for (const MaxwellBranch& branch : material.branches)
    if (!(branch.modulus > 0 && branch.time > 0 && std::isfinite(branch.modulus) && std::isfinite(branch.time)))
      refuse(
          fmt::format("has a Maxwell branch of modulus {} and relaxation time {}; both must be greater than 0 and "
                      "finite",
                      branch.modulus, branch.time));
  if (const std::string why = why_no_branches(material); !material.branches.empty() && !why.empty())
    refuse("has Maxwell branches: " + why);
  if (material.points < 0 || material.points > 10)
    refuse(fmt::format("has {} Gauss points a direction; 0 to 10 are allowed", material.points));
  if (material.formulation == Formulation::Enhanced && material.points == 1)
    refuse("has 1 Gauss point a direction, which is too few for Enhanced elements: their modes vanish at the centre");
}

}  // namespace ixos
