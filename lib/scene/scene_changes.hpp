/// The changes between the scene of a checkpoint and the one that resumes from it.
#pragma once
#include <Teuchos_ParameterList.hpp>
#include <string>
#include <vector>

namespace ixos {

/// The effect of a change on a restart.
enum class Bearing {
  None,      ///< the motion is the same: what is written, when the run ends
  Solution,  ///< the same equations solved by other means: to tolerance, not bit for bit
  Motion,    ///< the run resumes from the same displacements and velocities with other laws, steps or schemes
  State      ///< the state itself would be another one: not allowed
};

struct SceneChange {
  std::string path;         ///< "List/Sublist/Name"
  std::string before, now;  ///< values as in XML; "absent" if the scene has none
  Bearing bearing = Bearing::Motion;

  /// Returns "Time Integrator/Type: "Newmark", now "Bathe Composite"".
  std::string text() const;
};

/// Returns the scene with the defaults of the parameters that it lacks, such as those that came after the version that
/// wrote it. Returns the scene itself if this version refuses it.
Teuchos::ParameterList with_defaults(const Teuchos::ParameterList& scene);

/// Returns XXH3 (128 bits), as 32 hexadecimal digits, of the parameters of a complete scene that define its problem, as
/// for changes_of_problem(), and of the fingerprint of its mesh.
std::string scene_digest(const Teuchos::ParameterList& scene, const std::string& mesh_fingerprint);

/// Returns the differences that make `now`, a complete scene, another problem than `before`, a scene as read from a
/// file: all but those of Output, Stop, Final Time and the solvers' settings. Fills in the defaults of `before`, unless
/// this version refuses it.
std::vector<SceneChange> changes_of_problem(const Teuchos::ParameterList& before, const Teuchos::ParameterList& now);

/// Returns the differences of two complete scenes, in the order of the second's lists. Files of one name in two folders
/// are no difference.
std::vector<SceneChange> scene_changes(const Teuchos::ParameterList& before, const Teuchos::ParameterList& now);

}  // namespace ixos
