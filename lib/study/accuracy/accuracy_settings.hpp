/// The settings of the runs by which ixos reaches an accuracy.
#pragma once
#include "scene/simulation.hpp"
#include "study/common/study_run.hpp"

namespace ixos {

/// Limits of a mesh that follows the front, see AdaptOptions.
struct MeshSettings {
  int levels = 0;  ///< 0: the mesh stays, and is not judged
  double part = 0, strain = 0;
};

/// Limits of adaptive steps, the tolerance of Newton's method, and limits of the mesh.
struct AccuracySettings {
  double tolerance = 0;         ///< largest local error of a displacement in a step [L0]
  double gap_ratio = 0;         ///< largest ratio of gaps in a step; 0: no limit
  double longest_step = 0;      ///< [T0]
  double newton_tolerance = 0;  ///< see NewtonOptions::tolerance
  MeshSettings mesh{};
};

/// Returns the settings of the first run for an accuracy, which is relative. For 1 % and more these are a local error
/// of 1 % of the smallest body's longest side, a gap ratio of 2, a 25th of the run and a Newton tolerance of 1e-6; a
/// scene with adaptive steps has its own limits instead, and the mesh those of the scene. For less they are refined as
/// the root of the accuracy, as errors of the second order ask for. Coarse first runs cost little: each run costs about
/// half of the next one.
///
/// Throws InputError if the scheme has no estimate of its local error.
AccuracySettings first_settings(const Simulation& simulation, double accuracy);

/// Returns the settings with which steps have about `part` of their length: local errors fall with its third power, and
/// the logarithm of the gap ratio with the first. Newton's tolerance falls with the third power as well, down to 1e-11,
/// because the errors of all steps add up.
AccuracySettings refined(const AccuracySettings& settings, double part);

/// Returns whether a finer mesh can be asked for: it follows the front, and neither Levels nor Part would leave their
/// range.
bool has_finer_mesh(const AccuracySettings& settings);

/// Returns the settings with which a mesh that follows the front has cells of half the size there, and inside the
/// bodies if it follows the strain: half the changes, and a level more.
AccuracySettings with_finer_mesh(const AccuracySettings& settings);

/// Returns the settings as changes of the scene.
Assignments assignments(const AccuracySettings& settings);

}  // namespace ixos
