/// A watch on the deformation of cells.
#pragma once
#include "base/record.hpp"
#include "model/model.hpp"

namespace ixos {

/// The extremes of the deformation of cells over a run.
struct StrainExtremes {
  double least_jacobian = 1;         ///< J, a cell's mean [-]
  double largest_jacobian = 1;       ///< [-]
  double largest_invariant = 0;      ///< |tr(sigma)|/E, a cell's mean [-]
  double least_scaled_jacobian = 1;  ///< of the deformed cells, see MeshQuality
  double time = 0;                   ///< at which a cell came to be the most deformed, by the last of these [T0]
};

/// Looks at the cells now and then. A look costs a few evaluations of the elastic forces.
class StrainWatch {
 public:
  /// Looks at a state. Collective.
  void look(const Model& model, const Place& at);
  const StrainExtremes& extremes() const { return extremes_; }

  /// For checkpoints.
  void transfer(Record& record);

 private:
  StrainExtremes extremes_;
};

}  // namespace ixos
