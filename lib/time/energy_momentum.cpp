#include "time/momentum_form.hpp"
#include "time/schemes.hpp"

namespace ixos {

Table energy_momentum() {
  Stage stage = momentum_form_stage();
  stage.elastic = discrete_gradient_rule();
  stage.interaction = discrete_gradient_rule();
  stage.load = gauss_times(0);
  stage.nearby = {gauss_rule(4), gauss_rule(16)};  // the average vector field
  Table table = momentum_form_table("Energy-Momentum", stage);
  table.energy_promise = 1e-10;
  return table;
}

}  // namespace ixos
