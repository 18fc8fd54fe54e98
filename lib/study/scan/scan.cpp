#include "study/scan/scan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <map>
#include <optional>

#include "base/error.hpp"
#include "base/printable.hpp"
#include "io/disk_file.hpp"
#include "parameters/scene_node.hpp"
#include "scene/read/scene_units.hpp"
#include "scene/scene_file.hpp"
#include "study/common/results_folder.hpp"
#include "study/common/run_history.hpp"
#include "study/common/run_pool.hpp"
#include "study/scan/scan_table.hpp"

namespace ixos {
namespace {

/// Returns the scan in words, by which its folder is recognised: other values of the same parameters are the same scan.
std::string owner(const Scan& scan) {
  std::string text = "the scan of " + std::filesystem::absolute(scan.scene).lexically_normal().string() + " over";
  for (const VariedParameter& varied : scan.varied)
    text += (&varied == &scan.varied.front() ? " " : ", ") + varied.path;
  for (const std::string& assignment : scan.common) text += ", with " + assignment;
  return printable(text);
}

/// Returns the row of a finished run. A failed run has the quantities that were decided before it failed.
ScanRow row_of(const RunPool& pool, const StudyRun& run, const std::vector<AskedQuantity>& quantities) {
  ScanRow row{pool.record(run), {}};
  row.values.assign(quantities.size(), std::numeric_limits<double>::quiet_NaN());
  if (!row.reached_its_end() && !row.failed_with_rows()) return row;
  const RunHistory history(pool.folder(run));
  for (std::size_t i = 0; i < quantities.size(); ++i) {
    if (!row.reached_its_end() && !quantities[i].is_decided(history)) continue;
    try {
      row.values[i] = quantities[i].value(history);
    } catch (const InputError& error) {
      row.reason += (row.reason.empty() ? "" : "; ") + std::string(error.what());
    }
  }
  return row;
}

/// Lets the program check a run with the quantities of the scan. Returns whether it can say anything of them.
bool check_before(const RunPool& pool, const Scan& scan, const StudyRun& run) {
  std::string asked;
  for (const AskedQuantity& quantity : scan.quantities) asked += (asked.empty() ? "" : ", ") + quantity.text();
  if (pool.check(run, "Output/Quantities={" + asked + "}") == 0) return true;
  const std::string place = "Output/Quantities: ";
  std::ifstream told = open_text(pool.log(run));
  for (std::string line; std::getline(told, line);)
    if (const auto found = line.find(place); found != std::string::npos)
      throw InputError((scan.collects ? "--collect: " : place) + line.substr(found + place.size()));
  return false;
}

/// Refuses quantities that need a column which the runs lack, or will lack: that of the first run that can say so.
void check_columns(const RunPool& pool, const Scan& scan) {
  for (const StudyRun& run : scan.runs) {
    if (!pool.is_done(run)) {
      if (check_before(pool, scan, run)) return;
      continue;
    }
    const RunRecord record = pool.record(run);
    if (!record.reached_its_end() && !record.failed_with_rows()) continue;
    const RunHistory history(pool.folder(run));
    at(scan.collects ? "--collect" : "Output/Quantities", [&] {
      for (const AskedQuantity& quantity : scan.quantities) quantity.check_columns(history.table().names());
    });
    return;
  }
}

void name_apart(std::vector<VariedParameter>& varied) {
  std::map<std::string, int> uses;
  for (const VariedParameter& one : varied) ++uses[one.name];
  for (VariedParameter& one : varied)
    if (uses[one.name] > 1) one.name = one.path;
}

/// Returns the quantities that a complete scene names.
std::vector<AskedQuantity> quantities_of(Teuchos::ParameterList& scene) {
  std::vector<AskedQuantity> quantities;
  at("Output/Quantities", [&] {
    for (const auto& text : scene.sublist("Output").get<Teuchos::Array<std::string>>("Quantities"))
      quantities.emplace_back(text);
  });
  if (quantities.empty())
    throw InputError("--collect is missing, and the scene names no Output/Quantities; give one of\n" +
                     quantity_forms());
  return quantities;
}

}  // namespace

Scan read_scan(const std::string& scene, const Assignments& common, const std::vector<std::string>& varied,
               const std::vector<std::string>& quantities) {
  Scan scan{scene, common, {}, {}, !quantities.empty(), {}};
  for (const std::string& text : varied) {
    scan.varied.push_back(read_varied(text));
    for (std::size_t i = 0; i + 1 < scan.varied.size(); ++i)
      if (scan.varied[i].path == scan.varied.back().path)
        throw InputError("--vary: \"" + scan.varied[i].path + "\" is varied twice");
  }
  name_apart(scan.varied);
  for (const std::string& text : quantities) scan.quantities.emplace_back(text);
  scan.runs = combinations({scan.varied.begin(), scan.varied.end()}, common);
  const Teuchos::ParameterList file = read_scene_file(scene);
  for (const StudyRun& run : scan.runs) {
    Teuchos::ParameterList complete;
    try {
      complete = complete_scene(with_settings(file, run.settings));
    } catch (const InputError& error) {
      throw InputError("run " + run.name + ": " + error.what());
    }
    if (scan.quantities.empty()) scan.quantities = quantities_of(complete);
    if (&run == &scan.runs.front())
      for (VariedParameter& one : scan.varied)
        if (one.has_plain_numbers()) one.unit = unit_of(complete, one.path);
  }
  return scan;
}

ScanOutcome run_scan(const Scan& scan, const ScanOptions& options) {
  std::error_code code;
  const bool is_new = std::filesystem::create_directories(options.folder, code);
  if (code) throw FileError("the results folder cannot be used: " + options.folder + ": " + code.message());
  const ResultsFolder held(options.folder, owner(scan), options.overwrite);
  const RunPool pool({options.folder + "/runs", scan.scene, options.driver, options.version, 0, options.interrupted});
  try {
    check_columns(pool, scan);
  } catch (const InputError&) {
    if (is_new) std::filesystem::remove_all(options.folder, code);
    throw;
  }
  std::vector<std::optional<ScanRow>> found(scan.runs.size());
  std::size_t done = 0;
  ScanOutcome outcome;
  outcome.complete = pool.carry_out(scan.runs, options.jobs, [&](std::size_t number, bool reused) {
    found[number] = row_of(pool, scan.runs[number], scan.quantities);
    if (options.watch) options.watch(*found[number], ++done, reused);
  });
  for (std::optional<ScanRow>& row : found)
    if (row) outcome.rows.push_back(std::move(*row));
  write_scan(scan, outcome.rows, options);
  return outcome;
}

}  // namespace ixos
