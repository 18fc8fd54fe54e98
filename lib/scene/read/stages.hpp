/// Stages of a scene: runs that follow each other, each with its own scheme, steps, conditions and laws.
#pragma once
#include <Teuchos_ParameterList.hpp>
#include <string>
#include <vector>

#include "scene/read/histories.hpp"

namespace ixos {

/// Adds the list "Stages" to a valid scene.
void declare_stages(Teuchos::ParameterList& scene);

/// The scenes of the stages. The lists of a stage change the scene of the stage before; those of the first stage change
/// the scene itself. Criteria of Stop and Initial Conditions hold for the stage that gives them. A scene
/// without the list "Stages" is one stage without a name.
class Stages {
 public:
  /// `scene`: as a user writes it. Throws InputError, with the path, for a list that no stage may have. Functions of
  /// the program, `given`, go on by the clock of the run.
  explicit Stages(const Teuchos::ParameterList& scene, const GivenHistories& given = {});

  std::size_t count() const { return names_.empty() ? 1 : names_.size(); }
  bool any() const { return !names_.empty(); }
  /// Returns the name of a stage, or of none if the scene has no stages.
  std::string name(std::size_t stage) const { return names_.empty() ? "" : names_[stage]; }
  /// Returns "Stages/NAME", the place for messages; empty if the scene has no stages.
  std::string path(std::size_t stage) const;

  /// Returns the scene of a stage, not yet validated. `begins`: the times at which the stages after the first one, up
  /// to this one, begin [T0]; so their number is that of the stage. Times in a stage with the clock "Stage" count from
  /// there, and a history that it gives adds to the value that the history of that name had there. Only the first scene
  /// has the list "Stages". Throws InputError, with the path of the stage.
  Teuchos::ParameterList scene(const std::vector<double>& begins) const;
  /// Returns whether the stage gives velocities, which it adds to those of the bodies.
  bool gives_velocities(std::size_t stage) const;
  /// Returns the times at which the stages end if those that have not begun, and the last one that has, come to their
  /// Final Time [T0]. Throws as scene().
  std::vector<double> planned_ends(std::vector<double> begins = {}) const;

 private:
  const Teuchos::ParameterList& own(std::size_t stage) const;
  void check(const std::string& name) const;

  Teuchos::ParameterList scene_;
  std::vector<std::string> names_;
  GivenHistories given_;
};

}  // namespace ixos
