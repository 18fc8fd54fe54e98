#include <Teuchos_Array.hpp>

#include "parameters/one_of.hpp"
#include "parameters/range_validator.hpp"
#include "parameters/validation.hpp"
#include "study/compare/study.hpp"
#include "study/compare/study_errors.hpp"

namespace ixos {
namespace {

using List = Teuchos::ParameterList;
using Words = Teuchos::Array<std::string>;

void add_settings(List& list, const char* name, const char* documentation) {
  mark_free_form(list.sublist(name, false, documentation));
}

List make() {
  List study("Study");
  study.set("Scene", required, "Path of the scene file, relative to the study's folder.");
  study.set("Jobs", 1, "Number of runs at the same time. They affect each other's wall-clock times.", between(1, 1024));
  study.set("Time Limit", 0.0,
            "Seconds of wall-clock time after which a run is stopped and counts as failed. 0: no limit.", at_least(0));
  add_settings(study, "Common",
               "Settings of every run. The name of a setting is the parameter's path in the scene, such as \"Time "
               "Integrator/Type\".");
  List& axis = study.sublist("Axes", false, "Settings that are varied. Every combination of the axes' values is a run.")
                   .sublist(any_name);
  axis.set("Parameter", "",
           "Path of the parameter that the axis varies. An axis has either Parameter and Values, or Settings.");
  axis.set("Values", Words(), "Values of Parameter.");
  List& settings = axis.sublist(
      "Settings", false, "One list of settings for each value of the axis; the list's name is the value's label.");
  mark_free_form(settings.sublist(any_name));
  List& reference =
      study.sublist("Reference", false, "Reference that the runs are compared with. It has either Folder or Settings.");
  reference.set("Folder", "", "Results folder of an earlier run, relative to the study's folder.");
  reference.set("Check", true,
                "Whether to run the reference once more with coarser settings. The distance of that run from the "
                "reference is taken as the error of the reference.");
  add_settings(reference, "Settings", "Settings of a reference run, in addition to Common.");
  add_settings(reference, "Check Settings",
               "Settings of the coarser run, in addition to those of the reference. If empty, it has twice the time "
               "step of the reference, which must be fixed.");
  List& errors = study.sublist("Errors", false, "How errors are computed from the rows of history.csv.");
  errors.set("Force", Words(), "Columns of the force and of its peak. If empty, they are the contact force.");
  errors.set("Position", Words(), "Columns of the position error. If empty, they are the displacements of all probes.");
  errors.set("Interval", Teuchos::Array<double>(),
             "Times {from, to} of the comparison [T0]. If empty, it is the whole run.", any_number());
  errors.set("Energy Scale", 0.0,
             "Energy that energy errors are divided by [E0 L0^D]. 0: the largest kinetic energy of the reference.",
             at_least(0));
  std::vector<std::string> columns;
  for (const Measure& measure : measures()) columns.emplace_back(measure.column);
  List& question = study.sublist("Question", false, "The question that the recommendation answers.");
  question.set("Connect", "", "Axis along which a line of a plot joins points. If empty, it is the last axis.");
  question.set("Cost", "wall_seconds", "Cost of a run: a column of study.csv.",
               one_of({"wall_seconds", "cpu_seconds", "newton_iterations"}));
  question.set("Measure", "error_force", "Error that counts: a column of study.csv.", one_of(columns));
  question.set("Tolerance", 0.01,
               "Largest error, that of the reference included. The cheapest run within it is recommended. 0: no "
               "tolerance.",
               at_least(0));
  question.set("Budget", 0.0, "Largest cost. The most accurate run within it is named. 0: no budget.", at_least(0));
  return study;
}

}  // namespace

const List& study_parameters() {
  static const List parameters = make();
  return parameters;
}

}  // namespace ixos
