// Exceptions of the library as exceptions of Python.
#include "base/error.hpp"
#include "base/memory.hpp"
#include "bindings.hpp"

namespace py = pybind11;

namespace ixos::python {

void bind_errors(py::module_& module) {
  py::register_exception<InputError>(module, "InputError", PyExc_ValueError).doc() =
      "Bad input. The message is the one that the command ixos prints: the place, the value and what is allowed.";
  py::register_exception<FileError>(module, "FileError", PyExc_OSError).doc() =
      "A file or folder could not be written or read.";
  py::register_exception_translator([](std::exception_ptr thrown) {  // NOLINT(performance-unnecessary-value-param)
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const MemoryError& error) {
      PyErr_SetString(PyExc_MemoryError, error.what());
    } catch (const std::bad_alloc&) {
      PyErr_SetString(PyExc_MemoryError, out_of_memory().c_str());
    }
  });
}

}  // namespace ixos::python
