/// Studies: one scene, run with many settings, to compare accuracy and cost.
#pragma once
#include <Teuchos_ParameterList.hpp>
#include <limits>
#include <string>
#include <vector>

#include "study/common/axes.hpp"
#include "study/common/study_run.hpp"

namespace ixos {

/// How errors against the reference are taken.
struct ErrorOptions {
  std::vector<std::string> force;     ///< columns of history.csv; empty: the contact force
  std::vector<std::string> position;  ///< empty: the displacements of all probes
  double from = -std::numeric_limits<double>::infinity(), to = std::numeric_limits<double>::infinity();  ///< [T0]
  double energy_scale = 0;  ///< [E0 L0^D]; 0: the reference's largest kinetic energy
};

/// A coarser run of the reference, which shows how well the reference is known.
struct ReferenceCheck {
  Assignments settings;     ///< beyond those of the reference; empty: there is no such run
  std::string description;  ///< of the run, or why there is none
};

/// The question that the study answers.
struct Question {
  std::string connect;   ///< the axis along which points of a plot are joined
  std::string cost;      ///< a column of study.csv
  std::string measure;   ///< an error column of study.csv, see measures()
  double tolerance = 0;  ///< of that error; 0: none
  double budget = 0;     ///< of that cost; 0: none
};

struct Study {
  std::string name;
  std::string scene;  ///< path of the scene's file
  Assignments common;
  std::vector<Axis> axes;
  Assignments reference;         ///< beyond the common ones; of a reference that is computed
  std::string reference_folder;  ///< results that serve as the reference, in place of a computed one
  ReferenceCheck check;
  ErrorOptions errors;
  Question question;
  int jobs = 1;           ///< runs at a time
  double time_limit = 0;  ///< wall clock of one run [s]; 0: none
  std::vector<StudyRun> runs;
};

/// Returns every list and parameter of a study file, with defaults, ranges and documentation.
const Teuchos::ParameterList& study_parameters();

/// Reads a study file and its scene, and checks the settings of every run against what a scene may say. Throws
/// InputError that names the file, the list path, the value, and what is allowed.
Study read_study(const std::string& path);

/// Returns the complete scene of a run as it will be read, by which a result is recognised. Throws InputError.
std::string scene_text(const Study& study, const Assignments& settings);

}  // namespace ixos
