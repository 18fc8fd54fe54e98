/// Results that a run would replace.
#pragma once
#include <string>

#include "scene/simulation.hpp"

namespace ixos {

/// Returns whether a name in a results folder is that of a frames file: fields.e, or fields.e.N.r of rank r of N.
bool is_frames_file(const std::string& name);

/// The results in a folder that a run replaces.
struct ReplacedResults {
  std::string note;         ///< a line for the user; empty if the folder holds no results
  bool of_another = false;  ///< they are of another scene, or of none that can be read
};

/// Looks for results in the folder of a run that starts new files. Changes nothing.
///
/// The results are those of the same scene if effective.xml differs from the present scene in Output, Stop, Final Time
/// and the solvers' settings at most, and if summary.json, where there is one, has the same fingerprint of the mesh,
/// and counts the same cells and degrees of freedom: a mesh file may have changed. Defaults of parameters that an
/// earlier version lacked count as given. Files of other names do not matter.
///
/// Throws InputError, unless `overwrite` is set, if
/// the results are those of another scene, or if files with the names of results come without a scene that can be read.
/// Collective: the first rank looks.
ReplacedResults replaced_results(const Simulation& simulation, const std::string& folder, bool overwrite);

}  // namespace ixos
