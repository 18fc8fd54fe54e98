#include "run/summary.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "base/agreement.hpp"
#include "io/disk_file.hpp"

namespace ixos {
namespace {

/// Returns the largest resident set of this process [bytes], 0 if the system does not report it.
double peak_memory() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.rfind("VmHWM:", 0) == 0) return 1024 * std::stod(line.substr(6));
  return 0;
}

/// Returns, for each kind of result, the symbol of its unit, its value in SI units and the SI unit.
nlohmann::ordered_json to_json(const std::vector<ResultUnit>& units) {
  nlohmann::ordered_json json;
  for (const ResultUnit& unit : units)
    json[unit.quantity] = {{"symbol", unit.expression}, {"si", unit.scale}, {"unit", unit.si}};
  return json;
}

}  // namespace

std::string to_string(RunStatus status) {
  if (status == RunStatus::Completed) return "completed";
  if (status == RunStatus::Stopped) return "stopped";
  return status == RunStatus::Diverged ? "diverged" : "interrupted";
}

void write_summary(const Simulation& simulation, const RunResult& result, const std::string& path) {
  const Model& model = simulation.model();
  const Comm& comm = model.space().comm();
  double memory = peak_memory();
  model.space().sum(&memory, 1);
  nlohmann::ordered_json json;
  json["status"] = to_string(result.status);
  json["reason"] = result.reason;
  json["scheme"] = simulation.time_integrator().scheme;
  json["end_time"] = result.end_time;
  json["steps"] = result.steps;
  json["rejected_steps"] = result.rejected_steps;
  json["restarts"] = result.restarts;
  json["dofs"] = model.space().global();
  json["elements"] = model.mesh().global_cells;
  json["mesh_fingerprint"] = simulation.fingerprint_of_results();
  json["least_scaled_jacobian"] = simulation.mesh_quality().least_scaled_jacobian;
  json["largest_aspect_ratio"] = simulation.mesh_quality().largest_aspect_ratio;
  json["ranks"] = comm->getSize();
  json["newton_iterations"] = result.newton_iterations;
  json["linear_iterations"] = result.linear_iterations;
  json["wall_seconds"] = result.wall_seconds;
  json["setup_seconds"] = simulation.setup_seconds();
  json["seconds_per_increment"] = result.wall_seconds / static_cast<double>(std::max(result.steps, 1L));
  json["seconds"] = nlohmann::ordered_json::object();
  for (std::size_t i = 0; i < phase_names.size(); ++i) json["seconds"][phase_names[i]] = result.phase_seconds[i];
  json["peak_memory_bytes"] = static_cast<long long>(memory);
  // Numbers that are not finite are written as null.
  json["max_energy_error"] = result.max_energy_error;
  json["largest_energy"] = result.largest_energy;
  json["max_force"] = nlohmann::ordered_json::object();
  for (const auto& [reaction, force] : result.max_forces) json["max_force"][reaction] = force;
  json["contacts"] = nlohmann::ordered_json::object();
  for (const ContactTimes& own : result.contacts)
    json["contacts"][own.interaction] = {{"first", own.first}, {"released", own.released}};
  json["dissipated"] = nlohmann::ordered_json::object();
  const std::vector<double>& dissipations = simulation.integrator().dissipations();
  for (std::size_t i = 0; i < dissipations.size(); ++i)
    json["dissipated"][model.dissipation_names()[i]] = dissipations[i];
  if (const double before = simulation.integrator().dissipated_before(); before != 0)
    json["dissipated"]["before the restart"] = before;
  if (result.jumps.count > 0) {
    const Jump& largest = result.jumps.largest;
    json["jumps"] = {{"count", result.jumps.count},
                     {"released", result.jumps.released},
                     {"largest", {{"released", largest.released}, {"from", largest.from}, {"to", largest.to}}}};
  }
  if (simulation.adaptation().on()) {
    const MeshChanges& changes = result.mesh_changes;
    json["mesh_changes"] = {{"count", changes.count},
                            {"repeated_steps", changes.repeated},
                            {"energy", changes.energy.total()},
                            {"kinetic_energy", changes.energy.kinetic},
                            {"elastic_energy", changes.energy.elastic},
                            {"contact_energy", changes.energy.contact},
                            {"coarsening", changes.coarsening},
                            {"mean_dofs", changes.unknowns / static_cast<double>(std::max(result.steps, 1L))},
                            {"most_dofs", changes.most_unknowns}};
  }
  if (simulation.stages().any()) {
    std::vector<StageEnd> stages = result.stages;
    if (result.status == RunStatus::Completed || result.status == RunStatus::Stopped)
      stages.push_back({simulation.stages().name(simulation.stage()), result.end_time, result.steps, result.reason});
    json["stages"] = nlohmann::ordered_json::array();
    for (const StageEnd& stage : stages)
      json["stages"].push_back(
          {{"name", stage.name}, {"end_time", stage.time}, {"steps", stage.steps}, {"reason", stage.reason}});
  }
  json["warnings"] = nlohmann::ordered_json::array();
  for (const std::vector<Warning>* warnings : {&simulation.warnings(), &result.warnings, &result.findings})
    for (const Warning& warning : *warnings)
      json["warnings"].push_back({{"name", warning.name}, {"message", warning.message}});
  json["units"] = to_json(simulation.result_units());
  json["checkpoint"] = nullptr;
  if (!result.checkpoint.empty()) json["checkpoint"] = std::filesystem::path(result.checkpoint).filename().string();
  on_first_rank(
      comm, [&] { write_whole_file(path, json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + '\n'); });
}

}  // namespace ixos
