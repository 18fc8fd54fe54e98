/// Settings of the results that a run writes: the list "Output" of a scene.
#pragma once
#include <Teuchos_ParameterList.hpp>
#include <string>
#include <vector>

#include "parameters/scene_node.hpp"

namespace ixos {

enum class FieldsFormat { Exodus, Hdf5 };

/// Whether history.csv has columns of each interaction alone. Automatic: if the scene has several.
enum class InteractionColumns { Automatic, On, Off };

/// The list "Output/Checkpoint".
struct CheckpointOptions {
  int interval = 0;             ///< steps between checkpoints; 0: none by steps
  double clock_interval = 600;  ///< seconds between checkpoints; 0: none by the clock
  int keep = 2;                 ///< number of latest checkpoints that are kept; 0: none is written
};

/// Actions of the energy watch on a row that breaks its bound.
enum class WatchAction { Off, Warn, Stop, Resume };

/// The list "Output/Watch".
struct WatchOptions {
  WatchAction action = WatchAction::Warn;
  double tolerance = 0;  ///< change of the balance in a step, over the largest energy; 0: the scheme sets it
};

/// The list "Output" without its probes: find_probes() reads those.
struct OutputOptions {
  int history_interval = 1;  ///< steps between rows
  int fields_interval = 0;   ///< steps between frames; 0: no frames
  FieldsFormat fields_format = FieldsFormat::Exodus;
  std::vector<std::string> fields{};  ///< names of chosen_fields(); empty: the usual ones
  double history_time_interval = 0;   ///< between rows [T0]; 0: history_interval counts
  double fields_time_interval = 0;    ///< between frames [T0]; 0: fields_interval counts
  CheckpointOptions checkpoint{};
  WatchOptions watch{};
  bool energies = true;     ///< whether history.csv has these columns
  bool momenta = true;      ///< the same
  bool interaction = true;  ///< the same
  bool strains = false;     ///< whether it has strain_columns
  InteractionColumns interaction_columns = InteractionColumns::Automatic;
  std::vector<std::string> reactions{};   ///< node sets whose reactions are recorded
  std::vector<std::string> norms{};       ///< fields whose norms are recorded
  std::vector<std::string> quantities{};  ///< numbers of the run whose accuracy counts

  bool has_frames() const { return fields_interval > 0 || fields_time_interval > 0; }
  /// Returns the time intervals [T0] at whose multiples steps have to end.
  std::vector<double> time_intervals() const;
};

/// Adds the parameters of OutputOptions to a valid list.
void declare_output(Teuchos::ParameterList& list);

/// Returns whether history.csv of a scene with that number of interactions has columns of each alone. Automatic ones
/// need the group "Interaction".
bool has_interaction_columns(const OutputOptions& output, std::size_t interactions);

/// Returns the options of the validated list "Output" of a scene with these interactions. Throws InputError if a name
/// is no field.
OutputOptions read_output(const SceneNode& output, const std::vector<std::string>& interactions = {});

}  // namespace ixos
