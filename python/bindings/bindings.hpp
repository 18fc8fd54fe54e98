/// The parts of the module ixos._core. Each function adds the classes and functions of one theme.
#pragma once
#include <pybind11/pybind11.h>

namespace ixos::python {

void bind_errors(pybind11::module_& module);
void bind_scene(pybind11::module_& module);
void bind_mesh(pybind11::module_& module);
void bind_simulation(pybind11::module_& module);
void bind_study(pybind11::module_& module);

/// Add properties and functions to the class Simulation.
class LiveSimulation;
using SimulationClass = pybind11::class_<LiveSimulation>;
void bind_state(SimulationClass& simulation);
void bind_initial_state(SimulationClass& simulation);
void bind_measures(SimulationClass& simulation);
void bind_local_mesh(pybind11::module_& module, SimulationClass& simulation);
void bind_run(pybind11::module_& module, SimulationClass& simulation);

}  // namespace ixos::python
