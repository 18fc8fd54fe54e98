// Studies run one scene with many settings, each in a separate process.
#include "study/compare/study.hpp"

#include <pybind11/stl.h>

#include "bindings.hpp"
#include "scan_command.hpp"
#include "scene_list.hpp"
#include "shell_word.hpp"
#include "study/compare/study_runner.hpp"
#include "study/scan/scan.hpp"

namespace py = pybind11;

namespace ixos::python {
namespace {

/// A study and its file.
struct StudyFile {
  Study study;
  std::string path;
};

StudyFile read(const std::string& path) {
  return at_scene(path, {}, [&] { return StudyFile{read_study(path), path}; });
}

py::dict row(const StudyResult& result) {
  py::dict values;
  values["name"] = result.run.name;
  values["labels"] = result.run.labels;
  values["status"] = result.status;
  values["reason"] = result.reason;
  for (const Measure& measure : measures()) values[measure.column] = result.errors.*measure.error;
  values["wall_seconds"] = result.wall_seconds;
  values["cpu_seconds"] = result.cpu_seconds;
  values["steps"] = result.steps;
  values["rejected_steps"] = result.rejected_steps;
  values["newton_iterations"] = result.newton_iterations;
  values["linear_iterations"] = result.linear_iterations;
  values["peak_memory_bytes"] = result.peak_memory_bytes;
  values["end_time"] = result.end_time;
  return values;
}

/// Stops a loop that runs without Python's lock, when a signal or an observer has raised an exception.
class Stoppable {
 public:
  /// Returns whether it is to stop.
  bool operator()() {
    const py::gil_scoped_acquire hold;
    if (!stopped_ && PyErr_CheckSignals() != 0) stopped_ = std::make_exception_ptr(py::error_already_set());
    return stopped_ != nullptr;
  }
  /// Calls the observer of a run with what `row` makes, unless it has none or is to stop.
  template <class Row>
  void tell(const py::object& observer, const Row& row, std::size_t done, bool reused) {
    const py::gil_scoped_acquire hold;
    if (stopped_ || observer.is_none()) return;
    try {
      observer(row(), done, reused);
    } catch (...) {
      stopped_ = std::current_exception();
    }
  }
  void rethrow() const {
    if (stopped_) std::rethrow_exception(stopped_);
  }

 private:
  std::exception_ptr stopped_;
};

/// Returns the rows and the recommendation. Throws what `watch` throws, and KeyboardInterrupt.
py::tuple run_file(const StudyFile& file, const std::string& folder, const std::string& driver, bool overwrite,
                   const py::object& watch) {
  Stoppable stopped;
  RunnerOptions options;
  options.folder = folder;
  options.driver = driver;
  options.version = IXOS_VERSION;
  options.command = "ixos-study " + shell_word(file.path) + " --output " + shell_word(folder);
  options.overwrite = overwrite;
  options.interrupted = [&] { return stopped(); };
  options.watch = [&](const StudyResult& result, std::size_t done, bool reused) {
    stopped.tell(
        watch, [&] { return row(result); }, done, reused);
  };
  StudyOutcome outcome;
  {
    const py::gil_scoped_release free;
    outcome = at_scene(file.path, {}, [&] { return run_study(file.study, options); });
  }
  stopped.rethrow();
  if (outcome.status == StudyStatus::ReferenceFailed)
    throw std::runtime_error("the reference did not reach its end: " + outcome.results.front().status + ": " +
                             outcome.results.front().reason);
  py::list rows;
  for (const StudyResult& result : outcome.results) rows.append(row(result));
  return py::make_tuple(rows, outcome.recommendation);
}

py::dict scan_row(const ScanRow& result) {
  py::dict values;
  values["labels"] = result.run.labels;
  values["values"] = result.values;
  values["name"] = result.run.name;
  values["status"] = result.status;
  values["reason"] = result.reason;
  values["wall_seconds"] = result.wall_seconds;
  values["steps"] = result.steps;
  return values;
}

/// Returns the names of the varied parameters, the quantities, and the rows.
py::tuple run_scan_of(const std::string& scene, const std::vector<std::string>& varied,
                      const std::vector<std::string>& quantities, const Assignments& settings,
                      const std::string& folder, const std::string& driver, int jobs, bool overwrite,
                      const py::object& watch) {
  Stoppable stopped;
  ScanOptions options;
  options.folder = folder;
  options.driver = driver;
  options.version = IXOS_VERSION;
  options.command = scan_command(scene, varied, quantities, settings, folder);
  options.jobs = jobs;
  options.overwrite = overwrite;
  options.interrupted = [&] { return stopped(); };
  options.watch = [&](const ScanRow& result, std::size_t done, bool reused) {
    stopped.tell(
        watch, [&] { return scan_row(result); }, done, reused);
  };
  Scan scan;
  ScanOutcome outcome;
  {
    const py::gil_scoped_release free;
    outcome = at_scene(scene, {}, [&] {
      scan = read_scan(scene, settings, varied, quantities);
      return run_scan(scan, options);
    });
  }
  stopped.rethrow();
  std::vector<std::string> names, collected;
  for (const VariedParameter& parameter : scan.varied) names.push_back(parameter.name);
  for (const AskedQuantity& quantity : scan.quantities) collected.push_back(quantity.text());
  py::list rows;
  for (const ScanRow& result : outcome.rows) rows.append(scan_row(result));
  return py::make_tuple(names, collected, rows);
}

py::list runs(const StudyFile& file) {
  py::list result;
  for (const StudyRun& run : file.study.runs) {
    py::dict entry;
    entry["name"] = run.name;
    entry["labels"] = run.labels;
    entry["settings"] = run.settings;
    result.append(entry);
  }
  return result;
}

}  // namespace

void bind_study(py::module_& module) {
  py::class_<StudyFile>(module, "StudyFile", "A study as its file has it. ixos.Study is made of one.")
      .def(py::init(&read), py::arg("path"))
      .def_readonly("path", &StudyFile::path)
      .def_property_readonly("name", [](const StudyFile& file) { return file.study.name; })
      .def_property_readonly("scene", [](const StudyFile& file) { return file.study.scene; })
      .def_property_readonly("axes",
                             [](const StudyFile& file) {
                               py::dict axes;
                               for (const Axis& axis : file.study.axes) {
                                 std::vector<std::string> labels;
                                 for (const AxisValue& value : axis.values) labels.push_back(value.label);
                                 axes[py::str(axis.name)] = labels;
                               }
                               return axes;
                             })
      .def_property_readonly("runs", &runs)
      .def("run", &run_file, py::arg("folder"), py::arg("driver"), py::arg("overwrite") = false,
           py::arg("watch") = py::none());
  module.def("scan", &run_scan_of, py::arg("scene"), py::arg("varied"), py::arg("quantities"), py::arg("settings"),
             py::arg("folder"), py::arg("driver"), py::arg("jobs"), py::arg("overwrite"), py::arg("watch"));
}

}  // namespace ixos::python
