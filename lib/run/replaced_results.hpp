/// Results that a run would replace.
#pragma once
#include <string>

#include "scene/simulation.hpp"

namespace ixos {

/// Returns to which simulation of a run a name in a results folder belongs, from 1, if it is that of frames or of a
/// scene: fields.e and effective.xml of the first, fields-2.e and effective-2.xml of the second; fields.e-s.0002 of the
/// second mesh that follows the front; fields.e.N.r is of rank r of N. Otherwise 0.
struct NumberedResult {
  long frames = 0, scene = 0;
};
NumberedResult numbered_result(const std::string& name);

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
