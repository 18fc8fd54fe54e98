#include "time/schemes.hpp"

namespace ixos {

Table average_vector_field(int elastic_points, int interaction_points) {
  const Row du = unknown_displacement() - displacement(0);
  Stage stage;
  stage.velocity = 2 * du - velocity(0);
  stage.acceleration = 4 * du - 4 * velocity(0) - acceleration(0);
  stage.inertia = stage.velocity - velocity(0);
  stage.damping = du;
  stage.elastic = gauss_rule(elastic_points);
  stage.interaction = mean_rule(interaction_points);
  stage.load = gauss_times(interaction_points);
  return {
      "Average Vector Field", {stage}, Closing::Collocate, {WorkSum::Form::Increment, {}}, Predictor::LastDisplacement};
}

}  // namespace ixos
