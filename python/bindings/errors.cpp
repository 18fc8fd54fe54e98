// Exceptions of the library as exceptions of Python.
#include "base/error.hpp"
#include "base/memory.hpp"
#include "bindings.hpp"

namespace py = pybind11;

namespace ixos::python {

void bind_errors(py::module_& module) {
  py::register_exception<InputError>(module, "InputError", PyExc_ValueError).doc() =
      "Bad input. The message is the one that the command ixos prints: the place, the value and what is allowed.";
  // One class for the library and for the reader of results, which works without the library.
  const py::object shared = py::module_::import("ixos.result_files").attr("FileError");
  module.attr("FileError") = shared;
  static PyObject* const file_error = shared.inc_ref().ptr();
  py::register_exception_translator([](std::exception_ptr thrown) {  // NOLINT(performance-unnecessary-value-param)
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const FileError& error) {
      PyErr_SetString(file_error, error.what());
    } catch (const MemoryError& error) {
      PyErr_SetString(PyExc_MemoryError, error.what());
    } catch (const std::bad_alloc&) {
      PyErr_SetString(PyExc_MemoryError, out_of_memory().c_str());
    }
  });
}

}  // namespace ixos::python
