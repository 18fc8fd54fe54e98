// Studies run one scene with many settings, each in a separate process.
#include "study/compare/study.hpp"

#include <pybind11/stl.h>

#include "bindings.hpp"
#include "scene_list.hpp"
#include "shell_word.hpp"
#include "study/compare/study_runner.hpp"

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

/// Returns the rows and the recommendation. Throws what `watch` throws, and KeyboardInterrupt.
py::tuple run_file(const StudyFile& file, const std::string& folder, const std::string& driver, bool overwrite,
                   const py::object& watch) {
  std::exception_ptr stopped;
  RunnerOptions options;
  options.folder = folder;
  options.driver = driver;
  options.version = IXOS_VERSION;
  options.command = "ixos-study " + shell_word(file.path) + " --output " + shell_word(folder);
  options.overwrite = overwrite;
  options.interrupted = [&] {
    const py::gil_scoped_acquire hold;
    if (!stopped && PyErr_CheckSignals() != 0) stopped = std::make_exception_ptr(py::error_already_set());
    return stopped != nullptr;
  };
  if (!watch.is_none())
    options.watch = [&](const StudyResult& result, std::size_t done, bool reused) {
      const py::gil_scoped_acquire hold;
      try {
        if (!stopped) watch(row(result), done, reused);
      } catch (...) {
        stopped = std::current_exception();
      }
    };
  StudyOutcome outcome;
  {
    const py::gil_scoped_release free;
    outcome = at_scene(file.path, {}, [&] { return run_study(file.study, options); });
  }
  if (stopped) std::rethrow_exception(stopped);
  if (outcome.status == StudyStatus::ReferenceFailed)
    throw std::runtime_error("the reference did not reach its end: " + outcome.results.front().status + ": " +
                             outcome.results.front().reason);
  py::list rows;
  for (const StudyResult& result : outcome.results) rows.append(row(result));
  return py::make_tuple(rows, outcome.recommendation);
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
}

}  // namespace ixos::python
