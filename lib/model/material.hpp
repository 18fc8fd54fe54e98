/// The materials of a model.
#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "material/maxwell_branch.hpp"
#include "model/refusal.hpp"
#include "term/body/elastic_term.hpp"

namespace ixos {

class ElasticLaw;

/// The material of one block.
struct Material {
  std::string block;
  std::shared_ptr<const ElasticLaw> law;  ///< see make_elastic_law()
  double density = 0;                     ///< [E0 T0^2/L0^2]
  double mass_damping = 0;                ///< alpha_1 [1/T0]
  double stiffness_damping = 0;           ///< alpha_2 [T0]
  double viscosity = 0;                   ///< over Lame's constants, see make_viscous_term() [T0]
  int points = 0;                         ///< Gauss points a direction, see cell_rule(); 0: the element's own
  Formulation formulation = Formulation::Standard;
  std::vector<MaxwellBranch> branches{};  ///< beside the law
  HistoryUpdate history_update = HistoryUpdate::BackwardEuler;
};

/// Returns why the material's elements take no Maxwell branches; empty if they do.
std::string why_no_branches(const Material& material);

/// Returns the first setting that is not allowed; nothing if all are. The density must be positive if the model has
/// inertia.
std::optional<Refusal> refusal_of(const Material& material, bool inertia);
/// Throws InputError, with the block, if refusal_of() returns something.
void check_material(const Material& material, bool inertia);

}  // namespace ixos
