#include "time/momentum_form.hpp"
#include "time/schemes.hpp"

namespace ixos {

namespace {

/// Above what the ball shows by the number of points (docs/theory.md).
double energy_promise(int elastic_points) {
  return elastic_points >= 4 ? 1e-9 : elastic_points == 3 ? 1e-7 : elastic_points == 2 ? 1e-4 : 0;
}

}  // namespace

Table average_vector_field(int elastic_points, int interaction_points) {
  Stage stage = momentum_form_stage();
  stage.elastic = gauss_rule(elastic_points);
  stage.interaction = mean_rule(interaction_points);
  stage.load = gauss_times(interaction_points);
  Table table = momentum_form_table("Average Vector Field", stage);
  table.interaction_points = interaction_points;
  table.energy_promise = energy_promise(elastic_points);
  return table;
}

}  // namespace ixos
