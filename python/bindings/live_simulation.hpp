/// A simulation that Python owns.
#pragma once
#include <pybind11/pybind11.h>

#include <memory>
#include <string>

#include "scene/simulation.hpp"
#include "session.hpp"

namespace ixos::python {

/// A Simulation with what it needs to outlive: its communicator's object of mpi4py. It ends with the session at the
/// latest; get() throws std::runtime_error from then on.
class LiveSimulation {
 public:
  /// `mesh`: the mesh to take in place of the scene's, or null. Messages of InputError name `file`.
  LiveSimulation(const Teuchos::ParameterList& scene, const std::string& file, const pybind11::object& comm,
                 const Mesh* mesh);

  Simulation& get() const;
  const Model& model() const { return get().model(); }
  Integrator& integrator() const { return get().integrator(); }
  const State& state() const { return integrator().state(); }
  const std::string& file() const { return file_; }  ///< of the scene; may be empty

 private:
  std::string file_;
  pybind11::object comm_;
  std::unique_ptr<Simulation> simulation_;
  EndsWithSession end_;
};

/// Returns the list of functions to call after each accepted step of a Python object of this class.
pybind11::list observers(const pybind11::object& simulation);

/// Calls the functions in the list of observers of a Python object of this class, each with the object.
void notify(const pybind11::object& simulation);

}  // namespace ixos::python
