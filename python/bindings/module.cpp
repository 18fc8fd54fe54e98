// The module ixos._core: the library in Python. The package ixos adds what is shorter in Python.
#include "bindings.hpp"
#include "session.hpp"
#include "solve/direct/klu2_repair.hpp"

PYBIND11_MODULE(_core, module) {
  module.doc() = "The library of Ixos.";
  module.attr("__version__") = IXOS_VERSION;
  ixos::python::start_session();
  ixos::python::bind_errors(module);
  ixos::python::bind_mesh(module);
  ixos::python::bind_scene(module);
  ixos::python::bind_simulation(module);
  ixos::python::bind_study(module);
  module.def("klu2_library", &ixos::klu2_library,
             "Returns the name of the library whose KLU2 this process uses; empty if Trilinos needs no repair.");
}
