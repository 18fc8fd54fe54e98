#include "time/momentum_form.hpp"

namespace ixos {

Stage momentum_form_stage() {
  const Row du = unknown_displacement() - displacement(0);
  Stage stage;
  stage.velocity = 2 * du - velocity(0);
  stage.acceleration = 4 * du - 4 * velocity(0) - acceleration(0);
  stage.inertia = stage.velocity - velocity(0);
  stage.damping = du;
  stage.rate_form = RateForm::Middle;
  return stage;
}

Table momentum_form_table(const char* name, const Stage& stage) {
  return {name, {stage}, Closing::Collocate, {WorkSum::Form::Increment, {}}, Predictor::Nearest};
}

}  // namespace ixos
