/// One block of a model.
#pragma once
#include <cstddef>

#include "model/material.hpp"
#include "term/body/elastic_term.hpp"
#include "term/body/maxwell_term.hpp"
#include "term/body/viscous_term.hpp"

namespace ixos {

/// A block and its terms, which its model owns.
struct Body {
  const Elasticity* term;
  const Viscosity* viscosity;              ///< may be null
  const Viscoelasticity* viscoelasticity;  ///< may be null
  std::size_t block;                       ///< number in the mesh
  Material material;
};

}  // namespace ixos
