#include "run/remedies.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "time/equilibrium.hpp"

namespace ixos {
namespace {

/// Returns the way to shorter steps, of which there are several.
Remedy shorter_steps(const Simulation& simulation) {
  const std::string control = "Time Integrator/Time Step Control/";
  const StepControlOptions& steps = simulation.step_control();
  const Table& table = simulation.integrator().table();
  if (is_explicit(table))
    return {"shorter steps", fmt::format("Time Integrator/{}/Safety={:.6g}", table.name, table.safety / 2)};
  if (steps.adaptive.tolerance > 0)
    return {"a larger tolerance", fmt::format("{}Adaptive/Tolerance={:.6g}", control, 10 * steps.adaptive.tolerance)};
  if (steps.adaptive.on)
    return {"longer steps", fmt::format("{}Adaptive/Maximum Gap Ratio={:.6g}", control, 2 * steps.adaptive.gap_ratio)};
  if (steps.maximum_cuts > 0)
    return {"shorter steps", fmt::format("{}Time Step={:.6g}", control, steps.time_step / 10)};
  return {"shorter steps", control + "Maximum Cuts=10"};
}

}  // namespace

std::vector<Remedy> remedies(const Simulation& simulation, bool ran_out) {
  std::vector<Remedy> all;
  const bool is_quasi_static = is_static(simulation.integrator().table());
  const int snap = simulation.parameters().sublist("Nonlinear Solver").get<int>("Snap Iterations");
  if (is_quasi_static && snap < 1000 && ran_out)
    all.push_back({"more iterations", "Nonlinear Solver/Snap Iterations=1000"});
  all.push_back(shorter_steps(simulation));
  if (!is_quasi_static) return all;
  const auto& materials = simulation.materials();
  const auto has_density = [](const Material& material) { return material.density > 0; };
  if (!std::all_of(materials.begin(), materials.end(), has_density)) return all;
  // Shorter steps only come nearer to the largest load that the body bears.
  const bool is_overloaded =
      load_grows(simulation.model(), simulation.integrator().state(), simulation.step_control().time_step);
  all.insert(is_overloaded ? all.begin() : all.end(),
             {"a dynamic scheme, which needs motions with an acceleration", "Time Integrator/Type=Generalized-Alpha"});
  return all;
}

}  // namespace ixos
