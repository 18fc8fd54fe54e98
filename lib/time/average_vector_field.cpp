#include "time/momentum_form.hpp"
#include "time/schemes.hpp"

namespace ixos {

Table average_vector_field(int elastic_points, int interaction_points) {
  Stage stage = momentum_form_stage();
  stage.elastic = gauss_rule(elastic_points);
  stage.interaction = mean_rule(interaction_points);
  stage.load = gauss_times(interaction_points);
  Table table = momentum_form_table("Average Vector Field", stage);
  table.interaction_points = interaction_points;
  return table;
}

}  // namespace ixos
