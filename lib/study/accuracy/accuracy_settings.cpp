#include "study/accuracy/accuracy_settings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "interaction/gap_law.hpp"
#include "study/common/tuning.hpp"

namespace ixos {
namespace {

double smallest_size(const Simulation& simulation) {
  double size = std::numeric_limits<double>::infinity();
  for (const BodyNumbers& body : simulation.characteristic_numbers().bodies) size = std::min(size, body.size);
  return size;
}

bool has_gap_ratio(const Simulation& simulation) {
  const auto& all = simulation.interactions();
  return std::any_of(all.begin(), all.end(), [](const SceneInteraction& interaction) {
    return interaction.law->domain() == GapDomain::Positive;
  });
}

}  // namespace

AccuracySettings first_settings(const Simulation& simulation, double accuracy) {
  const std::string& scheme = simulation.time_integrator().scheme;
  const Table& table = simulation.integrator().table();
  if (simulation.stages().any())
    throw InputError(
        "--accuracy: the scene has Stages, which set their own steps: choose them in the scene, or vary them by "
        "ixos-study --scan");
  if (table.mass == Inertia::None)
    throw InputError(
        "--accuracy: the Time Integrator/Type \"" + scheme +
        "\" has load steps, which have no estimate of their error; use ixos-study --advise, or another Type");
  if (table.error_constant == 0)
    throw InputError("--accuracy: the Time Integrator/Type \"" + scheme +
                     "\" has no estimate of its local error, by which steps adapt; choose another one, such as \"" +
                     default_scheme() + "\"");
  const StepControlOptions& control = simulation.step_control();
  const AdaptiveOptions& own = control.adaptive;
  AccuracySettings coarse;
  coarse.tolerance = own.tolerance > 0 ? own.tolerance : tuning::coarse_accuracy * smallest_size(simulation);
  if (has_gap_ratio(simulation)) coarse.gap_ratio = own.gap_ratio > 0 ? own.gap_ratio : tuning::coarse_gap_ratio;
  coarse.longest_step =
      std::min(control.maximum_step, (control.final_time - control.initial_time) / tuning::coarse_steps);
  coarse.newton_tolerance = tuning::coarse_newton;
  const AdaptOptions& mesh = simulation.adaptation();
  if (mesh.on()) coarse.mesh = {mesh.levels, mesh.part, mesh.strain};
  return refined(coarse, std::min(1.0, std::sqrt(accuracy / tuning::coarse_accuracy)));
}

AccuracySettings refined(const AccuracySettings& settings, double part) {
  const double cube = part * part * part;
  AccuracySettings finer = settings;
  finer.tolerance = settings.tolerance * cube;
  finer.gap_ratio = settings.gap_ratio > 0 ? std::pow(settings.gap_ratio, part) : 0;
  finer.longest_step = settings.longest_step * part;
  finer.newton_tolerance = std::max(settings.newton_tolerance * cube, tuning::least_newton);
  return finer;
}

bool has_finer_mesh(const AccuracySettings& settings) {
  return settings.mesh.levels > 0 && settings.mesh.levels < most_adapt_levels &&
         settings.mesh.part / 2 >= least_adapt_part;
}

AccuracySettings with_finer_mesh(const AccuracySettings& settings) {
  AccuracySettings finer = settings;
  ++finer.mesh.levels;
  finer.mesh.part /= 2;
  finer.mesh.strain /= 2;
  return finer;
}

Assignments assignments(const AccuracySettings& settings) {
  const std::string control = "Time Integrator/Time Step Control/", adaptive = control + "Adaptive/";
  Assignments all{control + "Type=Adaptive", fmt::format("{}Tolerance={:.6g}", adaptive, settings.tolerance),
                  fmt::format("{}Maximum Gap Ratio={:.9g}", adaptive, settings.gap_ratio),
                  fmt::format("{}Maximum Time Step={:.6g}", adaptive, settings.longest_step),
                  fmt::format("Nonlinear Solver/Tolerance={:.3g}", settings.newton_tolerance)};
  if (settings.mesh.levels > 0) {
    all.push_back(fmt::format("Mesh/Adapt/Levels={}", settings.mesh.levels));
    all.push_back(fmt::format("Mesh/Adapt/Part={:.6g}", settings.mesh.part));
    all.push_back(fmt::format("Mesh/Adapt/Strain={:.6g}", settings.mesh.strain));
  }
  return all;
}

}  // namespace ixos
