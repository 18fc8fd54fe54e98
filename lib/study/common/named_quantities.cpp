#include "study/common/named_quantities.hpp"

#include "parameters/scene_node.hpp"

namespace ixos {

std::vector<AskedQuantity> named_quantities(const Simulation& simulation) {
  std::vector<AskedQuantity> quantities;
  if (simulation.output().quantities.empty()) return quantities;
  at("Output/Quantities", [&] {
    const std::vector<std::string>& columns = simulation.run_columns();
    for (const std::string& text : simulation.output().quantities) {
      quantities.emplace_back(text);
      quantities.back().check_columns(columns);
    }
  });
  return quantities;
}

void check_times(const std::vector<AskedQuantity>& quantities, const Simulation& simulation) {
  const StepControlOptions& control = simulation.step_control();
  at("Output/Quantities", [&] {
    for (const AskedQuantity& quantity : quantities) quantity.check_times(control.initial_time, control.final_time);
  });
}

}  // namespace ixos
