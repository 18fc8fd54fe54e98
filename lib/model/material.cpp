#include "model/material.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "base/error.hpp"

namespace ixos {

std::string why_no_branches(const Material& material) {
  if (material.formulation != Formulation::Enhanced) return "";
  return "are not there for Enhanced elements, which solve for their modes with the elastic law alone; use Standard or "
         "Mean Dilatation elements";
}

std::optional<Refusal> refusal_of(const Material& material, bool inertia) {
  const auto number = [](const char* setting, double value, const std::string& why) {
    return Refusal{setting, fmt::format("{}", value), why};
  };
  if (!material.law) return Refusal{"Model", "", "is missing: there is no elastic law"};
  if (inertia && !(material.density > 0 && std::isfinite(material.density)))
    return number("Density", material.density, "must be greater than 0 and finite");
  for (const auto& [value, name] :
       {std::pair(material.mass_damping, "Mass Damping"), std::pair(material.stiffness_damping, "Stiffness Damping"),
        std::pair(material.viscosity, "Viscosity")})
    if (!(value >= 0 && std::isfinite(value))) return number(name, value, "must be at least 0 and finite");
  for (const MaxwellBranch& branch : material.branches)
    if (!(branch.modulus > 0 && branch.time > 0 && std::isfinite(branch.modulus) && std::isfinite(branch.time)))
      return Refusal{"Maxwell Branches", "",
                     fmt::format("have a branch of modulus {} and relaxation time {}; both must be greater than 0 and "
                                 "finite",
                                 branch.modulus, branch.time)};
  if (std::string why = why_no_branches(material); !material.branches.empty() && !why.empty())
    return Refusal{"Maxwell Branches", "", why};
  if (material.viscosity != 0 && material.formulation != Formulation::Standard)
    return number(
        "Viscosity", material.viscosity,
        "is not there for elements other than \"Standard\": their viscous stress would lock; use 0, Stiffness "
        "Damping, or the Element Formulation \"Standard\"");
  if (material.points < 0 || material.points > 10)
    return number("Quadrature Points", material.points,
                  "is out of range: 0 to 10 Gauss points a direction are allowed");
  if (material.formulation == Formulation::Enhanced && material.points == 1)
    return number("Quadrature Points", material.points,
                  "is too few for \"Enhanced\" elements, whose modes vanish at the centre; use at least 2");
  return std::nullopt;
}

void check_material(const Material& material, bool inertia) {
  if (const auto refusal = refusal_of(material, inertia))
    throw InputError("the material of block \"" + material.block + "\" is not allowed: " + refusal->in_words());
}

}  // namespace ixos
