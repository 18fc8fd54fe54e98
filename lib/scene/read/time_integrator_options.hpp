/// Settings of the scheme and of the steps of a run: the list "Time Integrator" of a scene.
#pragma once
#include <Teuchos_ParameterList.hpp>
#include <optional>
#include <string>

#include "parameters/scene_node.hpp"
#include "scene/output/output_options.hpp"
#include "time/catalogue.hpp"
#include "time/step_control.hpp"
#include "time/table.hpp"

namespace ixos {

/// The list "Time Integrator" without the schemes' own lists and the criteria that end a run.
struct TimeIntegratorOptions {
  std::string scheme = default_scheme();
  std::optional<Predictor> predictor{};  ///< empty: the scheme's own
  bool keeps_static_rates = false;       ///< see Integrator::keep_static_rates
  StepControlOptions step_control{};
};

/// Adds the parameters of TimeIntegratorOptions, and the lists of the schemes, to a valid list.
void declare_time_integrator(Teuchos::ParameterList& list);

/// Returns the options of the validated list "Time Integrator". Steps end at the time intervals of `output`.
TimeIntegratorOptions read_time_integrator(const SceneNode& time_integrator, const OutputOptions& output);

}  // namespace ixos
