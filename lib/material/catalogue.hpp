/// The elastic laws that a scene may choose.
#pragma once
#include <memory>
#include <string>

#include "material/lame.hpp"
#include "parameters/catalogue.hpp"

namespace ixos {

class ElasticLaw;

/// An entry makes an elastic law from its parameters.
using ElasticEntry = CatalogueEntry<std::shared_ptr<const ElasticLaw>>;

/// Returns the catalogue; its choice is "Model".
const Catalogue<ElasticEntry>& elastic_laws();

/// Returns the elastic law of that name, for programs: make_elastic_law("Neo-Hooke", {{"Young's Modulus", 1.0},
/// {"Poisson's Ratio", 0.2}}). docs/parameters.md lists names, parameters and defaults ("Materials"). Throws
/// InputError.
std::shared_ptr<const ElasticLaw> make_elastic_law(const std::string& name, const Settings& settings = {});

/// Young's modulus [E0] and Poisson's ratio [-], which several laws share.
struct IsotropicConstants {
  double young = 1;
  double poisson = 0.2;
  Lame lame() const { return lame_constants(young, poisson); }
};
Options<IsotropicConstants> isotropic_options();

}  // namespace ixos
