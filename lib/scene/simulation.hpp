/// A scene made ready to run.
#pragma once
#include <Teuchos_ParameterList.hpp>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "adapt/options.hpp"
#include "adapt/split_mesh.hpp"
#include "base/tpetra.hpp"
#include "base/warning.hpp"
#include "mesh/quality.hpp"
#include "mesh/set_size.hpp"
#include "mesh/splitting/refine.hpp"
#include "scene/examine/characteristic_numbers.hpp"
#include "scene/output/output_options.hpp"
#include "scene/read/histories.hpp"
#include "scene/read/interactions.hpp"
#include "scene/read/probes.hpp"
#include "scene/read/stages.hpp"
#include "scene/read/stop.hpp"
#include "scene/read/time_integrator_options.hpp"
#include "solve/newton/newton.hpp"
#include "time/integrator.hpp"
#include "time/step_control.hpp"
#include "units/result_units.hpp"

namespace ixos {

/// The objects that a scene asks for, built and at their initial state; of a scene with the list "Stages", those of its
/// first stage. Collective.
class Simulation {
 public:
  /// `scene` is as a user writes it; the constructor converts units and validates it, and builds each later stage once
  /// for its warnings and columns. `folder` is the folder of the scene's file, for mesh files named relative to it.
  /// `given` are histories that the program evaluates, see Histories. Throws InputError with the list path.
  Simulation(const Teuchos::ParameterList& scene, const Comm& comm, const std::string& folder = ".",
             const GivenHistories& given = {});

  /// Makes the simulation on a mesh of the caller's, which is whole and the same on all ranks. It takes the place of
  /// the scene's mesh; the scene's "Mesh/Sets" are added to its own. Throws InputError also for arrays that
  /// check_arrays() refuses.
  Simulation(const Teuchos::ParameterList& scene, const Mesh& mesh, const Comm& comm, const GivenHistories& given = {});

  Simulation(const Simulation&) = delete;
  Simulation& operator=(const Simulation&) = delete;

  const Teuchos::ParameterList& parameters() const { return parameters_; }  ///< complete, in plain numbers
  const UnitSystem& units() const { return units_; }                        ///< what the plain numbers refer to
  const std::vector<ResultUnit>& result_units() const { return result_units_; }
  const std::vector<Material>& materials() const { return materials_; }
  const std::vector<SceneInteraction>& interactions() const { return interactions_; }
  const Model& model() const { return *model_; }
  Model& model() { return *model_; }
  Integrator& integrator() { return *integrator_; }
  const Integrator& integrator() const { return *integrator_; }
  const OutputOptions& output() const { return output_; }
  const TimeIntegratorOptions& time_integrator() const { return time_integrator_; }
  const StepControlOptions& step_control() const { return time_integrator_.step_control; }
  const NewtonOptions& newton() const { return newton_; }
  const std::vector<Probe>& probes() const { return probes_; }
  StopCriteria stop_criteria() const;
  const std::string& mesh_fingerprint() const { return mesh_fingerprint_; }  ///< see fingerprint()
  const MeshQuality& mesh_quality() const { return mesh_quality_; }

  const Stages& stages() const { return plan_->stages; }
  /// Returns the number of this stage, from 0, and the times at which it and those after the first one began [T0].
  std::size_t stage() const { return begins_.size(); }
  const std::vector<double>& stage_begins() const { return begins_; }
  bool has_next_stage() const { return stage() + 1 < stages().count(); }
  /// Builds the next stage, which begins at that time [T0], on the mesh and the partition of this one, without a state:
  /// hand_over() or a checkpoint gives it that of this one. Throws std::logic_error if there is none; InputError as the
  /// constructor does.
  std::unique_ptr<Simulation> next_stage(double begin) const;
  /// Returns the time at which the last stage ends if each comes to its Final Time [T0].
  double planned_end() const { return planned_end_; }
  /// Returns the columns of history.csv, with those of other stages.
  const std::vector<std::string>& run_columns() const { return plan_->columns; }
  /// Returns the velocities that the list "Initial Conditions" gives [L0/T0], a local array.
  std::vector<double> given_velocities() const;

