#include <Teuchos_Array.hpp>

#include "base/one_of.hpp"
#include "base/range_validator.hpp"
#include "scene/validation.hpp"
#include "study/study.hpp"

namespace ixos {
namespace {

using List = Teuchos::ParameterList;
using Words = Teuchos::Array<std::string>;

void add_settings(List& list, const char* name, const char* documentation) {
  mark_free_form(list.sublist(name, false, documentation));
}

List make() {
  List study("Study");
  study.set("Scene", required, "the scene's file; a relative path counts from the study's folder");
  study.set("Jobs", 1, "runs at a time; two disturb each other's times", between(1, 2));
  study.set("Time Limit", 0.0, "wall-clock seconds after which a run counts as failed; 0: none", at_least(0));
  add_settings(study, "Common",
               "settings of every run: the parameter's path in the scene is the name, \"Time Integrator/Type\"");
  List& axis = study.sublist("Axes", false, "what is varied; every combination is run").sublist(any_name);
  axis.set("Parameter", "", "path of the one parameter that Values are for");
  axis.set("Values", Words(), "its values");
  List& settings = axis.sublist("Settings", false, "or a list for each value: its name is the label");
  mark_free_form(settings.sublist(any_name));
  List& reference = study.sublist("Reference", false, "what errors are taken against");
  reference.set("Folder", "", "results of an earlier run; a relative path counts from the study's folder");
  add_settings(reference, "Settings", "or the settings of a run, beyond the common ones");
  List& errors = study.sublist("Errors", false, "how errors are taken, over rows of history.csv");
  errors.set("Force", Words(), "columns; the contact force when empty");
  errors.set("Position", Words(), "columns; the displacements of all probes when empty");
  errors.set("Interval", Teuchos::Array<double>(), "{from, to} in time [T0]; the whole run when empty", any_number());
  errors.set("Energy Scale", 0.0, "[E0 L0^D]; 0: the largest kinetic energy of the reference", at_least(0));
  List& question = study.sublist("Question", false, "what is asked of the runs");
  question.set("Connect", "", "axis along which a plot joins points; the last when empty");
  question.set("Cost", "wall_seconds", "what a run costs",
               one_of({"wall_seconds", "cpu_seconds", "newton_iterations"}));
  question.set("Measure", "error_force", "which error counts",
               one_of({"error_energy", "error_momentum", "error_force", "error_position"}));
  question.set("Tolerance", 0.01, "largest error; the cheapest run within it is recommended; 0: none", at_least(0));
  question.set("Budget", 0.0, "largest cost; the most accurate run within it is named; 0: none", at_least(0));
  return study;
}

}  // namespace

const List& study_parameters() {
  static const List parameters = make();
  return parameters;
}

}  // namespace ixos
