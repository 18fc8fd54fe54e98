#include "scene/materials.hpp"

#include "scene/list_access.hpp"

namespace ixos {
namespace {

Material material(const Teuchos::ParameterList& list) {
  Material m;
  m.block = list.get<std::string>("Block");
  m.law = list.get<std::string>("Model") == "Neo-Hooke" ? ElasticLaw::NeoHooke : ElasticLaw::Linear;
  m.lame = lame_constants(list.get<double>("Young's Modulus"), list.get<double>("Poisson's Ratio"));
  m.density = list.get<double>("Density");
  m.mass_damping = list.get<double>("Mass Damping");
  m.stiffness_damping = list.get<double>("Stiffness Damping");
  m.points = list.get<int>("Quadrature Points");
  m.formulation = formulation(list);
  return m;
}

}  // namespace

Formulation formulation(const Teuchos::ParameterList& material) {
  const auto& name = material.get<std::string>("Element Formulation");
  if (name == "Mean Dilatation") return Formulation::MeanDilatation;
  return name == "Enhanced" ? Formulation::Enhanced : Formulation::Standard;
}

std::vector<Material> materials(const Teuchos::ParameterList& list) {
  std::vector<Material> result;
  for (const std::string& name : sublists(list)) result.push_back(material(list.sublist(name)));
  return result;
}

}  // namespace ixos
