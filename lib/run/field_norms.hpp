/// The norms of fields in history.csv.
#pragma once
#include <vector>

#include "scene/output/output_norms.hpp"

namespace ixos {

/// Evaluates the norms of "Output/Norms". The norm of a field f is sqrt(1/V int |f|^2 dV), V the reference volume of
/// all bodies: the L2 norm over sqrt(V). It has the unit of the field. |f|^2 sums the squares of all components, those
/// of the shears of a tensor twice. Fields of cells count with the means of cells. Collective.
class FieldNorms {
 public:
  /// `names`: a checked list. Keeps nothing if it is empty. Throws InputError as norm_fields().
  FieldNorms(const std::vector<std::string>& names, const Model& model);

  /// Returns the norms of the present state in the order of the names. NaN: the state does not have the field.
  std::vector<double> values(Integrator& integrator) const;

 private:
  double cell_square(const OutputField& field, FieldFrame& frame) const;

  std::vector<OutputField> fields_;
  std::vector<std::vector<double>> volumes_;  ///< see owned_volumes()
  double volume_ = 0;                         ///< of all ranks [L0^D]
};

}  // namespace ixos
