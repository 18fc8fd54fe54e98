#include "time/momentum_form.hpp"
#include "time/schemes.hpp"

namespace ixos {

Table midpoint(bool exact_interaction) {
  Stage stage = momentum_form_stage();
  stage.elastic = point_rule({0.5}, {1.0});
  stage.interaction = exact_interaction ? exact_rule() : stage.elastic;
  stage.load = {{0.5, 1.0}};
  return momentum_form_table("Midpoint", stage);
}

}  // namespace ixos