  /// Returns how the mesh follows the front.
  const AdaptOptions& adaptation() const { return adaptation_; }
  /// Returns the mesh that may change, and how its cells were split. Throws std::logic_error if it stays.
  const SplitMesh& split_mesh() const;
  /// Returns the places of the scene's list "Mesh/Refine".
  std::vector<NamedRegion> refined_places() const;
  /// Builds the same scene on a mesh whose cells are split so, with nodes divided anew, without a state:
  /// Integrator::initialize() or a checkpoint gives it one. Throws InputError as the constructor does.
  std::unique_ptr<Simulation> on_mesh(const CellSplits& splits) const;
  /// Returns what tells results of this scene's mesh from those of another one: mesh_fingerprint(), or that of the
  /// unsplit mesh if the mesh follows the front.
  std::string fingerprint_of_results() const;

  const std::vector<SetSize>& set_sizes() const { return set_sizes_; }  ///< before contact elements add nodes
  const CharacteristicNumbers& characteristic_numbers() const { return numbers_; }
  /// Returns warnings for the user about settings that are allowed but may be a mistake.
  const std::vector<Warning>& warnings() const { return warnings_; }
  /// Tells that a run resumes from a checkpoint: drops the warnings about the initial time.
  void resumes();
  /// Returns what Ixos left out of a mesh file, how large that mesh is, and which ramps outlast the run, in sentences.
  const std::vector<std::string>& notes() const { return notes_; }
  /// Returns what the scene may leave out unintended, see scene_notes().
  const std::vector<std::string>& hints() const { return hints_; }
  double setup_seconds() const { return setup_seconds_; }

 private:
  Table chosen_table() const;
  std::vector<int> partition(const Mesh& mesh, int ranks, Inertia inertia) const;
  /// Extracts a rank's part, with its coarse cells if the solver may use them.
  LocalMesh local_mesh(const Mesh& mesh, const std::vector<int>& owner, int rank, int ranks, Inertia inertia) const;
  /// The sources of the simulations of all stages, and what these have in common.
  struct Plan {
    Stages stages;
    std::function<Teuchos::ParameterList(const Teuchos::ParameterList&)> with_files;
    std::function<Mesh(Teuchos::ParameterList& list, bool bubbles, const Splitting& splitting)> make_mesh;
    std::function<void(const Teuchos::ParameterList& list)> prepare;  ///< before make_mesh, on the first rank
    GivenHistories given;
    std::vector<std::string> columns{};
    // next_stage() sets these for the simulation that it builds on the mesh of the stage before; else they are empty.
    std::vector<int> owner{};  ///< the ranks of the nodes
    std::string mesh{};        ///< the fingerprint that the mesh must have
  };
  static Plan given_mesh_plan(const Teuchos::ParameterList& scene, const Mesh& mesh, const GivenHistories& given);
  /// `splits`: of a mesh that follows the front, whose state comes later; null: those of the list "Refine".
  Simulation(std::shared_ptr<Plan> plan, const Comm& comm, std::vector<double> begins,
             const CellSplits* splits = nullptr);
  bool some_stage_needs_bubbles() const;
  Mesh whole_mesh(const CellSplits* splits, Inertia inertia);
  void build_model(const Comm& comm, Inertia inertia, const CellSplits* splits);
  void look_ahead();
  void refuse_jump_to(const Simulation& next) const;
  void build_integrator(Table table);
  void set_initial_state();

  std::shared_ptr<Plan> plan_;
  std::vector<double> begins_;
  double planned_end_ = 0;
  Teuchos::ParameterList parameters_;
  const UnitSystem units_;
  std::vector<ResultUnit> result_units_;
  OutputOptions output_;
  const TimeIntegratorOptions time_integrator_;
  const NewtonOptions newton_;
  std::vector<Material> materials_;
  std::vector<SceneInteraction> interactions_;
  std::unique_ptr<Model> model_;
  std::unique_ptr<Integrator> integrator_;
  AdaptOptions adaptation_;
  std::unique_ptr<const SplitMesh> split_mesh_;  ///< null if the mesh stays
  std::vector<int> owner_;                       ///< the ranks of the nodes, if there are several stages
  std::vector<Probe> probes_;
  std::string mesh_fingerprint_;
  MeshQuality mesh_quality_;
  std::vector<SetSize> set_sizes_;
  CharacteristicNumbers numbers_;
  std::vector<Warning> warnings_;
  std::vector<std::string> notes_, hints_;
  double setup_seconds_ = 0;
};

}  // namespace ixos
