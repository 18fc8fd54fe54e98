#include <algorithm>

#include "time/momentum_form.hpp"
#include "time/schemes.hpp"

namespace ixos {

namespace {

/// Above what the ball at 0.001 T0 and the strip's snap-off at 0.1 T0 show (docs/robustness.md). In closed form the
/// interaction's mean has no error.
double energy_promise(int elastic_points, int interaction_points) {
  const double elastic = elastic_points >= 4 ? 1e-9 : elastic_points == 3 ? 1e-7 : elastic_points == 2 ? 1e-4 : 0;
  const double interaction = interaction_points == 0   ? 1e-9
                             : interaction_points >= 8 ? 2e-6
                             : interaction_points >= 5 ? 2e-5
                                                       : 1e-4;
  return elastic == 0 ? 0 : std::max(elastic, interaction);
}

}  // namespace

Table average_vector_field(int elastic_points, int interaction_points) {
  Stage stage = momentum_form_stage();
  stage.elastic = gauss_rule(elastic_points);
  stage.interaction = mean_rule(interaction_points);
  stage.load = gauss_times(interaction_points);
  Table table = momentum_form_table("Average Vector Field", stage);
  table.interaction_points = interaction_points;
  table.energy_promise = energy_promise(elastic_points, interaction_points);
  return table;
}

}  // namespace ixos
