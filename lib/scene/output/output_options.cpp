#include "scene/output/output_options.hpp"

#include "parameters/options.hpp"
#include "parameters/range_validator.hpp"
#include "scene/output/output_fields.hpp"
#include "scene/output/output_norms.hpp"

namespace ixos {
namespace {

Options<CheckpointOptions> checkpoint_options() {
  return Options<CheckpointOptions>()
      .add("Interval", &CheckpointOptions::interval,
           "Number of steps between checkpoints. 0: only Wall-Clock Interval counts.", between(0, 1000000000))
      .add("Wall-Clock Interval", &CheckpointOptions::clock_interval,
           "Wall-clock time between checkpoints [s]. 0: only Interval counts.", at_least(0))
      .add("Keep", &CheckpointOptions::keep, "Number of latest checkpoints that are kept. 0: the run writes none.",
           between(0, 1000));
}

Options<WatchOptions> watch_options() {
  return Options<WatchOptions>()
      .choose("Action", &WatchOptions::action,
              {{"Off", WatchAction::Off},
               {"Warn", WatchAction::Warn},
               {"Stop", WatchAction::Stop},
               {"Resume", WatchAction::Resume}},
              "The consequence of a row that breaks the bound. Warn prints one warning; Stop ends the run; Resume goes "
              "back to the last checkpoint, and ends the run if that does not help.")
      .add("Tolerance", &WatchOptions::tolerance,
           "Largest change of the energy balance in a step, as a share of the largest energy so far [-]. 0: what the "
           "scheme, its points in time and the tolerance of Newton's method promise; then only schemes that conserve "
           "energy are watched, in scenes where nothing dissipates (damping, viscosity, Maxwell branches, dashpots, "
           "friction, Bilinear Damage), and with Interaction Points above 0 only if no obstacle moves and all laws "
           "need positive gaps.",
           at_least(0));
}

const Options<OutputOptions>& options() {
  static const Options<OutputOptions> all =
      Options<OutputOptions>()
          .add("History Interval", &OutputOptions::history_interval,
               "Number of steps between rows of history.csv. The last state is always a row.", between(1, 1000000000))
          .add("Fields Interval", &OutputOptions::fields_interval,
               "Number of steps between frames of fields.e. 0: no frames.", between(0, 1000000000))
          .choose("Fields Format", &OutputOptions::fields_format,
                  {{"Exodus", FieldsFormat::Exodus}, {"HDF5", FieldsFormat::Hdf5}},
                  "Format of fields.e. Exodus writes one file per rank; HDF5 writes one file that all ranks share "
                  "(Exodus on HDF5).")
          .add("Fields", &OutputOptions::fields, output_fields_documentation())
          .add("History Time Interval", &OutputOptions::history_time_interval,
               "Time between rows of history.csv [T0]. It replaces History Interval unless it is 0.", at_least(0))
          .add("Fields Time Interval", &OutputOptions::fields_time_interval,
               "Time between frames of fields.e [T0]. It replaces Fields Interval unless it is 0.", at_least(0))
          .sublist("Checkpoint", &OutputOptions::checkpoint, checkpoint_options(),
                   "Checkpoints, from which a run can be resumed. A run also writes one at its end and on SIGINT or "
                   "SIGTERM.")
          .sublist("Watch", &OutputOptions::watch, watch_options(),
                   "Watch on the energy balance, row by row of history.csv. It needs Energies. It finds steps that are "
                   "too long for the scheme's points in time, and damaged memory.")
          .add("Energies", &OutputOptions::energies, "Whether history.csv has the energies.")
          .add("Momenta", &OutputOptions::momenta, "Whether history.csv has the momenta.")
          .add("Interaction", &OutputOptions::interaction,
               "Whether history.csv has contact force, contact measure and least gap.")
          .add("Strains", &OutputOptions::strains,
               "Whether history.csv has the largest rotation of a quadrature point [rad] and the least and largest "
               "principal strain, a stretch less 1 [-].")
          .choose("Interaction Columns", &OutputOptions::interaction_columns,
                  {{"Automatic", InteractionColumns::Automatic},
                   {"On", InteractionColumns::On},
                   {"Off", InteractionColumns::Off}},
                  "Whether history.csv has force, moment about the origin, contact measure and least gap of each "
                  "interaction under its name. Automatic: if the scene has several interactions and Interaction is "
                  "true.")
          .add("Reactions", &OutputOptions::reactions, "Node sets whose reactions become columns of history.csv.")
          .add("Norms", &OutputOptions::norms, output_norms_documentation())
          .add("Quantities", &OutputOptions::quantities,
               "Numbers of the run that the option accuracy of ixos asks for, such as {peak reaction_top_y, mean "
               "contact_force_y [20, 50]} (docs/user-guide.md, Advice). The option advise of ixos-study takes them if "
               "its command names none.");
  return all;
}

}  // namespace

std::vector<double> OutputOptions::time_intervals() const {
  std::vector<double> result;
  for (double interval : {history_time_interval, fields_time_interval})
    if (interval > 0) result.push_back(interval);
  return result;
}

bool has_interaction_columns(const OutputOptions& output, std::size_t interactions) {
  if (output.interaction_columns != InteractionColumns::Automatic)
    return output.interaction_columns == InteractionColumns::On;
  return output.interaction && interactions > 1;
}

void declare_output(Teuchos::ParameterList& list) { options().declare(list); }

OutputOptions read_output(const SceneNode& output, const std::vector<std::string>& interactions) {
  OutputOptions result = options().read(output);
  check_field_names(output, "Fields", result.fields, interactions);
  check_norm_names(output, "Norms", result.norms);
  return result;
}

}  // namespace ixos
