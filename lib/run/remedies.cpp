#include "run/remedies.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace ixos {

std::vector<Remedy> remedies(const Simulation& simulation) {
  const std::string control = "Time Integrator/Time Step Control/";
  const StepControlOptions& steps = simulation.step_control();
  const Table& table = simulation.integrator().table();
  std::vector<Remedy> all;
  if (is_static(table) && simulation.parameters().sublist("Nonlinear Solver").get<int>("Snap Iterations") < 1000)
    all.push_back({"more iterations", "Nonlinear Solver/Snap Iterations=1000"});
  if (!steps.adaptive.on) {
    const bool cuts = steps.maximum_cuts > 0 || is_explicit(table);
    all.push_back({"shorter steps",
                   control + (cuts ? fmt::format("Time Step={:.6g}", steps.time_step / 10) : "Maximum Cuts=10")});
  }
  const auto& materials = simulation.materials();
  const auto has_density = [](const Material& material) { return material.density > 0; };
  if (is_static(table) && std::all_of(materials.begin(), materials.end(), has_density))
    all.push_back({"a dynamic scheme", "Time Integrator/Type=Generalized-Alpha"});
  return all;
}

}  // namespace ixos
