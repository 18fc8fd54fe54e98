#include "scene/read/materials.hpp"

#include "material/catalogue.hpp"
#include "parameters/options.hpp"
#include "parameters/range_validator.hpp"
#include "scene/read/maxwell_branches.hpp"

namespace ixos {
namespace {

struct Defaults : Material {
  Defaults() {
    block = "body";
    density = 5e-7;
    points = 2;
  }
};

const Options<Defaults>& options() {
  static const Options<Defaults> all =
      Options<Defaults>()
          .add("Block", &Defaults::block, "Name of the block of cells that consists of this material.")
          .add("Density", &Defaults::density,
               "Mass density rho [E0 T0^2/L0^2]. In the default units, 5e-7 corresponds to 1000 kg/m^3.",
               greater_than(0))
          .add("Mass Damping", &Defaults::mass_damping,
               "Rayleigh damping: the coefficient alpha_1 of the mass matrix [1/T0].", at_least(0))
          .add("Stiffness Damping", &Defaults::stiffness_damping,
               "Rayleigh damping: the coefficient alpha_2 of the stiffness matrix [T0]. It also damps finite rigid "
               "rotations.",
               at_least(0))
          .add("Viscosity", &Defaults::viscosity,
               "Kelvin-Voigt viscosity, as a time over the elastic moduli [T0]: the viscous stress is that of the rate "
               "of Green's strain. Rigid rotations are not damped. Standard elements only.",
               at_least(0))
          .add(
              "Quadrature Points", &Defaults::points,
              "Number of Gauss points per direction in linear elements that are not enriched; quadratic ones have one "
              "more. Triangles, tetrahedra, prisms and pyramids take what they need with 1 and 2, and rules of as high "
              "a degree with more.",
              between(1, 10))
          .choose(
              "Element Formulation", &Defaults::formulation,
              {{"Standard", Formulation::Standard},
               {"Mean Dilatation", Formulation::MeanDilatation},
               {"Enhanced", Formulation::Enhanced}},
              "Element type. Mean Dilatation avoids volumetric locking; its forces and tangents cost 2 to 4 times as "
              "much as those of Standard. Enhanced also avoids locking in bending; its forces cost 5 to 40 times and "
              "its tangents 3 to 10 times as much. Enhanced is not suitable for strong compression, enriched "
              "contact elements stay Standard, and quadratic cells, which do not lock in bending, refuse it.");
  return all;
}

}  // namespace

void declare_material(Teuchos::ParameterList& list) {
  elastic_laws().declare(list);
  options().declare(list);
  declare_branches(list);
}

std::vector<Material> read_materials(const SceneNode& materials) {
  std::vector<Material> result;
  for (const SceneNode& node : materials.sublists()) {
    Material material = options().read(node);
    material.law = elastic_laws().make(node);
    read_branches(node, material);
    result.push_back(std::move(material));
  }
  return result;
}

}  // namespace ixos
