/// A scene made ready to run.
#pragma once
#include <Teuchos_ParameterList.hpp>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "base/tpetra.hpp"
#include "base/warning.hpp"
#include "mesh/quality.hpp"
#include "mesh/set_size.hpp"
#include "scene/examine/characteristic_numbers.hpp"
#include "scene/output/output_options.hpp"
#include "scene/read/histories.hpp"
#include "scene/read/interactions.hpp"
#include "scene/read/probes.hpp"
#include "scene/read/stop.hpp"
#include "scene/read/time_integrator_options.hpp"
#include "solve/newton/newton.hpp"
#include "time/integrator.hpp"
#include "time/step_control.hpp"
#include "units/result_units.hpp"

namespace ixos {

/// The objects that a scene asks for, built and at their initial state. Collective.
class Simulation {
 public:
  /// `scene` is as a user writes it; the constructor converts units and validates it. `folder` is the folder of the
  /// scene's file, for mesh files named relative to it. `given` are histories that the program evaluates, see
  /// Histories. Throws InputError with the list path.
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
  using MakeMesh = std::function<Mesh(Teuchos::ParameterList& list)>;
  Simulation(const Teuchos::ParameterList& scene, const Comm& comm, const MakeMesh& make_mesh,
             const GivenHistories& given);
  void build_model(const Comm& comm, const MakeMesh& make_mesh, const GivenHistories& given, Inertia inertia);
  void build_integrator(Table table);
  void set_initial_state();

  Teuchos::ParameterList parameters_;
  const UnitSystem units_;
  std::vector<ResultUnit> result_units_;
  const OutputOptions output_;
  const TimeIntegratorOptions time_integrator_;
  const NewtonOptions newton_;
  std::vector<Material> materials_;
  std::vector<SceneInteraction> interactions_;
  std::unique_ptr<Model> model_;
  std::unique_ptr<Integrator> integrator_;
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
