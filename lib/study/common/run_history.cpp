#include "study/common/run_history.hpp"

#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "io/disk_file.hpp"
#include "parameters/validation.hpp"
#include "scene/scene_file.hpp"
#include "time/catalogue.hpp"

namespace ixos {
namespace {

/// Returns whether the scheme of effective.xml gives reactions as means of a step.
bool has_step_means(const std::string& path) {
  const Teuchos::ParameterList scene = read_scene_file(path);
  try {
    const Teuchos::ParameterList& integrator = scene.sublist("Time Integrator");
    const Scheme& chosen = scheme(integrator.get<std::string>("Type"));
    // Parameters that an older version did not know take their defaults.
    const Teuchos::ParameterList given =
        integrator.isSublist(chosen.name) ? integrator.sublist(chosen.name) : Teuchos::ParameterList();
    return chosen.table(validated(given, chosen.parameters)).closing == Closing::Collocate;
  } catch (const std::exception& error) {  // of Teuchos, of the validation, of the table
    throw InputError(path + ": Time Integrator: " + last_paragraph(error.what()));
  }
}

}  // namespace

RunHistory::RunHistory(const std::string& folder)
    : folder_(folder), table_(folder + "/history.csv"), step_means_(has_step_means(folder + "/effective.xml")) {}

std::vector<double> RunHistory::times(const std::string& column) const {
  std::vector<double> result = table_.column("time");
  if (!step_means_ || column.rfind("reaction_", 0) != 0) return result;
  const std::vector<double>& step = table_.column("time_step");
  for (std::size_t i = 1; i < result.size(); ++i) result[i] -= step[i] / 2;
  return result;
}

double RunHistory::energy_error() const {
  std::ifstream file = open_text(folder_ + "/summary.json");
  const nlohmann::json summary = nlohmann::json::parse(file, nullptr, false);
  if (!summary.is_object() || !summary.contains("max_energy_error"))
    throw FileError(folder_ + "/summary.json: cannot be read");
  const auto& error = summary["max_energy_error"];
  return error.is_number() ? error.get<double>() : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace ixos
