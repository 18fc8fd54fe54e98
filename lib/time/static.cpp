#include "time/schemes.hpp"

namespace ixos {

Table static_equilibrium() {
  Stage stage;
  stage.velocity = unknown_displacement() - displacement(0);
  stage.elastic = end_rule();
  stage.interaction = end_rule();
  stage.load = {{1.0, 1.0}};
  Table table{"Static", {stage}, Closing::Kinematic, {WorkSum::Form::EndMean, {}}, Predictor::Nearest};
  table.mass = Inertia::None;
  table.error_constant = 0;
  return table;
}

}  // namespace ixos
