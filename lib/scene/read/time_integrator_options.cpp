#include "scene/read/time_integrator_options.hpp"

#include <vector>

#include "parameters/options.hpp"
#include "parameters/range_validator.hpp"

namespace ixos {
namespace {

/// The entries of "Adaptive". A longest step of 0 is no limit.
struct Adaptive : AdaptiveOptions {
  double maximum_step = 0;
};

/// The entries of "Time Step Control".
struct Control : StepControlOptions {
  bool is_adaptive = false;
  Adaptive limits{};
};

struct Parameters : TimeIntegratorOptions {
  Control control{};
};

std::vector<const Scheme*> all_schemes() {
  std::vector<const Scheme*> all;
  for (const Scheme& scheme : schemes()) all.push_back(&scheme);
  all.push_back(&custom_scheme());
  return all;
}

Options<Adaptive> adaptive_options() {
  return Options<Adaptive>()
      .add("Tolerance", &Adaptive::tolerance, "Largest local error of a displacement in a step [L0]. 0: no limit.",
           at_least(0))
      .add("Maximum Gap Ratio", &Adaptive::gap_ratio,
           "Largest ratio between the gaps that a point of the surface has in a step [-]. It must be "
           "greater than 1. 0: no limit.",
           at_least(0))
      .add("Choose Time Points", &Adaptive::time_points,
           "Chooses 5, 8 or 16 Gauss points in time for the interaction, by the gap ratio of the step.")
      .add("Safety", &Adaptive::safety, "Safety factor: the next step takes this fraction of the predicted size [-].",
           greater_and_less_than(0, 1))
      .add("Largest Growth", &Adaptive::growth, "Largest ratio of a step size to the one before [-].", greater_than(1))
      .add("Maximum Time Step", &Adaptive::maximum_step, "Largest step size [T0]. 0: no limit.", at_least(0));
}

Options<Control> control_options() {
  return Options<Control>()
      .choose_list("Type", &Control::is_adaptive, {{"Fixed", false}, {"Adaptive", true}},
                   "How the step size is chosen. Fixed keeps it; Adaptive checks each step and adapts the size.")
      .add("Initial Time", &Control::initial_time, "Time at which the run starts [T0].", any_number())
      .require("Final Time", &Control::final_time,
               "Time at which the run ends [T0]. It must be later than Initial Time.", any_number())
      .require("Time Step", &Control::time_step,
               "Step size [T0]; with Adaptive, the size of the first step. Steps are shortened where needed, so that "
               "one ends at Final Time and at each multiple of the time intervals of Output.",
               greater_than(0))
      .add("Maximum Cuts", &Control::maximum_cuts,
           "How many times Time Step may be halved after failed steps. With 0, a failed step ends the run. Adaptive "
           "runs ignore it.",
           between(0, 60))
      .add("Minimum Time Step", &Control::minimum_step, "Smallest step size that halving or adapting may choose [T0].",
           at_least(0))
      .sublist("Adaptive", &Control::limits, adaptive_options(),
               "Limits of an adaptive step. A step that exceeds one of them is repeated with a smaller size.");
}

const Options<Parameters>& options() {
  static const Options<Parameters> all = [] {
    Options<Parameters>::Words<std::string> names;
    for (const Scheme* scheme : all_schemes()) names.emplace_back(scheme->name, scheme->name);
    return Options<Parameters>()
        .choose_list("Type", &Parameters::scheme, names,
                     "Name of the time integration scheme. The option list-schemes of ixos prints the properties of "
                     "each.")
        .choose(
            "Predictor", &Parameters::predictor,
            {{"Automatic", std::nullopt},
             {"Last Displacement", Predictor::LastDisplacement},
             {"Constant Velocity", Predictor::ConstantVelocity},
             {"Constant Acceleration", Predictor::ConstantAcceleration},
             {"Newmark", Predictor::Newmark},
             {"Extrapolation", Predictor::Extrapolation},
             {"Quadratic", Predictor::Quadratic},
             {"Nearest", Predictor::Nearest}},
            "Initial guess of Newton's method. Extrapolation is the straight line through the last two displacements, "
            "Quadratic the parabola through the last three. Nearest takes, step by step, the one of Last "
            "Displacement, Constant Velocity, Extrapolation and Quadratic that would have been nearest to the end of "
            "the last step. Automatic is the guess that suits the scheme: Nearest if the scheme has one stage.")
        .choose(
            "Velocity After Static", &Parameters::keeps_static_rates, {{"Zero", false}, {"Rate", true}},
            "Velocity of a body at a restart from a checkpoint of the scheme Static. Zero: the equilibrium is at "
            "rest. Rate: the body moves on with the rate of the last load step, the change of its displacement over "
            "the step's length. Prescribed displacements follow their histories in both cases.")
        .sublist("Time Step Control", &Parameters::control, control_options(),
                 "Times of the run, and size of its steps.");
  }();
  return all;
}

}  // namespace

void declare_time_integrator(Teuchos::ParameterList& list) {
  for (const Scheme* scheme : all_schemes()) {
    list.sublist(scheme->name, false, scheme->citation) = scheme->parameters;
    list.sublist(scheme->name).setName(scheme->name);
  }
  options().declare(list);
}

TimeIntegratorOptions read_time_integrator(const SceneNode& time_integrator, const OutputOptions& output) {
  Parameters read = options().read(time_integrator);
  StepControlOptions& control = read.step_control;
  control = read.control;
  control.output_intervals = output.time_intervals();
  if (read.control.is_adaptive) {
    const Adaptive& limits = read.control.limits;
    control.adaptive = limits;
    control.adaptive.on = true;
    if (limits.maximum_step > 0) control.maximum_step = limits.maximum_step;
  }
  return read;
}

}  // namespace ixos
