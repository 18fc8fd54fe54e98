/// A simulation that Python owns.
#pragma once
#include <pybind11/pybind11.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

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

  /// Throws std::runtime_error while another thread of Python computes.
  Simulation& get() const;
  const Model& model() const { return get().model(); }
  Integrator& integrator() const { return get().integrator(); }
  const State& state() const { return integrator().state(); }
  const std::string& file() const { return file_; }  ///< of the scene; may be empty
  /// Has the simulation of a later stage take the place of the present one, which stays: arrays may view its state.
  void go_on_with(std::shared_ptr<Simulation> stage);

 private:
  friend class Changing;
  std::string file_;
  pybind11::object comm_;
  std::shared_ptr<Simulation> simulation_;
  std::vector<std::shared_ptr<Simulation>> earlier_;
  bool changing_ = false;
  EndsWithSession end_;
};

/// A guard of a function that may solve or communicate: other threads of Python run meanwhile, but cannot use any
/// simulation, because MPI and Trilinos serve one thread. An observer of a run, in the same thread, can.
class Computing {
 public:
  /// Throws std::runtime_error if another thread has such a guard.
  Computing();
  ~Computing();
  Computing(const Computing&) = delete;
  Computing& operator=(const Computing&) = delete;
  static void check();  ///< throws as the constructor does

 private:
  std::optional<pybind11::gil_scoped_release> release_;
};

/// Calls a function of the Simulation under the guard Computing.
template <class Function>
auto compute(const LiveSimulation& simulation, const Function& function) {
  Simulation& inner = simulation.get();
  const Computing guard;
  return function(inner);
}

/// A guard of a function that changes the state. Throws std::runtime_error inside another one: an observer may read
/// the simulation only.
class Changing {
 public:
  explicit Changing(LiveSimulation& simulation);
  ~Changing() { simulation_.changing_ = false; }
  Changing(const Changing&) = delete;
  Changing& operator=(const Changing&) = delete;

 private:
  LiveSimulation& simulation_;
};

/// Returns the list of functions to call after each accepted step of a Python object of this class.
pybind11::list observers(const pybind11::object& simulation);

/// Returns whether that list has any functions.
bool has_observers(const pybind11::object& simulation);

/// Calls the functions in the list of observers of a Python object of this class, each with the object.
void notify(const pybind11::object& simulation);

}  // namespace ixos::python
