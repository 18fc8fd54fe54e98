/// The uses of a scene's parameters whose units depend on their use.
#pragma once
#include <Teuchos_ParameterList.hpp>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace ixos {

/// The uses of parameters in a scene as a user writes it, see DocumentedUnit.
class UnitUses {
 public:
  /// `valid` has the defaults. `dimension`: that of the mesh; 0 if no more is known than the scene states.
  UnitUses(const Teuchos::ParameterList& scene, const Teuchos::ParameterList& valid, int dimension = 0);

  /// Returns the uses of the entries of a list, for example {"motion"} for those of a history that drives one. `path`
  /// has the names of the lists from the root; `list` is the list itself.
  std::set<std::string> of(const std::vector<std::string>& path, const Teuchos::ParameterList& list) const;

 private:
  std::map<std::string, std::set<std::string>> histories_;  ///< uses by name
  std::string dimension_;                                   ///< "2D", "3D"; empty if only the mesh file says it
  Teuchos::ParameterList condition_, probe_;  ///< defaults of a boundary condition and of a stop criterion
};

}  // namespace ixos
