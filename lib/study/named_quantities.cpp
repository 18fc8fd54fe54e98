#include "study/named_quantities.hpp"

#include "parameters/scene_node.hpp"
#include "scene/history_columns.hpp"

namespace ixos {

std::vector<AskedQuantity> named_quantities(const Simulation& simulation) {
  std::vector<AskedQuantity> quantities;
  if (simulation.output().quantities.empty()) return quantities;
  at("Output/Quantities", [&] {
    const std::vector<std::string> columns = history_columns(simulation).names;
    const StepControlOptions& control = simulation.step_control();
    for (const std::string& text : simulation.output().quantities) {
      quantities.emplace_back(text);
      quantities.back().check_columns(columns);
      quantities.back().check_times(control.initial_time, control.final_time);
    }
  });
  return quantities;
}

}  // namespace ixos
